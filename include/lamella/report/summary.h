// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_summary_h
#define lamella_report_summary_h

#include <lamella/recover/results.h>

#include <string>

namespace lamella
{
  /// Returns the content of summary.json (doc/reference/output.md): resultants
  /// and checks of the last load step in @p results, and the warnings of all
  /// steps. Bytes that are not valid UTF-8 are replaced.
  std::string
  summary_text(const Results &results);
} // namespace lamella

#endif
