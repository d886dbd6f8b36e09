// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_segments_h
#define lamella_contact_segments_h

#include <lamella/contact/mesh_surface.h>

#include <deal.II/base/quadrature.h>

#include <array>
#include <vector>

namespace lamella
{
  /// The corners of a convex polygon, counterclockwise.
  using Polygon = std::vector<dealii::Point<2>>;

  /// Its area; negative if the corners run clockwise.
  double
  area(const Polygon &polygon);

  /// Its centroid; the area must not vanish.
  dealii::Point<2>
  centroid(const Polygon &polygon);

  /// The part of @p polygon inside of @p window, both convex and
  /// counterclockwise (Sutherland and Hodgman).
  Polygon
  clipped(const Polygon &polygon, const Polygon &window);

  /// A rule on the triangle (0, 0), (1, 0), (0, 1) that integrates polynomials
  /// of @p degree exactly; all weights are positive.
  const dealii::Quadrature<2> &
  triangle_rule(const unsigned int degree);

  /**
   * A quadrilateral piece of a surface, in the plane of its chords, with axes
   * along its first side and across.
   */
  struct ChordPlane
  {
    /// @p corners at (0, 0), (1, 0), (0, 1), (1, 1) of a facet or of a part of
    /// it; @p outward tells the side that the normal is to look to.
    ChordPlane(const std::array<dealii::Point<3>, 4> &corners,
               const dealii::Tensor<1, 3>            &outward);

    /// The place of @p x in the plane, moved along @p direction.
    dealii::Point<2>
    project(const dealii::Point<3>     &x,
            const dealii::Tensor<1, 3> &direction) const;

    dealii::Point<3>     origin;
    dealii::Tensor<1, 3> e1, e2, normal;
    Polygon              outline;
    double               area = 0.;
  };

  /// What a piece of a surface and one facet of another have in common, in the
  /// piece's chord plane.
  struct Segment
  {
    unsigned int facet = 0;
    Polygon      polygon;
    double       area = 0.;
  };

  /**
   * Cuts the piece @p plane with the facets of @p other that lie within
   * @p reach, projected along @p direction (the averaged normal in the middle
   * of the piece). Slivers below 1e-11 of the piece's area are left out.
   */
  std::vector<Segment>
  cut(const ChordPlane           &plane,
      const dealii::Tensor<1, 3> &direction,
      const MeshSurface          &other,
      const double                reach);
} // namespace lamella

#endif
