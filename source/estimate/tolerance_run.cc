// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/axis/axis.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/interruption.h>
#include <lamella/base/output_file.h>
#include <lamella/base/processes.h>
#include <lamella/base/progress.h>
#include <lamella/base/sentence.h>
#include <lamella/base/text.h>
#include <lamella/estimate/axis_marks.h>
#include <lamella/estimate/start.h>
#include <lamella/estimate/tolerance_run.h>
#include <lamella/report/fields_table.h>
#include <lamella/report/goals_table.h>
#include <lamella/run/run_scene.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace lamella
{
  namespace
  {
    // A source with less than this share of what a goal may be off by stays as
    // it is; the worst goal has to get better by this factor in two passes.
    constexpr double small_share = 0.25, least_progress = 0.5;
    // More are a sign that none would be enough.
    constexpr unsigned int most_passes = 8;
  } // namespace



  bool
  all_met(const std::vector<GoalResult> &goals)
  {
    return std::all_of(goals.begin(), goals.end(), [](const GoalResult &goal) {
      return goal.met();
    });
  }



  double
  worst_ratio(const std::vector<GoalResult> &goals)
  {
    double worst = 0.;
    for (const GoalResult &goal : goals)
      worst =
        std::max(worst,
                 (goal.trusted ? goal.bar : 2. * std::abs(goal.estimate)) /
                   goal.most_error());
    return worst;
  }



  ToleranceRun::ToleranceRun(const Scene &said, std::ostream &out)
    : scene(start_of(said))
    , out(out)
  {
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      begins_equal.push_back(said.bodies[b].axis.fineness > 0. &&
                             scene.bodies[b].axis.fineness == 0.);
  }



  void
  ToleranceRun::keep_ends(const Scene &first)
  {
    for (unsigned int b = 0; b < first.bodies.size(); ++b)
      {
        kept.emplace_back();
        double end = 0.;
        if (!begins_equal[b])
          for (const double length : element_lengths(first.bodies[b].axis))
            kept.back().push_back(end += length);
      }
  }



  void
  ToleranceRun::make_pass()
  {
    const Progress::Part part(out, "pass " + std::to_string(passes.size() + 1));
    std::ostream         nowhere(nullptr);
    nowhere.copyfmt(out); // its progress
    const auto built = [&]() {
      return std::make_unique<Simulation>(scene, nowhere, rules);
    };
    auto next = built();
    if (passes.empty() && begin_lower(scene, next->model()))
      next = built();
    const double most = scene.goals.budget_dofs;
    if (most > 0 && next->results().n_dofs() > most)
      throw NumericsError("the next model has " +
                          std::to_string(next->results().n_dofs()) +
                          " DoFs, more than the budget of " +
                          std::to_string(scene.goals.budget_dofs));
    out << "Pass " << passes.size() + 1 << ": " << next->results().n_dofs()
        << " DoFs" << std::endl;
    next->solve();
    check_loads(*next);
    Pass pass;
    pass.number = passes.size() + 1;
    pass.dofs   = next->results().n_dofs();
    Estimation estimation(*next, out, cache, Estimation::Effort::as_needed);
    if (simulation != nullptr)
      estimation.comes_after(ResultNumbers(simulation->results()));
    else
      keep_ends(next->model().scene());
    pass.goals   = estimation.goals();
    pass.seconds = wall.wall_time();
    for (const BodyFacts &body : next->results().bodies)
      pass.theories +=
        (pass.theories.empty() ? "" : "; ") + body.name + " " + body.theory;
    passes.push_back(pass);
    simulation = std::move(next);
  }



  void
  ToleranceRun::check_loads(const Simulation &next) const
  {
    constexpr double agreement = 1e-7;
    if (simulation == nullptr)
      return;
    const auto &loads  = next.results().loads,
               &before = simulation->results().loads;
    // Couples have no force: what all loads do together is the measure.
    double size = 0.;
    for (const LoadResultant &load : before)
      size += load.force.norm() + load.moment.norm() / next.results().size;
    for (unsigned int k = 0; k < loads.size(); ++k)
      if ((loads[k].force - before[k].force).norm() > agreement * size)
        throw NumericsError(
          "load " + loads[k].name + " is " + to_text(loads[k].force) +
          " on the next model and was " + to_text(before[k].force) +
          ": it varies too fast for its integration. Give it as pieces, a load "
          "each");
  }



  double
  ToleranceRun::largest_change() const
  {
    double worst = 0.;
    if (passes.size() > 1)
      for (unsigned int g = 0; g < passes.back().goals.size(); ++g)
        {
          const GoalResult &now    = passes.back().goals[g],
                           &before = passes[passes.size() - 2].goals[g];
          worst =
            std::max(worst,
                     std::abs(now.value - before.value) / now.most_error());
        }
    return worst;
  }



  std::vector<Source>
  ToleranceRun::wanted() const
  {
    std::vector<Source> sources;
    for (const Source source :
         {Source::axis, Source::fields, Source::section, Source::contact})
      for (const GoalResult &goal : passes.back().goals)
        if (!goal.met())
          for (const auto &[name, share] : goal.shares)
            if (name == name_of(source) &&
                (std::abs(share) > small_share * goal.most_error() ||
                 name == largest_share(goal)) &&
                std::find(sources.begin(), sources.end(), source) ==
                  sources.end())
              sources.push_back(source);
    return sources;
  }



  bool
  ToleranceRun::is_late() const
  {
    // All processes have to agree.
    return scene.goals.budget_seconds > 0. &&
           dealii::Utilities::MPI::max(wall.wall_time(), communicator()) >
             scene.goals.budget_seconds;
  }



  std::string
  ToleranceRun::why_no_richer_model() const
  {
    for (const GoalResult &goal : passes.back().goals)
      if (!goal.met() && goal.shares.empty())
        return goal.why;
    return "";
  }



  std::string
  ToleranceRun::reason_to_stop() const
  {
    if (all_met(passes.back().goals))
      return "all goals are within their tolerances";
    const double worst = worst_ratio(passes.back().goals);
    if (passes.size() > 2 &&
        worst > least_progress * worst_ratio(passes[passes.size() - 3].goals))
      return "the worst goal has got no better in two passes";
    if (passes.size() == most_passes)
      return std::to_string(most_passes) + " passes are the most";
    if (is_late())
      return "the budget of " + to_text(scene.goals.budget_seconds) +
             " s is spent";
    if (!why_no_richer_model().empty())
      return why_no_richer_model();
    if (wanted().empty())
      return "nothing is left to be enriched";
    return "";
  }



  Scene
  ToleranceRun::next_scene() const
  {
    // What elements may do to a goal when they stay as they are, over its
    // tolerance, and what those that are bisected do at least of all.
    constexpr double most_left = 0.1, least_done = 0.65;
    // And what elements may do that become one.
    constexpr double most_merged = 0.05;

    const auto               &goals   = passes.back().goals;
    Scene                     next    = simulation->model().scene();
    const Model              &model   = *cache.find(next);
    const std::vector<Source> sources = wanted();
    // Other fields have other errors along the axis: those of EBBT say nothing.
    if (std::find(sources.begin(), sources.end(), Source::fields) ==
        sources.end())
      next = merged(next, kept, goals, most_merged);
    for (const Source source : sources)
      {
        const auto marked = marked_elements(next, goals, most_left, least_done);
        next              = source == Source::axis && marked ?
                              bisected(next, *marked) :
                              enriched(next, source, model.sizes);
      }
    return next;
  }



  void
  ToleranceRun::print_pass() const
  {
    const Pass &pass = passes.back();
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
    if (passes.size() > 1)
      out << "  since the last pass goals have changed by at most "
          << to_text(largest_change(), 2) << " of their tolerances\n";
    out << std::flush;
  }



  std::string
  ToleranceRun::table() const
  {
    std::string text =
      "pass,dofs,seconds,goal,value,estimate,bar,trusted,met\n";
    for (const Pass &pass : passes)
      for (const GoalResult &goal : pass.goals)
        text += std::to_string(pass.number) + "," + std::to_string(pass.dofs) +
                "," + csv(pass.seconds) + ",\"" + goal.name + "\"," +
                csv(goal.value) + "," + csv(goal.estimate) + "," +
                (goal.trusted ? csv(goal.bar) + ",1" : ",0") +
                (goal.met() ? ",1\n" : ",0\n");
    return text;
  }



  void
  ToleranceRun::write_pass(const std::string &directory)
  {
    const Uninterrupted whole;
    simulation->set_goals(passes.back().goals);
    write_run(*simulation, directory);
    if (!is_speaker())
      return;
    write_file(directory + "/passes.csv", table());
    say_if_interrupted(
      "interrupted. " + directory + " has the results of pass " +
      std::to_string(passes.size()) + ". A run to a Tolerance begins anew.");
  }



  void
  ToleranceRun::end_with_bars(const std::string &directory)
  {
    passes.back().goals =
      Estimation(*simulation, out, cache, Estimation::Effort::full).goals();
    write_pass(directory);
  }



  void
  ToleranceRun::print_end(const std::string &reason) const
  {
    out << (all_met(passes.back().goals) ? "\nDone in " :
                                           "\nNot all goals are met after ")
        << passes.size() << (passes.size() == 1 ? " pass: " : " passes: ")
        << reason << "." << std::endl;
  }



  void
  ToleranceRun::run(const std::string &directory)
  {
    std::string reason;
    if (is_speaker())
      say_if_interrupted("interrupted in the first pass: nothing of this run "
                         "is in " +
                         directory + ".");
    while (reason.empty())
      {
        try
          {
            make_pass();
          }
        catch (const std::runtime_error &error)
          {
            if (passes.empty())
              throw;
            reason = without_full_stop(error.what());
            break;
          }
        write_pass(directory);
        print_pass();
        reason = reason_to_stop();
        if (!reason.empty())
          break;
        scene = next_scene();
      }
    if (!all_met(passes.back().goals) && !is_late() &&
        why_no_richer_model().empty())
      end_with_bars(directory);
    say_if_interrupted("");
    print_results(*simulation, directory, out);
    print_end(reason);
  }
} // namespace lamella
