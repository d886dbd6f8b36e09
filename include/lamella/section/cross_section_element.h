// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_cross_section_element_h
#define lamella_section_cross_section_element_h

#include <lamella/shape/section_geometry.h>
#include <lamella/shape/section_mesh.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>

#include <memory>

#include <string>
#include <vector>

namespace lamella
{
  /// The expansion functions that do not vanish on a cell, at one of its
  /// points.
  struct FunctionValues
  {
    /// The point, x and z in the section's plane, and the Jacobian
    /// d(x, z) / d(xi, eta) of the map from the unit square.
    dealii::Point<2>     position;
    dealii::Tensor<2, 2> jacobian;
    /// F_tau and (dF_tau/dx, dF_tau/dz) in the order of cell_functions().
    std::vector<double>               values;
    std::vector<dealii::Tensor<1, 2>> gradients;
  };

  /// A point of a section's boundary where contact and supports are collocated.
  struct EdgePoint
  {
    dealii::Point<2>     position;
    dealii::Tensor<1, 2> normal;
    /// The length of boundary that belongs to the point; over all points of a
    /// boundary these sum to its length.
    double weight = 0.;
    /// Whether sides of different normals meet there.
    bool corner = false;
    /// Where the point lies: a cell, the place on its unit square, and the
    /// cell's depth normal to the boundary.
    unsigned int     cell = 0;
    dealii::Point<2> unit;
    double           depth = 0.;
  };

  /**
   * The cross-section expansion F_tau(x, z), tau = 0 ... n_functions() - 1, of
   * the paper's Eq. 1 on a section mesh.
   *
   * Every expansion is hierarchical: its first three functions are 1,
   * (x - x_c) / h and (z - z_c) / h, differentiated analytically, so that the
   * rigid motions of the section are DoFs of their own and slender beams keep
   * their bending energy (doc/stable-basis.md). What follows is warping.
   */
  class CrossSectionElement
  {
  public:
    virtual ~CrossSectionElement() = default;

    /// The polynomial degree of the functions on a cell.
    virtual unsigned int
    degree() const = 0;

    /// On a side of a cell positions and functions are polynomials of this
    /// degree in the side's parameter; with curved sides that may be more than
    /// degree().
    virtual unsigned int
    trace_degree() const
    {
      return degree();
    }

    /// Gauss points a direction and cell that integrate products of two
    /// functions exactly (on straight cells).
    virtual unsigned int
    n_gauss_points() const
    {
      return degree() + 1;
    }

    virtual unsigned int
    n_functions() const = 0;

    /// 0 for 1, x, z, higher for finer functions: coarse DoFs are eliminated
    /// first, so that what stays is still hierarchical.
    virtual unsigned int
    level(const unsigned int tau) const
    {
      return tau < 3 ? 0 : 1;
    }

    /// The functions that do not vanish on @p cell, ascending.
    virtual const std::vector<unsigned int> &
    cell_functions(const unsigned int cell) const = 0;

    /// cell_functions() and the geometry at @p unit of the unit square.
    virtual FunctionValues
    evaluate(const unsigned int cell, const dealii::Point<2> &unit) const = 0;

    /// The geometry alone, for searches.
    virtual SectionGeometry::Place
    map(const unsigned int cell, const dealii::Point<2> &unit) const = 0;

    /// Points that fix the trace of the expansion on the boundary named
    /// @p boundary, with outward normals and weights.
    virtual std::vector<EdgePoint>
    edge_points(const std::string &boundary) const = 0;

    /// Points that fix the expansion on the whole section, as few as that takes
    /// (normal and weight not set).
    virtual std::vector<EdgePoint>
    section_points() const = 0;

    /// A grid of points of the section with the areas that belong to them, all
    /// positive and (on straight cells) the whole area in all; normal not set.
    virtual std::vector<EdgePoint>
    section_grid() const = 0;

    /// Gauss points of the boundary named @p boundary, @p n on each side of a
    /// cell, with outward normals; weights are those of the integral over its
    /// length.
    std::vector<EdgePoint>
    edge_quadrature(const std::string &boundary, const unsigned int n) const;

    /// The sides of cells, as pairs of cell and face, of the boundary @p name.
    std::vector<std::pair<unsigned int, unsigned int>>
    boundary_faces(const std::string &name) const;

    /// The point at the parameter @p t of the side @p face of @p cell, on the
    /// boundary; its weight is the length per unit of the parameter.
    EdgePoint
    edge_point(const unsigned int cell,
               const unsigned int face,
               const double       t) const;

    const SectionMesh &
    section_mesh() const
    {
      return *mesh;
    }

    std::shared_ptr<const SectionMesh>
    shared_mesh() const
    {
      return mesh;
    }

    /// The point (x_c, z_c) and the length h of the linear functions.
    dealii::Point<2>
    centre() const
    {
      return origin;
    }

    double
    reference_length() const
    {
      return length;
    }

    /// Of the section; curved edges may leave it a little.
    dealii::BoundingBox<2>
    bounding_box() const;

  protected:
    /// Values of the first three functions, geometry as given.
    FunctionValues
    linear_functions(const dealii::Point<2>     &position,
                     const dealii::Tensor<2, 2> &jacobian) const;

    /// Adds a side's share of normal and length to @p point, at whose place the
    /// side's own normal is @p own_normal; marks corners of more than 20
    /// degrees.
    static void
    add_side(EdgePoint                  &point,
             const dealii::Tensor<1, 2> &scaled_normal,
             const double                weight,
             const dealii::Tensor<1, 2> &own_normal);

    /// The depth of @p cell behind its side @p face: area over length of side.
    double
    depth(const unsigned int cell, const unsigned int face) const;

    /// x_c, z_c is the centre of area, h half the bounding box's diagonal.
    explicit CrossSectionElement(std::shared_ptr<const SectionMesh> mesh);

    std::shared_ptr<const SectionMesh> mesh;
    dealii::Point<2>                   origin;
    double                             length;
  };

  /// The point of the unit square at the parameter @p t in [0, 1] of @p face.
  dealii::Point<2>
  face_point(const unsigned int face, const double t);

  /**
   * The outward normal, scaled with the length of face per unit of its
   * parameter, where @p jacobian is that of the cell's map.
   */
  dealii::Tensor<1, 2>
  scaled_face_normal(const unsigned int          face,
                     const dealii::Tensor<2, 2> &jacobian);
} // namespace lamella

#endif
