// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/sentence.h>
#include <lamella/base/text.h>
#include <lamella/estimate/coarser_model_estimate.h>
#include <lamella/estimate/enrichment_estimate.h>
#include <lamella/estimate/estimation.h>
#include <lamella/estimate/goal_bars.h>
#include <lamella/estimate/halved_axis_estimate.h>
#include <lamella/estimate/operations.h>
#include <lamella/estimate/support_refinement.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <ostream>
#include <utility>

namespace lamella
{
  namespace
  {
    /// Returns the comparison of @p run with models on coarser axes, if it is
    /// possible, and if it is cheap where bars are not asked for.
    std::optional<HalvedAxisPlan>
    plan_of(const Simulation &run)
    {
      if (!HalvedAxisEstimate::unavailable_reason(run).empty())
        return {};
      const GoalParameters &goals = run.model().scene().goals;
      // A tolerance leads to LE-3, close to LE-2; LE-1 is far from LE-2.
      if (!goals.tolerances.empty())
        return HalvedAxisPlan{1, 3};
      if (goals.bars != ErrorBars::automatic)
        return HalvedAxisPlan();
      const HalvedAxisRules rules;
      return HalvedAxisEstimate::plan(run,
                                      std::max(rules.max_share_of_run *
                                                 operations(run),
                                               rules.free_operations));
    }



    using Goals = std::vector<GoalResult>;

    /// Returns the function that makes the bars of @p run without Estimation,
    /// and the name of the models; empty if impossible or too costly.
    std::pair<std::function<Goals(std::ostream &, ModelCache &)>, std::string>
    choose_estimator(const Simulation &run)
    {
      if (CoarserModelEstimate::unavailable_reason(run).empty())
        return {[&run](std::ostream &out, ModelCache &cache) {
                  return CoarserModelEstimate(run, out, cache).goals();
                },
                "poorer models"};
      if (EnrichmentEstimate::unavailable_reason(run).empty())
        return {[&run](std::ostream &out, ModelCache &cache) {
                  return EnrichmentEstimate(run, out, cache).goals();
                },
                "models that differ in one source each"};
      if (const auto plan = plan_of(run))
        return {[&run, plan](std::ostream &out, ModelCache &cache) {
                  return HalvedAxisEstimate(run, *plan, out, cache).goals();
                },
                "models on coarser axes"};
      return {};
    }



    /// Raises the mesh part of the bars of @p goals to at least twice the
    /// changes @p missed at supported places. Contact parts are added.
    void
    widen(const std::vector<double> &missed, Goals &goals)
    {
      for (unsigned int k = 0; k < missed.size(); ++k)
        {
          GoalResult  &goal  = goals[k];
          const double whole = 2. * missed[k];
          goal.least         = std::abs(whole);
          double of_contact  = 0.;
          for (const auto &[source, share] : goal.shares)
            if (source == name_of(Source::contact) ||
                source == name_of(Source::path))
              of_contact += std::abs(share);
          if (!(goal.least > goal.bar - of_contact))
            continue;
          goal.bar      = goal.least + of_contact;
          goal.estimate = missed[k];
          for (auto &[source, share] : goal.shares)
            if (source == name_of(Source::axis))
              share = whole;
        }
    }



    /// Extends the bars of @p goals by the effects of supported places. If
    /// these models fail, the bars stay and @p out gets a message.
    void
    add_support_effects(const Simulation &run,
                        std::ostream     &out,
                        ModelCache       &cache,
                        Goals            &goals)
    {
      const Outcome outcome = outcome_of(
        [&] { widen(support_refinement_changes(run, out, cache), goals); });
      if (outcome.status != 0)
        out << "  failed: " << trimmed(outcome.message) << std::endl;
    }



    /// Returns the goals of @p run with bars by choose_estimator(). None if
    /// bars are not wanted, impossible or fail; @p failure then has the reason.
    std::optional<Goals>
    cheap_goals(const Simulation &run,
                std::ostream     &out,
                ModelCache       &cache,
                std::string      &failure)
    {
      if (run.model().scene().goals.bars == ErrorBars::richer ||
          !RunGoals::unavailable_reason(run).empty())
        return {};
      const auto [make, from] = choose_estimator(run);
      if (!make)
        return {};
      out << "Error bars, from " << from << ":" << std::endl;
      // A failure of another model must not discard the results of the run.
      std::optional<Goals> goals;
      const Outcome        outcome =
        outcome_of([&, &make = make] { goals = make(out, cache); });
      if (outcome.status != 0)
        {
          failure = strip_period(trimmed(outcome.message));
          out << "  failed: " << failure << "." << std::endl;
          failure =
            from + " have no result (" + failure + "), and of richer ones: ";
        }
      else
        add_support_effects(run, out, cache, *goals);
      return goals;
    }



    /// Returns the bars of a @p run with large rotations, by a coarser axis.
    GoalBars
    bars_for_large_rotations(const Simulation &run,
                             std::ostream     &out,
                             ModelCache       &cache)
    {
      for (const std::string &why :
           {RunGoals::unavailable_reason(run),
            HalvedAxisEstimate::unavailable_reason(run)})
        if (!why.empty())
          return {{}, why};
      out << "Error bars, from a model on a coarser axis:" << std::endl;
      Goals         goals;
      const Outcome outcome = outcome_of([&] {
        goals =
          HalvedAxisEstimate(run, HalvedAxisPlan{1, 0}, out, cache).goals();
      });
      if (outcome.status != 0)
        return {{},
                "the model on a coarser axis has no result (" +
                  trimmed(outcome.message) + ")"};
      return {goals, ""};
    }
  } // namespace



  GoalBars
  error_bars_of(const Simulation &run, std::ostream &out, ModelCache &cache)
  {
    if (run.model().scene().solve.rotations == Rotations::large)
      return bars_for_large_rotations(run, out, cache);
    std::string failure;
    if (const auto goals = cheap_goals(run, out, cache, failure))
      return {*goals, ""};
    Estimation        estimation(run, out, cache);
    const std::string none = estimation.unavailable_reason();
    return {estimation.goals(), none.empty() ? none : failure + none};
  }
} // namespace lamella
