// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_plies_table_h
#define lamella_report_plies_table_h

#include <lamella/recover/results.h>

#include <iosfwd>
#include <string>

namespace lamella
{
  /// Returns the lines of plies.csv for load step @p step of @p results: the
  /// smallest reserve factor of each ply.
  std::string
  plies_lines(const Results &results, const StepResults &step);

  /// Returns the lines of plies_along.csv for load step @p step of @p results:
  /// the largest inverse reserve factor of each ply at points along the axis.
  std::string
  plies_along_lines(const Results &results, const StepResults &step);

  /// Prints the critical ply, criterion and failure mode of each load step, the
  /// five smallest reserve factors of the last step, and the load at first
  /// failure. No output if the scene has no strength analysis.
  void
  print_reserves(std::ostream &out, const Results &results);
} // namespace lamella

#endif
