// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_slide_h
#define lamella_contact_slide_h

#include <lamella/contact/contact_sides.h>
#include <lamella/contact/opposing_surface.h>
#include <lamella/contact/pairing.h>

#include <array>
#include <optional>
#include <vector>

namespace lamella
{
  /// t_1 and t_2 of a contact's rows, unit vectors that make with its normal a
  /// right-handed frame n, t_1, t_2.
  using Tangents = std::array<dealii::Tensor<1, 3>, 2>;

  /// Those across @p n, the first one as near to the scene's y axis as that
  /// allows (to its x axis, where n is within 5 degrees of y).
  Tangents
  tangents_of(const dealii::Tensor<1, 3> &n);

  /// Those across @p n at the place @p st of a facet that has moved from
  /// @p before to @p now: the first one is what was tangents_of() the facet
  /// there, moved along and projected. So a frame turns with the body and not
  /// on its own.
  Tangents
  carried_tangents(const FacetMap             &before,
                   const FacetMap             &now,
                   const dealii::Point<2>     &st,
                   const dealii::Tensor<1, 3> &n);

  /// Where a point of a contact and what it faced were as a load step began:
  /// what its slip in the step is measured from.
  struct HeldPlace
  {
    /// Material places of both bodies.
    GapPoint point;
    /// Of an obstacle the place that was faced, from Obstacle::point [length],
    /// and the unit normal there.
    dealii::Tensor<1, 3> on_obstacle, normal;
  };

  /// Those of a contact, a place for each of its points; nothing of points that
  /// have faced nothing yet.
  using HeldPlaces = std::vector<std::optional<HeldPlace>>;

  /// That of @p point, which faces @p at where @p sides stand.
  HeldPlace
  held_place(const ContactSides &sides,
             const GapPoint     &point,
             const Opposition   &at);

  /**
   * By how far the surface that @p now faces at @p at has slid along that of
   * the point since both were at @p then, where @p sides stand [length], a
   * vector across the normal:
   *   s = P (x_c(C) - x_c(C_0)) - P (x_o(O) - x_o(O_0)),   P = I - n n,
   * C and O the material places on the carrying and the opposing surface that
   * touch now, C_0 and O_0 those that did. C is C_0 but on the line to a
   * roller. Around a roller the second term is the arc. No rigid motion of both
   * bodies changes s, nor do rotations of n; what chords are short of arcs on
   * curved bodies is of third order in the slide.
   */
  dealii::Tensor<1, 3>
  slide(const ContactSides &sides,
        const bool          on_second,
        const HeldPlace    &then,
        const GapPoint     &now,
        const Opposition   &at);
} // namespace lamella

#endif
