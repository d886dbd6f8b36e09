// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_end_penetration_h
#define lamella_contact_end_penetration_h

#include <lamella/contact/contact_sides.h>

#include <optional>

namespace lamella
{
  /// Node of a body behind the surface of the other body.
  struct EndPenetration
  {
    /// True if the node is on the second side.
    bool second = false;
    /// Penetration [length], and the depth of the cell that it faces.
    double depth = 0., cell = 0.;
    /// Closest-point projection of the node.
    MeshSurface::FacetPoint at = {};
  };

  /// Returns the deepest node of either body, or of its ends alone, behind the
  /// other surface in the configuration @p now. Projections are at most @p
  /// search_radius away [length], on the sides as @p paired. Faces that slide
  /// over an end have no constraint for its nodes unless these are contact
  /// points.
  std::optional<EndPenetration>
  deepest_node(const ContactSides &paired,
               const ContactSides &now,
               const double        search_radius,
               const bool          of_ends);
} // namespace lamella

#endif
