// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_error_bar_h
#define lamella_estimate_error_bar_h

#include <string>
#include <vector>

namespace lamella
{
  /// Constants of error bars. With these 411 of 414 bars of
  /// doc/theory/error-bars.md are correct; most are several times too long.
  struct BarRules
  {
    /// Largest ratio of successive changes that is extrapolated.
    double max_remaining_share = 2. / 3.;
    /// Share of the scale below which the spread of the values is the error.
    double small = 1e-2;
    /// Share of the scale below which differences are rounding.
    double digits = 1e-8;
    /// Ratio of successive changes above which a value is reported to grow.
    double growth = 0.9;
    /// Bar over |change|, and over the sum of |shares|, which may cancel.
    double of_change = 2., of_shares = 0.5;
    /// Least error after a pass over the bars of the refined sources before.
    double of_pass = 1. / 8.;
  };

  /// Values of a quantity from a run, a richer and a still richer model.
  struct Refinements
  {
    double run = 0., richer = 0., richest = 0.;
    /// Sum of |share| over the sources of error (GoalResult::shares).
    double shares = 0.;
    /// Reference size of errors: the value, or the largest of its kind.
    double scale = 0.;
    /// Error of the value by rounding.
    double rounding = 0.;
  };

  /// Returns the end of the sentence "it changes by so many per cent".
  std::string
  describe_growth();

  /// Estimated error of a run's value.
  struct ErrorBar
  {
    /// Signed estimate eta = richest - run, to be added to the value.
    double estimate = 0.;
    /// Bound of |error|: the length of the bar to either side.
    double bar = 0.;
    /// True if the refinements agree, so that the bar can be relied on.
    bool trusted = false;
    /// Reason if not trusted: a sentence without a full stop.
    std::string why = {};
    /// Part of each source in the bar, if it was made of several.
    std::vector<double> parts = {};
  };

  /**
   * Returns the bar of a value v_0 from the values v_1, v_2 of two richer
   * models:
   *   estimate  eta = v_2 - v_0
   *   bar       max(2 |eta|, 1/2 sum |shares|, rounding, 1e-8 scale).
   * If each refinement multiplies the error by q, then v_2 - v_1 = q (v_1 -
   * v_0), and eta misses q^2 of the error. The bar is trusted if q <= 2/3, or
   * if all three values agree to 1e-2 of the scale. Agreement to 1e-8 is
   * rounding. A value that changes as much again in the same direction is
   * reported to grow without limit. (Becker and Rannacher, Acta Numerica 10
   * (2001) 1-102.)
   */
  ErrorBar
  error_bar(const Refinements &values, const BarRules &rules = {});

  /// Changes of a quantity over the last two levels below a run in one source
  /// of error: the last change and the one before it, signed.
  struct Levels
  {
    double last = 0., before = 0.;
    /// Least error of this source: sizes of contributions that may cancel.
    double least = 0.;
  };

  /**
   * Returns the bar of a value from poorer models. With d = |last|, e =
   * |before| of a source, q = d / e, and an error that goes on to fall by q,
   * its error is at most
   *   max(d, 2 d q / (1 - q), least),
   * where d covers a q that is small by accident and `least` a d that is. If q
   * > 2/3, the part is at least twice the larger of d and e, and the bar is not
   * trusted if that exceeds a hundredth of @p scale. The bar is the sum over @p
   * sources, at least @p rounding and 1e-8 of the scale. The estimate is the
   * sum of last q / (1 - q), an extrapolation.
   */
  ErrorBar
  coarser_model_bar(const std::vector<Levels> &sources,
                    const double               scale,
                    const double               rounding = 0.,
                    const BarRules            &rules    = {});
} // namespace lamella

#endif
