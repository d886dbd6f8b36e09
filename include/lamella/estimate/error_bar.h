// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_error_bar_h
#define lamella_estimate_error_bar_h

#include <string>
#include <vector>

namespace lamella
{
  /**
   * When a bar is held to, and how long it is. With these 411 of the 414
   * bars of doc/error-bars.md hold; most are several times too long.
   */
  struct BarRules
  {
    /// The largest ratio of two successive changes that still converges fast
    /// enough to be summed up.
    double most_left = 2. / 3.;
    /// Of the scale: below it all that the values do is taken for their error.
    double small = 1e-2;
    /// Of the scale: values that agree to more are not told from rounding.
    double digits = 1e-8;
    /// The ratio above which a value grows: what has a limit changes less from
    /// one refinement to the next.
    double growth = 0.9;
    /// A bar over the change that it is made of, and over the sum of the
    /// shares, which may cancel in the change.
    double of_change = 2., of_shares = 0.5;
    /// What a goal is held to be off by at least after a pass, of what the
    /// sources that it has less of could have done before.
    double of_pass = 1. / 8.;
  };

  /// What a run, a richer model of the same scene and a still richer one give
  /// for a quantity, in its unit.
  struct Refinements
  {
    double run = 0., richer = 0., richest = 0.;
    /// The sum of |share| over the sources of error (GoalEstimate::shares).
    double shares = 0.;
    /// What errors are small against: the value, or the largest of its kind in
    /// the scene where that is near zero.
    double scale = 0.;
    /// What the arithmetic leaves open of the value.
    double rounding = 0.;
  };

  /// Behind "it changes by so many per cent" where numbers have no limit: at
  /// which places, and what to do.
  std::string
  where_it_grows();

  /// The error of a run's value as it is estimated.
  struct ErrorBar
  {
    /// eta = richest - run, signed: the value plus this is the better number.
    double estimate = 0.;
    /// The true error is held to be at most this, a length of the bar to either
    /// side.
    double bar = 0.;
    /// Whether the two refinements agree, so that the bar can be held to.
    bool trusted = false;
    /// If not, why not: a sentence without a full stop.
    std::string why = {};
    /// What each of several sources has of it, if it was made of such.
    std::vector<double> parts = {};
  };

  /**
   * The bar of a value v_0 from those of two richer models, v_1 and v_2:
   *   estimate  eta = v_2 - v_0
   *   bar       max(2 |eta|, 1/2 sum |shares|, rounding, 1e-8 scale).
   * With an error that each refinement multiplies by q, v_2 - v_1 is q times
   * v_1 - v_0, and eta is short of the error by q^2 of it; the bar is trusted
   * if q is at most 2/3, or if all three values agree to 1e-2 of the scale
   * (twice their spread is the bar then). Values that agree to more than eight
   * digits agree by rounding of which nobody keeps count: a slender cantilever
   * in bending, say, where each model has the exact moments, and conditions of
   * 1e10 and more. A value that goes on in one direction
   * by as much again is told to grow: there is no limit that could be near.
   * (Estimates of goals from richer spaces: Becker and Rannacher, Acta Numerica
   * 10 (2001) 1-102; here these are solved for.)
   */
  ErrorBar
  error_bar(const Refinements &values, const BarRules &rules = {});

  /// What the last two levels below a run, poorer in one source of error, have
  /// changed a quantity by, in its unit: the last change and the one before it,
  /// signed.
  struct Levels
  {
    double last = 0., before = 0.;
    /// What the error of this source is held to be at least: sizes of what may
    /// cancel in the changes.
    double least = 0.;
  };

  /**
   * The bar of a value from what is poorer than its model. With d = |last| and
   * e = |before| of a source, q = d / e and an error that goes on to fall by q,
   * it is off by at most
   *   max(d, 2 d q / (1 - q), least)
   * by this source, where the first holds a q that is small by accident and
   * `least` such a d. With q above 2/3 there is no bar if d or e are a
   * hundredth of @p scale or more, else twice the larger counts. The bar is the
   * sum over @p sources, at least @p rounding and 1e-8 of the scale; the
   * estimate sums last q / (1 - q): no promise, as the next level was not
   * looked at.
   */
  ErrorBar
  error_bar_from_below(const std::vector<Levels> &sources,
                       const double               scale,
                       const double               rounding = 0.,
                       const BarRules            &rules    = {});
} // namespace lamella

#endif
