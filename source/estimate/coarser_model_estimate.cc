// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/estimate/coarser_model_estimate.h>
#include <lamella/estimate/coarser_scenes.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace lamella
{
  namespace
  {
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
  } // namespace



  std::string
  CoarserModelEstimate::unavailable_reason(const Simulation &run)
  {
    const unsigned int degree = CoarserModelRules().min_degree;
    for (const BodyDescription &body : run.model().scene().bodies)
      if (!is_layerwise(body, degree))
        return "body " + body.name + " is no beam of LE-" +
               std::to_string(degree) + " or more";
    return "";
  }



  CoarserModelEstimate::CoarserModelEstimate(const Simulation &run,
                                             std::ostream     &out,
                                             ModelCache       &cache)
    : run(run)
    , of_run(run)
    , dual(run)
    , of_contact(run)
  {
    for (const NamedQuantity &quantity : of_run.quantities())
      derivatives.push_back(dual.derivative(quantity));
    if (Surpluses::unavailable_reason(run, rules.min_degree).empty())
      surpluses = std::make_unique<const Surpluses>(run);
    bool compares = false;
    for (unsigned int k = 0; k < derivatives.size(); ++k)
      compares = compares || needs_coarser_models(k);
    if (compares)
      solve_coarser_models(out, cache);
  }



  bool
  CoarserModelEstimate::needs_coarser_models(const unsigned int number) const
  {
    return !run.model().scene().contacts.empty() || surpluses == nullptr ||
           !derivatives[number];
  }



  void
  CoarserModelEstimate::solve_coarser_models(std::ostream &out,
                                             ModelCache   &cache)
  {
    ComparisonModels others(run, out, cache);
    const auto       poorer = [](const Scene &scene) {
      return with_lower_degree(with_halved_axes(scene));
    };
    const Scene one = poorer(for_estimates(run));
    half = others.solved(one, "one degree less, half the axis").numbers;
    quarter =
      others.solved(poorer(one), "two degrees less, a quarter of it").numbers;
    of_contact.compare(of_run.quantities(), others, one, *half);
  }



  ErrorBar
  CoarserModelEstimate::by_surpluses(const NamedQuantity &goal,
                                     const SurplusParts  &own) const
  {
    const Surplus &section = own.section, &axis = own.axis;
    return coarser_model_bar(
      {{section.last,
        section.before,
        std::max(rules.min_share_of_previous * std::abs(section.before),
                 rules.min_share_of_sizes * section.by_nodes)},
       {axis.last, axis.before, rules.min_share_of_sizes * axis.by_nodes}},
      of_run.scale_of(goal),
      of_run.rounding_of(goal));
  }



  ErrorBar
  CoarserModelEstimate::by_models(const NamedQuantity               &goal,
                                  const std::optional<SurplusParts> &own) const
  {
    const double change  = of_run.numbers().value(goal) - half->value(goal),
                 before  = half->value(goal) - quarter->value(goal);
    const auto by_source = [&](double Surplus::*const level) {
      return own ? std::abs(own->section.*level) + std::abs(own->axis.*level) :
                   0.;
    };
    // The larger one at both levels: sources may cancel in the solved models.
    const double last  = std::max(std::abs(change), by_source(&Surplus::last));
    const double least = rules.min_share_of_previous * std::abs(before);
    return coarser_model_bar(
      {{std::copysign(last, change),
        std::copysign(std::max(std::abs(before), by_source(&Surplus::before)),
                      before),
        least}},
      of_run.scale_of(goal),
      of_run.rounding_of(goal));
  }



  CoarserModelEstimate::Shares
  CoarserModelEstimate::shares_of(const NamedQuantity               &goal,
                                  const ErrorBar                    &bar,
                                  const std::optional<SurplusParts> &own) const
  {
    const std::string section = name_of(Source::section),
                      axis    = name_of(Source::axis);
    if (!own)
      return {
        {axis + " and " + section,
         std::copysign(bar.parts[0],
                       of_run.numbers().value(goal) - half->value(goal))}};
    const double of_section = own->section.last, of_axis = own->axis.last,
                 both = std::abs(of_section) + std::abs(of_axis);
    // Models coarser in both do not separate the sources; surpluses do.
    const bool is_told = bar.parts.size() == 2;
    const auto part    = [&](const unsigned int k, const double last) {
      return std::copysign(is_told    ? bar.parts[k] :
                           both == 0. ? 0.5 * bar.parts[0] :
                                        bar.parts[0] * std::abs(last) / both,
                           last);
    };
    return {{axis, part(1, of_axis)}, {section, part(0, of_section)}};
  }



  std::vector<GoalResult>
  CoarserModelEstimate::goals() const
  {
    std::vector<GoalResult> results;
    for (unsigned int k = 0; k < of_run.quantities().size(); ++k)
      {
        const NamedQuantity        &quantity = of_run.quantities()[k];
        std::optional<SurplusParts> own;
        if (derivatives[k] && surpluses != nullptr)
          {
            BlockVector z = dual.solve(*derivatives[k]).u;
            if (const auto w = dual.lifting(quantity))
              z -= *w;
            own = surpluses->of(z);
          }
        const ErrorBar bar = needs_coarser_models(k) ?
                               by_models(quantity, own) :
                               by_surpluses(quantity, *own);
        GoalResult    &result =
          results.emplace_back(of_run.with_error_bar(k, bar));
        result.shares = shares_of(quantity, bar, own);
        if (own)
          result.local = own->along_axis;
        of_contact.add_to(quantity, result);
      }
    return results;
  }
} // namespace lamella
