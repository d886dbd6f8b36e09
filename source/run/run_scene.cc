// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>
#include <lamella/base/text.h>
#include <lamella/conditions/follower_load.h>
#include <lamella/report/console.h>
#include <lamella/report/results_writer.h>
#include <lamella/report/section_stiffness.h>
#include <lamella/report/summary.h>
#include <lamella/report/tables.h>
#include <lamella/report/validation.h>
#include <lamella/run/run_scene.h>
#include <lamella/scene/rotation_rules.h>

#include <algorithm>
#include <limits>
#include <ostream>

namespace lamella
{
  namespace
  {
    /// Message on @p directory if the user stops after @p done of @p all steps.
    void
    update_interruption_message(const std::string &directory,
                                const unsigned int done,
                                const unsigned int all,
                                const bool         may_resume)
    {
      if (!is_root_process())
        return;
      if (done == 0)
        set_interruption_message(
          "interrupted before the first load step was done: "
          "nothing of this run is in " +
          directory + ".");
      else
        set_interruption_message(
          "interrupted. " + directory + " has " +
          (done == all ?
             "all load steps, but not what comes after them" :
             "load step" + std::string(done == 1 ? " " : "s 1 to ") +
               std::to_string(done) + " of " + std::to_string(all)) +
          (may_resume ?
             ". The same command with --resume goes on from there." :
             ". No run can go on from there, as this one has changed the axis "
             "or the contacts of its scene."));
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
      lists.modes = scene.find.references;
      return lists;
    }



    /// What the files of @p simulation are made of, beyond results.
    ResultsWriter::OutputSources
    scenery_of(const Simulation &simulation)
    {
      const BuiltScene &built = simulation.model();
      // Points of pictures do not know which of their stress stays when loads
      // grow: no reserve factors there where bodies are heated.
      return {built.structure(),
              built.interfaces(),
              built.sections(),
              built.scene().resolved,
              built.scene().write_vtu,
              built.structure().is_heated() ? nullptr : built.strength()};
    }



    /// Solves what is left of @p simulation and has @p writer write each step;
    /// also the end of the results, where the numerics fail after some steps.
    void
    do_steps(Simulation        &simulation,
             ResultsWriter     &writer,
             const std::string &directory,
             bool              &is_writing)
    {
      const Results &found = simulation.results();
      // Steps of an earlier run, which are not looked at again.
      const std::size_t earlier = found.steps.size();
      update_interruption_message(directory, earlier, found.load_steps, true);
      try
        {
          simulation.solve([&](const Results &results) {
            const SignalBlock whole;
            is_writing = true;
            writer.write_step(results);
            is_writing = false;
            update_interruption_message(directory,
                                        results.steps.size(),
                                        results.load_steps,
                                        !simulation.is_revised());
          });
        }
      catch (const NumericsError &error)
        {
          if (found.steps.size() > earlier)
            {
              simulation.record_costs();
              writer.write_end(found);
              print_results(simulation, directory, simulation.output());
            }
          else
            // Notes may explain the failure.
            for (const std::string &note : found.notes)
              simulation.output() << note_line(note) << "\n";
          if (writer.folder().has_earlier_results())
            throw NumericsError(std::string(error.what()) +
                                " (The results in " + directory +
                                " are of an earlier run.)");
          throw;
        }
    }



    /// Solves as do_steps(). What is found wrong with the scene after some
    /// steps leaves no results.
    void
    solve_steps(Simulation        &simulation,
                ResultsWriter     &writer,
                const std::string &directory)
    {
      const bool is_resumed = !simulation.results().steps.empty();
      bool       is_writing = false;
      try
        {
          do_steps(simulation, writer, directory, is_writing);
        }
      catch (const InputError &)
        {
          // A full disk is no fault of the scene.
          if (!is_resumed && !is_writing)
            writer.discard();
          throw;
        }
    }
  } // namespace



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



  void
  run_scene(Simulation           &simulation,
            const std::string    &directory,
            const bool            resume,
            const PostProcessing &post_processing)
  {
    ResultsWriter  writer(directory,
                         [&simulation] { return scenery_of(simulation); });
    const Results &found = simulation.results();
    std::ostream  &out   = simulation.output();
    if (resume)
      {
        simulation.resume(writer.resume());
        out << "Going on after load step " << found.steps.size() << " of "
            << found.load_steps << std::endl;
      }
    solve_steps(simulation, writer, directory);
    if (post_processing)
      {
        {
          const SignalBlock whole;
          writer.write_outcome(found);
          if (is_root_process())
            set_interruption_message(
              "interrupted while error bars were made. " +
              writer.folder().path() +
              " has all results but these. The same command with --resume makes "
              "them; a run with --set \"Goals/Error bars=false\" makes none.");
        }
        post_processing();
      }
    {
      const SignalBlock whole;
      writer.write_end(found);
      set_interruption_message("");
    }
    print_results(simulation, directory, out);
  }



  void
  write_run(Simulation &simulation, const std::string &directory)
  {
    simulation.record_costs();
    ResultsWriter writer(directory,
                         [&simulation] { return scenery_of(simulation); });
    Results       so_far = simulation.results();
    so_far.steps.clear();
    for (const StepResults &step : simulation.results().steps)
      {
        so_far.steps.push_back(step);
        writer.write_step(so_far);
      }
    writer.write_end(simulation.results());
  }



  void
  print_results(const Simulation  &simulation,
                const std::string &directory,
                std::ostream      &to)
  {
    const Results &found = simulation.results();
    if (found.load_steps > 1)
      to << "\nOf load step " << found.steps.size() << ", load factor "
         << found.last().load_factor.of_scene() << ":";
    print_comparison(to, found, references_of(simulation.model().scene()));
    print_summary(to, found);
    to << "\nResults are in " << directory
       << " (summary.json, probes.csv, solution.pvd, ...)" << std::endl;
  }



  namespace
  {
    /// Prints the sections of @p built, and writes them to @p directory unless
    /// it is empty.
    void
    print_sections(const BuiltScene  &built,
                   const std::string &directory,
                   std::ostream      &out)
    {
      const Scene &scene = built.scene();
      for (const auto &[name, shape] : scene.sections)
        {
          if (const auto *laminate = std::get_if<Laminate>(&shape))
            print_laminate(out,
                           name,
                           laminate->plies(scene.materials),
                           laminate->width,
                           *built.sections().at(name),
                           scene.units);
          else
            print_section(out,
                          name,
                          name_of(shape),
                          *built.sections().at(name),
                          scene.units);
          const SectionStiffness stiffness =
            section_stiffness(built.sections().at(name));
          print_stiffness(out, name, stiffness, scene.units);
          if (!directory.empty() && is_root_process())
            write_section(directory,
                          name,
                          *built.sections().at(name),
                          stiffness,
                          scene.units);
        }
    }
  } // namespace



  void
  print_validation(const Simulation &simulation, const std::string &directory)
  {
    const BuiltScene &built = simulation.model();
    const Scene      &scene = built.scene();
    std::ostream     &out   = simulation.output();
    out << scene.title << (scene.title.empty() ? "" : "\n");
    for (const auto &[name, material] : scene.materials)
      print_material(out, name, material, scene.units);
    print_sections(built, directory, out);
    print_bodies(out, built.structure(), built.interfaces(), scene.units);
    if (const auto &inertia = simulation.results().inertia)
      print_inertia(out, *inertia);
    built.print_plans(out);
    for (const std::string &warning : simulation.results().notes)
      out << note_line(warning) << "\n";
    out << "The scene is valid; nothing was solved";
    if (directory.empty())
      out << " or written." << std::endl;
    else
      out << ". Its sections are in " << directory << "/sections." << std::endl;
  }



  namespace
  {
    // Of forces or displacements.
    constexpr double needs_finite_rotations = 2e-3;



    /// @p scene with linear kinematics; nothing keeps these within their range
    /// if there @p are_others to take then.
    Scene
    with_linear_rotations(Scene scene, const bool are_others)
    {
      scene.solve.rotations = Rotations::linear;
      if (are_others)
        {
          scene.solve.rotation_limit = std::numeric_limits<double>::max();
          scene.solve.beyond_linear  = OutOfRange::accept;
        }
      return scene;
    }
  } // namespace



  LinearTrial::LinearTrial(const Scene     &scene,
                           const SceneText &text,
                           std::ostream    &out)
  {
    build_large(scene, text, out);
    linear = make_simulation(with_linear_rotations(scene, large != nullptr),
                             text,
                             out);
    out << "Rotations = auto: the linear model first" << std::endl;
    try
      {
        linear->solve();
        judge(scene);
      }
    catch (const NumericsError &error)
      {
        if (large == nullptr)
          throw;
        why = "the linear model has no result: " + strip_period(error.what());
      }
    why = std::string("rotations: ") + (linear_suffices ? "linear" : "large") +
          ", taken by Rotations = auto: " + why;
    out << why << std::endl;
    (linear_suffices ? large : linear).reset();
    chosen().add_endnote("run.rotations-chosen: the kinematics, linear or with "
                         "large rotations, were chosen automatically; " +
                         why);
  }



  void
  LinearTrial::build_large(const Scene     &scene,
                           const SceneText &text,
                           std::ostream    &out)
  {
    try
      {
        large = make_simulation(with_finite_rotations(scene), text, out);
      }
    catch (const InputError &error)
      {
        if (requests_finite_rotations(scene))
          throw;
        why = "large is refused: " + strip_period(error.what()) + "; ";
      }
  }



  void
  LinearTrial::judge(const Scene &scene)
  {
    double rotation = 0., stiffening = 0., amplification = 0.;
    bool   is_buckled = false;
    for (const StepResults &step : linear->results().steps)
      {
        const NonlinearityEstimate &beyond = step.checks.beyond;
        rotation      = std::max(rotation, step.checks.max_rotation);
        stiffening    = std::max(stiffening, beyond.stiffening);
        amplification = std::max(amplification, beyond.amplification);
        is_buckled |= beyond.buckling_factor && *beyond.buckling_factor < 1.;
      }
    const bool along =
      std::any_of(scene.loads.begin(), scene.loads.end(), is_follower_load);
    const double turned   = along ? rotation : rotation * rotation,
                 left_out = std::max({stiffening, turned, amplification});
    linear_suffices =
      large == nullptr || (!is_buckled && left_out <= needs_finite_rotations &&
                           rotation <= scene.solve.rotation_limit);
    const auto per_cent = [](const double share) {
      return to_text(100. * share, 2) + " %";
    };
    why += "what the linear model leaves out is " + per_cent(stiffening) +
           " by stretching, " + per_cent(turned) + " by turning (" +
           (along ? "loads turn by " : "the square of ") +
           to_text(rotation, 2) + " rad), " +
           (is_buckled ? "and it buckles below these loads" :
                         per_cent(amplification) + " by compression") +
           "; from " + per_cent(needs_finite_rotations) + " on bodies turn";
  }



  void
  LinearTrial::write(const std::string    &directory,
                     const PostProcessing &bars) const
  {
    bars();
    write_run(*linear, directory);
    print_results(*linear, directory, linear->output());
  }
} // namespace lamella
