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
  /// Unit tangents t_1, t_2 at a contact point; n, t_1, t_2 is right-handed.
  using Tangents = std::array<dealii::Tensor<1, 3>, 2>;

  /// Returns the tangents for the normal @p n, the first as close as possible
  /// to the y axis of the scene (or to x if n is within 5 degrees of y).
  Tangents
  tangents_of(const dealii::Tensor<1, 3> &n);

  /// Returns the tangents for the normal @p n at the point @p st of a facet
  /// with the deformed map @p now. The first is the first of tangents_of() on
  /// the undeformed map @p before, convected with the facet.
  Tangents
  convected_tangents(const FacetMap             &before,
                     const FacetMap             &now,
                     const dealii::Point<2>     &st,
                     const dealii::Tensor<1, 3> &n);

  /// Reference point of the slip in a load step: the contact point and the
  /// point that it faced at the beginning of the step.
  struct SlipReferencePoint
  {
    /// Material points of both bodies.
    GapPoint point;
    /// For an obstacle: vector from Obstacle::point to the opposite point, and
    /// the obstacle normal there.
    dealii::Tensor<1, 3> on_obstacle, normal;
  };

  /// Reference points of a contact, one per contact point; empty if unpaired.
  using SlipReferencePoints = std::vector<std::optional<SlipReferencePoint>>;

  /// Returns the reference point for the contact point @p point, which faces
  /// the master point @p at on the surfaces @p sides.
  SlipReferencePoint
  slip_reference_point(const ContactSides &sides,
                       const GapPoint     &point,
                       const MasterPoint  &at);

  /// Returns the slip [length] of the master side relative to the slave side at
  /// the contact point @p now, which faces @p at on @p sides, since its
  /// reference @p then, as a vector normal to n:
  ///   s = P (x_c(C) - x_c(C_0)) - P (x_o(O) - x_o(O_0)),   P = I - n n,
  /// where C and O are the material points of the slave and master surface now
  /// in contact, C_0 and O_0 those of the reference, and x_c and x_o current
  /// positions. C is C_0 except on the line of a roller contact. s is invariant
  /// to rigid motions of both bodies and to rotations of n.
  dealii::Tensor<1, 3>
  slip_increment_of(const ContactSides       &sides,
                    const bool                on_second,
                    const SlipReferencePoint &then,
                    const GapPoint           &now,
                    const MasterPoint        &at);
} // namespace lamella

#endif
