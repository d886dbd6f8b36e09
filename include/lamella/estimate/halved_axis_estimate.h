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
  /// Constants of HalvedAxisEstimate.
  struct HalvedAxisRules
  {
    /// Bounds for a trusted bar: there is none if a richer section changes a
    /// goal by more than `max_remaining_share` of the change by the degree
    /// before, and by more than `small` of the scale.
    double max_remaining_share = 0.8, small = 1e-2;
    /// Least bar, as a share of the change by the degree before.
    double min_share_of_previous = 1. / 8.;
    /// Cost limits of bars that are not asked for: a share of the run's
    /// multiplications, and a number of them (about a second) that is always
    /// free.
    double max_share_of_run = 0.5, free_operations = 5e9;
  };

  /// Models that a run is compared with: number of times that the axis is
  /// halved, and degree of the LE that stands in for theories other than LE (0:
  /// sections are not compared).
  struct HalvedAxisPlan
  {
    unsigned int times = 1, degree = 2;
  };

  /**
   * Error bars of runs without poorer models of their own kind: LE-1 and LE-2,
   * EBBT, TBT, TE-N and SV. The models have half of the elements (or a
   * quarter: HalvedAxisPlan) and
   *   H_p  the run's theories and degrees;
   *   H_r  LE with one degree more, other theories replaced by
   *        LE-HalvedAxisPlan::degree;
   *   H_l  one degree less than H_p if all bodies are LE, else than H_r.
   * With s = J(H_r) - J(H_p) the bar is
   *   2 |s| + |J(run) - J(H_p)|,
   * and at least |J(H_p) - J(H_l)| / 8 if all bodies are LE, else
   * |J(H_r) - J(H_l)|. The estimate is s (combination technique).
   *
   * Without a richer section (degree 0) the bar is 2 |J(run) - J(H_p)|, the
   * error of the axis, which also holds if the errors of both models are of
   * similar size and of one sign. Runs with large rotations have only this
   * bar. Penalties and load steps: see ContactShares.
   */
  class HalvedAxisEstimate
  {
  public:
    /// Returns why @p run has no such bars, as a sentence without a full stop;
    /// empty if it has.
    static std::string
    unavailable_reason(const Simulation &run);

    /// Returns the best plan that costs at most @p most multiplications, if
    /// there is one. LE-1 stands in for EBBT, TBT and TE-1 only: it is not
    /// richer than other theories.
    static std::optional<HalvedAxisPlan>
    plan(const Simulation &run, const double most);

    /// Solves the models of @p plan; other arguments, exceptions and
    /// collectivity are those of CoarserModelEstimate().
    HalvedAxisEstimate(const Simulation     &run,
                       const HalvedAxisPlan &plan,
                       std::ostream         &out,
                       ModelCache           &cache);

    std::vector<GoalResult>
    goals() const;

  private:
    /// Returns the approximate multiplications of the models of @p plan, for
    /// @p scene with bodies of @p sizes.
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
    /// Numbers of H_p, H_r and H_l.
    ResultNumbers                half, richer;
    std::optional<ResultNumbers> lower;
  };
} // namespace lamella

#endif
