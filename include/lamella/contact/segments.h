// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_segments_h
#define lamella_contact_segments_h

#include <lamella/contact/mesh_surface.h>
#include <lamella/contact/polygon.h>

#include <array>
#include <vector>

namespace lamella
{
  /// Chord plane of a quadrilateral piece of a surface, with axes along its
  /// first side and normal to it: the plane through the first corner along both
  /// diagonals. Mortar segments are cut there; curved patches become polygons.
  struct ChordPlane
  {
    /// Creates the plane of @p corners at (0, 0), (1, 0), (0, 1), (1, 1) of a
    /// facet or of a part of it; @p outward determines the sign of the normal.
    /// The diagonals must span a plane.
    ChordPlane(const std::array<dealii::Point<3>, 4> &corners,
               const dealii::Tensor<1, 3>            &outward);

    /// Returns the projection of @p x along @p direction: coordinates along e1
    /// and e2 from the origin [length]. @p direction must not lie in the plane;
    /// its length is irrelevant.
    dealii::Point<2>
    project(const dealii::Point<3>     &x,
            const dealii::Tensor<1, 3> &direction) const;

    /// First corner, and an orthonormal right-handed frame with outward normal,
    /// in scene axes.
    dealii::Point<3>     origin;
    dealii::Tensor<1, 3> e1, e2, normal;
    /// Corners projected along the normal, and the area of that [length^2].
    Polygon outline;
    double  area = 0.;
  };

  /// A mortar segment: the intersection of a piece of a surface and one facet
  /// of another, in the chord plane of the piece. Integrands are smooth on it.
  struct Segment
  {
    /// Facet of the other surface; polygon and area [length^2] in the chord
    /// plane.
    unsigned int facet = 0;
    Polygon      polygon;
    double       area = 0.;
  };

  /// Returns the segments of the piece @p plane with the facets of @p other
  /// within @p search_radius, projected along @p direction (the averaged normal
  /// at the center of the piece), by ascending facets. Omits segments below
  /// 1e-11 of the area of the piece, and facets seen from the side (normal
  /// within a cosine of 0.1 of perpendicular to @p direction) or from behind.
  /// Segments of facets behind each other overlap.
  std::vector<Segment>
  cut(const ChordPlane           &plane,
      const dealii::Tensor<1, 3> &direction,
      const MeshSurface          &other,
      const double                search_radius);
} // namespace lamella

#endif
