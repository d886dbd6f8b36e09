// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_probes_table_h
#define lamella_report_probes_table_h

#include <lamella/recover/results.h>

#include <iosfwd>

namespace lamella
{
  /// Prints displacements and stresses of the probes in the last load step, in
  /// the scene's axes, with the error bars of goals in per cent. Prints only
  /// the first of many probes.
  void
  print_probes(std::ostream &out, const Results &results);
} // namespace lamella

#endif
