// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/memory.h>
#include <lamella/base/output_file.h>
#include <lamella/base/processes.h>
#include <lamella/base/text.h>
#include <lamella/contact/assumptions.h>
#include <lamella/report/console.h>
#include <lamella/report/section_table.h>
#include <lamella/report/validation.h>
#include <lamella/report/vtu.h>
#include <lamella/run/simulation.h>
#include <lamella/scene/theory_notes.h>
#include <lamella/solve/condensed_strategy.h>
#include <lamella/solve/full_strategy.h>

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
  } // namespace



  Simulation::Simulation(const Scene &scene, std::ostream &out)
    : scene(scene)
    , out(out)
    , timer(out, TimerOutput::never, TimerOutput::wall_times)
  {
    {
      TimerOutput::Scope scope(timer, "setup");
      sections = build_section_meshes(scene);
      tell_large_sections(sections, out);
      std::vector<Stabilisation> stabilisations;
      for (const BodyDescription &body : scene.bodies)
        stabilisations.push_back(body.stabilisation);
      structure = std::make_unique<Structure>(build_bodies(scene, sections),
                                              scene.supports,
                                              scene.loads,
                                              stabilisations);
      for (const auto &body : structure->bodies())
        body->solver_kind(scene.solve.solver);
    }
    {
      TimerOutput::Scope scope(timer, "contact");
      for (const ContactPair &contact : scene.contacts)
        {
          contacts.push_back(make_interface(contact, structure->bodies()));
          gap_rows.insert(gap_rows.end(),
                          contacts.back().rows.begin(),
                          contacts.back().rows.end());
        }
      check_conflicts(contacts, structure->bodies());
      for (const ContactPair &contact : scene.contacts)
        search_checks.emplace_back(contact, structure->bodies());
    }
    TimerOutput::Scope scope(timer, "setup");
    for (const Support &support : scene.supports)
      summary.support_names.push_back(support.name);
    summary.title    = scene.title;
    summary.warnings = scene.warnings;
    for (const std::string &note : notes_on_theories(scene, sections))
      summary.warnings.push_back(note);
    for (const LoadResultant &load : structure->load_resultants())
      summary.warnings.insert(summary.warnings.end(),
                              load.notes.begin(),
                              load.notes.end());
    for (const ContactInterface &contact : contacts)
      summary.warnings.insert(summary.warnings.end(),
                              contact.notes.begin(),
                              contact.notes.end());
    summary.units     = scene.units;
    summary.structure = structure.get();
    summary.contacts  = &contacts;
    summary.pairs     = &scene.contacts;
    if (scene.write_vtu)
      for (const ContactInterface &contact : contacts)
        contact_surfaces.emplace_back(contact, *structure);
    recorder = std::make_unique<Recorder>(*structure,
                                          contacts,
                                          summary.support_names,
                                          scene.probes,
                                          scene.lines,
                                          scene.cuts);
  }



  void
  Simulation::run(const std::string &directory)
  {
    const MemoryBudget budget(scene.solve.memory_limit);
    const std::string  memory = budget.require_matrices(*structure);
    folder                    = std::make_unique<ResultsFolder>(directory);
    print_bodies(out, *structure, contacts, scene.units);
    out << "Memory: " << memory << std::endl;
    {
      TimerOutput::Scope scope(timer, "assembly");
      structure->assemble(scene.solve.solver);
    }
    {
      TimerOutput::Scope scope(timer, "factorisation");
      prepare_strategy(budget);
    }
    newton           = std::make_unique<Newton>(*structure,
                                      gap_rows,
                                      *strategy,
                                      scene.solve.newton);
    newton->progress = [this](const std::string &line) {
      out << "  " << line << std::endl;
    };
    newton->describe = [this](const unsigned int row) {
      return describe_row(row);
    };

    try
      {
        for (unsigned int step = 1; step <= scene.solve.load_factors.size();
             ++step)
          solve_step(step, scene.solve.load_factors[step - 1]);
        summary.converged = true;
      }
    catch (const NumericsError &error)
      {
        write_results();
        if (folder->has_earlier_results())
          throw NumericsError(std::string(error.what()) + " (The results in " +
                              directory + " are of an earlier run.)");
        throw;
      }
    write_results();
  }



  void
  Simulation::prepare_strategy(const MemoryBudget &budget)
  {
    if (scene.solve.strategy == Strategy::full)
      {
        strategy = std::make_unique<FullStrategy>(*structure, gap_rows);
        return;
      }
    structure->factorise([&](const Body &body, const FactorSize &size) {
      out << "Memory: " << budget.require_factor(body, size) << std::endl;
    });
    strategy = std::make_unique<CondensedStrategy>(*structure, gap_rows);
  }



  std::string
  Simulation::describe_row(unsigned int row) const
  {
    auto contact = contacts.begin();
    for (; row >= contact->rows.size(); ++contact)
      row -= contact->rows.size();
    return "contact " + contact->name + ", body '" +
           structure->bodies()[contact->first_body]->name() + "' at " +
           to_text(contact->points[row].first);
  }



  void
  Simulation::solve_step(const unsigned int step, const double factor)
  {
    out << "Load step " << step << " of " << scene.solve.load_factors.size()
        << ", load factor " << factor << std::endl;
    const State previous = state;
    {
      TimerOutput::Scope scope(timer, "solve");
      state = newton->solve_free(factor);
    }
    if (!gap_rows.empty())
      {
        TimerOutput::Scope scope(timer, "contact");
        state = newton->release_springs(
          newton->solve_contact(state, factor, previous), factor);
      }
    Checks checks;
    {
      TimerOutput::Scope scope(timer, "solve");
      checks =
        check_state(*structure, contacts, scene.supports.size(), state, factor);
      require_sound(state, checks, scene.solve.rotation_limit);
      for (unsigned int k = 0; k < contacts.size(); ++k)
        search_checks[k].check(contacts[k], state.u, factor, active_rows(k));
    }
    TimerOutput::Scope scope(timer, "output");
    recorder->record(step, factor, state, checks);
    summary.status_changes = recorder->status_changes();
    if (scene.write_vtu)
      write_vtu_files(step, factor);
    for (const Recorder::InterfaceJump &jump : recorder->interface_jumps())
      summary.interface_jumps[jump.line] = jump.relative;
    summary.checks = checks;
    summary.iterations.push_back(state.iterations);
    summary.free_corrections    = state.free_corrections;
    summary.contact_corrections = state.contact_corrections;
    add_warnings(step, factor, checks);
    if (step == scene.solve.load_factors.size())
      for (const std::string &warning : strategy->warnings())
        summary.warnings.push_back(warning);
    summary.condition_estimate = strategy->condition_estimate();
  }



  std::vector<unsigned int>
  Simulation::active_rows(const unsigned int contact) const
  {
    unsigned int first = 0;
    for (unsigned int k = 0; k < contact; ++k)
      first += contacts[k].rows.size();
    std::vector<unsigned int> active;
    for (const unsigned int row : state.active)
      if (row >= first && row < first + contacts[contact].rows.size())
        active.push_back(row - first);
    return active;
  }



  void
  Simulation::add_warnings(const unsigned int step,
                           const double       factor,
                           const Checks      &checks)
  {
    std::vector<std::string> warnings = warnings_of(state, checks, contacts);
    for (unsigned int k = 0; k < contacts.size(); ++k)
      for (const std::string &warning : broken_assumptions(
             contacts[k], structure->bodies(), state.u, factor, active_rows(k)))
        warnings.push_back(warning);
    for (const std::string &warning : warnings)
      summary.warnings.push_back((scene.solve.load_factors.size() > 1 ?
                                    "load step " + std::to_string(step) + ": " :
                                    "") +
                                 warning);
  }



  void
  Simulation::write_vtu_files(const unsigned int step, const double factor)
  {
    folder->make_room();
    vtu_files["solution"].emplace_back(
      step, write_vtu(folder->path(), step, factor, *structure, state.u));
    if (!is_speaker())
      return;
    unsigned int first_row = 0;
    for (unsigned int k = 0; k < contacts.size(); ++k)
      {
        vtu_files["contact_" + contacts[k].name].emplace_back(
          step,
          contact_surfaces[k].write_vtu(
            folder->path(), step, factor, state, first_row));
        first_row += contacts[k].rows.size();
      }
  }



  void
  Simulation::write_results()
  {
    // Where nothing was solved nothing is left behind.
    if (summary.iterations.empty())
      return;
    if (scene.solve.strategy == Strategy::condensed)
      for (const auto &body : structure->bodies())
        summary.solvers[body->name()] = body->solver().statistics();
    summary.processes   = n_processes();
    summary.peak_memory = Utilities::MPI::max(peak_memory(), communicator());
    summary.peak_memory_of_all =
      Utilities::MPI::sum(peak_memory(), communicator());
    folder->make_room();
    if (!is_speaker())
      return;
    const std::string &directory = folder->path();
    {
      TimerOutput::Scope scope(timer, "output");
      recorder->write(directory);
      for (const auto &[name, files] : vtu_files)
        write_pvd(directory, name, files);
      for (const auto &[name, section] : sections)
        write_section(directory, name, *section);
      write_file(directory + "/scene.prm", scene.resolved);
    }
    for (const char *phase :
         {"setup", "assembly", "factorisation", "solve", "contact", "output"})
      summary.seconds[phase] = 0.;
    for (const auto &[phase, seconds] :
         timer.get_summary_data(TimerOutput::total_wall_time))
      summary.seconds[phase] = seconds;
    summary.seconds["total"] = wall.wall_time();
    write_summary(summary, directory);

    std::vector<ResultantReferences> resultants;
    for (unsigned int s = 0; s < scene.supports.size(); ++s)
      resultants.push_back(
        {"support " + scene.supports[s].name,
         summary.checks.reactions[s],
         scene.support_references.at(scene.supports[s].name)});
    for (unsigned int k = 0; k < contacts.size(); ++k)
      resultants.push_back({"contact " + contacts[k].name,
                            summary.checks.contacts[k].force,
                            scene.contact_references.at(contacts[k].name)});
    if (scene.solve.load_factors.size() > 1)
      out << "\nOf load step " << summary.iterations.size() << ", load factor "
          << scene.solve.load_factors[summary.iterations.size() - 1] << ":";
    print_comparison(out, scene.probes, *recorder, resultants);
    print_summary(out, summary);
    out << "\nResults are in " << directory
        << " (summary.json, probes.csv, solution.pvd, ...)" << std::endl;
  }



  void
  Simulation::print_validation() const
  {
    out << scene.title << (scene.title.empty() ? "" : "\n");
    for (const auto &[name, shape] : scene.sections)
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
    print_bodies(out, *structure, contacts, scene.units);
    for (const std::string &warning : summary.warnings)
      out << "Note: " << warning << ".\n";
    out << "The scene is valid; nothing was solved or written." << std::endl;
  }
} // namespace lamella
