// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_error_bar_h
#define lamella_estimate_error_bar_h

#include <lamella/estimate/rules.h>

#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /// Values of a quantity in a run, a finer model and a still finer model.
  struct Refinements
  {
    double run      = 0., ///< Value in the run.
      richer        = 0., ///< Value in the finer model.
      richest       = 0.; ///< Value in the finest model.
    double shares   = 0.; ///< Sum of |change| over the error sources.
    double scale    = 0.; ///< Scale: |value|, or largest value of its kind.
    double rounding = 0.; ///< Rounding error of the value in the run.
  };

  /// Returns the causes and the remedy of a diverging value, for messages.
  std::string
  describe_growth();

  /// Estimated error of a value of a run.
  struct ErrorBar
  {
    /// Signed error estimate, to be added to the value: finest model minus run.
    double estimate = 0.;
    double bar      = 0.;    ///< Bound of |error|, to either side of the value.
    bool   trusted  = false; ///< True if successive refinements agree.
    /// Reason if the bar is not trusted, a sentence without a full stop.
    std::string why = {};
    /// Contribution of each of the `sources` of coarser_model_bar() to the bar.
    std::vector<double> parts = {};
    /// Names and signed contributions of error sources; may be empty.
    std::vector<std::pair<std::string, double>> shares = {};
  };

  /// Returns the error bar of a value v_0 from the values v_1, v_2 of two
  /// successively finer models:
  ///   estimate  eta = v_2 - v_0
  ///   bar       max(2 |eta|, 1/2 sum |shares|, rounding, 1e-8 scale).
  /// If each refinement multiplies the error by q, then v_2 - v_1 = q (v_1 -
  /// v_0), and v_2 still has q^2 of the error of v_0. The bar is trusted if q
  /// <= 2/3, or all values agree to 1e-2 of the scale. A value with q >= 0.9 is
  /// reported to diverge. (Becker and Rannacher, Acta Numerica 10, 2001.)
  ErrorBar
  error_bar(const Refinements &values, const EstimateRules &rules = {});

  /// Signed changes of a quantity from two coarser models to the run, by one
  /// error source (mesh, theory, ...).
  struct Levels
  {
    double last = 0., ///< Change from the coarser model to the run.
      before    = 0.; ///< Change from the coarsest to the coarser model.
    /// Lower limit of the error, in case `last` is accidentally small.
    double least = 0.;
  };

  /// Returns the error bar of a value from coarser models. For each error
  /// source let d = |last|, e = |before| (Levels) and q = d / e. The estimate
  /// is the sum of last q / (1 - q), or of last if q > 2/3. The bar is the sum,
  /// but at least @p rounding and 1e-8 @p scale, of
  /// - if q <= 2/3: max(d, 2 d q / (1 - q), Levels::least). d q / (1 - q) is
  ///   the error if it continues to decrease by q; q may be small by accident;
  /// - if q > 2/3: max(2 d, 2 e, Levels::least). The bar is then not trusted if
  ///   d or e exceeds 0.01 @p scale.
  ErrorBar
  coarser_model_bar(const std::vector<Levels> &sources,
                    const double               scale,
                    const double               rounding = 0.,
                    const EstimateRules       &rules    = {});
} // namespace lamella

#endif
