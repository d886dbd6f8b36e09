// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_goals_table_h
#define lamella_report_goals_table_h

#include <lamella/recover/results.h>

#include <iosfwd>
#include <string>

namespace lamella
{
  /// Returns the file goals.csv, with the columns goal, value, estimate,
  /// corrected, bar, trusted, tolerance, met, the shares of axis, fields,
  /// section and contact, stiffening, buckling_factor, scale, why. Units are
  /// those of the quantities; trusted and met are 0 or 1; missing numbers are
  /// empty. Stiffening and buckling factor are those of the last step
  /// (NonlinearityEstimate).
  std::string
  goals_csv(const Results &results);

  /// Returns the file indicators.csv: the error of each element along a beam in
  /// the axis share of a goal (goal, body, begin and end along its axis,
  /// error), then the parts of contact and remainder (LocalErrors). If richer
  /// models give the error bars, the errors of a goal sum to its share `axis`.
  std::string
  indicators_csv(const Results &results);

  /// Prints the goals with their error bars, the source and remedy of large
  /// shares, and nonlinear effects that exceed the error bars.
  void
  print_goals(std::ostream &out, const Results &results);

  /// Returns @p value over the scale of @p goal, as "0.12 %"; with the value if
  /// the goal is near zero, as "0.0011 MPa (0.5 %)"; the value alone without a
  /// scale.
  std::string
  share_text(const GoalResult &goal, const double value);

  /// Returns the name of the largest share of @p goal; may be empty.
  std::string
  largest_share(const GoalResult &goal);
} // namespace lamella

#endif
