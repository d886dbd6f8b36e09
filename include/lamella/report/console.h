// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_console_h
#define lamella_report_console_h

#include <lamella/recover/requests.h>
#include <lamella/solve/results.h>

#include <iosfwd>

namespace lamella
{
  /// Rows of cells, the first row the headings.
  using TextTable = std::vector<std::vector<std::string>>;

  /// Prints @p table in columns: the first to the left, numbers to the right,
  /// the last to the left.
  void
  print_table(std::ostream &out, const TextTable &table);

  /// What a scene compares its results with.
  struct ReferenceLists
  {
    /// Of each probe, support and contact, in the order of Results.
    std::vector<std::vector<Reference>> probes, supports, contacts;
  };

  /// Prints the results that have references, a row each: what, the result, the
  /// reference, the difference in percent, the source. Nothing without any.
  void
  print_comparison(std::ostream         &out,
                   const Results        &results,
                   const ReferenceLists &references);

  /// Prints checks, contact state, reactions, seconds and memory.
  void
  print_summary(std::ostream &out, const Results &results);
} // namespace lamella

#endif
