// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_fields_of_nodes_h
#define lamella_report_fields_of_nodes_h

#include <lamella/body/body.h>

#include <string>

namespace lamella
{
  /// Returns the file fields.csv: the number of section fields at each node of
  /// the beam axes, a line per node in the order of the axis:
  ///   body, node (from 1), s (distance from the first node, a length), x, y, z
  ///   (the node in the undeformed scene), fields.
  /// The fields sum to Body::n_dofs(). Not collective.
  std::string
  fields_of_nodes(const Bodies &bodies);
} // namespace lamella

#endif
