// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_slip_increment_h
#define lamella_contact_slip_increment_h

#include <lamella/contact/contact_sides.h>
#include <lamella/contact/master_surface.h>
#include <lamella/contact/pairing.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace lamella
{
  /// Unit tangents t_1, t_2 of a surface; with the normal n right-handed.
  using Tangents = std::array<dealii::Tensor<1, 3>, 2>;

  /// Returns the unit tangents for the unit normal @p n. The first is as close
  /// as possible to the scene's y axis (x if n is within 5 degrees of y).
  Tangents
  tangents_of(const dealii::Tensor<1, 3> &n);

  /// Returns the unit tangents for the normal @p n at the point @p st of a
  /// facet with the undeformed map @p before and the deformed map @p now. The
  /// first has the direction of the deformed first tangent of tangents_of().
  Tangents
  convected_tangents(const FacetMap             &before,
                     const FacetMap             &now,
                     const dealii::Point<2>     &st,
                     const dealii::Tensor<1, 3> &n);

  /// Reference point of the slip in a load step: the slave point of a contact
  /// and the master point that it faced at the beginning of the step.
  struct SlipReferencePoint
  {
    GapPoint point; ///< Both material points at the beginning of the step.
    /// For an obstacle: vector from Obstacle::point to the opposite point.
    dealii::Tensor<1, 3> on_obstacle,
      normal; ///< For an obstacle: its unit normal at the opposite point.
  };

  /// Slip reference points, one per contact point; an entry is empty if its
  /// point is unpaired.
  using SlipReferencePoints = std::vector<std::optional<SlipReferencePoint>>;

  /// Begin of a load step, from which slips are measured.
  struct SlipReference
  {
    /// Surfaces at the beginning of the step; null before the first step.
    std::shared_ptr<const ContactSides> sides;
    SlipReferencePoints                 points; ///< Facing points there.
  };

  /// Returns the slip reference point of the contact point @p point, which
  /// faces the master point @p at on the surfaces @p sides.
  SlipReferencePoint
  slip_reference_point(const ContactSides &sides,
                       const GapPoint     &point,
                       const MasterPoint  &at);

  /// Returns the slip of a contact point in a load step: the tangential motion
  /// [length] of the master surface relative to the slave surface, from the
  /// reference @p then to the point @p now, which faces @p at on @p sides,
  ///   s = P (x_c(C) - x_c(C_0)) - P (x_o(O) - x_o(O_0)),   P = I - n n,
  /// where C and O are the material points of the slave and master surface now
  /// in contact, C_0 and O_0 those of the reference, and x_c and x_o current
  /// positions. C is C_0 except on the line of a roller contact. The slave is
  /// the second surface if @p on_second is true, else the first. s is invariant
  /// to rigid motions of both bodies and to rotations of n.
  dealii::Tensor<1, 3>
  slip_increment_of(const ContactSides       &sides,
                    const bool                on_second,
                    const SlipReferencePoint &then,
                    const GapPoint           &now,
                    const MasterPoint        &at);

  /// Returns the slip in a load step of a contact point that faced the master
  /// surface at the reference @p then, but has left it past an edge,
  ///   s = P (x_o(O_0) - x_c(C_0)),
  /// with the slave normal n now.
  dealii::Tensor<1, 3>
  slip_past_edge(const ContactSides       &sides,
                 const bool                on_second,
                 const SlipReferencePoint &then);

  /// Returns the slip in a load step of a contact point @p now that has come
  /// over the master surface from past an edge. With the surfaces @p began at
  /// the beginning of the step and the tangents t_a of the slave surface,
  ///   s = sum over a of (x_c(C) - x_o(O)) . t_a at the beginning, times t_a at
  /// @p at, on the surfaces @p sides now.
  dealii::Tensor<1, 3>
  slip_from_past_edge(const ContactSides &began,
                      const ContactSides &sides,
                      const bool          on_second,
                      const GapPoint     &now,
                      const MasterPoint  &at);
} // namespace lamella

#endif
