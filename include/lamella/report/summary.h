// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_summary_h
#define lamella_report_summary_h

#include <lamella/solve/results.h>

#include <string>

namespace lamella
{
  /// As in a scene file: `node to node`, `penalty`, ...
  std::string
  name_of(const Discretisation discretisation);
  std::string
  name_of(const Enforcement enforcement);

  /// What summary.json says of @p results, keys as fixed in doc/output.md:
  /// resultants and checks are those of the last load step.
  std::string
  summary_text(const Results &results);
} // namespace lamella

#endif
