// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_halved_axis_estimate_h
#define lamella_estimate_halved_axis_estimate_h

#include <lamella/estimate/comparison_models.h>
#include <lamella/estimate/contact_shares.h>
#include <lamella/estimate/error_bar.h>
#include <lamella/estimate/run_goals.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /// Parameters of HalvedAxisEstimate.
  struct HalvedAxisRules
  {
    /// A bar is trusted if a finer section changes the goal by at most
    /// `max_remaining_share` of the previous change, or `small` of the scale.
    double max_remaining_share = 0.8, small = 1e-2;
    /// The bar is at least this fraction of the change by the previous degree.
    double min_share_of_previous = 1. / 8.;
    /// Limits of multiplications for `auto` bars: a fraction of those of the
    /// run, and a number (about a second) that is always allowed.
    double max_share_of_run = 0.5, free_operations = 5e9;
  };

  /// Comparison models of HalvedAxisEstimate: number of halvings of the axis,
  /// and degree of LE that replaces other theories (0: none).
  struct HalvedAxisPlan
  {
    unsigned int times = 1, degree = 2;
  };

  /// Error bars of runs for which there are no coarser models of the same
  /// theory: LE-1 and LE-2, EBBT, TBT, TE-N and SV. The comparison models have
  /// half of the elements (or a quarter: HalvedAxisPlan) and
  /// - H_p: the run's theories and degrees;
  /// - H_r: LE with one degree more, other theories replaced by LE of the
  ///   degree of HalvedAxisPlan;
  /// - H_l: one degree less than H_p if all bodies are LE, else than H_r.
  ///
  /// With s = J(H_r) - J(H_p) for the goal J, the bar is
  ///   2 |s| + |J(run) - J(H_p)|,
  /// and at least |J(H_p) - J(H_l)| / 8 if all bodies are LE, else |J(H_r) -
  /// J(H_l)|. The error estimate is s (combination technique). If there is no
  /// finer section (degree 0), as for large rotations, the bar is 2 |J(run) -
  /// J(H_p)|, the axis error. ContactShares adds penalties and load steps.
  class HalvedAxisEstimate
  {
  public:
    /// Returns why this method is not possible for @p run; empty if it is.
    static std::string
    unavailable_reason(const Simulation &run);

    /// Returns the best models, if any, that take at most @p most
    /// multiplications. LE-1 replaces EBBT, TBT and TE-1 only.
    static std::optional<HalvedAxisPlan>
    plan(const Simulation &run, const double most);

    /// Solves the models of @p plan; arguments as of CoarserModelEstimate().
    HalvedAxisEstimate(const Simulation     &run,
                       const HalvedAxisPlan &plan,
                       std::ostream         &out,
                       ModelCache           &cache);

    std::vector<GoalResult>
    goals() const;

  private:
    /// Returns the approximate number of multiplications of @p plan.
    static double
    operations(const Scene                 &scene,
               const std::vector<BodySize> &sizes,
               const HalvedAxisPlan        &plan);
    void
    solve_levels(ComparisonModels &others, const Scene &scene);
    GoalResult
    goal(const unsigned int number) const;
    ErrorBar
    by_levels(const NamedQuantity &goal) const;

    const Simulation &run;
    HalvedAxisPlan    chosen;
    HalvedAxisRules   rules;
    RunGoals          of_run;
    ContactShares     of_contact;
    /// True if all bodies are LE.
    bool layerwise = false;
    /// Results of H_p, H_r and H_l.
    ResultNumbers                half, richer;
    std::optional<ResultNumbers> lower;
  };
} // namespace lamella

#endif
