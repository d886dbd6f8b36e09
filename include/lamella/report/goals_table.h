// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_goals_table_h
#define lamella_report_goals_table_h

#include <lamella/recover/results.h>

#include <iosfwd>
#include <string>

namespace lamella
{
  /// Returns the content of goals.csv. Each line has a goal (quantity of
  /// interest) with these columns; unknown numbers are empty:
  /// - goal, value, estimate (of the error), corrected (value plus estimate);
  /// - bar (error bound), trusted, tolerance, met;
  /// - axis, fields, section, contact (contributions to the error);
  /// - stiffening, buckling_factor (NonlinearityEstimate), scale, why.
  std::string
  goals_csv(const Results &results);

  /// Returns the content of indicators.csv: the contribution of each axis
  /// element of a beam to the error of a goal (quantity of interest), with the
  /// columns goal, body, begin and end along the axis, and error. The last
  /// lines have the contributions of contact and the remainder (LocalErrors).
  std::string
  indicators_csv(const Results &results);

  /// Prints the quantities of interest with error bars, the largest error
  /// source (mesh, theory, contact) of those with large errors, and nonlinear
  /// effects that exceed the error bars.
  void
  print_goals(std::ostream &out, const Results &results);

  /// Returns the text of the error @p value of @p goal in percent, such as
  /// "0.12 %". If the goal is near zero, the text is "0.0011 MPa (0.5 %)";
  /// without a reference value (scale 0), it is "0.0011 MPa".
  std::string
  share_text(const GoalResult &goal, const double value);

  /// Returns the name of the largest contribution to the error of @p goal
  /// (axis, fields, section or contact); may be empty.
  std::string
  largest_share(const GoalResult &goal);
} // namespace lamella

#endif
