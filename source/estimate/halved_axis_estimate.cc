// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/estimate/coarser_scenes.h>
#include <lamella/estimate/halved_axis_estimate.h>

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



    /// Returns @p scene with axes halved @p times.
    Scene
    with_coarser_axis(Scene scene, const unsigned int times)
    {
      for (unsigned int time = 0; time < times; ++time)
        scene = with_halved_axes(scene);
      return scene;
    }



    /// Returns H_r of the scene of H_p, with LE-@p degree as theory.
    Scene
    with_enriched_section(Scene scene, const unsigned int degree)
    {
      for (BodyDescription &body : scene.bodies)
        if (is_layerwise_only(body))
          ++body.theory.order;
        else
          {
            const unsigned int order  = body.theory.section_order;
            body.theory               = Theory::layerwise(degree);
            body.theory.section_order = order;
            // B2 and B3 with assumed shear strains are for theories that lock.
            body.axis.degree        = 3;
            body.axis.assumed_shear = false;
          }
      return scene;
    }
  } // namespace



  std::string
  HalvedAxisEstimate::unavailable_reason(const Simulation &run)
  {
    const Scene &scene = run.model().scene();
    for (const BodyDescription &body : scene.bodies)
      {
        if (body.theory.is_solid())
          return "body " + body.name + " is a solid";
        if (scene.solve.rotations == Rotations::large)
          continue;
        if (!body.pieces.empty())
          return "body " + body.name + " is made of pieces";
        if (body.theory.has_responses())
          return "body " + body.name + " is of " + body.theory.name();
      }
    return "";
  }



  double
  HalvedAxisEstimate::operations(const Scene                 &scene,
                                 const std::vector<BodySize> &sizes,
                                 const HalvedAxisPlan        &plan)
  {
    const Scene rich = with_enriched_section(scene, plan.degree);
    double      sum  = 0.;
    for (unsigned int b = 0; b < sizes.size(); ++b)
      {
        const double nodes = sizes[b].nodes * std::pow(0.5, plan.times);
        const auto   take  = [&](const unsigned int degree) {
          const double m = layerwise_dofs(sizes[b], degree) / sizes[b].nodes;
          return CostRules().of_block * nodes * m * m * m;
        };
        // H_r, and one degree less: H_p or H_l.
        const unsigned int degree = rich.bodies[b].theory.order;
        sum += take(degree) + (degree > 1 ? take(degree - 1) : 0.);
      }
    return sum;
  }



  std::optional<HalvedAxisPlan>
  HalvedAxisEstimate::plan(const Simulation &run, const double most)
  {
    const Scene                &scene        = run.model().scene();
    const std::vector<BodySize> sizes        = sizes_of(run.model());
    const bool                  any_is_above = any_body(scene, is_above_linear);
    for (const HalvedAxisPlan &plan : {HalvedAxisPlan{1, 2},
                                       HalvedAxisPlan{2, 2},
                                       HalvedAxisPlan{1, 1},
                                       HalvedAxisPlan{2, 1}})
      if (operations(scene, sizes, plan) <= most &&
          !(any_is_above && plan.degree == 1))
        return plan;
    return std::nullopt;
  }



  HalvedAxisEstimate::HalvedAxisEstimate(const Simulation     &run,
                                         const HalvedAxisPlan &plan,
                                         std::ostream         &out,
                                         ModelCache           &cache)
    : run(run)
    , chosen(plan)
    , of_run(run)
    , of_contact(run)
  {
    const Scene scene = for_estimates(run);
    layerwise =
      std::all_of(scene.bodies.begin(), scene.bodies.end(), is_layerwise_only);
    ComparisonModels others(run, out, cache);
    solve_levels(others, scene);
  }



  void
  HalvedAxisEstimate::solve_levels(ComparisonModels &others, const Scene &scene)
  {
    const Scene half_scene = with_coarser_axis(scene, chosen.times);
    if (chosen.degree == 0)
      {
        half = richer = others.solved(half_scene, "coarser axis").numbers;
        return;
      }
    const Scene rich = with_enriched_section(half_scene, chosen.degree);
    const Scene low  = with_lower_degree(layerwise ? half_scene : rich);
    half             = others.solved(half_scene, "coarser axis").numbers;
    richer = others.solved(rich, "coarser axis, richer section").numbers;
    if (any_body(layerwise ? half_scene : rich, [](const auto &body) {
          return is_layerwise_only(body) && body.theory.order > 1;
        }))
      lower = others.solved(low, "coarser axis, poorer section").numbers;
    of_contact.compare(of_run.quantities(), others, half_scene, half);
  }



  ErrorBar
  HalvedAxisEstimate::by_levels(const NamedQuantity &goal) const
  {
    const double value  = of_run.numbers().value(goal),
                 change = richer.value(goal) - half.value(goal),
                 scale  = of_run.scale_of(goal);
    ErrorBar bar;
    bar.estimate = change;
    bar.trusted  = true;
    bar.bar      = 2. * std::abs(change) + (chosen.degree == 0 ? 2. : 1.) *
                                        std::abs(value - half.value(goal));
    if (!lower)
      return bar;
    const double before =
      (layerwise ? half : richer).value(goal) - lower->value(goal);
    bar.bar = std::max(bar.bar,
                       (layerwise ? rules.min_share_of_previous : 1.) *
                         std::abs(before));
    if (layerwise &&
        std::abs(change) > rules.max_remaining_share * std::abs(before) &&
        std::abs(change) > rules.small * scale)
      {
        bar.trusted = false;
        bar.why =
          "the last increase of the section degree changes the quantity by " +
          to_text(100. * before / scale, 2) + " % and the next one by " +
          to_text(100. * change / scale, 2) +
          " %, so it does not converge. Refine the section";
      }
    return bar;
  }



  std::vector<GoalResult>
  HalvedAxisEstimate::goals() const
  {
    std::vector<GoalResult> results;
    for (unsigned int k = 0; k < of_run.quantities().size(); ++k)
      {
        const NamedQuantity &quantity = of_run.quantities()[k];
        const double         value    = of_run.numbers().value(quantity);
        ErrorBar             bar      = by_levels(quantity);
        bar.bar = std::max(bar.bar, of_run.rounding_of(quantity));
        GoalResult &result =
          results.emplace_back(of_run.with_error_bar(k, bar));
        result.shares = {{name_of(Source::axis), value - half.value(quantity)}};
        if (chosen.degree > 0)
          result.shares.emplace_back(
            name_of(layerwise ? Source::section : Source::fields),
            2. * (richer.value(quantity) - half.value(quantity)));
        of_contact.add_to(quantity, result);
      }
    return results;
  }
} // namespace lamella
