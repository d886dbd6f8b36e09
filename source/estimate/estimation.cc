// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/estimate/error_bar.h>
#include <lamella/estimate/estimation.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace lamella
{
  namespace
  {
    // The DoFs of a run that is so small that bars are left to who asks for
    // them.
    constexpr double large_run = 60000.;

    /// Values below this share of the largest of their kind have that for a
    /// scale.
    constexpr double near_zero = 1e-3;



    /// What models of one scene differ in.
    std::string
    key_of(const Scene &scene)
    {
      std::string key;
      for (const BodyDescription &body : scene.bodies)
        {
          key += body.theory.name() + "/" +
                 std::to_string(body.theory.section_order) + "/" +
                 std::to_string(body.axis.degree) + "/" +
                 std::to_string(body.refinement.everywhere);
          for (const Theory &theory : body.pieces.theories)
            key += " " + theory.name();
          for (const unsigned int n : body.axis.elements)
            key += " " + std::to_string(n);
          for (const double y : body.axis.breaks)
            key += " " + to_text(y, 15);
          key += "; ";
        }
      for (const ContactPair &contact : scene.contacts)
        key += name_of(contact.enforcement);
      return key;
    }
  } // namespace



  const Model *
  ModelCache::find(const Scene &scene) const
  {
    const auto place = models.find(key_of(scene));
    return place == models.end() ? nullptr : &place->second;
  }



  void
  ModelCache::keep(const Model &model)
  {
    models[key_of(model.scene)] = model;
  }



  Estimation::Estimation(const Simulation &run,
                         std::ostream     &out,
                         ModelCache       &cache)
    : run(run)
    , out(out)
    , cache(cache)
  {}



  bool
  Estimation::wanted() const
  {
    const GoalParameters &goals = run.solved_scene().goals;
    if (goals.quantities.empty() && goals.whole_probes.empty())
      return false;
    return goals.bars == ErrorBars::always ||
           (goals.bars == ErrorBars::automatic &&
            run.results().n_dofs() > large_run);
  }



  std::vector<NamedQuantity>
  Estimation::quantities() const
  {
    const GoalParameters      &goals = run.solved_scene().goals;
    std::vector<NamedQuantity> all   = goals.quantities;
    for (const std::string &probe : goals.whole_probes)
      for (const NamedQuantity &quantity :
           models.front().numbers.largest_at(probe))
        all.push_back(quantity);
    return all;
  }



  Model
  Estimation::first_model() const
  {
    Model model{for_estimates(run.solved_scene()),
                ResultNumbers(run.results()),
                {}};
    for (const BodyFacts &body : run.results().bodies)
      model.dofs.push_back(body.dofs);
    return model;
  }



  Model
  Estimation::solved(const Scene &scene, const std::string &what)
  {
    if (const Model *known = cache.find(scene))
      return *known;
    std::ostream nowhere(nullptr);
    out << "  " << what << ": " << std::flush;
    Simulation     simulation(scene, nowhere);
    const Results &results = simulation.solve();
    Model          model{simulation.solved_scene(), ResultNumbers(results), {}};
    for (const BodyFacts &body : results.bodies)
      model.dofs.push_back(body.dofs);
    out << results.n_dofs() << " DoFs, "
        << to_text(results.seconds.at("total"), 2) << " s" << std::endl;
    cache.keep(model);
    return model;
  }



  void
  Estimation::climb()
  {
    models = {first_model()};
    cache.keep(models.front());
    for (const Source source :
         {Source::axis, Source::fields, Source::section, Source::contact})
      if (has_source(models.back().scene, source))
        {
          const Model &last = models.back();
          models.push_back(
            solved(enriched(last.scene, source, last.dofs, most_dofs_of_layers),
                   std::string("richer in ") + name_of(source)));
          sources.push_back(source);
        }
    Scene                     scene = models.back().scene;
    std::vector<unsigned int> dofs  = models.back().dofs;
    for (const Source source : {Source::axis, Source::fields, Source::section})
      if (has_source(scene, source))
        scene = enriched(scene, source, dofs, most_dofs_of_layers);
    models.push_back(solved(scene, "richer in all of it once more"));
  }



  GoalResult
  Estimation::goal(const NamedQuantity &quantity,
                   const unsigned int   number) const
  {
    const auto value = [&](const unsigned int model) {
      return models[model].numbers.value(quantity);
    };
    const GoalParameters &goals = run.solved_scene().goals;
    const Results        &found = run.results();
    GoalResult            result;
    result.name          = quantity.label();
    result.value         = value(0);
    const double largest = models[0].numbers.largest_of_kind(quantity);
    result.scale         = std::abs(result.value) > near_zero * largest ?
                             std::abs(result.value) :
                             largest;
    if (!goals.tolerances.empty())
      result.tolerance = goals.tolerances.size() == 1 ?
                           goals.tolerances[0] :
                           goals.tolerances.at(number);
    result.kinematics =
      0.5 * std::pow(found.last().checks.max_rotation, 2) * result.scale;
    if (!failure.empty())
      {
        result.why = failure;
        return result;
      }

    Refinements values;
    for (unsigned int k = 0; k < sources.size(); ++k)
      {
        result.shares.emplace_back(name_of(sources[k]),
                                   value(k + 1) - value(k));
        values.shares += std::abs(result.shares.back().second);
      }
    values.run         = result.value;
    values.richer      = value(sources.size());
    values.richest     = value(sources.size() + 1);
    values.scale       = result.scale;
    const State &state = found.last().state;
    values.rounding    = largest * (state.contact_corrections.empty() ?
                                      state.free_corrections.back() :
                                      state.contact_corrections.back());
    const ErrorBar bar = error_bar(values);
    result.estimate    = bar.estimate;
    result.bar         = bar.bar;
    result.trusted     = bar.trusted;
    result.why         = bar.why;
    return result;
  }



  std::vector<GoalResult>
  Estimation::goals()
  {
    if (!wanted())
      return {};
    out << "Error bars, from richer models of the scene:" << std::endl;
    const auto give_up = [this](const std::exception &error) {
      failure = "a richer model has no result (" + trimmed(error.what()) + ")";
      out << "failed" << std::endl;
    };
    try
      {
        climb();
      }
    catch (const InputError &error)
      {
        give_up(error);
      }
    catch (const NumericsError &error)
      {
        give_up(error);
      }
    std::vector<GoalResult> results;
    for (const NamedQuantity &quantity : quantities())
      results.push_back(goal(quantity, results.size()));
    return results;
  }
} // namespace lamella
