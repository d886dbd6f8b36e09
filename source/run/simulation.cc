// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/adapt/graded_axis.h>
#include <lamella/adapt/node_fields.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/interruption.h>
#include <lamella/base/memory.h>
#include <lamella/base/processes.h>
#include <lamella/base/sentence.h>
#include <lamella/base/text.h>
#include <lamella/conditions/hold.h>
#include <lamella/contact/assumptions.h>
#include <lamella/contact/main_normals.h>
#include <lamella/recover/named_quantity.h>
#include <lamella/report/console.h>
#include <lamella/report/results_writer.h>
#include <lamella/report/section_stiffness.h>
#include <lamella/report/section_table.h>
#include <lamella/report/validation.h>
#include <lamella/run/first_failure.h>
#include <lamella/run/simulation.h>
#include <lamella/scene/theory_notes.h>
#include <lamella/solve/lost_digits.h>
#include <lamella/solve/multiplier_loop.h>
#include <lamella/solve/penalty_newton.h>

#include <optional>
#include <ostream>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// What takes a while says so before it begins.
    void
    tell_large_sections(const SectionMeshes &sections, std::ostream &out)
    {
      constexpr unsigned int many = 5000;
      for (const auto &[name, section] : sections)
        if (const unsigned int n = section->mesh.n_active_cells(); n > many)
          out
            << "Section " << name << ": " << n
            << " cells; making its expansion, bodies and supports takes a while"
            << std::endl;
    }



    ContactFacts
    contact_facts(const ContactInterface &contact,
                  const Enforcement       enforcement)
    {
      const auto [least, greatest] =
        std::minmax_element(contact.rows.begin(),
                            contact.rows.end(),
                            [](const GapRow &a, const GapRow &b) {
                              return a.initial_gap < b.initial_gap;
                            });
      return {contact.name,
              contact.second_name,
              contact.discretisation,
              enforcement,
              static_cast<unsigned int>(contact.rows.size()),
              contact.unpaired,
              contact.unpaired_second,
              least->initial_gap,
              greatest->initial_gap};
    }



    /// What is to be said of stresses whose equilibrium does not close.
    std::vector<std::string>
    closure_warnings(const Closures &closures, const Results &found)
    {
      constexpr double         much = 0.05;
      std::vector<std::string> warnings;
      for_each_closure(
        found,
        closures,
        [&](const std::string &kind,
            const std::string &name,
            const double       share) {
          if (share > much)
            warnings.push_back(
              kind + " " + name +
              ": transverse stresses by equilibrium miss the traction on the "
              "upper face by " +
              to_text(100. * share, 2) +
              " % of the largest; put more elements along the axis there, or "
              "look further away from supports, edges and concentrated loads");
        });
      return warnings;
    }



    /// What to say of the folder @p directory where the user ends the run after
    /// @p done of @p all load steps.
    void
    keep_ready_for_interruption(const std::string &directory,
                                const unsigned int done,
                                const unsigned int all)
    {
      if (!is_speaker())
        return;
      if (done == 0)
        say_if_interrupted("interrupted before the first load step was done: "
                           "nothing of this run is in " +
                           directory + ".");
      else
        say_if_interrupted(
          "interrupted. " + directory + " has " +
          (done == all ?
             "all load steps, but not what comes after them" :
             "load step" + std::string(done == 1 ? " " : "s 1 to ") +
               std::to_string(done) + " of " + std::to_string(all)) +
          ". The same command with --resume goes on from there.");
    }



    ReferenceLists
    references_of(const Scene &scene)
    {
      ReferenceLists lists;
      for (const Probe &probe : scene.probes)
        lists.probes.push_back(probe.references);
      for (const Support &support : scene.supports)
        lists.supports.push_back(scene.support_references.at(support.name));
      for (const ContactPair &contact : scene.contacts)
        lists.contacts.push_back(scene.contact_references.at(contact.name));
      for (const Measure &measure : scene.measures)
        lists.measures.push_back(measure.references);
      return lists;
    }
  } // namespace



  Simulation::Simulation(const Scene      &given,
                         std::ostream     &out,
                         const FieldRules &rules)
    : scene(given)
    , out(out)
    , field_rules(rules)
    , timer(out, TimerOutput::never, TimerOutput::wall_times)
  {
    build();
  }



  void
  Simulation::build()
  {
    {
      TimerOutput::Scope scope(timer, name_of(Phase::setup));
      build_structure();
    }
    {
      TimerOutput::Scope scope(timer, name_of(Phase::contact));
      build_contacts();
    }
    TimerOutput::Scope scope(timer, name_of(Phase::setup));
    sampler = std::make_unique<Sampler>(structure->bodies(),
                                        scene.probes,
                                        scene.lines,
                                        scene.cuts);
    for (const Measure &measure : scene.measures)
      sampler->check(measure.quantity);
    scene.goals.quantities = in_plies(scene.goals.quantities);
    plausibility =
      std::make_unique<Plausibility>(structure->bodies(), scene.units);
    build_strength();
    if (scene.find_first_failure)
      require_growth(*structure, contacts);
    describe();
  }



  Simulation::~Simulation() = default;



  void
  Simulation::build_structure()
  {
    sections = build_section_meshes(scene);
    tell_large_sections(sections, out);
    grade_axes(
      scene.bodies, sections, scene.supports, scene.loads, scene.contacts);
    std::vector<Stabilisation> stabilisations;
    for (const BodyDescription &body : scene.bodies)
      stabilisations.push_back({body.stabilisation});
    Bodies bodies = make_bodies_with_fields();
    hold_bodies(bodies);
    structure = std::make_unique<Structure>(std::move(bodies),
                                            scene.supports,
                                            scene.loads,
                                            stabilisations,
                                            scene.gravity);
    check_balance_of_held(scene.supports,
                          structure->bodies(),
                          structure->load());
    for (const auto &body : structure->bodies())
      body->solver_kind(scene.solve.solver);
  }



  void
  Simulation::hold_bodies(const Bodies &bodies)
  {
    if (std::none_of(scene.bodies.begin(),
                     scene.bodies.end(),
                     [](const BodyDescription &body) { return body.is_held; }))
      return;
    std::vector<ContactPlace> places;
    for (const ContactPair &contact : scene.contacts)
      {
        const ContactInterface made  = make_interface(contact, bodies);
        const Body            &first = *bodies[made.first_body];
        // Nearer than a tenth of what the section extends to either side.
        const double depth =
          0.1 * centroid_of(first.surface_points("start"))
                  .distance(far_points(first, "start").front().position);
        for (const auto &[row, normal] : main_normals(made, depth))
          {
            const ContactInterface::Point &at = made.points[row];
            places.push_back({made.first_body, at.first, normal});
            if (made.second_body)
              places.push_back({*made.second_body, at.second, normal});
          }
      }
    find_held_motions(scene.supports, bodies, places);
  }



  Bodies
  Simulation::make_bodies_with_fields()
  {
    Bodies bodies =
      make_bodies(scene.bodies, sections, scene.solve.memory_limit);
    spread_totals(scene.loads, bodies);
    clear_held_motions(scene.supports);
    if (has_fields_to_choose(scene.bodies))
      {
        apply_heat(scene.loads, bodies);
        std::vector<ContactInterface> touching;
        for (const ContactPair &contact : scene.contacts)
          touching.push_back(make_interface(contact, bodies));
        field_notes = choose_fields(
          bodies,
          scene.bodies,
          scene.supports,
          scene.loads,
          touching,
          stress_places(bodies, scene.probes, scene.lines, scene.cuts),
          field_rules,
          scene.gravity);
      }
    return bodies;
  }



  void
  Simulation::build_contacts()
  {
    for (ContactPair &contact : scene.contacts)
      {
        contacts.push_back(make_interface(contact, structure->bodies()));
        contact.discretisation = contacts.back().discretisation;
        scene.resolved =
          SceneText::with_automatic(scene.resolved,
                                    "Contact " + contact.name,
                                    "Discretisation",
                                    name_of(contact.discretisation));
      }
    gap_rows = GapRows(contacts);
    check_partners(contacts);
    check_conflicts(contacts, structure->bodies());
    for (const ContactPair &contact : scene.contacts)
      search_checks.emplace_back(contact, structure->bodies());
    for (const auto *quantities :
         {&scene.goals.quantities, &scene.trade.quantities})
      for (const NamedQuantity &quantity : *quantities)
        for (const ContactInterface &contact : contacts)
          if (quantity.of == NamedQuantity::Of::contact &&
              quantity.name == contact.name)
            check_strip(quantity, contact.points);
  }



  void
  Simulation::build_strength()
  {
    if (scene.strength.criteria.empty())
      return;
    strength =
      std::make_unique<StrengthSweep>(structure->bodies(), scene.strength);
  }



  FaceTractions
  Simulation::tractions_at(const double factor) const
  {
    FaceTractions tractions(scene.loads, factor, scene.supports);
    for (unsigned int c = 0; c < contacts.size(); ++c)
      tractions.add_contact(contacts[c].first_body,
                            contacts[c].second_body,
                            contacts[c].points,
                            gap_rows.of_contact(c, state.force));
    return tractions;
  }



  void
  Simulation::take_strength(StepResults         &results,
                            const FaceTractions &tractions) const
  {
    if (strength == nullptr)
      return;
    StrengthSweep::Found found =
      strength->sweep(results.state.u, tractions, cured_state());
    results.plies           = std::move(found.plies);
    results.plies_along     = std::move(found.along);
    const std::string doubt = doubt_of_worst(results.plies,
                                             scene.supports,
                                             scene.loads,
                                             structure->bodies());
    if (!doubt.empty())
      results.warnings.push_back(doubt);
  }



  void
  Simulation::describe()
  {
    found.title      = scene.title;
    found.units      = scene.units;
    found.load_steps = scene.solve.load_factors.size();
    found.size       = structure->size();
    found.loads      = structure->load_resultants();
    for (const auto &body : structure->bodies())
      found.bodies.push_back(
        {body->name(), body->theory(), body->n_dofs(), {}});
    for (unsigned int k = 0; k < contacts.size(); ++k)
      found.contacts.push_back(
        contact_facts(contacts[k], scene.contacts[k].enforcement));
    for (const Support &support : scene.supports)
      found.supports.push_back(support.name);
    for (const Probe &probe : scene.probes)
      found.probes.push_back(probe.name);
    for (const Line &line : scene.lines)
      found.lines.push_back(line.name);
    for (const Cut &cut : scene.cuts)
      found.cuts.push_back(cut.name);
    for (const Measure &measure : scene.measures)
      found.measures.push_back(measure.name);

    const auto add = [this](const std::vector<std::string> &notes) {
      found.notes.insert(found.notes.end(), notes.begin(), notes.end());
    };
    add(scene.warnings);
    add(field_notes);
    add(notes_on_theories(scene, sections));
    for (const LoadResultant &load : structure->load_resultants())
      add(load.notes);
    for (const ContactInterface &contact : contacts)
      add(contact.notes);
  }



  std::vector<NamedQuantity>
  Simulation::in_plies(std::vector<NamedQuantity> quantities) const
  {
    for (NamedQuantity &quantity : quantities)
      {
        if (quantity.path == references_path)
          quantity = sampler->in_lower_ply(quantity);
        sampler->check(quantity);
      }
    return quantities;
  }



  bool
  Simulation::take_all_fields()
  {
    bool any = false;
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      if (const Body &body = *structure->bodies()[b];
          scene.bodies[b].pieces.empty() &&
          scene.bodies[b].theory.kind == Theory::Kind::SV)
        {
          any = true;
          field_rules.unsolved.push_back(body.name());
          out << "Body " << body.name() << ": " << body.theory()
              << ", is beyond double precision; once more with all fields of "
                 "its section"
              << std::endl;
        }
    if (!any)
      return false;
    solver.reset();
    sampler.reset();
    strength.reset();
    contacts.clear();
    search_checks.clear();
    cured.reset();
    state = State();
    found = Results();
    build();
    return true;
  }



  const Results &
  Simulation::solve(const Observer &observer)
  {
    try
      {
        return solve_as_built(observer);
      }
    catch (const LostDigits &)
      {
        // Steps that are done stay with the fields that they have.
        if (!found.steps.empty() || !take_all_fields())
          throw;
      }
    return solve_as_built(observer);
  }



  const Results &
  Simulation::solve_as_built(const Observer &observer)
  {
    prepare();
    if (strength != nullptr && structure->is_heated())
      find_cured_state();
    const std::vector<double> &factors = scene.solve.load_factors;
    if (last_is_bare && found.steps.size() == factors.size())
      complete_last_step();
    while (found.steps.size() < factors.size())
      {
        const unsigned int step = found.steps.size() + 1;
        out << "Load step " << step << " of " << factors.size()
            << ", load factor " << factors[step - 1] << std::endl;
        solve_step(step, factors[step - 1], observer);
      }
    if (scene.find_first_failure)
      find_first_failure();
    const std::vector<std::string> warnings = solver->warnings();
    found.endnotes.insert(found.endnotes.end(),
                          warnings.begin(),
                          warnings.end());
    found.converged = true;
    count_costs();
    return found;
  }



  void
  Simulation::find_cured_state()
  {
    out << "State without loads, of heat alone" << std::endl;
    const State before = state;
    solve_state(0.);
    cured = state.u;
    state = before;
  }



  void
  Simulation::prepare()
  {
    const MemoryBudget budget(scene.solve.memory_limit);
    const std::string  memory = budget.require_matrices(*structure);
    print_bodies(out, *structure, contacts, scene.units);
    out << "Memory: " << memory << std::endl;
    if (scene.solve.strategy == Strategy::full)
      {
        TimerOutput::Scope scope(timer, name_of(Phase::assembly));
        solver = std::make_unique<PenaltyNewton>(*structure,
                                                 gap_rows,
                                                 scene.solve.loop);
      }
    else
      solver = std::make_unique<MultiplierLoop>(linearise(budget),
                                                gap_rows,
                                                scene.solve.loop);
    if (!found.steps.empty())
      solver->recall(found.last().memory);
    solver->progress = [this](const std::string &line) {
      out << "  " << line << std::endl;
    };
    solver->describe = [this](const unsigned int row) {
      return describe_row(row);
    };
  }



  std::shared_ptr<const Linearisation>
  Simulation::linearise(const MemoryBudget &budget)
  {
    // Phases that alternate from body to body, and end with whatever is thrown.
    std::optional<TimerOutput::Scope> phase;
    Linearisation::BodyMonitor        monitor;
    monitor.begins = [&](const Body &) {
      phase.emplace(timer, name_of(Phase::assembly));
    };
    monitor.assembled = [&](const Body &) {
      phase.reset();
      phase.emplace(timer, name_of(Phase::factorisation));
    };
    monitor.sized = [&](const Body &body, const FactorSize &size) {
      out << "Memory: " << budget.require_factor(body, size) << std::endl;
    };
    monitor.ends = [&](const Body &) { phase.reset(); };
    return linearised(*structure, scene.solve.solver, monitor);
  }



  std::string
  Simulation::describe_row(const unsigned int row) const
  {
    const auto [c, k]               = gap_rows.in_contact(row);
    const ContactInterface &contact = contacts[c];
    return "contact " + contact.name + ", body '" +
           structure->bodies()[contact.first_body]->name() + "' at " +
           to_text(contact.points[k].first);
  }



  Checks
  Simulation::solve_state(const double factor)
  {
    const State previous = state;
    {
      TimerOutput::Scope scope(timer, name_of(Phase::solve));
      state = solver->solve_free(factor);
    }
    if (!gap_rows.empty())
      {
        TimerOutput::Scope scope(timer, name_of(Phase::contact));
        state = solver->release_springs(
          solver->solve_contact(state, factor, previous), factor);
      }
    return checked(factor);
  }



  Checks
  Simulation::checked(const double factor)
  {
    Checks checks;
    {
      TimerOutput::Scope scope(timer, name_of(Phase::solve));
      checks = check_state(
        solver->tangent(), contacts, scene.supports.size(), state, factor);
      require_sound(state, checks, scene.solve.rotation_limit);
      for (unsigned int k = 0; k < contacts.size(); ++k)
        search_checks[k].check(contacts[k],
                               state.u,
                               factor,
                               gap_rows.of_contact(k, state.active));
    }
    if (!scene.solve.is_judged)
      return checks;
    {
      TimerOutput::Scope scope(timer, name_of(Phase::beyond));
      checks.beyond =
        beyond_linear(*structure, *solver, state, checks.energies);
    }
    if (scene.solve.beyond_linear == OutOfRange::refuse)
      require_linear_range(checks.beyond, *structure);
    return checks;
  }



  void
  Simulation::complete_last_step()
  {
    StepResults  kept   = std::move(found.steps.back());
    const Checks checks = checked(kept.load_factor);
    StepResults &last   = found.steps.back();
    last          = take_results(kept.step, kept.load_factor, checks, state);
    last.memory   = std::move(kept.memory);
    last.changes  = std::move(kept.changes);
    last.warnings = std::move(kept.warnings);
    take_measures();
    last_is_bare = false;
  }



  void
  Simulation::solve_step(const unsigned int step,
                         const double       factor,
                         const Observer    &observer)
  {
    const State  previous = state;
    const Checks checks   = solve_state(factor);
    {
      TimerOutput::Scope scope(timer, name_of(Phase::output));
      found.steps.push_back(take_results(step, factor, checks, previous));
      take_measures();
    }
    if (!observer)
      return;
    count_costs();
    TimerOutput::Scope scope(timer, name_of(Phase::output));
    observer(found);
    if (step > 1)
      found.steps[step - 2].drop_fields();
  }



  void
  Simulation::take_measures()
  {
    if (scene.measures.empty())
      return;
    const ResultNumbers numbers(found);
    for (const Measure &measure : scene.measures)
      found.steps.back().measures.push_back(numbers.value(measure.quantity));
  }



  FailureTrial
  Simulation::try_for_failure(const double             factor,
                              std::vector<PlyReserve> &plies)
  {
    FailureTrial trial;
    trial.load_factor  = factor;
    const State before = state;
    try
      {
        trial.checks = solve_state(factor);
      }
    catch (const NumericsError &)
      {
        // No start for the next trial.
        state = before;
        throw;
      }
    const FaceTractions tractions = tractions_at(factor);
    trial.probes                  = sampler->sample_probes(state.u, tractions);
    plies = strength->sweep(state.u, tractions, cured_state()).plies;
    if (const PlyReserve *worst = worst_of(plies))
      trial.reserve = worst->reserve;
    return trial;
  }



  void
  Simulation::find_first_failure()
  {
    const State        last_step = state;
    FirstFailureSearch search(
      [this](const double factor, std::vector<PlyReserve> &plies) {
        return try_for_failure(factor, plies);
      },
      out);
    found.first_failure = search.find(found.steps);
    if (const std::string note = search.note(); !note.empty())
      found.endnotes.push_back(note);
    state = last_step;
  }



  StepResults
  Simulation::take_results(const unsigned int step,
                           const double       factor,
                           const Checks      &checks,
                           const State       &previous) const
  {
    StepResults results;
    results.step                  = step;
    results.load_factor           = factor;
    results.state                 = state;
    results.checks                = checks;
    results.memory                = solver->memory();
    results.warnings              = warnings_of_step(factor, checks);
    const FaceTractions tractions = tractions_at(factor);
    sampler->sample(state.u, results, tractions);
    for (const std::string &warning : closure_warnings(results.closures, found))
      results.warnings.push_back(warning);
    take_strength(results, tractions);
    for (unsigned int c = 0; c < contacts.size(); ++c)
      {
        const ContactInterface &contact = contacts[c];
        const auto              force   = gap_rows.of_contact(c, state.force);
        auto                   &rows    = results.contacts.emplace_back();
        auto                   &change  = results.changes.emplace_back();
        for (unsigned int k = 0; k < contact.rows.size(); ++k)
          {
            rows.push_back({contact.points[k],
                            contact.rows[k].initial_gap,
                            contact.rows[k].gap(state.u, factor),
                            force[k],
                            checks.contacts[c].of_rows[k]});
            const bool touched = !previous.force.empty() &&
                                 gap_rows.of_contact(c, previous.force)[k] > 0.;
            change.closed += rows.back().touches() && !touched;
            change.opened += !rows.back().touches() && touched;
          }
      }
    return results;
  }



  std::vector<std::string>
  Simulation::warnings_of_step(const double factor, const Checks &checks) const
  {
    std::vector<std::string> warnings = warnings_of(state, checks, contacts);
    for (const std::string &warning : warnings_of(checks.beyond, *structure))
      warnings.push_back(warning);
    if (scene.solve.is_judged)
      for (const std::string &doubt : plausibility->doubts(state.u))
        warnings.push_back(doubt);
    for (unsigned int k = 0; k < contacts.size(); ++k)
      for (const std::string &warning :
           broken_assumptions(contacts[k],
                              structure->bodies(),
                              state.u,
                              factor,
                              gap_rows.of_contact(k, state.active)))
        warnings.push_back(warning);
    for (const std::string &warning : warnings_of_holds(checks))
      warnings.push_back(warning);
    return warnings;
  }



  std::vector<std::string>
  Simulation::warnings_of_holds(const Checks &checks) const
  {
    // Of the largest force, a moment over the scene's size.
    constexpr double         worth_saying = 1e-3;
    double                   largest      = 0.;
    std::vector<std::string> warnings;
    for (const Resultant &reaction : checks.reactions)
      largest = std::max(largest, reaction.force.norm());
    for (const KuhnTucker &contact : checks.contacts)
      largest = std::max(largest, contact.force.norm());
    for (unsigned int s = 0; s < scene.supports.size(); ++s)
      {
        const Resultant &reaction = checks.reactions[s];
        const double     share =
          std::max(reaction.force.norm(),
                   reaction.moment.norm() / structure->size()) /
          largest;
        if (scene.supports[s].hold && !checks.contacts.empty() &&
            share > worth_saying)
          warnings.push_back(
            "the hold of body '" +
            structure->bodies()[scene.supports[s].hold->body]->name() +
            "' bears a force of " + to_text(reaction.force) +
            " and a moment of " + to_text(reaction.moment) + ", " +
            to_text(100. * share, 2) +
            " % of the largest force: contact forces off their main direction "
            "do not balance in motions that it takes out. Put a support where "
            "the real one is, if that is too much");
      }
    return warnings;
  }



  void
  Simulation::count_costs()
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
    if (solver != nullptr && scene.solve.strategy == Strategy::condensed)
      for (unsigned int b = 0; b < found.bodies.size(); ++b)
        found.bodies[b].solver = solver->tangent().solver(b).statistics();
  }



  ResultsWriter::Scenery
  Simulation::scenery() const
  {
    // Points of pictures do not know which of their stress stays when loads
    // grow: no reserve factors there where bodies are heated.
    return {*structure,
            contacts,
            sections,
            scene.resolved,
            scene.write_vtu,
            structure->is_heated() ? nullptr : strength.get()};
  }



  void
  Simulation::run(const std::string  &directory,
                  const bool          resume,
                  const Afterthought &afterwards)
  {
    ResultsWriter writer(directory, scenery());
    // Steps of an earlier run, which are not looked at again.
    std::size_t earlier = 0;
    if (resume)
      {
        found.steps  = writer.resume();
        earlier      = found.steps.size();
        state        = found.steps.back().state;
        last_is_bare = true;
        out << "Going on after load step " << found.steps.size() << " of "
            << found.load_steps << std::endl;
      }
    keep_ready_for_interruption(directory, earlier, found.load_steps);
    try
      {
        solve([&](const Results &results) {
          writer.write_step(results);
          keep_ready_for_interruption(directory,
                                      results.steps.size(),
                                      found.load_steps);
        });
      }
    catch (const NumericsError &error)
      {
        if (found.steps.size() > earlier)
          {
            count_costs();
            writer.write_end(found);
            print_results(directory, out);
          }
        if (writer.folder().has_earlier_results())
          throw NumericsError(std::string(error.what()) + " (The results in " +
                              directory + " are of an earlier run.)");
        throw;
      }
    if (afterwards)
      afterwards(found);
    writer.write_end(found);
    say_if_interrupted("");
    print_results(directory, out);
  }



  void
  Simulation::write(const std::string             &directory,
                    const std::vector<GoalResult> &goals)
  {
    found.goals = goals;
    count_costs();
    ResultsWriter writer(directory, scenery());
    Results       so_far = found;
    so_far.steps.clear();
    for (const StepResults &step : found.steps)
      {
        so_far.steps.push_back(step);
        writer.write_step(so_far);
      }
    writer.write_end(found);
  }



  void
  Simulation::print_results(const std::string &directory,
                            std::ostream      &to) const
  {
    if (found.load_steps > 1)
      to << "\nOf load step " << found.steps.size() << ", load factor "
         << found.last().load_factor << ":";
    print_comparison(to, found, references_of(scene));
    print_summary(to, found);
    to << "\nResults are in " << directory
       << " (summary.json, probes.csv, solution.pvd, ...)" << std::endl;
  }



  void
  Simulation::print_validation(const std::string &directory) const
  {
    out << scene.title << (scene.title.empty() ? "" : "\n");
    for (const auto &[name, material] : scene.materials)
      print_material(out, name, material, scene.units);
    for (const auto &[name, shape] : scene.sections)
      {
        if (const auto *laminate = std::get_if<Laminate>(&shape))
          print_laminate(out,
                         name,
                         laminate->plies(scene.materials),
                         laminate->width,
                         *sections.at(name),
                         scene.units);
        else
          print_section(
            out, name, name_of(shape), *sections.at(name), scene.units);
        const SectionStiffness stiffness = section_stiffness(sections.at(name));
        print_stiffness(out, name, stiffness, scene.units);
        if (!directory.empty() && is_speaker())
          {
            write_section(directory, name, *sections.at(name));
            write_section_stiffness(directory, name, stiffness, scene.units);
          }
      }
    print_bodies(out, *structure, contacts, scene.units);
    for (const std::string &warning : found.notes)
      out << "Note: " << warning << ".\n";
    out << "The scene is valid; nothing was solved";
    if (directory.empty())
      out << " or written." << std::endl;
    else
      out << ". Its sections are in " << directory << "/sections." << std::endl;
  }



  std::unique_ptr<Simulation>
  make_simulation(const Scene &scene, const SceneText &text, std::ostream &out)
  {
    try
      {
        return std::make_unique<Simulation>(scene, out);
      }
    catch (const InputError &error)
      {
        throw text.placed(error);
      }
  }
} // namespace lamella
