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
    /// True if the node is on the second body.
    bool second = false;
    /// Penetration, and depth of the penetrated cell [length].
    double depth = 0., cell = 0.;
    /// Closest-point projection of the node.
    MeshSurface::FacetPoint at = {};
  };

  /// Returns the node of either body with the deepest penetration into the
  /// other surface in the configuration @p now. If @p of_ends, only nodes at
  /// body ends are considered: a face that slides over an end has no constraint
  /// at the end's nodes unless these are contact points. Projections are at
  /// most @p search_radius away [length]. @p paired are the surfaces at the
  /// last pairing.
  std::optional<EndPenetration>
  deepest_node(const ContactSides &paired,
               const ContactSides &now,
               const double        search_radius,
               const bool          of_ends);
} // namespace lamella

#endif
