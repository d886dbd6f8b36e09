// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_end_penetration_h
#define lamella_contact_end_penetration_h

#include <lamella/contact/contact_sides.h>

#include <optional>

namespace lamella
{
  /// A node of a body that penetrates the surface of the other body.
  struct EndPenetration
  {
    /// True for a node of the second body, false for one of the first.
    bool   second = false;
    double depth  = 0., ///< Penetration [length].
      cell = 0.; ///< Depth of the penetrated cell along its normal [length].
    /// Closest-point projection of the node onto the other surface.
    MeshSurface::FacetPoint at = {};
  };

  /// Returns the node of either body with the deepest penetration into the
  /// other surface in the configuration @p now; empty if none penetrates. If @p
  /// of_ends is true, only nodes at body ends are considered, since they have
  /// no constraint if a surface slides over them. Projections are at most @p
  /// search_radius away [length]. @p paired are the surfaces that were paired.
  std::optional<EndPenetration>
  deepest_node(const ContactSides &paired,
               const ContactSides &now,
               const double        search_radius,
               const bool          of_ends);
} // namespace lamella

#endif
