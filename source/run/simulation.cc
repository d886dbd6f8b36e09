// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/adapt/graded_axis.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/memory.h>
#include <lamella/base/processes.h>
#include <lamella/base/text.h>
#include <lamella/report/validation.h>
#include <lamella/run/first_failure.h>
#include <lamella/run/simulation.h>
#include <lamella/solve/memory_budget.h>
#include <lamella/solve/tangent_operator.h>

#include <optional>
#include <ostream>

namespace lamella
{
  using namespace dealii;

  Simulation::Simulation(const Scene      &given,
                         std::ostream     &out,
                         const FieldRules &rules)
    : out(out)
    , timer(out, TimerOutput::never, TimerOutput::wall_times)
  {
    for (const BodyDescription &body : given.bodies)
      may_refine.push_back(body.axis.refinement_factor > 0. ||
                           !given.solve.computes_estimates ||
                           !given.goals.tolerances.empty());
    build(given, rules);
  }



  Simulation::~Simulation() = default;



  void
  Simulation::build(const Scene &given, const FieldRules &rules)
  {
    built = std::make_unique<BuiltScene>(given, rules, out, timer);
    found = built->facts();
  }



  bool
  Simulation::rebuild_with_all_fields()
  {
    FieldRules rules = built->rules();
    for (unsigned int b = 0; b < scene().bodies.size(); ++b)
      if (const Body &body = *built->structure().bodies()[b];
          scene().bodies[b].pieces.empty() &&
          scene().bodies[b].theory.is_saint_venant())
        {
          rules.unsolved.push_back(body.name());
          out << "Body " << body.name() << ": " << body.theory()
              << ", is beyond double precision; repeated with all section "
                 "functions"
              << std::endl;
        }
    if (rules.unsolved.size() == built->rules().unsolved.size())
      return false;
    release_solver();
    build(built->with_automatic_contacts(), rules);
    return true;
  }



  bool
  Simulation::shorten_elements(const UndetectedPenetration &missed)
  {
    if (!may_refine[missed.body] || last_has_state_only)
      return false;
    Scene            shorter = built->with_automatic_contacts();
    BodyDescription &body    = shorter.bodies[missed.body];
    refine_at(body.axis, missed.y, missed.longest);
    const std::string what = "Body " + body.name +
                             ": shorter elements at y = " + to_text(missed.y) +
                             " of its axis, for a contact between its points";
    revise(std::move(shorter), what);
    return true;
  }



  namespace
  {
    /// Adds a contact at @p end, part of an existing one; returns a note.
    std::string
    add_end(const EndInContact &end, Scene &scene)
    {
      ContactPair       part  = scene.contacts[end.contact];
      const Region     &side  = end.of_second ? part.second : part.first;
      const std::string whole = part.name, body = scene.bodies[side.body].name;
      part.name += "_end_of_" + body;
      part.discretization = Discretization::edge_to_surface;
      part.slave_side   = end.of_second ? SlaveSide::second : SlaveSide::first;
      part.is_automatic = false;
      part.part_of      = end.contact;
      scene.contacts.push_back(part);
      scene.contact_references[part.name];
      return "contact " + whole + ": an end of body '" + body +
             "' is in contact outside of the face constraints. Contact " +
             part.name +
             " of its nodes is added; its force is included in that of " +
             whole;
    }
  } // namespace



  bool
  Simulation::add_ends(const MissingEnds &missing)
  {
    if (last_has_state_only)
      return false;
    Scene       with_ends = built->with_automatic_contacts();
    std::string added;
    for (const EndInContact &end : missing.ends)
      added += (added.empty() ? "" : "; ") + add_end(end, with_ends);
    try
      {
        revise(std::move(with_ends), "Once more: " + added);
      }
    catch (const InputError &)
      {
        return false;
      }
    return true;
  }



  void
  Simulation::revise(Scene changed, const std::string &what)
  {
    out << what << std::endl;
    // No other run can resume the load steps of the changed scene.
    changed.resolved += "# " + what + "\n";
    revised = true;
    release_solver();
    build(changed, built->rules());
  }



  void
  Simulation::release_solver()
  {
    path.reset();
    recorder.reset();
    solver.reset();
  }



  // ---- the main loop

  const Results &
  Simulation::solve(const Observer &observer)
  {
    // Ten bisections: 1/1000 of the initial element length.
    constexpr unsigned int most = 10;
    for (unsigned int attempt = 0;; ++attempt)
      try
        {
          return solve_as_built(observer);
        }
      catch (const IllConditioned &)
        {
          // Steps that are done stay with the fields that they have.
          if (!found.steps.empty() || !rebuild_with_all_fields())
            throw;
        }
      catch (const UndetectedPenetration &missed)
        {
          if (attempt == most || !shorten_elements(missed))
            throw;
        }
      catch (const MissingEnds &missing)
        {
          if (attempt == most || !add_ends(missing))
            throw NumericsError(missing.what());
        }
  }



  const Results &
  Simulation::solve_as_built(const Observer &observer)
  {
    prepare();
    // Active constraints are evaluated before the next step pairs them anew.
    if (last_has_state_only &&
        (!path->has_more() || built->structure().has_finite_rotations()))
      complete_last_step();
    const unsigned int all = scene().solve.load_factors.size();
    while (path->has_more())
      {
        out << "Load step " << path->n_done() + 1 << " of " << all
            << ", load factor " << path->next_factor().of_scene() << std::endl;
        do_step(observer);
      }
    if (const std::string note = recorder->note_on_idle_contacts();
        !note.empty())
      found.endnotes.push_back(note);
    if (scene().find.modes || scene().find.n_buckling_modes > 0)
      {
        TimerOutput::Scope scope(timer, name_of(Phase::modes));
        find_modes(*built, solver.get(), path->state(), found);
      }
    if (scene().find.first_failure)
      find_first_failure();
    if (solver != nullptr)
      for (const std::string &warning : solver->contact_strategy().warnings())
        found.endnotes.push_back(warning);
    found.converged = true;
    record_costs();
    return found;
  }



  void
  Simulation::prepare()
  {
    const MemoryBudget budget(scene().solve.memory_limit);
    const std::string  memory = budget.check_matrix_memory(built->structure());
    print_bodies(out, built->structure(), built->interfaces(), scene().units);
    out << "Memory: " << memory << std::endl;
    auto nonlinear      = scene().solve.rotations == Rotations::large ?
                            make_large_solver(budget) :
                            make_linear_solver(budget);
    nonlinear->progress = [this](const std::string &line) {
      out << "  " << line << std::endl;
    };
    auto step = std::make_shared<LoadStep>(std::move(nonlinear),
                                           built->interfaces(),
                                           built->contact_objects(),
                                           scene().supports.size(),
                                           scene().solve,
                                           timer);
    recorder =
      std::make_unique<StepRecorder>(*built, found, solve_thermal_state(*step));
    path = std::make_unique<LoadPath>(std::move(step),
                                      scene().solve.load_factors,
                                      scene().solve.substeps,
                                      scene().find.first_failure);
    path->watch([this](const SolvedStep &one,
                       const SolvedStep &other,
                       const State      &before) {
      update_interfaces();
      return recorder->change_of_goals(one, other, before);
    });
    if (found.steps.empty())
      return;
    path->resume(found.steps.size(), found.last().state);
    update_interfaces();
    built->update_pairing_facts(found.contacts);
  }



  std::unique_ptr<NonlinearSolver>
  Simulation::make_linear_solver(const MemoryBudget &budget)
  {
    make_solver(budget);
    if (!found.steps.empty())
      solver->contact_strategy().restore(found.last().memory);
    auto linear =
      std::make_unique<NonlinearSolver>(*solver, scene().solve.nonlinear);
    linear->describe = [this](const unsigned int row) {
      return built->describe_row(row);
    };
    return linear;
  }



  std::unique_ptr<NonlinearSolver>
  Simulation::make_large_solver(const MemoryBudget &budget)
  {
    auto large = std::make_unique<NonlinearSolver>(
      built->structure(),
      MovingContacts(built->interfaces(),
                     built->pairings(),
                     built->contact_objects()),
      scene().solve.solver,
      scene().solve.nonlinear,
      scene().solve.strategy);
    large->monitor.factor_sized = [budget](const Body       &body,
                                           const FactorSize &size) {
      budget.check_factor_memory(body, size);
    };
    return large;
  }



  void
  Simulation::make_solver(const MemoryBudget &budget)
  {
    std::shared_ptr<const TangentOperator> about;
    std::optional<TimerOutput::Scope>      phase;
    strategy = choose_strategy(scene().solve.strategy,
                               built->structure(),
                               built->rows());
    if (strategy != Strategy::condensed &&
        scene().solve.strategy == Strategy::automatic)
      out << "Contact strategy: full, as many points with friction touch"
          << std::endl;
    if (strategy == Strategy::condensed)
      about = linearize(budget);
    else
      {
        // The strategy makes the matrix.
        phase.emplace(timer, name_of(Phase::assembly));
        about = linearized_without_solvers(built->structure());
      }
    solver = std::make_unique<LinearSystem>(std::move(about),
                                            built->rows(),
                                            scene().solve.nonlinear,
                                            strategy);
  }



  std::shared_ptr<const TangentOperator>
  Simulation::linearize(const MemoryBudget &budget)
  {
    // Phases that alternate from body to body, and end with whatever is thrown.
    std::optional<TimerOutput::Scope> phase;
    TangentOperator::BodyMonitor      monitor;
    const auto                        begin = [&](const Phase which) {
      phase.reset();
      phase.emplace(timer, name_of(which));
    };
    monitor.begins       = [&](const Body &) { begin(Phase::assembly); };
    monitor.assembled    = [&](const Body &) { begin(Phase::factorization); };
    monitor.factor_sized = [&](const Body &body, const FactorSize &size) {
      out << "Memory: " << budget.check_factor_memory(body, size) << std::endl;
    };
    monitor.ends = [&](const Body &) { phase.reset(); };
    return linearized(built->structure(), scene().solve.solver, monitor);
  }



  std::shared_ptr<const BlockVector>
  Simulation::solve_thermal_state(LoadStep &step)
  {
    if (built->strength() == nullptr || !built->structure().is_heated())
      return nullptr;
    out << "State without loads, of heat alone" << std::endl;
    const LoadFactor none = scene().solve.load_factors.front().without_loads();
    return std::make_shared<const BlockVector>(
      step(State(), none, none).state.u);
  }



  void
  Simulation::complete_last_step()
  {
    StepResults      kept = std::move(found.steps.back());
    const SolvedStep solved{kept.load_factor,
                            path->state(),
                            path->check_again()};
    StepResults     &last = found.steps.back();
    last                  = recorder->record(kept.step, solved, solved.state);
    last.memory           = std::move(kept.memory);
    last.changes          = std::move(kept.changes);
    last.substeps         = kept.substeps;
    last.change           = kept.change;
    last.warnings         = std::move(kept.warnings);
    recorder->add_measures(found);
    last_has_state_only = false;
  }



  void
  Simulation::do_step(const Observer &observer)
  {
    const State      previous = path->state();
    const SolvedStep solved   = path->advance();
    update_interfaces();
    built->update_pairing_facts(found.contacts);
    if (solved.change)
      out << "  in " << solved.substeps << " substeps; half as many differ by "
          << to_text(100. * *solved.change, 2) << " %" << std::endl;
    {
      TimerOutput::Scope scope(timer, name_of(Phase::output));
      found.steps.push_back(recorder->record(path->n_done(), solved, previous));
      if (solver != nullptr)
        found.steps.back().memory = solver->contact_strategy().memory();
      recorder->add_measures(found);
    }
    if (!observer)
      return;
    record_costs();
    TimerOutput::Scope scope(timer, name_of(Phase::output));
    observer(found);
    if (path->n_done() > 1)
      found.steps[path->n_done() - 2].drop_fields();
  }



  void
  Simulation::update_interfaces()
  {
    if (built->structure().has_finite_rotations())
      built->set_interfaces(path->interfaces());
  }



  void
  Simulation::find_first_failure()
  {
    std::optional<SolvedStep> failing;
    std::vector<PlyReserve>   plies_there;
    FirstFailureSearch        search(
      [&](const double             factor,
          const unsigned int       load_step,
          std::vector<PlyReserve> &plies) {
        SolvedStep solved = path->branch(factor, load_step);
        update_interfaces();
        FailureTrial trial = recorder->trial(solved, plies);
        if (trial.reserve && *trial.reserve <= 1.)
          {
            failing     = std::move(solved);
            plies_there = plies;
          }
        return trial;
      },
      out);
    found.first_failure = search.find(found.steps);
    // Failures at a load step are reported with it.
    if (failing)
      found.first_failure->warnings =
        recorder->warnings_off_path(*failing, std::move(plies_there));
    if (const std::string note = search.note(); !note.empty())
      found.endnotes.push_back(note);
  }



  // ---- what it has come to

  void
  Simulation::resume(std::vector<StepResults> steps)
  {
    found.steps         = std::move(steps);
    last_has_state_only = true;
  }



  void
  Simulation::set_goals(std::vector<GoalResult> goals,
                        const std::string      &missing_reason)
  {
    found.goals            = std::move(goals);
    found.no_goals_reason  = missing_reason;
    found.seconds_of_goals = wall.wall_time() - found.seconds.at("total");
  }



  void
  Simulation::record_costs()
  {
    for (const std::string &phase : phase_names())
      found.seconds[phase] = 0.;
    for (const auto &[phase, seconds] :
         timer.get_summary_data(TimerOutput::total_wall_time))
      found.seconds[phase] = seconds;
    found.seconds["total"] = wall.wall_time();
    // A run that is resumed may fail before there is one.
    if (solver != nullptr)
      found.condition_estimate = solver->tangent().condition_estimate();
    found.processes   = n_processes();
    found.peak_memory = Utilities::MPI::max(peak_memory(), communicator());
    found.peak_memory_of_all =
      Utilities::MPI::sum(peak_memory(), communicator());
    if (solver != nullptr && strategy == Strategy::condensed)
      for (unsigned int b = 0; b < found.bodies.size(); ++b)
        found.bodies[b].solver = solver->tangent().solver(b).statistics();
  }
} // namespace lamella
