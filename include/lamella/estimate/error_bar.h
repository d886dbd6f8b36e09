// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_error_bar_h
#define lamella_estimate_error_bar_h

#include <string>
#include <vector>

namespace lamella
{
  /// Parameters of error bars. With these, 411 of the 414 bars in
  /// doc/theory/error-bars.md are correct; most are several times too long.
  struct BarRules
  {
    /// Largest ratio of successive changes for which a bar is trusted.
    double max_remaining_share = 2. / 3.;
    /// A bar is trusted if values differ by less, as a fraction of the scale.
    double small = 1e-2;
    /// Differences below this fraction of the scale are rounding errors.
    double digits = 1e-8;
    /// Ratio of successive changes above which a value is reported to diverge.
    double growth = 0.9;
    /// Factors in the bar of |change| and of the sum of |changes| by source.
    double of_change = 2., of_shares = 0.5;
    /// Fraction of the previous bar that a refined source keeps at least.
    double of_pass = 1. / 8.;
  };

  /// Values of a quantity from a run, a finer model and a still finer model.
  struct Refinements
  {
    double run = 0., richer = 0., richest = 0.;
    /// Sum of |change| over the sources of error (GoalResult::shares).
    double shares = 0.;
    /// Reference size of errors: |value|, or the largest value of its kind.
    double scale = 0.;
    /// Rounding error of the value.
    double rounding = 0.;
  };

  /// Returns the text with which reasons for a diverging value end.
  std::string
  describe_growth();

  /// Estimated error of a value of a run.
  struct ErrorBar
  {
    /// Signed error estimate eta = richest - run, to be added to the value.
    double estimate = 0.;
    /// Bound of |error|: length of the error bar to either side.
    double bar = 0.;
    /// True if successive refinements agree, so that the bar is reliable.
    bool trusted = false;
    /// Reason if not trusted: a sentence without a full stop.
    std::string why = {};
    /// Contribution of each error source to the bar, if there are several.
    std::vector<double> parts = {};
  };

  /// Returns the error bar of a value v_0 from the values v_1, v_2 of two
  /// successively finer models:
  ///   estimate  eta = v_2 - v_0
  ///   bar       max(2 |eta|, 1/2 sum |shares|, rounding, 1e-8 scale).
  /// If each refinement multiplies the error by q, then v_2 - v_1 = q (v_1 -
  /// v_0), and v_2 still has q^2 of the error of v_0. The bar is trusted if q
  /// <= 2/3, or if all three values agree to 1e-2 of the scale. A value whose
  /// second change has the sign of the first and at least 0.9 of its size is
  /// reported to diverge. (Becker and Rannacher, Acta Numerica 10, 2001.)
  ErrorBar
  error_bar(const Refinements &values, const BarRules &rules = {});

  /// Changes of a quantity by one error source over the last two levels below a
  /// run, signed: from the next coarser model, and the change before.
  struct Levels
  {
    double last = 0., before = 0.;
    /// Smallest error of this source, from contributions that may cancel.
    double least = 0.;
  };

  /// Returns the error bar of a value from coarser models. For each error
  /// source let d = |last|, e = |before| and q = d / e. If the error continues
  /// to decrease by q, the error is at most max(d, 2 d q / (1 - q), least),
  /// where d and `least` are lower bounds if q or d is small by accident. If q
  /// > 2/3, the contribution is at least twice the larger of d and e, and the
  /// bar is not trusted if the contribution exceeds 0.01 @p scale. The bar is
  /// the sum over @p sources, at least @p rounding and 1e-8 of the scale. The
  /// estimate is the sum of last q / (1 - q), an extrapolation.
  ErrorBar
  coarser_model_bar(const std::vector<Levels> &sources,
                    const double               scale,
                    const double               rounding = 0.,
                    const BarRules            &rules    = {});
} // namespace lamella

#endif
