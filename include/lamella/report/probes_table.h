// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_probes_table_h
#define lamella_report_probes_table_h

#include <lamella/recover/results.h>

#include <iosfwd>

namespace lamella
{
  /// Prints displacements and stresses of the first probes in the last load
  /// step, in scene axes, with error bars in per cent for goals.
  void
  print_probes(std::ostream &out, const Results &results);
} // namespace lamella

#endif
