// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_fields_of_nodes_h
#define lamella_report_fields_of_nodes_h

#include <lamella/body/body.h>

#include <string>

namespace lamella
{
  /**
   * The file fields.csv: how many fields of its section each node of a beam's
   * axis carries, a line a node, in the order of the axis:
   *   body, node (from 1), s (the distance from the first node, a length), x,
   *   y, z (the node in the undeformed scene), fields.
   * They sum to Body::n_dofs(). Of nodal bodies (solids), whose nodes are no
   * places of an axis, there are no lines. Communicates nothing.
   */
  std::string
  fields_of_nodes(const Bodies &bodies);
} // namespace lamella

#endif
