// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/axis/axis.h>
#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/sentence.h>
#include <lamella/base/text.h>
#include <lamella/body/beam.h>
#include <lamella/estimate/axis_marks.h>
#include <lamella/estimate/coarser_model_estimate.h>
#include <lamella/estimate/enrichment_estimate.h>
#include <lamella/estimate/estimation.h>
#include <lamella/estimate/goal_bars.h>
#include <lamella/estimate/halved_axis_estimate.h>
#include <lamella/estimate/run_goals.h>

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



  using namespace dealii;

  namespace
  {
    /// Returns the distances from the start of @p beam, body number @p number,
    /// of supported points and lines, and of supported ends if it is heated.
    std::vector<double>
    held_at(const Beam                 &beam,
            const unsigned int          number,
            const std::vector<Support> &supports)
    {
      const double        length = beam.axis().length();
      std::vector<double> at;
      for (const Support &support : supports)
        for (const Region &region : support.on)
          {
            if (region.body != number)
              continue;
            for (const Point<3> &x : region.at)
              at.push_back(std::clamp(beam.place().to_body(x)[1], 0., length));
            for (const bool at_start : {true, false})
              if (beam.is_heated() && region.covers_end(at_start))
                at.push_back(at_start ? 0. : length);
          }
      return at;
    }



    /// Adds the elements of @p axis, of body @p number, that are longer than
    /// @p longest and contain one of the places @p at, to @p marked.
    void
    mark_long(const AxisMesh            &axis,
              const unsigned int         number,
              const std::vector<double> &at,
              const double               longest,
              std::vector<ElementError> &marked)
    {
      double begin = 0.;
      for (const double length : element_lengths(axis))
        {
          const double near = arithmetic::same_in_element * length;
          if (length > longest &&
              std::any_of(at.begin(), at.end(), [&](const double y) {
                return begin - near < y && y < begin + length + near;
              }))
            {
              ElementError element;
              element.body  = number;
              element.begin = begin;
              element.end   = begin + length;
              marked.push_back(element);
            }
          begin += length;
        }
    }



    /// Returns @p scene with beams of LE-1.
    Scene
    of_first_degree(Scene scene)
    {
      for (BodyDescription &body : scene.bodies)
        if (body.theory.describes_contraction() && !body.theory.is_solid())
          {
            const unsigned int order  = body.theory.section_order;
            body.theory               = Theory::layerwise(1);
            body.theory.section_order = order;
          }
      return scene;
    }



    bool
    has_support_effects(const Scene &scene)
    {
      return std::none_of(scene.bodies.begin(),
                          scene.bodies.end(),
                          [](const BodyDescription &body) {
                            return !body.pieces.empty();
                          }) &&
             std::none_of(scene.contacts.begin(),
                          scene.contacts.end(),
                          [](const ContactPair &contact) {
                            return contact.discretization ==
                                   Discretization::node_to_node;
                          });
    }



    /// Returns @p scene, a scene of the bodies of @p run, with long elements at
    /// supported places bisected @p rules.times; nothing if there are none.
    std::optional<Scene>
    with_short_elements(Scene                         scene,
                        const Simulation             &run,
                        const SupportRefinementRules &rules)
    {
      const auto beams = beams_of(run.model().structure().bodies());
      bool       any   = false;
      for (unsigned int time = 0; time < rules.times; ++time)
        {
          std::vector<ElementError> marked;
          for (unsigned int b = 0; b < beams.size(); ++b)
            if (beams[b] != nullptr &&
                scene.bodies[b].theory.describes_contraction())
              mark_long(scene.bodies[b].axis,
                        b,
                        held_at(*beams[b], b, scene.supports),
                        rules.longest * beams[b]->section().extents().second,
                        marked);
          any   = any || !marked.empty();
          scene = bisected(scene, marked);
        }
      return any ? std::optional(scene) : std::nullopt;
    }
  } // namespace



  std::vector<double>
  support_refinement_changes(const Simulation             &run,
                             std::ostream                 &out,
                             ModelCache                   &cache,
                             const SupportRefinementRules &rules)
  {
    const Scene scene = for_estimates(run);
    if (!has_support_effects(scene))
      return {};
    const auto shorter = with_short_elements(scene, run, rules);
    if (!shorter)
      return {};
    ComparisonModels    models(run, out, cache);
    const ResultNumbers as_is = models
                                  .solved(of_first_degree(scene),
                                          "LE-1, for places that are held")
                                  .numbers,
                        finer = models
                                  .solved(of_first_degree(*shorter),
                                          "LE-1, short elements there")
                                  .numbers;
    std::vector<double> missed;
    const RunGoals      goals(run);
    for (const NamedQuantity &quantity : goals.quantities())
      missed.push_back(finer.value(quantity) - as_is.value(quantity));
    return missed;
  }
} // namespace lamella
