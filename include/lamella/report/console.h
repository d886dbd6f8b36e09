// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_console_h
#define lamella_report_console_h

#include <lamella/report/recorder.h>
#include <lamella/report/summary.h>

#include <iosfwd>

namespace lamella
{
  /// Rows of cells, the first row the headings.
  using TextTable = std::vector<std::vector<std::string>>;

  /// Prints @p table in columns: the first to the left, numbers to the right,
  /// the last to the left.
  void
  print_table(std::ostream &out, const TextTable &table);

  /// References of a contact's or a support's resultant.
  struct ResultantReferences
  {
    /// As in the scene: `Contact middle`.
    std::string            what;
    dealii::Tensor<1, 3>   force;
    std::vector<Reference> references;
  };

  /// Prints the results that have references, a row each: what, the result, the
  /// reference, the difference in percent, the source. Nothing without any.
  void
  print_comparison(std::ostream                           &out,
                   const std::vector<Probe>               &probes,
                   const Recorder                         &recorder,
                   const std::vector<ResultantReferences> &resultants);

  /// Prints DoFs, checks, contact state, reactions, seconds and memory.
  void
  print_summary(std::ostream &out, const Summary &summary);
} // namespace lamella

#endif
