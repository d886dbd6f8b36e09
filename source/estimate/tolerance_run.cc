// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/output_file.h>
#include <lamella/base/processes.h>
#include <lamella/base/text.h>
#include <lamella/estimate/comparison.h>
#include <lamella/estimate/enrichment.h>
#include <lamella/estimate/error_bar.h>
#include <lamella/estimate/tolerance_run.h>
#include <lamella/report/goals_table.h>
#include <lamella/report/tables.h>
#include <lamella/run/run_scene.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

namespace lamella
{
  namespace
  {
    /// Returns the error of each goal J if SV-N (section functions for N wave
    /// numbers) replaces Lagrange expansions LE: |J(LE) - J(SV-N)| on the
    /// sections and axes of @p run, for the bodies that are LE in @p run and
    /// SV-N in @p next. Infinite if SV-N has more than @p max_share of the
    /// DoFs. Returns no errors if there are none. A comparison with other wave
    /// numbers would not detect some errors, such as of the slowly decaying
    /// warping of thin walls near a twisting load. Prints a line to @p out; @p
    /// cache stores the model. Throws the exceptions of Simulation. Collective.
    std::vector<double>
    surrogate_error(const Simulation &run,
                    const Scene      &next,
                    const double      max_share,
                    std::ostream     &out,
                    ModelCache       &cache)
    {
      Scene scene    = for_estimates(run);
      bool  replaces = false;
      for (unsigned int b = 0; b < scene.bodies.size(); ++b)
        {
          Theory       &theory = scene.bodies[b].theory;
          const Theory &other  = next.bodies[b].theory;
          if (theory.is_layerwise() && other.has_responses())
            {
              theory   = theory.to_saint_venant(other.order);
              replaces = true;
            }
        }
      if (!replaces)
        return {};
      ComparisonModels models(run, out, cache);
      const Model      own = models.solved(scene, "own fields of the sections");
      const RunGoals   goals(run);
      double           dofs = 0.;
      for (const BodySize &size : own.sizes)
        dofs += size.dofs;
      const bool is_smaller = dofs <= max_share * run.results().n_dofs();
      std::vector<double> lost;
      for (const NamedQuantity &quantity : goals.quantities())
        lost.push_back(is_smaller && own.numbers.has(quantity) ?
                         std::abs(goals.numbers().value(quantity) -
                                  own.numbers.value(quantity)) :
                         std::numeric_limits<double>::infinity());
      return lost;
    }



    /// Returns the multiplications to factorize the model of @p run.
    double
    total_operations(const Simulation &run)
    {
      double sum = 0.;
      for (const Cost &cost : predicted_costs(run.model().structure().bodies()))
        sum += cost.operations;
      return sum;
    }



    /// Throws NumericsError if @p run has no active contact in its last step
    /// and all goals are zero.
    void
    check_active_contact(const Simulation &run)
    {
      const RunGoals goals(run);
      const auto    &all = goals.quantities();
      if (RunGoals::has_no_active_contact(run) &&
          std::all_of(all.begin(), all.end(), [&goals](const auto &quantity) {
            return goals.numbers().value(quantity) == 0.;
          }))
        throw NumericsError(
          "estimate.no-contact: No contact is active in the last load step, "
          "and all quantities of subsection Goals are 0. Move or load the "
          "bodies towards each other.");
    }
  } // namespace



  ToleranceRun::ToleranceRun(const Scene         &said,
                             std::ostream        &out,
                             const EstimateRules &rules)
    : scene(initial_model(said))
    , out(out)
    , rules(rules)
    , passes(rules)
  {}



  std::unique_ptr<Simulation>
  ToleranceRun::next_model(std::ostream &progress)
  {
    const auto built = [&]() {
      return std::make_unique<Simulation>(scene, progress, field_rules);
    };
    auto next = built();
    if (passes.all().empty() && start_with_layerwise(scene, next->model()))
      next = built();
    check_budgets(next->results().n_dofs(), total_operations(*next));
    return next;
  }



  // The decision has to be the same on all processes.
  void
  ToleranceRun::check_budgets(const double dofs, const double operations) const
  {
    const double most = scene.goals.budget_dofs,
                 time = scene.goals.budget_seconds;
    if (most > 0 && dofs > most)
      throw NumericsError(
        "estimate.budget-exceeded: the next refined model has " +
        std::to_string(std::lround(dofs)) + " DoFs, but the limit is " +
        std::to_string(std::lround(most)) + " (Budget DoFs)");
    if (time == 0. || passes.all().empty())
      return;
    const double begin   = dealii::Utilities::MPI::max(wall.wall_time(),
                                                     communicator()),
                 seconds = passes.predicted_seconds(operations);
    if (begin + seconds > time)
      throw NumericsError(
        "estimate.budget-exceeded: the next pass would end after about " +
        to_text(begin + seconds, 2) + " s, but the limit is " + to_text(time) +
        " s (Budget seconds)");
  }



  void
  ToleranceRun::make_pass()
  {
    const std::string number = std::to_string(passes.all().size() + 1);
    // Only the results of the pass before are needed: its factorization is
    // freed before the next one.
    if (simulation != nullptr)
      simulation->release_solver();
    std::ostream nowhere(nullptr);
    auto         next       = next_model(nowhere);
    const double operations = total_operations(*next);
    out << "Pass " << number << ": " << next->results().n_dofs() << " DoFs"
        << (passes.all().empty() ?
              "" :
              ", about " + to_text(passes.predicted_seconds(operations), 2) +
                " s")
        << std::endl;
    next->solve();
    check_loads(*next);
    check_active_contact(*next);
    // It has its own modes, not those that comparisons look for.
    Scene known = for_estimates(*next);
    known.find  = next->model().scene().find;
    cache.keep(
      {known, ResultNumbers(next->results()), sizes_of(next->model())});
    Pass pass;
    pass.dofs           = next->results().n_dofs();
    pass.operations     = operations;
    const GoalBars bars = error_bars_of(*next, out, cache, rules);
    pass.goals          = bars.goals;
    pass.recipe         = bars.recipe;
    check_any_bar(pass.goals);
    for (unsigned int g = 0;
         g < std::min(surrogate_errors.size(), pass.goals.size());
         ++g)
      raise_share(pass.goals[g], Source::fields, surrogate_errors[g]);
    pass.seconds =
      dealii::Utilities::MPI::max(wall.wall_time(), communicator());
    for (const BodySummary &body : next->results().bodies)
      pass.theories +=
        (pass.theories.empty() ? "" : "; ") + body.name + " " + body.theory;
    passes.add(pass, refined);
    simulation = std::move(next);
  }



  void
  ToleranceRun::check_any_bar(const std::vector<GoalResult> &goals) const
  {
    const auto has_none = [](const GoalResult &goal) {
      return !goal.trusted && goal.shares.empty();
    };
    if (!passes.all().empty() && !goals.empty() &&
        std::all_of(goals.begin(), goals.end(), has_none))
      throw NumericsError("estimate.no-error-bars: The error of no quantity in "
                          "subsection Goals could be estimated, so the run "
                          "stops. Reason for the first: " +
                          goals.front().why);
  }



  void
  ToleranceRun::check_loads(const Simulation &next) const
  {
    if (simulation == nullptr)
      return;
    const auto &loads  = next.results().loads,
               &before = simulation->results().loads;
    // Couples have no force: the reference is the load of the whole scene.
    double size = 0.;
    for (const LoadResultant &load : before)
      size += load.force.norm() + load.moment.norm() / next.results().size;
    for (unsigned int k = 0; k < loads.size(); ++k)
      if ((loads[k].force - before[k].force).norm() > rules.loads_agree * size)
        throw NumericsError(
          "estimate.load-not-integrated: load " + loads[k].name + " is " +
          to_text(loads[k].force) + " on the next refined mesh, but it was " +
          to_text(before[k].force) +
          " before: its expression varies too fast for numerical integration. "
          "Divide the load into several smoother loads");
  }



  Scene
  ToleranceRun::refined_in_sources(Scene            next,
                                   const PlanRules &plan_rules) const
  {
    const std::vector<BodySize> sizes = sizes_of(simulation->model());
    for (const Source source : refined.sources)
      next = source == Source::axis && refined.marked ?
               bisected(next, *refined.marked) :
               enriched(next, source, sizes, plan_rules);
    return next;
  }



  void
  ToleranceRun::refine()
  {
    const Scene               next   = simulation->model().scene();
    const std::vector<Source> wanted = passes.wanted();
    refined                          = {wanted, {}};
    if (std::find(wanted.begin(), wanted.end(), Source::axis) != wanted.end())
      refined.marked = marked_elements(next,
                                       passes.open_goals(),
                                       rules.max_axis_remainder,
                                       rules.min_bisected_share);
    PlanRules plan_rules;
    if (passes.degrees_stall())
      {
        plan_rules.corner_degree  = plan_rules.first_degree;
        plan_rules.highest_degree = plan_rules.first_degree;
      }
    Scene               richer = refined_in_sources(next, plan_rules);
    std::vector<double> lost   = surrogate_error(
      *simulation, richer, rules.max_surrogate_share, out, cache);
    if (!lost.empty() && !passes.is_loss_acceptable(lost))
      {
        plan_rules.max_layerwise_dofs = std::numeric_limits<double>::max();
        richer                        = refined_in_sources(next, plan_rules);
        lost.clear();
      }
    refined.divides_cells = richer.divisions != next.divisions ||
                            richer.corner_layers != next.corner_layers;
    if (!lost.empty())
      surrogate_errors = lost;
    scene = with_min_degree(richer);
  }



  void
  ToleranceRun::print_pass() const
  {
    const Pass &pass = passes.last();
    out << "  after " << to_text(pass.seconds, 3) << " s: " << pass.theories
        << "\n";
    for (const GoalResult &goal : pass.goals)
      {
        out << "  " << goal.name << " = " << to_text(goal.value, 6);
        if (goal.trusted)
          out << " +- " << share_text(goal, goal.bar)
              << (goal.met() ? ", met" : "");
        else
          out << ", no bar yet";
        out << "\n";
      }
    if (passes.all().size() > 1)
      out << "  since the last pass goals have changed by at most "
          << to_text(passes.largest_change(), 2) << " of their tolerances\n";
    for (const std::string &sentence : passes.dropped_goals())
      out << "  " << sentence << "\n";
    out << std::flush;
  }



  std::string
  ToleranceRun::table() const
  {
    std::string text =
      "pass,dofs,seconds,goal,value,estimate,bar,trusted,met\n";
    unsigned int number = 0;
    for (const Pass &pass : passes.all())
      {
        ++number;
        for (const GoalResult &goal : pass.goals)
          text +=
            (CsvLine() << number << pass.dofs << pass.seconds
                       << '"' + goal.name + '"' << goal.value << goal.estimate
                       << (goal.trusted ? csv(goal.bar) : "") << goal.trusted
                       << goal.met())
              .text();
      }
    return text;
  }



  void
  ToleranceRun::write_pass(const std::string &directory)
  {
    const SignalBlock whole;
    simulation->set_goals(passes.last().goals);
    write_run(*simulation, directory);
    if (!is_root_process())
      return;
    write_file(directory + "/passes.csv", table());
    set_interruption_message("interrupted. " + directory +
                             " has the results of pass " +
                             std::to_string(passes.all().size()) +
                             ". A run to a Tolerance begins anew.");
  }



  void
  ToleranceRun::print_end(const std::string &reason) const
  {
    const std::size_t n = passes.all().size();
    out << (passes.all_goals_met() ? "\nDone in " :
                                     "\nNot all goals are met after ")
        << n << (n == 1 ? " pass: " : " passes: ") << reason << "."
        << std::endl;
  }



  std::string
  ToleranceRun::prepare_next_pass()
  {
    try
      {
        check_budgets(passes.last().dofs, passes.last().operations);
        refine();
      }
    catch (const std::runtime_error &error)
      {
        return strip_period(error.what());
      }
    return "";
  }



  bool
  ToleranceRun::run(const std::string &directory)
  {
    std::string reason;
    if (is_root_process())
      set_interruption_message(
        "interrupted in the first pass: nothing of this run is in " +
        directory + ".");
    while (reason.empty())
      {
        try
          {
            make_pass();
          }
        catch (const std::runtime_error &error)
          {
            if (passes.all().empty())
              throw;
            reason = strip_period(error.what());
            break;
          }
        write_pass(directory);
        print_pass();
        reason = passes.reason_to_stop();
        if (reason.empty())
          reason = prepare_next_pass();
      }
    set_interruption_message("");
    print_results(*simulation, directory, out);
    print_end(reason);
    return passes.all_goals_met();
  }
} // namespace lamella
