// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_console_h
#define lamella_report_console_h

#include <lamella/recover/requests.h>
#include <lamella/recover/results.h>

#include <iosfwd>

namespace lamella
{
  /// Rows of cells of equal length; the first row has the headings.
  using TextTable = std::vector<std::vector<std::string>>;

  /// Prints @p table, which must have headings, in columns: the first and the
  /// last left-aligned, numbers right-aligned.
  void
  print_table(std::ostream &out, const TextTable &table);

  /// References that a scene gives for its results.
  struct ReferenceLists
  {
    /// References of each probe, support, contact, measure, as in Results.
    std::vector<std::vector<Reference>> probes, supports, contacts, measures;
  };

  /// Prints a row for each result of the last load step with references: name,
  /// result, reference, difference 100 (result / reference - 1) in percent,
  /// source. The row of a probe on a ply interface is that of the lower ply.
  /// Throws InputError without load steps.
  void
  print_comparison(std::ostream         &out,
                   const Results        &results,
                   const ReferenceLists &references);

  /// Prints reactions, contact state, checks, seconds, memory, notes and
  /// warnings (summary.json), of the last load step. Throws InputError without
  /// load steps.
  void
  print_summary(std::ostream &out, const Results &results);
} // namespace lamella

#endif
