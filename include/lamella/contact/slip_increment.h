// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_slip_increment_h
#define lamella_contact_slip_increment_h

#include <lamella/contact/contact_sides.h>
#include <lamella/contact/master_surface.h>
#include <lamella/contact/pairing.h>

#include <array>
#include <optional>
#include <vector>

namespace lamella
{
  /// Unit tangents t_1, t_2 of a contact row; n, t_1, t_2 is right-handed.
  using Tangents = std::array<dealii::Tensor<1, 3>, 2>;

  /// Returns the tangents for @p n, the first closest to the scene's y axis (or
  /// x, if n is within 5 degrees of y).
  Tangents
  tangents_of(const dealii::Tensor<1, 3> &n);

  /// Returns the tangents for @p n at @p st of a facet displaced from @p before
  /// to @p now: the first is that of tangents_of() before, convected.
  Tangents
  convected_tangents(const FacetMap             &before,
                     const FacetMap             &now,
                     const dealii::Point<2>     &st,
                     const dealii::Tensor<1, 3> &n);

  /// Reference of the slip of a point in a load step: what it faced initially.
  struct SlipReferencePoint
  {
    /// Material points of both bodies.
    GapPoint point;
    /// Facing place on an obstacle relative to Obstacle::point, and its normal.
    dealii::Tensor<1, 3> on_obstacle, normal;
  };

  /// Slip references of a contact, one per point; empty without a master point.
  using SlipReferencePoints = std::vector<std::optional<SlipReferencePoint>>;

  /// Returns the slip reference of @p point, which faces @p at on @p sides.
  SlipReferencePoint
  slip_reference_point(const ContactSides &sides,
                       const GapPoint     &point,
                       const MasterPoint  &at);

  /**
   * Returns the slip of the surface that @p now faces at @p at relative to that
   * of the point, since both were at @p then, on @p sides [length], a vector
   * normal to n:
   *   s = P (x_c(C) - x_c(C_0)) - P (x_o(O) - x_o(O_0)),   P = I - n n,
   * with the material points C and O on the slave and master surface in contact
   * now, and C_0 and O_0 before. C is C_0 except on the line to a roller. s is
   * invariant to rigid motions of both bodies and to rotations of n; the
   * difference of chord and arc on curved bodies is of third order in the slip.
   */
  dealii::Tensor<1, 3>
  slip_increment_of(const ContactSides       &sides,
                    const bool                on_second,
                    const SlipReferencePoint &then,
                    const GapPoint           &now,
                    const MasterPoint        &at);
} // namespace lamella

#endif
