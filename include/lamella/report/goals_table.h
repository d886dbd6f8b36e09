// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_report_goals_table_h
#define lamella_report_goals_table_h

#include <lamella/recover/results.h>

#include <iosfwd>
#include <string>

namespace lamella
{
  /// Returns the content of goals.csv, a line per goal with the columns
  /// - goal, value, estimate (of the error), corrected (value plus estimate);
  /// - bar (error bound; empty if unreliable), trusted (1: bar is reliable);
  /// - tolerance (largest permitted error), met (1: the bar is within it);
  /// - axis, fields, section, contact, path (contributions to the error);
  /// - stiffening, buckling_factor (NonlinearityEstimate);
  /// - scale (reference of relative errors), why (the bar is unreliable).
  std::string
  goals_csv(const Results &results);

  /// Returns the content of indicators.csv: the contribution of each axis
  /// element of a beam to the error of a goal (quantity of interest), with the
  /// columns goal, body, begin and end along the axis, and error. The last
  /// lines have the contributions of contact and the remainder (LocalErrors).
  std::string
  indicators_csv(const Results &results);

  /// Prints each quantity of interest with its error bar and, if the error is
  /// large, its main source (mesh, theory, contact). Also prints nonlinear
  /// effects that are larger than the error bars.
  void
  print_goals(std::ostream &out, const Results &results);

  /// Returns the text of the error @p value of @p goal, such as "0.12 %" of
  /// GoalResult::scale; "0.0011 MPa (0.5 %)" if the goal is near zero; or
  /// "0.0011 MPa" if the scale is 0.
  std::string
  share_text(const GoalResult &goal, const double value);
} // namespace lamella

#endif
