// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_goals_table_h
#define lamella_report_goals_table_h

#include <lamella/recover/results.h>

#include <iosfwd>
#include <string>

namespace lamella
{
  /// The file goals.csv, a line each: goal, value, estimate, corrected, bar,
  /// trusted, tolerance, met, the shares of axis, fields, section and contact,
  /// stiffening, buckling_factor, scale, why. In the units of the quantities;
  /// trusted and met are 0 or 1; tolerance is a length of the bar, empty if
  /// none was asked for, and so is the bar if there is none. Stiffening and
  /// buckling factor (empty if there is none) are those of the last step
  /// (BeyondLinear): what no refinement shows.
  std::string
  goals_csv(const Results &results);

  /// The file indicators.csv: what each element along a beam does to the share
  /// of the axis in a goal's error, a line each (goal, body, begin and end
  /// along its axis, error), then what contact and a remainder do
  /// (LocalErrors). With bars from richer models the errors of a goal sum to
  /// its share `axis`.
  std::string
  indicators_csv(const Results &results);

  /// Prints the goals with their bars and, where a share of the error is large,
  /// what it comes from and what mends it, and what no refinement shows where
  /// that is more than the bars. Nothing without any.
  void
  print_goals(std::ostream &out, const Results &results);

  /// @p value over the scale of @p goal, as in "0.12 %"; with the value itself
  /// where the goal is near zero, as in "0.0011 MPa (0.5 %)", and that alone
  /// where all of its kind are zero.
  std::string
  share_text(const GoalResult &goal, const double value);

  /// The share of @p goal that is largest, or "" if there is none.
  std::string
  largest_share(const GoalResult &goal);
} // namespace lamella

#endif
