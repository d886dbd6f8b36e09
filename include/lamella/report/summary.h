// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_summary_h
#define lamella_report_summary_h

#include <lamella/recover/results.h>

#include <string>

namespace lamella
{
  /// What summary.json says of @p results, keys as fixed in doc/output.md:
  /// resultants and checks are those of the last load step, whose checks,
  /// changes and jumps must be there; warnings are those of all. Without any
  /// step they are left out. Bytes that are no UTF-8 are replaced. Ends with a
  /// line feed.
  std::string
  summary_text(const Results &results);
} // namespace lamella

#endif
