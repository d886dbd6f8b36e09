// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_plies_table_h
#define lamella_report_plies_table_h

#include <lamella/recover/results.h>

#include <iosfwd>
#include <string>

namespace lamella
{
  /// Returns the first line of `plies.csv`, with its end.
  std::string
  plies_header();

  /// Returns the lines of `plies.csv` for @p step of @p results. Missing
  /// reserve factors and angles are empty.
  std::string
  plies_lines(const Results &results, const StepResults &step);

  /// Returns the first line of `plies_along.csv`, with its end.
  std::string
  plies_along_header();

  /// Returns the lines of `plies_along.csv` for @p step of @p results: the
  /// largest 1/R at each station of the beam axes, ply by ply.
  std::string
  plies_along_lines(const Results &results, const StepResults &step);

  /// Prints the governing ply, criterion and mode of each load step, the five
  /// rows of the last step nearest to failure, and the load at first failure.
  /// No output without reserve factors.
  void
  print_reserves(std::ostream &out, const Results &results);
} // namespace lamella

#endif
