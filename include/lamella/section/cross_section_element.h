// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_cross_section_element_h
#define lamella_section_cross_section_element_h

#include <lamella/shape/section_geometry.h>
#include <lamella/shape/section_mesh.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>
#include <deal.II/base/quadrature.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// The expansion functions that do not vanish on a cell, at one of its
  /// points. What CrossSectionElement::evaluate() returns: F_tau with its
  /// derivatives, and the geometry, all that strains over the section are made
  /// of.
  struct FunctionValues
  {
    /// The point, x and z in the section's plane, and the Jacobian d(x, z) /
    /// d(xi, eta) of the map from the unit square. In the body frame [length].
    dealii::Point<2>     position;
    dealii::Tensor<2, 2> jacobian;
    /// F_tau and (dF_tau/dx, dF_tau/dz) in the order of cell_functions(). F_tau
    /// has no unit, its derivatives are in 1 / length.
    std::vector<double>               values;
    std::vector<dealii::Tensor<1, 2>> gradients;
  };

  /// A point of a section's boundary where contact, loads and supports are
  /// collocated, or of its interior, with the share of the boundary or of the
  /// area that belongs to it: its tributary length or area. Along the axis each
  /// becomes a SurfacePoint.
  struct EdgePoint
  {
    /// Coordinates x, z in the section's plane [length], and the unit outward
    /// normal there; where two sides meet their mean, weighted with their
    /// shares.
    dealii::Point<2>     position;
    dealii::Tensor<1, 2> normal;
    /// The length of boundary that belongs to the point [length], the integral
    /// of its shape function: over all points of a boundary these sum to its
    /// length. Of points of the whole section an area [length^2].
    double weight = 0.;
    /// Whether sides of different normals meet there. By more than 20 degrees.
    bool corner = false;
    /// Where the point lies: a cell, the place on its unit square, and the
    /// cell's depth normal to the boundary. Of points between cells in one of
    /// them. The depth is the cell's area over the length of its side [length];
    /// 0 for points that are on no boundary.
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
   *
   * Derived classes choose the functions: TaylorElement (equivalent single
   * layer) and LagrangeElement (layer-wise). A section mesh has cells, each the
   * image of the unit square under a map (xi, eta) -> (x, z); places are pairs
   * of a cell and a point of its unit square. Functions are numbered over the
   * whole section, cell_functions() says which of them live on a cell. Shares
   * the mesh.
   *
   * Immutable once it is made.
   */
  class CrossSectionElement
  {
  public:
    virtual ~CrossSectionElement() = default;

    /// The polynomial degree of the functions on a cell. N of TE-N, p of LE-p.
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

    /// M of Eq. 1.
    virtual unsigned int
    n_functions() const = 0;

    /// 0 for 1, x, z, higher for finer functions: coarse DoFs are eliminated
    /// first, so that what stays is still hierarchical.
    virtual unsigned int
    level(const unsigned int tau) const
    {
      return tau < 3 ? 0 : 1;
    }

    /// Of functions that are hierarchical by degree the q of the LE-q that the
    /// function completes: those of degree q and less are the leading ones, and
    /// span LE-q. degree() of all others.
    virtual unsigned int
    function_degree(const unsigned int) const
    {
      return degree();
    }

    /// The functions that do not vanish on @p cell, ascending. The first three
    /// are 0, 1, 2 on every cell. The reference stays valid.
    virtual const std::vector<unsigned int> &
    cell_functions(const unsigned int cell) const = 0;

    /// cell_functions() and the geometry at @p unit of the unit square. @p unit
    /// may lie outside of the square a little; the map and the functions are
    /// continued.
    virtual FunctionValues
    evaluate(const unsigned int cell, const dealii::Point<2> &unit) const = 0;

    /// The geometry alone, for searches. The same position and Jacobian as
    /// evaluate() gives, for less.
    virtual SectionGeometry::Place
    map(const unsigned int cell, const dealii::Point<2> &unit) const = 0;

    /// Points that fix the trace of the expansion on the boundary named
    /// @p boundary, with outward normals and weights. Their weights are
    /// integrals of the trace's nodal functions, which sum to the length of the
    /// boundary. None for a name that no side has.
    virtual std::vector<EdgePoint>
    edge_points(const std::string &boundary) const = 0;

    /// Points that fix the expansion on the whole section, as few as that takes
    /// (normal and weight not set). What holds the displacement there holds it
    /// everywhere on the section: a clamp. The number of points is
    /// n_functions().
    virtual std::vector<EdgePoint>
    section_points() const = 0;

    /// A grid of points of the section with the areas that belong to them, all
    /// positive and (on straight cells) the whole area in all; normal not set.
    /// The tributary areas of a beam's end faces.
    virtual std::vector<EdgePoint>
    section_grid() const = 0;

    /// edge_points() and section_grid() for the functions of @p degree and less
    /// (function_degree()): as few as these take. Those for all functions if
    /// they are not hierarchical by degree.
    virtual std::vector<EdgePoint>
    coarse_edge_points(const std::string &boundary, const unsigned int) const
    {
      return edge_points(boundary);
    }
    virtual std::vector<EdgePoint>
    coarse_section_grid(const unsigned int) const
    {
      return section_grid();
    }

    /// The sides of cells, as pairs of cell and face, of the boundary @p name.
    /// Faces as deal.II numbers those of the unit square: xi = 0, xi = 1, eta =
    /// 0, eta = 1. In the order of the cells.
    std::vector<std::pair<unsigned int, unsigned int>>
    boundary_faces(const std::string &name) const;

    /// The point at the parameter @p t of the side @p face of @p cell, on the
    /// boundary; its weight is the length per unit of the parameter. @p t from
    /// 0 to 1.
    EdgePoint
    edge_point(const unsigned int cell,
               const unsigned int face,
               const double       t) const;

    const SectionMesh &
    section_mesh() const
    {
      return *mesh;
    }

    /// The same, to be shared.
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

    /// Of the section; curved edges may leave it a little. It is the box of the
    /// mesh's vertices [length].
    dealii::BoundingBox<2>
    bounding_box() const;

  protected:
    /// Values of the first three functions, geometry as given. 1, (x - x_c) /
    /// h, (z - z_c) / h and their gradients, exact at any point: what derived
    /// classes append the others to.
    FunctionValues
    linear_functions(const dealii::Point<2>     &position,
                     const dealii::Tensor<2, 2> &jacobian) const;

    /// Integrals over a side of a nodal function times n, and alone.
    struct SideShare
    {
      dealii::Tensor<1, 2> scaled_normal;
      double               weight = 0.;
    };

    /**
     * Adds a side's share of normal and length to @p point, at whose place the
     * side's own normal is @p own_normal; marks corners of more than 20
     * degrees.
     * @p share is that of the point's nodal function; who calls it divides the
     * sum of normals by its length in the end.
     */
    static void
    add_side(EdgePoint                  &point,
             const SideShare            &share,
             const dealii::Tensor<1, 2> &own_normal);

    /// Those of @p shape, a function of the side's parameter, over the side
    /// @p face of @p cell. [length]
    SideShare
    side_share(const unsigned int                         cell,
               const unsigned int                         face,
               const dealii::Quadrature<1>               &quadrature,
               const std::function<double(const double)> &shape) const;

    /// The point at @p unit of @p cell, nothing but its place set.
    EdgePoint
    point_at(const unsigned int cell, const dealii::Point<2> &unit) const;

    /// The depth of @p cell behind its side @p face: area over length of side.
    /// Taken in the middle of the side. [length]
    double
    depth(const unsigned int cell, const unsigned int face) const;

    /// (x_c, z_c) is the centre of area of the cells, their sides taken
    /// straight, h half the diagonal of the bounding box. @p mesh is not null.
    explicit CrossSectionElement(std::shared_ptr<const SectionMesh> mesh);

    /// The section mesh; (x_c, z_c) and h [length].
    std::shared_ptr<const SectionMesh> mesh;
    dealii::Point<2>                   origin;
    double                             length;
  };

  /// The point of the unit square at the parameter @p t in [0, 1] of @p face.
  /// It runs in the direction of the square's axes: of faces 0 and 1 along eta,
  /// of 2 and 3 along xi.
  dealii::Point<2>
  face_point(const unsigned int face, const double t);

  /**
   * The outward normal, scaled with the length of face per unit of its
   * parameter, where @p jacobian is that of the cell's map.
   *
   * By Nanson's formula in the plane,
   *   n ds = det(J) J^-T N dt,
   * N the face's normal on the unit square. [length]
   */
  dealii::Tensor<1, 2>
  scaled_face_normal(const unsigned int          face,
                     const dealii::Tensor<2, 2> &jacobian);
} // namespace lamella

#endif
