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
  /// Values and gradients of the expansion functions F_tau(x, z) that are
  /// nonzero on a cell of a section mesh, at a point of this cell.
  struct FunctionValues
  {
    dealii::Point<2>     position; ///< x, z [length].
    dealii::Tensor<2, 2> jacobian; ///< d(x, z) / d(xi, eta) [length].
    /// Values [no unit] and, below, gradients [1 / length] of the functions, in
    /// the order of CrossSectionElement::cell_functions().
    std::vector<double>               values;
    std::vector<dealii::Tensor<1, 2>> gradients; ///< (d/dx, d/dz) F_tau.
  };

  /// A point of a section at which contact, loads or supports may act, with its
  /// tributary length or area. At axis nodes, it becomes a SurfacePoint.
  struct EdgePoint
  {
    dealii::Point<2> position; ///< x, z [length].
    /// Outward unit normal; at a vertex, the weighted mean of both sides.
    dealii::Tensor<1, 2> normal;
    /// Tributary length [length] on a boundary, or area [length^2] for points
    /// of the whole section: integral of the nodal function of the point.
    double weight = 0.;
    /// True at a vertex whose side normals differ by more than 20 degrees.
    bool             corner = false;
    unsigned int     cell   = 0; ///< A section cell that contains the point.
    dealii::Point<2> unit; ///< Coordinates xi, eta of the point in the cell.
    /// Area of the cell divided by the length of its side on the boundary
    /// [length]; zero for points that are not on a boundary.
    double depth = 0.;
  };

  /// The cross-section expansion of a beam theory: functions F_tau(x, z), tau =
  /// 0 ... n_functions() - 1, on a section mesh. The displacement is the sum of
  /// F_tau u_tau(y) over tau. Immutable; shares the ownership of the mesh.
  ///
  /// The first three functions are 1, (x - x_c) / h and (z - z_c) / h, with the
  /// centroid (x_c, z_c) and a reference length h. Rigid motions of the section
  /// are thus separate DoFs, which keeps rounding errors small in slender beams
  /// (doc/theory/stable-basis.md). TaylorElement (equivalent single layer) and
  /// LagrangeElement (layer-wise) define the functions tau > 2. Cells are
  /// images of the unit square (xi, eta).
  class CrossSectionElement
  {
  public:
    virtual ~CrossSectionElement() = default;

    /// Returns the polynomial degree of the expansion, N of TE-N or p of LE-p.
    virtual unsigned int
    degree() const = 0;

    /// Returns the polynomial degree of positions and functions on cell sides.
    virtual unsigned int
    trace_degree() const
    {
      return degree();
    }

    /// Returns the number of Gauss points per direction and cell, which
    /// integrate products of two functions exactly on straight-sided cells.
    virtual unsigned int
    n_gauss_points() const
    {
      return degree() + 1;
    }

    /// Returns the number of expansion functions F_tau.
    virtual unsigned int
    n_functions() const = 0;

    /// Returns the rank of function @p tau for supports, which eliminate DoFs
    /// of low rank first: 0 for the three linear functions.
    virtual unsigned int
    level(const unsigned int tau) const
    {
      return tau < 3 ? 0 : 1;
    }

    /// Returns, for hierarchical functions, the lowest degree q such that LE-q
    /// contains the function with the index in the argument; else degree().
    virtual unsigned int
    function_degree(const unsigned int) const
    {
      return degree();
    }

    /// Returns the indices of the functions that are nonzero on @p cell,
    /// ascending, beginning with 0, 1, 2.
    virtual const std::vector<unsigned int> &
    cell_functions(const unsigned int cell) const = 0;

    /// Evaluates the functions cell_functions() of @p cell at the coordinates
    /// @p unit = (xi, eta), which may be slightly outside of the unit square.
    virtual FunctionValues
    evaluate(const unsigned int cell, const dealii::Point<2> &unit) const = 0;

    /// Returns the position (x, z) and the Jacobian of @p cell at the
    /// coordinates @p unit = (xi, eta).
    SectionGeometry::Place
    map(const unsigned int cell, const dealii::Point<2> &unit) const
    {
      return geometry.map(cell, unit);
    }

    /// Returns points on @p boundary whose displacements determine those of the
    /// whole boundary, with normals and tributary lengths. Empty if there is no
    /// boundary of this name.
    virtual std::vector<EdgePoint>
    edge_points(const std::string &boundary) const = 0;

    /// Returns n_functions() points whose displacements determine those of the
    /// whole section, without normals and weights.
    virtual std::vector<EdgePoint>
    section_points() const = 0;

    /// Returns points of the whole section (an end face of the beam) with
    /// positive tributary areas, without normals.
    virtual std::vector<EdgePoint>
    section_grid() const = 0;

    /// Returns edge_points() for axis nodes that have only functions up to a
    /// degree (second argument, see function_degree()). The default ignores it.
    virtual std::vector<EdgePoint>
    coarse_edge_points(const std::string &boundary, const unsigned int) const
    {
      return edge_points(boundary);
    }
    /// Returns section_grid() for axis nodes that have only functions up to a
    /// degree (the argument). The default ignores it.
    virtual std::vector<EdgePoint>
    coarse_section_grid(const unsigned int) const
    {
      return section_grid();
    }

    /// Returns the cell sides on the boundary @p name as pairs of cell index
    /// and face number (deal.II's numbering), sorted by cell.
    std::vector<std::pair<unsigned int, unsigned int>>
    boundary_faces(const std::string &name) const;

    /// Returns the point at the parameter @p t in [0, 1] on the boundary side
    /// @p face of @p cell. Its weight is ds/dt, where s is the arc length.
    EdgePoint
    edge_point(const unsigned int cell,
               const unsigned int face,
               const double       t) const;

    /// Returns the section mesh.
    const SectionMesh &
    section_mesh() const
    {
      return *mesh;
    }

    /// Returns the section mesh with shared ownership.
    std::shared_ptr<const SectionMesh>
    shared_mesh() const
    {
      return mesh;
    }

    /// Returns the centroid (x_c, z_c) in the linear functions [length].
    dealii::Point<2>
    center() const
    {
      return origin;
    }

    /// Returns the length h in the linear functions [length].
    double
    reference_length() const
    {
      return length;
    }

    /// Returns the bounding box of the vertices of the mesh [length].
    dealii::BoundingBox<2>
    bounding_box() const;

  protected:
    /// Evaluates the functions 1, x and z and their gradients at @p position;
    /// @p jacobian is copied to the result.
    FunctionValues
    linear_functions(const dealii::Point<2>     &position,
                     const dealii::Tensor<2, 2> &jacobian) const;

    /// Integrals of a nodal function N over a side of a cell.
    struct SideShare
    {
      dealii::Tensor<1, 2> scaled_normal; ///< int N n ds, n: normal.
      double               weight = 0.;   ///< int N ds [length].
    };

    /// Adds the integrals @p share of a side to normal and weight of @p point;
    /// the caller normalizes the normal after the last side. Sets
    /// EdgePoint::corner if the normals of this side (@p own_normal) and of the
    /// previous one differ.
    static void
    add_side(EdgePoint                  &point,
             const SideShare            &share,
             const dealii::Tensor<1, 2> &own_normal);

    /// Integrates the nodal function @p shape over the side @p face of @p cell.
    /// The argument of @p shape is the side's parameter in [0, 1].
    SideShare
    side_share(const unsigned int                         cell,
               const unsigned int                         face,
               const dealii::Quadrature<1>               &quadrature,
               const std::function<double(const double)> &shape) const;

    /// Returns the point of @p cell at (xi, eta) = @p unit, without normal.
    EdgePoint
    point_at(const unsigned int cell, const dealii::Point<2> &unit) const;

    /// Returns area of @p cell divided by length of side @p face [length].
    double
    depth(const unsigned int cell, const unsigned int face) const;

    /// Computes the centroid (x_c, z_c) of @p mesh with straight cell sides,
    /// and the length h, half the diagonal of the bounding box. Cells are
    /// mapped with degree @p geometric_degree.
    CrossSectionElement(const std::shared_ptr<const SectionMesh> &mesh,
                        const unsigned int geometric_degree);

    std::shared_ptr<const SectionMesh> mesh;     ///< Section mesh.
    SectionGeometry                    geometry; ///< Map of the cells.
    dealii::Point<2>                   origin;   ///< (x_c, z_c) [length].
    double                             length;   ///< Reference length [length].
  };

  /// Returns the point (xi, eta) of the unit square at the parameter @p t in
  /// [0, 1] of @p face. Faces 0 and 1 are along eta, faces 2 and 3 along xi.
  dealii::Point<2>
  face_point(const unsigned int face, const double t);

  /// Returns n ds/dt on side @p face of a cell, with the outward unit normal n,
  /// the arc length s and the parameter t of the side, by Nanson's formula
  ///   n ds = det(J) J^-T N dt
  /// where J is the @p jacobian and N the normal on the unit square.
  dealii::Tensor<1, 2>
  scaled_face_normal(const unsigned int          face,
                     const dealii::Tensor<2, 2> &jacobian);
} // namespace lamella

#endif
