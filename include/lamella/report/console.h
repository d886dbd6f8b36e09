// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_console_h
#define lamella_report_console_h

#include <lamella/recover/requests.h>
#include <lamella/recover/results.h>

#include <iosfwd>

namespace lamella
{
  /// Rows of cells, the first row the headings; all rows as long as that.
  using TextTable = std::vector<std::vector<std::string>>;

  /// Prints @p table in columns as wide as their widest cell in bytes: the
  /// first to the left, numbers to the right, the last to the left. The table
  /// must have its row of headings.
  void
  print_table(std::ostream &out, const TextTable &table);

  /// What a scene compares its results with: values of a text book, a paper or
  /// another program.
  struct ReferenceLists
  {
    /// Of each probe, support, contact and measure, in the order of Results;
    /// empty lists of those without any.
    std::vector<std::vector<Reference>> probes, supports, contacts, measures;
  };

  /// Prints the results that have references, a row each: what, the result, the
  /// reference, the difference 100 (result / reference - 1) in percent (none
  /// where the reference is zero), the source. Nothing without any. Of a probe
  /// on a ply interface the first row counts, that of the lower ply. Results
  /// are those of the last load step; throws InputError if there is none.
  void
  print_comparison(std::ostream         &out,
                   const Results        &results,
                   const ReferenceLists &references);

  /// Prints reactions, contact state, checks, seconds and memory, and then all
  /// notes and warnings: what summary.json holds, for people. Forces and checks
  /// are those of the last load step; throws InputError if there is none.
  void
  print_summary(std::ostream &out, const Results &results);
} // namespace lamella

#endif
