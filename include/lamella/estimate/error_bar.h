// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_error_bar_h
#define lamella_estimate_error_bar_h

#include <lamella/recover/named_quantity.h>
#include <lamella/run/simulation.h>

#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /// All numbers that decide on error bars and on refinement to a tolerance.
  /// doc/verification/error-bar-rules.md has error bars without those that
  /// decide in many scenes (`scripts/measure ablation`). The scale is
  /// GoalResult::scale.
  struct EstimateRules
  {
    // Error bars.

    /// Factor in the bar of a change of the goal by a comparison model.
    double safety = 2.;
    /// Largest ratio of successive changes of a value with a trusted bar.
    double max_remaining_share = 2. / 3.;
    /// Largest such ratio for models on coarser axes: the change by a finer
    /// section over the change by the increase of the degree before.
    double max_section_ratio = 0.8;
    /// A bar is also trusted if all changes are below this share of the scale.
    double small = 1e-2;
    /// Differences below this share of the scale are rounding errors.
    double digits = 1e-8;
    /// Ratio of successive changes above which a value is reported to diverge,
    /// and section cells are not divided for it (Passes).
    double growth = 0.9;
    /// Lower limit of a bar, as a fraction of the change one refinement before:
    /// the last change may be small by accident.
    double min_share_of_previous = 1. / 8.;
    /// Smallest degree N of LE-N with bars from models of lower degree: the
    /// change from LE-1 to LE-2 does not bound the error of LE-2.
    unsigned int min_degree = 3;
    /// Number of wave numbers that the coarser model of SV-N omits.
    unsigned int fewer_waves = 3;
    /// Smallest section order of SV-N that a run to a tolerance compares with a
    /// lower order; smaller orders are compared with a higher order.
    unsigned int min_order = 3;
    /// Factor in the bar of SV-N of its change by a halved axis.
    double of_axis = 1.;
    /// Largest sum of changes of SV-N with a trusted bar, share of the scale.
    double max_change_share = 0.1;
    /// Factor in the bar of the change by twice as many substeps: the error is
    /// 1 (first order) to 3.4 times (order 1/2, growing contact) this change.
    double of_path = 4.;
    /// Largest length of an axis element at a support, as a multiple of the
    /// larger section side. Longer ones miss the local disturbance.
    double longest_at_support = 0.5;
    /// Largest cost of `auto` bars, as a fraction of the run's multiplications.
    double max_share_of_run = 0.5;
    /// Number of multiplications that `auto` bars may always take, about a
    /// second: passes of fewer are predicted to take the same time.
    double free_operations = 5e9;
    /// Smallest change of a goal by an error source that is refined once more
    /// (Estimation), as a fraction of the tolerance.
    double min_tolerance_share = 0.1;
    /// Smallest such change without a tolerance, as a fraction of all changes.
    double min_total_share = 0.02;
    /// Factor of the sum of changes by all sources in a bar of Estimation.
    double of_shares = 0.5;

    // Refinement to a tolerance.

    /// Error sources (mesh, theory, ...) are refined, the largest first, until
    /// the others sum to less than this fraction of the tolerance.
    double max_unrefined_share = 0.5;
    /// A goal is dropped (not refined any further) if it has no bar in this
    /// many passes and changes by more than its tolerance in the last of them.
    unsigned int patience = 2;
    /// A goal is dropped if its bar is above the fraction min_progress of the
    /// largest bar of this many passes before.
    unsigned int slow_passes = 2;
    /// Fraction of an earlier bar above which progress is slow (slow_passes).
    double min_progress = 2. / 3.;
    /// Largest ratio of the section error of a degree to that of the degree
    /// before for which the degree is raised again; above it, corners or large
    /// cells limit convergence.
    double max_degree_ratio = 0.5;
    /// Largest number of refinement passes.
    unsigned int max_passes = 8;
    /// Largest error of elements that are not bisected, share of the tolerance.
    double max_axis_remainder = 0.25;
    /// Smallest fraction of the error along the axis in bisected elements.
    double min_bisected_share = 0.65;
    /// SV-N replaces LE only if it has at most this fraction of the DoFs: SV-N
    /// takes two finer models for its bars, LE two coarser ones.
    double max_surrogate_share = 0.5;
    /// Relative tolerance of the resultant loads on refined meshes.
    double loads_agree = 1e-7;
  };

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

  /// Reason why a mode has no bar, for messages.
  inline const char *const no_similar_mode =
    "no mode of a comparison model moves alike. Request fewer modes, or a "
    "richer theory";

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

  /// Goals (output quantities) of a run: values, scales and rounding errors.
  class RunGoals
  {
  public:
    /// Returns why no goal of @p run needs an error bar; empty if one does.
    static std::string
    unavailable_reason(const Simulation &run);

    /// Returns true if @p run has contacts and none is active in its last step.
    static bool
    has_no_active_contact(const Simulation &run);

    /// Evaluates the goals at the last load step. Keeps a reference to @p run.
    explicit RunGoals(const Simulation &run, const GoalRules &rules = {});

    /// Returns the goals of the input file, including all columns of probes.
    const std::vector<NamedQuantity> &
    quantities() const
    {
      return all;
    }

    /// Returns the numerical results of the last load step.
    const ResultNumbers &
    numbers() const
    {
      return values;
    }

    /// Returns why @p quantity, a strain or stress at a probe, is singular
    /// there. Empty if it is not singular, or averaged over a box.
    std::string
    singularity_reason(const NamedQuantity &quantity) const;

    /// Returns the reference value of relative errors of @p quantity: |value|,
    /// or if this is near zero the largest value of its kind in its material
    /// (ResultNumbers::largest_in_material()).
    double
    scale_of(const NamedQuantity &quantity) const;

    /// Returns an estimate of the rounding error of @p quantity: the last
    /// relative correction of the displacements times the largest absolute
    /// value of all quantities of the same type (displacement, strain, stress,
    /// force).
    double
    rounding_of(const NamedQuantity &quantity) const;

    /// Returns the result of goal @p number with the error bar @p bar. A goal
    /// at a singularity is not compared with its tolerance. A goal that is zero
    /// because no contact is active does not meet its tolerance.
    GoalResult
    with_error_bar(const unsigned int number, const ErrorBar &bar) const;

    /// Returns the result of goal @p number without an error bar. If the goal
    /// is at a singularity, the result states this as the reason.
    GoalResult
    without_error_bar(const unsigned int number) const;

  private:
    const Simulation          &run;
    GoalRules                  rules;
    ResultNumbers              values;
    std::vector<NamedQuantity> all;
  };
} // namespace lamella

#endif
