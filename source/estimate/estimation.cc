// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/adapt/boundary_layer_modes.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/body/beam.h>
#include <lamella/estimate/estimation.h>
#include <lamella/estimate/local_errors.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

namespace lamella
{
  namespace
  {
    double
    operations(const BodySummary &body)
    {
      return body.solver ?
               operations_of_factor(body.solver->non_zeros, body.dofs) :
               0.;
    }



    std::size_t
    n_load_vectors(const std::vector<LocalInteraction> &touches)
    {
      std::size_t n = 0;
      for (const LocalInteraction &touch : touches)
        if (!touch.constrains_section)
          n += touch.loads.size();
      return n;
    }
  } // namespace



  double
  operations(const Simulation &run)
  {
    double sum = 0.;
    for (const BodySummary &body : run.results().bodies)
      sum += operations(body);
    return sum;
  }



  double
  operations_of_bars(const Simulation &run,
                     const PlanRules  &rules,
                     const CostRules  &cost)
  {
    const double                m      = rules.fields_of_responses;
    double                      sum    = 0.;
    const std::vector<BodySize> sizes  = sizes_of(run.model());
    const Bodies               &bodies = run.model().structure().bodies();
    const Scene                &scene  = run.model().scene();
    const auto                  beams  = beams_of(bodies);
    for (unsigned int b = 0; b < sizes.size(); ++b)
      {
        if (!may_have_responses(scene.bodies[b], sizes[b], rules) ||
            2. * sizes[b].dofs <= rules.max_layerwise_dofs)
          return std::numeric_limits<double>::infinity();
        sum += cost.axes * sizes[b].nodes * cost.of_block * m * m * m;
        // The body is LE-N, since it may have responses: a beam.
        const Beam  &beam    = *beams[b];
        const auto   touches = find_interactions(beam,
                                               b,
                                               bodies,
                                               scene.supports,
                                               scene.loads,
                                               run.model().interfaces());
        const double answers = 2. * cost.waves * n_load_vectors(touches);
        sum += sizes[b].fields * answers * answers +
               cost.of_eigenvectors * answers * answers * answers;
        sum += double(nodes_of_pieces(beam, touches)) / sizes[b].nodes *
               operations(run.results().bodies[b]);
      }
    return sum;
  }



  double
  operations_of_coarser_axes(const Scene                 &rich,
                             const std::vector<BodySize> &sizes,
                             const unsigned int           times)
  {
    double sum = 0.;
    for (unsigned int b = 0; b < sizes.size(); ++b)
      {
        const double nodes = sizes[b].nodes * std::pow(0.5, times);
        const auto   take  = [&](const unsigned int degree) {
          const double m = layerwise_dofs(sizes[b], degree) / sizes[b].nodes;
          return CostRules().of_block * nodes * m * m * m;
        };
        // The finer section, and one degree less.
        const unsigned int degree = rich.bodies[b].theory.order;
        sum += take(degree) + (degree > 1 ? take(degree - 1) : 0.);
      }
    return sum;
  }



  Estimation::Estimation(const Simulation    &run,
                         std::ostream        &out,
                         ModelCache          &cache,
                         const EstimateRules &rules)
    : rules(rules)
    , run(run)
    , out(out)
    , cache(cache)
    , others(run, out, cache)
  {}



  std::string
  Estimation::unavailable_reason() const
  {
    const GoalParameters &goals = run.model().scene().goals;
    if (std::string none = RunGoals::unavailable_reason(run); !none.empty())
      return none;
    if (goals.bars == ErrorBars::automatic &&
        !(operations_of_bars(run) <= rules.max_share_of_run * operations(run)))
      return "they would cost more than half of what the run does; --set "
             "\"Goals/Error bars=true\" makes them";
    return "";
  }



  bool
  Estimation::has_all(const NamedQuantity &quantity) const
  {
    return std::all_of(models.begin(), models.end(), [&](const Model &model) {
      return model.numbers.has(quantity);
    });
  }



  double
  Estimation::share_of(const Step &step, const NamedQuantity &quantity) const
  {
    return has_all(quantity) ? models[step.to].numbers.value(quantity) -
                                 models[step.from].numbers.value(quantity) :
                               0.;
  }



  double
  Estimation::weight_of(const Step &step) const
  {
    double       weight = 0.;
    unsigned int number = 0;
    for (const NamedQuantity &quantity : of_run->quantities())
      {
        const GoalResult without_error_bar =
          of_run->without_error_bar(number++);
        const double most =
          without_error_bar.tolerance ?
            rules.min_tolerance_share * without_error_bar.allowed_error() :
            rules.min_total_share * first_refinement(quantity).shares;
        if (most > 0.)
          weight = std::max(weight, std::abs(share_of(step, quantity)) / most);
      }
    return weight;
  }



  Refinements
  Estimation::first_refinement(const NamedQuantity &quantity) const
  {
    Refinements values;
    values.run    = models[0].numbers.value(quantity);
    values.richer = values.run;
    for (const Step &step : steps)
      {
        values.richer += share_of(step, quantity);
        values.shares += std::abs(share_of(step, quantity));
      }
    values.scale    = of_run->scale_of(quantity);
    values.rounding = of_run->rounding_of(quantity);
    return values;
  }



  std::vector<Source>
  Estimation::significant_sources() const
  {
    double largest = 0.;
    for (const Step &step : steps)
      if (step.source != Source::contact)
        largest = std::max(largest, weight_of(step));
    std::vector<Source> some;
    for (const Step &step : steps)
      if (step.source != Source::contact &&
          weight_of(step) >= std::min(1., largest))
        some.push_back(step.source);
    return some;
  }



  void
  Estimation::add_step(const Source source)
  {
    const Scene scene =
      enriched(models[base].scene, source, models[base].sizes);
    const std::string what = std::string("richer in ") + name_of(source);
    const auto        look = [this](const Simulation &finer) {
      local = errors_of(*of_run, run, finer);
    };
    // Duals give the errors along the axis; with friction there are none.
    const bool is_first =
      source == Source::axis && base == 0 && !has_source(scene, Source::path);
    const bool is_known = cache.find(scene) != nullptr;
    models.push_back(is_first && !is_known ? others.solved(scene, what, look) :
                                             others.solved(scene, what));
    const Step step{source, base, static_cast<unsigned int>(models.size() - 1)};
    steps.push_back(step);
    const bool matters =
      run.model().scene().goals.tolerances.empty() || weight_of(step) >= 1.;
    if (is_first && is_known && matters)
      others.solved(scene, what + " (again, for where)", look);
    if (matters)
      base = step.to;
  }



  void
  Estimation::solve_hierarchy()
  {
    cache.keep(models.front());
    for (const NameOf<Source> &source : Names<Source>::all)
      if (has_source(models[base].scene, source.value))
        add_step(source.value);
    solve_richest_model();
  }



  void
  Estimation::solve_richest_model()
  {
    const std::vector<Source> some = significant_sources();
    before_richest                 = base;
    // A single source is refined again right after its first refinement: the
    // later ones in the chain do not matter.
    for (const Step &step : steps)
      if (some.size() == 1 && some.front() == step.source)
        before_richest = step.to;
    // LE in place of other fields gets a richer, possibly known, section.
    std::vector<Source> refined;
    for (Source source : some)
      {
        if (!has_source(models[before_richest].scene, source))
          source = Source::section;
        if (std::find(refined.begin(), refined.end(), source) == refined.end())
          refined.push_back(source);
      }
    Scene       scene = models[before_richest].scene;
    std::string what;
    for (const Source source : refined)
      {
        scene = enriched(scene, source, models[before_richest].sizes);
        what += std::string(what.empty() ? "" : ", ") + name_of(source);
      }
    models.push_back(others.solved(scene, "once more in " + what));
  }



  ErrorBar
  Estimation::error_bar_of(const NamedQuantity &quantity) const
  {
    Refinements values = first_refinement(quantity);
    values.richest     = values.richer + models.back().numbers.value(quantity) -
                     models[before_richest].numbers.value(quantity);
    return error_bar(values, rules);
  }



  GoalResult
  Estimation::goal(const NamedQuantity &quantity,
                   const unsigned int   number) const
  {
    const std::string reason = !failure.empty()   ? failure :
                               !has_all(quantity) ? no_similar_mode :
                                                    "";
    GoalResult        result =
      reason.empty() ? of_run->with_error_bar(number, error_bar_of(quantity)) :
                              of_run->without_error_bar(number);
    if (!local.empty())
      result.local = local.at(number);
    if (!reason.empty())
      result.why = reason;
    else
      for (const Step &step : steps)
        result.shares.emplace_back(name_of(step.source),
                                   share_of(step, quantity));
    return result;
  }



  std::vector<GoalResult>
  Estimation::goals()
  {
    if (!unavailable_reason().empty())
      return {};
    out << "Error bars, from richer models of the scene:" << std::endl;
    of_run = std::make_unique<RunGoals>(run);
    models = {
      Model{for_estimates(run), of_run->numbers(), sizes_of(run.model())}};
    // A failure of another model must not discard the results of the run.
    if (const Outcome outcome = outcome_of([this] { solve_hierarchy(); });
        outcome.status != 0)
      {
        failure =
          "a richer model has no result (" + trimmed(outcome.message) + ")";
        out << "failed" << std::endl;
      }
    std::vector<GoalResult> results;
    for (const NamedQuantity &quantity : of_run->quantities())
      results.push_back(goal(quantity, results.size()));
    return results;
  }
} // namespace lamella
