// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_plies_table_h
#define lamella_report_plies_table_h

#include <lamella/recover/results.h>

#include <iosfwd>
#include <string>

namespace lamella
{
  /// The first line of `plies.csv`, with its end.
  std::string
  plies_header();

  /// The lines of `plies.csv` of @p step, one of the steps of @p results. A
  /// reserve factor or an angle that there is none of is empty.
  std::string
  plies_lines(const Results &results, const StepResults &step);

  /// The first line of `plies_along.csv`, with its end.
  std::string
  plies_along_header();

  /// The lines of `plies_along.csv` of @p step, one of the steps of @p results:
  /// the largest 1/R at each station of the axes of beams, ply by ply.
  std::string
  plies_along_lines(const Results &results, const StepResults &step);

  /// The ply, criterion and mode that govern each load step, the five rows of
  /// the last step that are nearest to failure, and the load at first failure
  /// if it was sought. Nothing without reserve factors.
  void
  print_reserves(std::ostream &out, const Results &results);
} // namespace lamella

#endif
