// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_fields_of_nodes_h
#define lamella_report_fields_of_nodes_h

#include <lamella/body/body.h>

#include <string>

namespace lamella
{
  /// Returns the content of fields.csv: the number of section functions (terms
  /// of the expansion over the cross-section) at each axis node of each beam. A
  /// line per node has the columns
  ///   body, node (from 1), s (distance from the first node), x, y, z
  ///   (undeformed position), fields (number of section functions).
  std::string
  fields_of_nodes(const Bodies &bodies);
} // namespace lamella

#endif
