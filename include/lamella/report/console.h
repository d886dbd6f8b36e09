// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_console_h
#define lamella_report_console_h

#include <lamella/recover/requests.h>
#include <lamella/recover/results.h>

#include <iosfwd>

namespace lamella
{
  /// Rows of a table, each with the same number of cells; first the headings.
  using TextTable = std::vector<std::vector<std::string>>;

  /// Prints @p table with aligned columns. The table must have headings.
  void
  print_table(std::ostream &out, const TextTable &table);

  /// Reference values that a scene defines for its results.
  struct ReferenceLists
  {
    /// References of each object, in the order of Results.
    std::vector<std::vector<Reference>> probes, supports, contacts, measures;
  };

  /// Prints a table with one row per reference value: name, result in the last
  /// load step, reference, difference in percent, source. A probe on a ply
  /// interface has the lower ply's result. Throws InputError without a load
  /// step.
  void
  print_comparison(std::ostream         &out,
                   const Results        &results,
                   const ReferenceLists &references);

  /// Prints the content of summary.json for the last load step: reactions,
  /// contact state, checks, time, memory, notes and warnings. Throws InputError
  /// if @p results has no load step.
  void
  print_summary(std::ostream &out, const Results &results);
} // namespace lamella

#endif
