// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_segments_h
#define lamella_contact_segments_h

#include <lamella/contact/mesh_surface.h>

#include <deal.II/base/point.h>
#include <deal.II/base/quadrature.h>

#include <array>
#include <functional>
#include <vector>

namespace lamella
{
  /// Corners of a convex polygon, counterclockwise, with coordinates in a plane
  /// [length] or in the unit square of a surface facet. It may be empty.
  using Polygon = std::vector<dealii::Point<2>>;

  /// Returns the area: 0 below three corners, negative if clockwise.
  double
  area(const Polygon &polygon);

  /// Returns the centroid of @p polygon, whose area must not vanish.
  dealii::Point<2>
  centroid(const Polygon &polygon);

  /// Returns the intersection of @p polygon and @p window, both convex and
  /// counterclockwise (Sutherland-Hodgman clipping). It may be empty.
  Polygon
  clipped(const Polygon &polygon, const Polygon &window);

  /// Returns the subset of the convex @p polygon on which @p height,
  /// interpolated linearly along the sides, is not negative. Called with
  /// -height, the function returns the complement, with bitwise the same edge.
  Polygon
  part_above(const Polygon                                         &polygon,
             const std::function<double(const dealii::Point<2> &)> &height);

  /// Returns a quadrature rule on the triangle (0, 0), (1, 0), (0, 1), exact
  /// for polynomials of degree @p degree, with positive weights that sum to
  /// 1/2: Witherden and Vincent's up to degree 13, above it Gauss points of the
  /// square collapsed onto the triangle. Its cache is not thread-safe.
  const dealii::Quadrature<2> &
  triangle_rule(const unsigned int degree);

  /// Plane in which mortar segments of a quadrilateral surface patch are cut.
  /// It contains the first corner and is parallel to both diagonals, with axes
  /// along the first side and normal to that side.
  struct ChordPlane
  {
    /// Creates the plane of a facet, or of a part of it, from its @p corners at
    /// the facet coordinates (0, 0), (1, 0), (0, 1), (1, 1). The normal points
    /// to the side of the vector @p outward.
    ChordPlane(const std::array<dealii::Point<3>, 4> &corners,
               const dealii::Tensor<1, 3>            &outward);

    /// Returns the in-plane coordinates along e1 and e2 [length] of the point
    /// @p x projected along @p direction, which must cross the plane.
    dealii::Point<2>
    project(const dealii::Point<3>     &x,
            const dealii::Tensor<1, 3> &direction) const;

    dealii::Point<3>     origin; ///< First corner, origin of coordinates.
    dealii::Tensor<1, 3> e1,     ///< Unit vector along the first side.
      e2,                        ///< Unit vector normal x e1.
      normal;                    ///< Unit normal of the plane, outward.
    Polygon outline;   ///< Corners projected along the normal [length].
    double  area = 0.; ///< Area of the outline [length^2].
  };

  /// A mortar segment, on which integrands are smooth: the intersection of a
  /// patch of one surface and a facet of the other surface, in the chord plane.
  struct Segment
  {
    unsigned int facet = 0; ///< Index of the facet of the other surface.
    Polygon      polygon;   ///< Corners in the chord plane [length].
    double       area = 0.; ///< Area of the polygon [length^2].
  };

  /// Returns the mortar segments of the surface patch with chord plane @p plane
  /// and the facets of @p other within @p search_radius [length]. Both are
  /// projected along @p direction, the averaged normal at the center of the
  /// patch. Segments are in ascending order of facets. Segments below 1e-11 of
  /// the area are omitted, as are facets seen from behind or from the side
  /// (cosine to @p direction below 0.1). Segments may overlap.
  std::vector<Segment>
  cut(const ChordPlane           &plane,
      const dealii::Tensor<1, 3> &direction,
      const MeshSurface          &other,
      const double                search_radius);
} // namespace lamella

#endif
