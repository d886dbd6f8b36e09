// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_bars_from_half_h
#define lamella_estimate_bars_from_half_h

#include <lamella/estimate/contact_shares.h>
#include <lamella/estimate/error_bar.h>
#include <lamella/estimate/other_models.h>
#include <lamella/estimate/run_goals.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /// What bars from models on half of the axis are made by.
  struct HalfRules
  {
    /// A richer section that changes a goal by more than this share of what
    /// the degree before did has no bar, where that is `small` of the scale or
    /// more: it grows, or does not contract.
    double most_left = 0.8, small = 1e-2;
    /// Of the change before: what the error is held to be at least.
    double least_of_before = 1. / 8.;
    /// Bars that nobody asks for may take this share of the run's
    /// multiplications, or so many: about a second.
    double most_of_run = 0.5, free_operations = 5e9;
  };

  /// The models that a run is compared with: elements along the axis halved so
  /// often, and the degree of the LE that stands for theories without
  /// responses; 0 if the section is not compared.
  struct HalfPlan
  {
    unsigned int times = 1, degree = 2;
  };

  /**
   * The errors of a run's goals that has nothing poorer to tell them by: LE-1
   * and LE-2, EBBT, TBT, TE-N and SV. Models on half of the elements (or a
   * quarter: HalfPlan) have
   *   H_p  the run's theories and degrees,
   *   H_r  one degree more for LE, what enriched() has in mind for the fields
   * of others (LE-2, or SV-6 and more), H_l  one degree less than H_p for LE;
   * than H_r where that is LE, and with s = J(H_r) - J(H_p) the value of the
   * run has the bar 2 |s| + |J(run) - J(H_p)|,   at least |J(H_p) - J(H_l)| /
   * 8, or of others than LE |J(H_r) - J(H_l)|: their families are no levels of
   * LE. The value plus s is the better number (the combination technique).
   *
   * Without a richer section (degree 0) the bar is 2 |J(run) - J(H_p)|, the
   * error of the axis, also if the errors of both models are alike and of one
   * sign. Runs with large rotations have only this bar.
   *
   * Penalties: as in BarsFromBelow.
   */
  class BarsFromHalf
  {
  public:
    /// Why there are none of @p run: a sentence without a full stop; empty if
    /// there are.
    static std::string
    reason_for_none(const Simulation &run);

    /// The best of the plans that costs at most @p most multiplications, if one
    /// does; LE-1 stands for EBBT, TBT and TE-1 alone, since it is not richer
    /// than others.
    static std::optional<HalfPlan>
    plan(const Simulation &run, const double most);

    /// As BarsFromBelow().
    BarsFromHalf(const Simulation &run,
                 const HalfPlan   &plan,
                 std::ostream     &out,
                 ModelCache       &cache);

    std::vector<GoalResult>
    goals() const;

  private:
    /// What the models of @p plan take, about, in multiplications, of @p scene
    /// whose bodies have @p sizes.
    static double
    operations(const Scene                 &scene,
               const std::vector<BodySize> &sizes,
               const HalfPlan              &plan);
    void
    solve_levels(OtherModels &others, const Scene &scene);
    GoalResult
    goal(const unsigned int number) const;
    ErrorBar
    by_levels(const NamedQuantity &goal) const;

    const Simulation &run;
    HalfPlan          chosen;
    HalfRules         rules;
    RunGoals          of_run;
    ContactShares     of_contact;
    /// Whether all bodies are of LE.
    bool layerwise = false;
    /// H_p, H_r and H_l.
    ResultNumbers                half, richer;
    std::optional<ResultNumbers> lower;
  };
} // namespace lamella

#endif
