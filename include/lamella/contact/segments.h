// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_segments_h
#define lamella_contact_segments_h

#include <lamella/contact/mesh_surface.h>
#include <lamella/contact/polygon.h>

#include <array>
#include <vector>

namespace lamella
{
  /**
   * A quadrilateral piece of a surface, in the plane of its chords, with axes
   * along its first side and across.
   *
   * The plane through the first corner along both diagonals, in which mortar
   * segments are cut: straight sides make polygons of what are curved patches.
   */
  struct ChordPlane
  {
    /// @p corners at (0, 0), (1, 0), (0, 1), (1, 1) of a facet or of a part of
    /// it; @p outward tells the side that the normal is to look to. The piece
    /// must not be degenerate: its diagonals span the plane.
    ChordPlane(const std::array<dealii::Point<3>, 4> &corners,
               const dealii::Tensor<1, 3>            &outward);

    /// The place of @p x in the plane, moved along @p direction. Coordinates
    /// along e1 and e2 from the origin [length]. @p direction must not lie in
    /// the plane; its length does not matter.
    dealii::Point<2>
    project(const dealii::Point<3>     &x,
            const dealii::Tensor<1, 3> &direction) const;

    /// The first corner; an orthonormal right-handed frame with the normal
    /// outwards. Scene axes.
    dealii::Point<3>     origin;
    dealii::Tensor<1, 3> e1, e2, normal;
    /// The corners projected along the normal, and the area of that [length^2].
    Polygon outline;
    double  area = 0.;
  };

  /// What a piece of a surface and one facet of another have in common, in the
  /// piece's chord plane. A mortar segment: on it no integrand has a kink.
  struct Segment
  {
    /// Of the other surface; polygon and area [length^2] in the chord plane.
    unsigned int facet = 0;
    Polygon      polygon;
    double       area = 0.;
  };

  /**
   * Cuts the piece @p plane with the facets of @p other that lie within
   * @p reach, projected along @p direction (the averaged normal in the middle
   * of the piece). Slivers below 1e-11 of the piece's area are left out.
   *
   * Facets that are seen from the side, their normal within a cosine of 0.1 of
   * square to @p direction or turned away, are left out as well. Segments of
   * facets that lie behind each other overlap. By ascending facets.
   */
  std::vector<Segment>
  cut(const ChordPlane           &plane,
      const dealii::Tensor<1, 3> &direction,
      const MeshSurface          &other,
      const double                reach);
} // namespace lamella

#endif
