// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_goals_table_h
#define lamella_report_goals_table_h

#include <lamella/recover/results.h>

#include <iosfwd>
#include <string>

namespace lamella
{
  /// Returns the content of goals.csv, a line per goal (quantity of interest)
  /// with these columns; missing numbers are empty:
  /// - goal, value, estimate (of the error), corrected (value plus estimate);
  /// - bar (error bound), trusted, tolerance, met;
  /// - axis, fields, section, contact (contributions to the error);
  /// - stiffening, buckling_factor (NonlinearityEstimate), scale, why.
  std::string
  goals_csv(const Results &results);

  /// Returns the content of indicators.csv: the contribution of each axis
  /// element of a beam to the error of a goal (goal, body, begin and end along
  /// the axis, error), then those of contact and the remainder (LocalErrors).
  std::string
  indicators_csv(const Results &results);

  /// Prints the goals with error bars, the source of large errors with a
  /// remedy, and nonlinear effects that exceed the error bars.
  void
  print_goals(std::ostream &out, const Results &results);

  /// Returns the error @p value relative to the scale of @p goal, such as "0.12
  /// %", or "0.0011 MPa (0.5 %)" if the goal is near zero; if the goal has no
  /// scale, the error with its unit only.
  std::string
  share_text(const GoalResult &goal, const double value);

  /// Returns the name of the largest contribution to the error of @p goal
  /// (axis, fields, section or contact); may be empty.
  std::string
  largest_share(const GoalResult &goal);
} // namespace lamella

#endif
