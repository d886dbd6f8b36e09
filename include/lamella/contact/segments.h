// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_segments_h
#define lamella_contact_segments_h

#include <lamella/contact/mesh_surface.h>
#include <lamella/contact/polygon.h>

#include <array>
#include <vector>

namespace lamella
{
  /// Chord plane of a quadrilateral part of a surface, in which mortar segments
  /// are cut: through its first corner, parallel to both diagonals, with axes
  /// along its first side and normal to that side.
  struct ChordPlane
  {
    /// Creates the plane of @p corners at (0, 0), (1, 0), (0, 1), (1, 1) of a
    /// facet or a part of it. The normal points to the side of @p outward.
    ChordPlane(const std::array<dealii::Point<3>, 4> &corners,
               const dealii::Tensor<1, 3>            &outward);

    /// Returns the coordinates along e1 and e2 [length] of @p x, projected
    /// along @p direction, which must not lie in the plane.
    dealii::Point<2>
    project(const dealii::Point<3>     &x,
            const dealii::Tensor<1, 3> &direction) const;

    /// First corner, and an orthonormal right-handed frame with outward normal.
    dealii::Point<3>     origin;
    dealii::Tensor<1, 3> e1, e2, normal;
    /// Polygon of the corners projected along the normal; area [length^2].
    Polygon outline;
    double  area = 0.;
  };

  /// A mortar segment, on which integrands are smooth: the intersection of a
  /// part of a surface and a facet of the other surface, in the chord plane.
  struct Segment
  {
    /// Facet of the other surface; polygon and area in the chord plane.
    unsigned int facet = 0;
    Polygon      polygon;
    double       area = 0.;
  };

  /// Returns the mortar segments of the part of a surface with chord plane
  /// @p plane and the facets of @p other within @p search_radius, projected
  /// along @p direction (the averaged normal at the center of the part), in
  /// ascending order of facets. Omits segments below 1e-11 of the area, and
  /// facets seen from behind or from the side (cosine to @p direction below
  /// 0.1). Segments of facets behind each other overlap.
  std::vector<Segment>
  cut(const ChordPlane           &plane,
      const dealii::Tensor<1, 3> &direction,
      const MeshSurface          &other,
      const double                search_radius);
} // namespace lamella

#endif
