// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_node_pairs_h
#define lamella_contact_node_pairs_h

#include <lamella/contact/contact_sides.h>
#include <lamella/contact/gap_rows.h>

namespace lamella
{
  /// The discretisation of a contact on these bodies: where it is `automatic`,
  /// node to node if every node that faces the other surface within @p reach
  /// [length] faces one of its nodes, else surface to surface.
  Discretisation
  decided(const ContactSides &sides, const double reach);

  /// Pairs of nodes (pair_node_to_node()) in the form of weighted gaps: one
  /// place a side, w = v = n, and the smaller one of both tributary areas. What
  /// finds no partner is counted in @p interface, with a note if it faces the
  /// other surface all the same.
  Gaps
  node_to_node(const ContactSides &sides,
               const double        reach,
               ContactInterface   &interface);
} // namespace lamella

#endif
