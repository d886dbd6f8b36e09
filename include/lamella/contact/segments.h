// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_segments_h
#define lamella_contact_segments_h

#include <lamella/contact/mesh_surface.h>
#include <lamella/contact/polygon.h>

#include <array>
#include <vector>

namespace lamella
{
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
