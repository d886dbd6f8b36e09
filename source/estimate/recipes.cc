// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/estimate/comparison.h>
#include <lamella/estimate/enrichment.h>
#include <lamella/estimate/estimation.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  namespace
  {
    template <typename Is>
    bool
    any_body(const Scene &scene, const Is &is)
    {
      return std::any_of(scene.bodies.begin(), scene.bodies.end(), is);
    }



    std::string
    body_of(const BodyDescription &body)
    {
      return "body " + body.name + " is of " + body.theory.name();
    }



    /// Returns whether all of @p body is LE of @p degree or more.
    bool
    is_layerwise(const BodyDescription &body, const unsigned int degree)
    {
      const auto is = [degree](const Theory &theory) {
        return theory.is_layerwise() && theory.order >= degree;
      };
      return body.pieces.empty() ? is(body.theory) :
                                   std::all_of(body.pieces.theories.begin(),
                                               body.pieces.theories.end(),
                                               is);
    }



    /// Returns the bar of a goal from its surpluses alone.
    ErrorBar
    bar_by_surpluses(const ComparedValues &goal, const EstimateRules &rules)
    {
      const Surplus &section = goal.surplus->section,
                    &axis    = goal.surplus->axis;
      return coarser_model_bar({{section.last,
                                 section.before,
                                 rules.min_share_of_previous *
                                   std::abs(section.before)},
                                {axis.last, axis.before, 0.}},
                               goal.scale,
                               goal.rounding,
                               rules);
    }



    /// Returns the bar of a goal from two coarser models, and its surpluses.
    ErrorBar
    bar_by_models(const ComparedValues &goal, const EstimateRules &rules)
    {
      const double change  = goal.run - goal.models[0],
                   before  = goal.models[0] - goal.models[1];
      const auto by_source = [&](double Surplus::*const level) {
        return goal.surplus ? std::abs(goal.surplus->section.*level) +
                                std::abs(goal.surplus->axis.*level) :
                              0.;
      };
      // The larger one at both levels: sources may cancel in the solved models.
      const double last = std::max(std::abs(change), by_source(&Surplus::last));
      return coarser_model_bar(
        {{std::copysign(last, change),
          std::copysign(std::max(std::abs(before), by_source(&Surplus::before)),
                        before),
          rules.min_share_of_previous * std::abs(before)}},
        goal.scale,
        goal.rounding,
        rules);
    }



    ErrorBar
    bar_by_coarser_models(const ComparedValues &goal,
                          const EstimateRules  &rules)
    {
      ErrorBar bar = goal.models.empty() ? bar_by_surpluses(goal, rules) :
                                           bar_by_models(goal, rules);
      const std::string section = name_of(Source::section),
                        axis    = name_of(Source::axis);
      if (!goal.surplus)
        {
          bar.shares = {
            {axis + " and " + section,
             std::copysign(bar.parts[0], goal.run - goal.models[0])}};
          return bar;
        }
      // Models coarser in both do not separate the sources; surpluses do.
      const double of_section = goal.surplus->section.last,
                   of_axis    = goal.surplus->axis.last,
                   both       = std::abs(of_section) + std::abs(of_axis);
      const auto part         = [&](const unsigned int k, const double last) {
        return std::copysign(bar.parts.size() == 2 ? bar.parts[k] :
                             both == 0. ? 0.5 * bar.parts[0] :
                                          bar.parts[0] * std::abs(last) / both,
                             last);
      };
      bar.shares = {{axis, part(1, of_axis)}, {section, part(0, of_section)}};
      return bar;
    }



    /// Comparison with a model that differs in one error source.
    struct SourceChange
    {
      Source source;
      bool   is_to_finer = false; ///< True if the model is finer than the run.
      double factor      = 0.;    ///< Factor of |change| in the bar.
    };



    ErrorBar
    bar_by_source(const std::vector<SourceChange> &changes,
                  const ComparedValues            &goal,
                  const EstimateRules             &rules)
    {
      double   changed = 0.;
      ErrorBar bar;
      bar.trusted = true;
      for (unsigned int k = 0; k < changes.size(); ++k)
        {
          const auto &[source, is_to_finer, factor] = changes[k];
          const double change =
            (is_to_finer ? 1. : -1.) * (goal.models[k] - goal.run);
          bar.bar += factor * std::abs(change);
          bar.estimate += is_to_finer ? change : 0.;
          bar.shares.emplace_back(name_of(source), factor * change);
          changed += std::abs(change);
        }
      if (changed > rules.max_change_share * goal.scale)
        {
          bar.trusted = false;
          bar.why     = "slightly different models change the quantity by " +
                    to_text(100. * changed / goal.scale, 2) + " %" +
                    describe_growth() + ", or refine theory and mesh";
        }
      bar.bar = std::max(bar.bar, goal.rounding);
      return bar;
    }



    /// Returns why bodies of @p run have no bars by single_source_recipe().
    std::string
    reason_for_other_sources(const Scene &scene)
    {
      for (const BodyDescription &body : scene.bodies)
        if (!body.pieces.empty())
          return "body " + body.name + " is made of pieces";
        else if (!body.theory.has_responses() && !body.theory.is_layerwise())
          return body_of(body);
      return any_body(scene,
                      [](const BodyDescription &body) {
                        return body.theory.has_responses();
                      }) ?
               "" :
               "no body is of SV-N";
    }



    bool
    is_layerwise_only(const BodyDescription &body)
    {
      return body.theory.is_layerwise() && body.pieces.empty();
    }



    /// Returns whether LE-1 is not richer than the theory of @p body: TE-3 and
    /// SV have functions that LE-1 lacks.
    bool
    is_above_linear(const BodyDescription &body)
    {
      return body.theory.is_saint_venant() ||
             (body.theory.is_taylor() && body.theory.order > 1);
    }



    std::string
    reason_for_axis(const Scene &scene)
    {
      for (const BodyDescription &body : scene.bodies)
        {
          if (body.theory.is_solid())
            return "body " + body.name + " is a solid";
          if (scene.solve.rotations == Rotations::large)
            continue;
          if (!body.pieces.empty())
            return "body " + body.name + " is made of pieces";
          if (body.theory.has_responses())
            return body_of(body);
        }
      return "";
    }



    /// Returns the bar of @p goal from the models H_p, H_r and perhaps H_l.
    ErrorBar
    bar_by_halved_axis(const ComparedValues &goal,
                       const bool            is_layerwise,
                       const EstimateRules  &rules)
    {
      const double half = goal.models[0], change = goal.models[1] - half,
                   axis = goal.run - half;
      ErrorBar bar;
      bar.estimate = change;
      bar.trusted  = true;
      bar.bar      = rules.safety * std::abs(change) + std::abs(axis);
      bar.shares   = {{name_of(Source::axis), axis},
                      {name_of(is_layerwise ? Source::section : Source::fields),
                       rules.safety * change}};
      if (goal.models.size() > 2)
        {
          const double before =
            goal.models[is_layerwise ? 0 : 1] - goal.models[2];
          bar.bar = std::max(bar.bar,
                             (is_layerwise ? rules.min_share_of_previous : 1.) *
                               std::abs(before));
          if (is_layerwise &&
              std::abs(change) > rules.max_section_ratio * std::abs(before) &&
              std::abs(change) > rules.small * goal.scale)
            {
              bar.trusted = false;
              bar.why     = "the last increase of the section degree changes "
                            "the quantity by " +
                        to_text(100. * before / goal.scale, 2) +
                        " % and the next one by " +
                        to_text(100. * change / goal.scale, 2) +
                        " %, so it does not converge. Refine the section";
            }
        }
      bar.bar = std::max(bar.bar, goal.rounding);
      return bar;
    }



    /// Returns the bar of @p goal from half of the elements alone.
    ErrorBar
    bar_by_axis(const ComparedValues &goal, const EstimateRules &rules)
    {
      const double change = goal.run - goal.models[0];
      ErrorBar     bar;
      bar.trusted = true;
      bar.bar     = std::max(rules.safety * std::abs(change), goal.rounding);
      bar.shares  = {{name_of(Source::axis), change}};
      return bar;
    }
  } // namespace



  Recipe
  coarser_model_recipe(const Simulation &run, const EstimateRules &rules)
  {
    Recipe recipe;
    recipe.from = "poorer models";
    for (const BodyDescription &body : run.model().scene().bodies)
      if (!is_layerwise(body, rules.min_degree))
        {
          recipe.unavailable = "body " + body.name + " is no beam of LE-" +
                               std::to_string(rules.min_degree) + " or more";
          return recipe;
        }
    const auto poorer = [](const Scene &scene) {
      return with_lower_degree(with_halved_axes(scene));
    };
    const Scene one   = poorer(for_estimates(run));
    recipe.models     = {{"one degree less, half the axis", one},
                         {"two degrees less, a quarter of it", poorer(one)}};
    recipe.of_contact = 0;
    recipe.has_surpluses =
      Surpluses::unavailable_reason(run, rules.min_degree).empty();
    recipe.bar = [rules](const ComparedValues &goal) {
      return bar_by_coarser_models(goal, rules);
    };
    return recipe;
  }



  Recipe
  single_source_recipe(const Simulation &run, const EstimateRules &rules)
  {
    Recipe recipe;
    recipe.from        = "models that differ in one source each";
    recipe.unavailable = reason_for_other_sources(run.model().scene());
    if (!recipe.unavailable.empty())
      return recipe;
    const Scene                 scene       = for_estimates(run);
    const std::vector<BodySize> sizes       = sizes_of(run.model());
    const bool                  is_to_finer = !scene.goals.tolerances.empty();
    const bool is_low = any_body(scene, [&rules](const BodyDescription &body) {
      return body.theory.has_responses() &&
             body.theory.section_order < rules.min_order;
    });
    std::vector<SourceChange> changes;
    const auto                add = [&](const Source source,
                         const bool   finer,
                         const Scene &coarser,
                         const double factor) {
      changes.push_back({source, finer, finer ? rules.safety : factor});
      recipe.models.push_back(
        {std::string(finer ? "richer" : "poorer") + " in " + name_of(source),
         finer ? enriched(scene, source, sizes) : coarser,
         finer && source == Source::axis});
    };
    add(Source::axis, is_to_finer, with_halved_axes(scene), rules.of_axis);
    add(Source::fields,
        is_to_finer,
        with_fewer_waves(scene, rules.fewer_waves),
        rules.safety);
    add(Source::section,
        is_to_finer && is_low,
        with_lower_section_order(scene),
        rules.safety);
    recipe.of_contact = 2;
    recipe.bar        = [changes, rules](const ComparedValues &goal) {
      return bar_by_source(changes, goal, rules);
    };
    return recipe;
  }



  Recipe
  halved_axis_recipe(const Simulation     &run,
                     const HalvedAxisPlan &plan,
                     const EstimateRules  &rules)
  {
    Recipe recipe;
    recipe.from        = "models on coarser axes";
    recipe.unavailable = reason_for_axis(run.model().scene());
    if (!recipe.unavailable.empty())
      return recipe;
    Scene half = for_estimates(run);
    for (unsigned int time = 0; time < plan.times; ++time)
      half = with_halved_axes(half);
    recipe.models = {{"coarser axis", half}};
    if (plan.degree == 0)
      {
        recipe.from = "models on a coarser axis";
        recipe.bar  = [rules](const ComparedValues &goal) {
          return bar_by_axis(goal, rules);
        };
        return recipe;
      }
    const bool is_layerwise =
      std::all_of(half.bodies.begin(), half.bodies.end(), is_layerwise_only);
    const Scene rich   = with_enriched_section(half, plan.degree),
                &above = is_layerwise ? half : rich;
    recipe.models.push_back({"coarser axis, richer section", rich});
    if (any_body(above, [](const BodyDescription &body) {
          return is_layerwise_only(body) && body.theory.order > 1;
        }))
      recipe.models.push_back(
        {"coarser axis, poorer section", with_lower_degree(above)});
    recipe.of_contact = 0;
    recipe.bar        = [is_layerwise, rules](const ComparedValues &goal) {
      return bar_by_halved_axis(goal, is_layerwise, rules);
    };
    return recipe;
  }



  std::optional<HalvedAxisPlan>
  affordable_plan(const Simulation &run, const double most)
  {
    const Scene                &scene        = run.model().scene();
    const std::vector<BodySize> sizes        = sizes_of(run.model());
    const bool                  any_is_above = any_body(scene, is_above_linear);
    for (const HalvedAxisPlan &plan : {HalvedAxisPlan{1, 2},
                                       HalvedAxisPlan{2, 2},
                                       HalvedAxisPlan{1, 1},
                                       HalvedAxisPlan{2, 1}})
      if (operations_of_coarser_axes(with_enriched_section(scene, plan.degree),
                                     sizes,
                                     plan.times) <= most &&
          !(any_is_above && plan.degree == 1))
        return plan;
    return std::nullopt;
  }



  Recipe
  choose_recipe(const Simulation &run, const EstimateRules &rules)
  {
    const Scene &scene = run.model().scene();
    if (scene.solve.rotations == Rotations::large)
      return halved_axis_recipe(run, {1, 0}, rules);
    if (Recipe recipe = coarser_model_recipe(run, rules);
        recipe.unavailable.empty())
      return recipe;
    if (Recipe recipe = single_source_recipe(run, rules);
        recipe.unavailable.empty())
      return recipe;
    // A tolerance leads to LE-3, close to LE-2; LE-1 is far from LE-2.
    std::optional<HalvedAxisPlan> plan = HalvedAxisPlan();
    if (!scene.goals.tolerances.empty())
      plan->degree = 3;
    else if (scene.goals.bars == ErrorBars::automatic)
      plan = affordable_plan(run,
                             std::max(rules.max_share_of_run * operations(run),
                                      rules.free_operations));
    if (plan)
      return halved_axis_recipe(run, *plan, rules);
    Recipe none;
    none.unavailable = "models on coarser axes would cost too much";
    return none;
  }



  std::vector<ComparisonModel>
  models_at_supports(const Simulation &run, const EstimateRules &rules)
  {
    const Scene scene = for_estimates(run);
    const bool  is_in_pieces =
      any_body(scene, [](const auto &body) { return !body.pieces.empty(); });
    if (is_in_pieces || scene.solve.rotations == Rotations::large ||
        pairs_nodes(scene))
      return {};
    const auto shorter =
      with_short_elements_at_supports(scene, run, rules.longest_at_support);
    if (!shorter)
      return {};
    return {{"LE-1, for places that are held", with_first_degree(scene)},
            {"LE-1, short elements there", with_first_degree(*shorter)}};
  }
} // namespace lamella
