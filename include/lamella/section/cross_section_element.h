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
  /// Values and gradients of the nonzero functions F_tau at a point of a cell.
  struct FunctionValues
  {
    /// Position x, z of the body, Jacobian d(x, z) / d(xi, eta) [length].
    dealii::Point<2>     position;
    dealii::Tensor<2, 2> jacobian;
    /// Values F_tau [no unit] and gradients (d/dx, d/dz) F_tau [1 / length].
    std::vector<double>               values;
    std::vector<dealii::Tensor<1, 2>> gradients;
  };

  /// A collocation point of a section for contact, loads and supports, with its
  /// tributary length or area. Combined with nodes of the axis, it becomes a
  /// SurfacePoint of the beam.
  struct EdgePoint
  {
    /// Position x, z [length], and outward unit normal; at a vertex, the
    /// weighted mean of the normals of both sides.
    dealii::Point<2>     position;
    dealii::Tensor<1, 2> normal;
    /// Integral of the shape function of the point: a tributary length [length]
    /// on a boundary, an area [length^2] for points of the whole section.
    double weight = 0.;
    /// True if the normals of two sides differ by more than 20 degrees.
    bool corner = false;
    /// A cell that contains the point, the reference coordinates of the point,
    /// and for points on a boundary the depth of the cell [length], which is
    /// its area divided by the length of its side on the boundary.
    unsigned int     cell = 0;
    dealii::Point<2> unit;
    double           depth = 0.;
  };

  /// The cross-section expansion of a beam theory: the functions F_tau(x, z),
  /// tau = 0 ... n_functions() - 1, of the displacement u = sum_tau F_tau
  /// u_tau(y), on a section mesh. Immutable; shares the ownership of the mesh.
  ///
  /// The first three functions are 1, (x - x_c) / h and (z - z_c) / h, with the
  /// centroid (x_c, z_c) and a reference length h. Rigid motions of the section
  /// are thus separate DoFs, which keeps rounding errors small in slender beams
  /// (doc/theory/stable-basis.md). The warping functions tau > 2 are defined by
  /// TaylorElement (equivalent single layer) and LagrangeElement (layer-wise).
  /// Cells are images of the unit square (xi, eta).
  class CrossSectionElement
  {
  public:
    virtual ~CrossSectionElement() = default;

    /// Returns the polynomial degree of the expansion, N of TE-N or p of LE-p.
    virtual unsigned int
    degree() const = 0;

    /// Returns the degree of positions and functions as polynomials of the
    /// parameter of a cell's side.
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

    /// Returns the number M of functions F_tau (Eq. 1).
    virtual unsigned int
    n_functions() const = 0;

    /// Returns the level of function @p tau: 0 for the three linear functions,
    /// higher for finer ones. Supports eliminate DoFs of low level first.
    virtual unsigned int
    level(const unsigned int tau) const
    {
      return tau < 3 ? 0 : 1;
    }

    /// Returns the smallest degree q for which LE-q contains the function, if
    /// the functions are hierarchical; otherwise degree().
    virtual unsigned int
    function_degree(const unsigned int) const
    {
      return degree();
    }

    /// Returns the numbers of the functions that are nonzero on @p cell,
    /// ascending, beginning with 0, 1, 2.
    virtual const std::vector<unsigned int> &
    cell_functions(const unsigned int cell) const = 0;

    /// Evaluates the cell_functions() of @p cell at the reference coordinates
    /// @p unit, which may be slightly outside of the unit square.
    virtual FunctionValues
    evaluate(const unsigned int cell, const dealii::Point<2> &unit) const = 0;

    /// Returns position and Jacobian at @p unit without evaluating functions.
    virtual SectionGeometry::Place
    map(const unsigned int cell, const dealii::Point<2> &unit) const = 0;

    /// Returns points on @p boundary whose displacements determine those of the
    /// whole boundary, with normals and tributary lengths; no points if no
    /// boundary has this name.
    virtual std::vector<EdgePoint>
    edge_points(const std::string &boundary) const = 0;

    /// Returns n_functions() points whose displacements determine those of the
    /// whole section, without normals and weights.
    virtual std::vector<EdgePoint>
    section_points() const = 0;

    /// Returns points of an end face of the beam with their positive tributary
    /// areas, without normals.
    virtual std::vector<EdgePoint>
    section_grid() const = 0;

    /// Return edge_points() and section_grid() for the functions up to a degree
    /// (function_degree()). These default implementations ignore the degree.
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

    /// Returns the sides on the boundary @p name as pairs of cell and face
    /// number (deal.II's), sorted by cell.
    std::vector<std::pair<unsigned int, unsigned int>>
    boundary_faces(const std::string &name) const;

    /// Returns the point at the parameter @p t in [0, 1] on the boundary side
    /// @p face of @p cell. Its weight is ds/dt, with the arc length s.
    EdgePoint
    edge_point(const unsigned int cell,
               const unsigned int face,
               const double       t) const;

    const SectionMesh &
    section_mesh() const
    {
      return *mesh;
    }

    /// Returns the mesh with shared ownership.
    std::shared_ptr<const SectionMesh>
    shared_mesh() const
    {
      return mesh;
    }

    /// Return (x_c, z_c) and h of the three linear functions.
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

    /// Returns the bounding box of the vertices of the mesh [length].
    dealii::BoundingBox<2>
    bounding_box() const;

  protected:
    /// Evaluates the three linear functions at @p position.
    FunctionValues
    linear_functions(const dealii::Point<2>     &position,
                     const dealii::Tensor<2, 2> &jacobian) const;

    /// Integrals int N n ds, int N ds of a nodal function N over a side with
    /// normal n.
    struct SideShare
    {
      dealii::Tensor<1, 2> scaled_normal;
      double               weight = 0.;
    };

    /// Adds the integrals @p share of a side to the normal and weight of
    /// @p point. Sets EdgePoint::corner from the side's normal @p own_normal at
    /// the point. The caller normalizes the sum of normals.
    static void
    add_side(EdgePoint                  &point,
             const SideShare            &share,
             const dealii::Tensor<1, 2> &own_normal);

    /// Integrates the nodal function @p shape, given on the side's parameter in
    /// [0, 1], over the side @p face of @p cell [length].
    SideShare
    side_share(const unsigned int                         cell,
               const unsigned int                         face,
               const dealii::Quadrature<1>               &quadrature,
               const std::function<double(const double)> &shape) const;

    /// Returns the point at @p unit of @p cell, without normal and weight.
    EdgePoint
    point_at(const unsigned int cell, const dealii::Point<2> &unit) const;

    /// Returns area of @p cell divided by length of side @p face [length].
    double
    depth(const unsigned int cell, const unsigned int face) const;

    /// Computes the centroid (x_c, z_c), as if cells had straight sides. h is
    /// half the diagonal of the bounding box.
    explicit CrossSectionElement(std::shared_ptr<const SectionMesh> mesh);

    /// Section mesh, centroid (x_c, z_c) and reference length h [length].
    std::shared_ptr<const SectionMesh> mesh;
    dealii::Point<2>                   origin;
    double                             length;
  };

  /// Returns the point of the unit square at the parameter @p t in [0, 1] of
  /// @p face. Faces 0 and 1 are along eta, faces 2 and 3 along xi.
  dealii::Point<2>
  face_point(const unsigned int face, const double t);

  /// Returns the outward normal n ds/dt of @p face, with unit normal n, arc
  /// length s and parameter t, by Nanson's formula
  ///   n ds = det(J) J^-T N dt
  /// where J is the @p jacobian and N the normal on the unit square.
  dealii::Tensor<1, 2>
  scaled_face_normal(const unsigned int          face,
                     const dealii::Tensor<2, 2> &jacobian);
} // namespace lamella

#endif
