// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/estimate/coarser_scenes.h>
#include <lamella/estimate/enrichment_estimate.h>
#include <lamella/estimate/local_errors.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  namespace
  {
    /// Returns @p scene with @p fewer wave numbers less for SV-N, 1 at least.
    Scene
    of_fewer_waves(Scene scene, const unsigned int fewer)
    {
      for (BodyDescription &body : scene.bodies)
        if (body.theory.has_responses())
          body.theory.order -= std::min(fewer, body.theory.order - 1);
      return scene;
    }



    Scene
    of_lower_section(Scene scene)
    {
      for (BodyDescription &body : scene.bodies)
        if (body.theory.is_saint_venant() && body.theory.section_order > 1)
          --body.theory.section_order;
      return with_lower_degree(scene);
    }
  } // namespace



  std::string
  EnrichmentEstimate::unavailable_reason(const Simulation &run)
  {
    bool any = false;
    for (const BodyDescription &body : run.model().scene().bodies)
      {
        any = any || body.theory.has_responses();
        if (!body.pieces.empty())
          return "body " + body.name + " is made of pieces";
        if (!body.theory.has_responses() && !body.theory.is_layerwise())
          return "body " + body.name + " is of " + body.theory.name();
      }
    return any ? "" : "no body is of SV-N";
  }



  EnrichmentEstimate::EnrichmentEstimate(const Simulation &run,
                                         std::ostream     &out,
                                         ModelCache       &cache)
    : run(run)
    , of_run(run)
    , of_contact(run)
  {
    const Scene      scene = for_estimates(run);
    ComparisonModels models(run, out, cache);
    if (scene.goals.tolerances.empty())
      compare_with_coarser(models, scene);
    else
      compare_with_enriched(models, scene);
    compare_sections(models, scene);
  }



  void
  EnrichmentEstimate::compare_with_coarser(ComparisonModels &models,
                                           const Scene      &scene)
  {
    others.push_back(
      {Source::axis,
       false,
       rules.of_axis,
       models.solved(with_halved_axes(scene), "poorer in axis").numbers});
    others.push_back(
      {Source::fields,
       false,
       rules.of_fields,
       models
         .solved(of_fewer_waves(scene, rules.fewer_waves), "poorer in fields")
         .numbers});
  }



  void
  EnrichmentEstimate::compare_with_enriched(ComparisonModels &models,
                                            const Scene      &scene)
  {
    const std::vector<BodySize> sizes = sizes_of(run.model());
    const auto                  look  = [this](const Simulation &finer) {
      local = errors_of(of_run, run, finer);
    };
    others.push_back(
      {Source::axis,
       true,
       rules.enriched_factor,
       models
         .solved(enriched(scene, Source::axis, sizes), "richer in axis", look)
         .numbers});
    others.push_back(
      {Source::fields,
       true,
       rules.enriched_factor,
       models.solved(enriched(scene, Source::fields, sizes), "richer in fields")
         .numbers});
  }



  void
  EnrichmentEstimate::compare_sections(ComparisonModels &models,
                                       const Scene      &scene)
  {
    const bool is_low =
      std::any_of(scene.bodies.begin(),
                  scene.bodies.end(),
                  [this](const auto &body) {
                    return body.theory.has_responses() &&
                           body.theory.section_order < rules.min_order;
                  });
    const bool  is_enriched = is_low && !scene.goals.tolerances.empty();
    const Scene other =
      is_enriched ? enriched(scene, Source::section, sizes_of(run.model())) :
                    of_lower_section(scene);
    const ResultNumbers numbers =
      models
        .solved(other, is_enriched ? "richer in section" : "poorer in section")
        .numbers;
    others.push_back({Source::section,
                      is_enriched,
                      is_enriched ? rules.enriched_factor : rules.of_fields,
                      numbers});
    of_contact.compare(of_run.quantities(), models, other, numbers);
  }



  double
  EnrichmentEstimate::change_by(const Other         &other,
                                const NamedQuantity &goal) const
  {
    const double change =
      of_run.numbers().value(goal) - other.numbers.value(goal);
    return other.is_enriched ? -change : change;
  }



  ErrorBar
  EnrichmentEstimate::error_bar_of(const NamedQuantity &goal) const
  {
    const double scale   = of_run.scale_of(goal);
    double       changed = 0.;
    ErrorBar     bar;
    bar.trusted = true;
    for (const Other &other : others)
      {
        const double change = change_by(other, goal);
        bar.bar += other.factor * std::abs(change);
        bar.estimate += other.is_enriched ? change : 0.;
        changed += std::abs(change);
      }
    if (changed > rules.max_change_share * scale)
      {
        bar.trusted = false;
        bar.why     = "slightly different models change the quantity by " +
                  to_text(100. * changed / scale, 2) + " %" +
                  describe_growth() + ", or refine theory and mesh";
      }
    bar.bar = std::max(bar.bar, of_run.rounding_of(goal));
    return bar;
  }



  std::vector<GoalResult>
  EnrichmentEstimate::goals() const
  {
    std::vector<GoalResult> results;
    for (unsigned int k = 0; k < of_run.quantities().size(); ++k)
      {
        const NamedQuantity &quantity = of_run.quantities()[k];
        GoalResult          &result   = results.emplace_back(
          of_run.with_error_bar(k, error_bar_of(quantity)));
        for (const Other &other : others)
          result.shares.emplace_back(name_of(other.source),
                                     other.factor * change_by(other, quantity));
        of_contact.add_to(quantity, result);
        if (!local.empty())
          result.local = local[k];
      }
    return results;
  }
} // namespace lamella
