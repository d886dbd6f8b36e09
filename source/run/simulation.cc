// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/memory.h>
#include <lamella/base/processes.h>
#include <lamella/base/text.h>
#include <lamella/contact/assumptions.h>
#include <lamella/report/console.h>
#include <lamella/report/section_table.h>
#include <lamella/report/validation.h>
#include <lamella/report/vtu.h>
#include <lamella/run/simulation.h>
#include <lamella/solve/condensed_strategy.h>
#include <lamella/solve/full_strategy.h>

#include <filesystem>
#include <fstream>
#include <ostream>

namespace lamella
{
  using namespace dealii;

  Simulation::Simulation(const Scene &scene, std::ostream &out)
    : scene(scene)
    , out(out)
    , timer(out, TimerOutput::never, TimerOutput::wall_times)
  {
    {
      TimerOutput::Scope scope(timer, "setup");
      sections = build_section_meshes(scene);
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
    }
    TimerOutput::Scope scope(timer, "setup");
    for (const Support &support : scene.supports)
      summary.support_names.push_back(support.name);
    summary.title    = scene.title;
    summary.warnings = scene.warnings;
    for (const std::string &warning :
         torques_left_out(scene.loads, structure->bodies()))
      summary.warnings.push_back(warning);
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



  namespace
  {
    /// Creates @p directory where there is none, which it returns, and makes
    /// sure that files can be written there.
    bool
    prepare_directory(const std::string &directory)
    {
      bool is_new = false, writes = true;
      if (is_speaker())
        {
          std::error_code error;
          is_new = !std::filesystem::exists(directory, error);
          std::filesystem::create_directories(directory, error);
          const std::string trial = directory + "/.lamella";
          writes = !error && std::ofstream(trial).put('\n').good();
          std::filesystem::remove(trial, error);
        }
      if (!on_all_processes(writes))
        throw InputError("--output " + directory +
                         ": results cannot be written there. Name a folder "
                         "that can be created and written.");
      return is_new;
    }
  } // namespace



  void
  Simulation::run(const std::string &directory)
  {
    const MemoryBudget budget(scene.solve.memory_limit);
    const std::string  memory = budget.require_matrices(*structure);
    output_directory          = directory;
    created_directory         = prepare_directory(directory);
    print_bodies(out, *structure, contacts);
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
        write_results(directory);
        if (summary.iterations.empty() &&
            std::filesystem::exists(directory + "/summary.json"))
          throw NumericsError(std::string(error.what()) + " (The results in " +
                              directory + " are of an earlier run.)");
        throw;
      }
    write_results(directory);
  }



  void
  Simulation::prepare_strategy(const MemoryBudget &budget)
  {
    if (scene.solve.strategy == Strategy::full)
      {
        strategy = std::make_unique<FullStrategy>(*structure, gap_rows);
        return;
      }
    try
      {
        structure->factorise([&](const Body &body, const FactorSize &size) {
          out << "Memory: " << budget.require_factor(body, size) << std::endl;
        });
      }
    catch (const InputError &)
      {
        remove_created_directory();
        throw;
      }
    strategy = std::make_unique<CondensedStrategy>(*structure, gap_rows);
  }



  void
  Simulation::remove_created_directory() const
  {
    std::error_code error;
    if (created_directory)
      std::filesystem::remove(output_directory, error);
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
    {
      TimerOutput::Scope scope(timer, "contact");
      if (!gap_rows.empty())
        state = newton->solve_contact(state, factor, previous);
    }
    Checks checks;
    {
      TimerOutput::Scope scope(timer, "solve");
      checks =
        check_state(*structure, contacts, scene.supports.size(), state, factor);
      require_sound(state, checks, scene.solve.rotation_limit);
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



  void
  Simulation::add_warnings(const unsigned int step,
                           const double       factor,
                           const Checks      &checks)
  {
    std::vector<std::string> warnings = warnings_of(state, checks, contacts);
    // Whose rows are active, numbered from 0 in each contact.
    auto         row       = state.active.begin();
    unsigned int first_row = 0;
    for (const ContactInterface &contact : contacts)
      {
        std::vector<unsigned int> active;
        for (; row != state.active.end() &&
               *row < first_row + contact.rows.size();
             ++row)
          active.push_back(*row - first_row);
        first_row += contact.rows.size();
        for (const std::string &warning : broken_assumptions(
               contact, structure->bodies(), state.u, factor, active))
          warnings.push_back(warning);
      }
    for (const std::string &warning : warnings)
      summary.warnings.push_back((scene.solve.load_factors.size() > 1 ?
                                    "load step " + std::to_string(step) + ": " :
                                    "") +
                                 warning);
  }



  void
  Simulation::write_vtu_files(const unsigned int step, const double factor)
  {
    vtu_files["solution"].emplace_back(
      step, write_vtu(output_directory, step, factor, *structure, state.u));
    if (!is_speaker())
      return;
    unsigned int first_row = 0;
    for (unsigned int k = 0; k < contacts.size(); ++k)
      {
        vtu_files["contact_" + contacts[k].name].emplace_back(
          step,
          contact_surfaces[k].write_vtu(
            output_directory, step, factor, state, first_row));
        first_row += contacts[k].rows.size();
      }
  }



  void
  Simulation::write_results(const std::string &directory)
  {
    if (summary.iterations.empty())
      {
        // Nothing was solved, so nothing is left behind.
        remove_created_directory();
        return;
      }
    if (scene.solve.strategy == Strategy::condensed)
      for (const auto &body : structure->bodies())
        summary.solvers[body->name()] = body->solver().statistics();
    summary.processes   = n_processes();
    summary.peak_memory = Utilities::MPI::max(peak_memory(), communicator());
    summary.peak_memory_of_all =
      Utilities::MPI::sum(peak_memory(), communicator());
    if (!is_speaker())
      return;
    {
      TimerOutput::Scope scope(timer, "output");
      recorder->write(directory);
      for (const auto &[name, files] : vtu_files)
        write_pvd(directory, name, files);
      for (const auto &[name, section] : sections)
        write_section(directory, name, *section);
      if (!(std::ofstream(directory + "/scene.prm") << scene.resolved))
        throw InputError("Cannot write into " + directory +
                         ". Is the disk full?");
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
                       laminate->width);
      else
        print_section(out, name, name_of(shape), *sections.at(name));
    print_bodies(out, *structure, contacts);
    for (const std::string &warning : summary.warnings)
      out << "Note: " << warning << ".\n";
    out << "The scene is valid; nothing was solved or written." << std::endl;
  }
} // namespace lamella
