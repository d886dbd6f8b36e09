// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_node_pairs_h
#define lamella_contact_node_pairs_h

#include <lamella/contact/contact_sides.h>
#include <lamella/contact/gap_constraints.h>

namespace lamella
{
  /// Returns the discretization of contact between the surfaces @p sides. For
  /// `automatic` it is node to node if every node that faces the other surface
  /// within @p search_radius faces one of its nodes, else surface to surface.
  Discretization
  choose_discretization(const ContactSides &sides, const double search_radius);

  /// Returns the gaps of node-to-node contact, one per pair of nodes at most @p
  /// search_radius apart (pair_node_to_node()), with the smaller of both
  /// tributary areas. Stores in @p interface how many nodes have no partner.
  Gaps
  node_to_node(const ContactSides &sides,
               const double        search_radius,
               ContactInterface   &interface);
} // namespace lamella

#endif
