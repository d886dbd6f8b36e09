// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_probes_table_h
#define lamella_report_probes_table_h

#include <lamella/recover/results.h>

#include <iosfwd>

namespace lamella
{
  /// Prints displacements and stresses (scene axes) of at most 40 probes in the
  /// last load step; for quantities of interest also error bars in percent.
  void
  print_probes(std::ostream &out, const Results &results);
} // namespace lamella

#endif
