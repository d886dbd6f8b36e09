// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_halved_axis_estimate_h
#define lamella_estimate_halved_axis_estimate_h

#include <lamella/estimate/comparison_models.h>
#include <lamella/estimate/contact_shares.h>
#include <lamella/estimate/error_bar.h>
#include <lamella/estimate/run_goals.h>

#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// Parameters of error bars from models with halved axes.
  struct HalvedAxisRules
  {
    /// A bar is trusted if the change by a finer section is below this fraction
    /// of the change by the previous increase of the degree.
    double max_remaining_share = 0.8;
    /// A bar is also trusted if this change is below `small` times the scale.
    double small = 1e-2;
    /// Smallest bar, as a fraction of the change by the previous degree.
    double min_share_of_previous = 1. / 8.;
    /// Largest cost of `auto` bars, as a fraction of the run's multiplications.
    double max_share_of_run = 0.5,
           free_operations = 5e9; ///< Number of multiplications always allowed.
  };

  /// Choice of the comparison models of HalvedAxisEstimate.
  struct HalvedAxisPlan
  {
    /// Number of times that the number of axis elements is halved.
    unsigned int times = 1;
    /// Degree of LE that replaces other theories; 0 if sections are unchanged.
    unsigned int degree = 2;
  };

  /// Error bars of runs for which there are no coarser models of the same
  /// theory: LE-1 and LE-2 (Lagrange expansions), EBBT, TBT, TE-N and SV. The
  /// comparison models have half or a quarter of the axis elements
  /// (HalvedAxisPlan) and
  /// - H_p: the run's theories and degrees;
  /// - H_r: LE with one degree more; LE of the degree of HalvedAxisPlan
  ///   replaces other theories;
  /// - H_l: one degree less than H_p if all bodies are LE, else than H_r.
  ///
  /// The error estimate of a goal J is s = J(H_r) - J(H_p), and the bar is
  ///   2 |s| + |J(run) - J(H_p)|.
  /// It is at least |J(H_p) - J(H_l)| / 8 if all bodies are LE, and at least
  /// |J(H_r) - J(H_l)| otherwise. If there is no finer section (degree 0), as
  /// for large rotations, the bar is 2 |J(run) - J(H_p)|. ContactShares adds
  /// penalties and load steps.
  class HalvedAxisEstimate
  {
  public:
    /// Returns the reason why @p run cannot have such error bars, a sentence
    /// for the user; empty if it can.
    static std::string
    unavailable_reason(const Simulation &run);

    /// Returns the most accurate comparison models of at most @p most
    /// multiplications, if any. LE-1 replaces only EBBT, TBT and TE-1.
    static std::optional<HalvedAxisPlan>
    plan(const Simulation &run, const double most);

    /// Solves the comparison models @p plan of @p run, whose last load step
    /// must be solved. Prints a line per model to @p out. @p cache stores the
    /// models.
    HalvedAxisEstimate(const Simulation     &run,
                       const HalvedAxisPlan &plan,
                       std::ostream         &out,
                       ModelCache           &cache);

    /// Returns the goals of the input file with their error bars.
    std::vector<GoalResult>
    goals() const;

  private:
    /// Returns the estimated number of multiplications of @p plan.
    static double
    operations(const Scene                 &scene,
               const std::vector<BodySize> &sizes,
               const HalvedAxisPlan        &plan);
    void
    solve_levels(ComparisonModels &others, const Scene &scene);
    ErrorBar
    by_levels(const NamedQuantity &goal) const;

    const Simulation &run;
    HalvedAxisPlan    chosen;
    HalvedAxisRules   rules;
    RunGoals          of_run;
    ContactShares     of_contact;
    bool layerwise = false; ///< True if all bodies have Lagrange expansions.
    /// Results with the run's section, a finer section and a coarser section.
    ResultNumbers                half, richer;
    std::optional<ResultNumbers> lower;
  };
} // namespace lamella

#endif
