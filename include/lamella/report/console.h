// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_console_h
#define lamella_report_console_h

#include <lamella/recover/requests.h>
#include <lamella/recover/results.h>

#include <iosfwd>

namespace lamella
{
  /// Texts of a table by row and column. The first row contains headings.
  using TextTable = std::vector<std::vector<std::string>>;

  /// Prints @p table with aligned columns. It must have a row of headings.
  void
  print_table(std::ostream &out, const TextTable &table);

  /// Reference values of a scene. Each list has the order of names in Results.
  struct ReferenceLists
  {
    std::vector<std::vector<Reference>> probes;   ///< Values for each probe.
    std::vector<std::vector<Reference>> supports; ///< Values for each support.
    std::vector<std::vector<Reference>> contacts; ///< Values for each contact.
    std::vector<std::vector<Reference>> measures; ///< Values for each measure.
    std::vector<Reference>              modes;    ///< Values of modes, by name.
  };

  /// Compares results of the last load step with reference values. Prints a row
  /// per reference value: name, result, reference, difference in percent,
  /// origin of the reference. On ply interfaces, the result in the lower ply is
  /// used. Throws InputError if @p results has no load step.
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
