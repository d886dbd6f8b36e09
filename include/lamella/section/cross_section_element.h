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
  /// Nonzero expansion functions F_tau at a point of a cell, with geometry.
  struct FunctionValues
  {
    /// Point x, z and Jacobian d(x, z) / d(xi, eta), body frame [length].
    dealii::Point<2>     position;
    dealii::Tensor<2, 2> jacobian;
    /// F_tau [no unit] and their gradients (d/dx, d/dz) [1 / length].
    std::vector<double>               values;
    std::vector<dealii::Tensor<1, 2>> gradients;
  };

  /// A point of a section with its tributary length or area, for the
  /// collocation of contact, loads and supports. Along the axis each becomes a
  /// SurfacePoint.
  struct EdgePoint
  {
    /// Coordinates x, z in the section's plane [length], and the unit outward
    /// normal, the weighted mean where two sides meet.
    dealii::Point<2>     position;
    dealii::Tensor<1, 2> normal;
    /// Tributary length [length], the integral of the point's shape function.
    /// For points of the whole section an area [length^2].
    double weight = 0.;
    /// Flag of a corner: normals of sides differ by more than 20 degrees.
    bool corner = false;
    /// A cell with the point, the position on its unit square, and the cell's
    /// area over the length of its side at the boundary [length]; 0 inside.
    unsigned int     cell = 0;
    dealii::Point<2> unit;
    double           depth = 0.;
  };

  /**
   * The cross-section expansion F_tau(x, z), tau = 0 ... n_functions() - 1, of
   * the paper's Eq. 1 on a section mesh, immutable and sharing the mesh.
   *
   * Its first three functions are 1, (x - x_c) / h and (z - z_c) / h,
   * differentiated analytically. Rigid motions of the section are then DoFs of
   * their own, and slender beams keep their bending energy
   * (doc/theory/stable-basis.md). The others are warping: TaylorElement
   * (equivalent single layer) and LagrangeElement (layer-wise) define them.
   * Each cell is the image of the unit square under a map (xi, eta) -> (x, z).
   */
  class CrossSectionElement
  {
  public:
    virtual ~CrossSectionElement() = default;

    /// Returns the polynomial degree on a cell, N of TE-N, p of LE-p.
    virtual unsigned int
    degree() const = 0;

    /// Returns the polynomial degree of positions and functions on a side.
    virtual unsigned int
    trace_degree() const
    {
      return degree();
    }

    /// Returns the number of Gauss points per direction and cell that integrate
    /// products of two functions exactly on straight cells.
    virtual unsigned int
    n_gauss_points() const
    {
      return degree() + 1;
    }

    /// Returns M of Eq. 1.
    virtual unsigned int
    n_functions() const = 0;

    /// Returns 0 for 1, x, z, higher for others. Coarse DoFs are eliminated
    /// first.
    virtual unsigned int
    level(const unsigned int tau) const
    {
      return tau < 3 ? 0 : 1;
    }

    /// Returns for functions hierarchical by degree the smallest q of LE-q that
    /// contains the function, else degree().
    virtual unsigned int
    function_degree(const unsigned int) const
    {
      return degree();
    }

    /// Returns the nonzero functions on @p cell, ascending, beginning with 0,
    /// 1, 2.
    virtual const std::vector<unsigned int> &
    cell_functions(const unsigned int cell) const = 0;

    /// Returns cell_functions() and the geometry at @p unit, possibly slightly
    /// outside of the unit square.
    virtual FunctionValues
    evaluate(const unsigned int cell, const dealii::Point<2> &unit) const = 0;

    /// Returns only the geometry of evaluate(), faster.
    virtual SectionGeometry::Place
    map(const unsigned int cell, const dealii::Point<2> &unit) const = 0;

    /// Returns points that determine the trace on the boundary @p boundary,
    /// with outward normals and integrals of nodal functions as weights. None
    /// for an unknown name.
    virtual std::vector<EdgePoint>
    edge_points(const std::string &boundary) const = 0;

    /// Returns n_functions() points that determine the expansion on the whole
    /// section, without normal and weight.
    virtual std::vector<EdgePoint>
    section_points() const = 0;

    /// Returns points with their areas, all positive, for end faces of a beam;
    /// normal not set.
    virtual std::vector<EdgePoint>
    section_grid() const = 0;

    /// Return edge_points() and section_grid() for functions of @p degree and
    /// less (function_degree()).
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

    /// Returns the sides on boundary @p name as pairs of cell and face,
    /// numbered as deal.II's, by cell.
    std::vector<std::pair<unsigned int, unsigned int>>
    boundary_faces(const std::string &name) const;

    /// Returns the point at @p t in [0, 1] on the boundary side @p face of
    /// @p cell; its weight is the length per unit of the parameter.
    EdgePoint
    edge_point(const unsigned int cell,
               const unsigned int face,
               const double       t) const;

    const SectionMesh &
    section_mesh() const
    {
      return *mesh;
    }

    /// Returns the mesh, shared.
    std::shared_ptr<const SectionMesh>
    shared_mesh() const
    {
      return mesh;
    }

    /// Returns (x_c, z_c) of the linear functions; reference_length() is h.
    dealii::Point<2>
    center() const
    {
      return origin;
    }

    double
    reference_length() const
    {
      return length;
    }

    /// Returns the box of the mesh's vertices [length].
    dealii::BoundingBox<2>
    bounding_box() const;

  protected:
    /// Returns 1, (x - x_c) / h, (z - z_c) / h with exact gradients.
    FunctionValues
    linear_functions(const dealii::Point<2>     &position,
                     const dealii::Tensor<2, 2> &jacobian) const;

    /// Integrals over a side of a nodal function times n, and alone.
    struct SideShare
    {
      dealii::Tensor<1, 2> scaled_normal;
      double               weight = 0.;
    };

    /// Adds a side's @p share of normal and length to @p point, where the side
    /// has the normal @p own_normal; marks corners. The caller finally
    /// normalizes the sum of normals.
    static void
    add_side(EdgePoint                  &point,
             const SideShare            &share,
             const dealii::Tensor<1, 2> &own_normal);

    /// Returns the integrals of @p shape, a function of the side's parameter,
    /// over the side @p face of @p cell [length].
    SideShare
    side_share(const unsigned int                         cell,
               const unsigned int                         face,
               const dealii::Quadrature<1>               &quadrature,
               const std::function<double(const double)> &shape) const;

    /// Returns the point at @p unit of @p cell with only its place set.
    EdgePoint
    point_at(const unsigned int cell, const dealii::Point<2> &unit) const;

    /// Returns the area of @p cell over the length of side @p face [length].
    double
    depth(const unsigned int cell, const unsigned int face) const;

    /// Sets (x_c, z_c) to the centroid of the cells with straight sides, h to
    /// half the diagonal of the bounding box.
    explicit CrossSectionElement(std::shared_ptr<const SectionMesh> mesh);

    /// Section mesh; (x_c, z_c) and h [length].
    std::shared_ptr<const SectionMesh> mesh;
    dealii::Point<2>                   origin;
    double                             length;
  };

  /// Returns the point of the unit square at @p t in [0, 1] of @p face. Faces 0
  /// and 1 are along eta, faces 2 and 3 along xi.
  dealii::Point<2>
  face_point(const unsigned int face, const double t);

  /// Returns the outward normal, scaled with the length of @p face per unit of
  /// its parameter, by Nanson's formula
  ///   n ds = det(J) J^-T N dt
  /// with the @p jacobian J and the face's normal N on the unit square.
  dealii::Tensor<1, 2>
  scaled_face_normal(const unsigned int          face,
                     const dealii::Tensor<2, 2> &jacobian);
} // namespace lamella

#endif
