// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_probes_table_h
#define lamella_report_probes_table_h

#include <lamella/recover/results.h>

#include <iosfwd>

namespace lamella
{
  /// Prints displacements and stresses of all probes of the last load step, in
  /// the scene's axes, behind a number that is a goal with a bar its bar in per
  /// cent; of many probes the first ones. Nothing without any.
  void
  print_probes(std::ostream &out, const Results &results);
} // namespace lamella

#endif
