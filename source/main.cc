// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/memory.h>
#include <lamella/base/processes.h>
#include <lamella/base/version.h>
#include <lamella/estimate/comparison.h>
#include <lamella/estimate/tolerance_run.h>
#include <lamella/export/calculix_deck.h>
#include <lamella/report/results_folder.h>
#include <lamella/run/command_line.h>
#include <lamella/run/run_scene.h>
#include <lamella/scene/scene.h>
#include <lamella/trade/trade.h>

#include <chrono>
#include <fstream>
#include <iostream>
#include <iterator>
#include <thread>

namespace
{
  using namespace lamella;

  /// Where messages go: nowhere, but for the process that speaks for all.
  std::ostream &
  output()
  {
    static std::ostream nowhere(nullptr);
    return is_root_process() ? std::cout : nowhere;
  }



  void
  run_to_tolerance(const CommandLine &command,
                   const Scene       &scene,
                   std::ostream      &out)
  {
    if (command.resume)
      throw InputError(
        "run.resume-to-tolerance: a run with a Tolerance (subsection Goals) "
        "cannot be resumed. Run it without --resume.");
    if (!ToleranceRun(scene, out).run(command.output))
      throw ToleranceNotMet(
        "estimate.tolerance-not-met: the Tolerance of a quantity in subsection "
        "Goals is not met. The results in " +
        command.output +
        " are those of the last refinement pass, with error estimates.");
  }



  /// What makes the error bars of @p simulation.
  PostProcessing
  make_error_bars(Simulation &simulation)
  {
    return [&simulation] {
      ModelCache cache;
      GoalBars   bars = error_bars_of(simulation, simulation.output(), cache);
      simulation.set_goals(std::move(bars.goals), bars.missing_reason);
    };
  }



  /// Runs @p scene with linear rotations if these suffice, else large ones.
  void
  run_automatic_rotations(const CommandLine &command,
                          const SceneText   &text,
                          const Scene       &scene,
                          std::ostream      &out)
  {
    const LinearTrial trial(scene, text, out);
    if (!trial.is_linear_sufficient())
      run_scene(trial.chosen(),
                command.output,
                command.resume,
                make_error_bars(trial.chosen()));
    else if (!command.resume)
      trial.write(command.output, make_error_bars(trial.chosen()));
    else
      throw InputError(
        "run.resume-of-linear-trial: there is nothing to resume: the linear "
        "run, which Rotations = auto chooses for this scene, writes its "
        "results at its end only. Run without --resume.");
  }



  /// Solves @p scene or, with --validate, only builds it.
  void
  solve(const CommandLine &command, const SceneText &text, const Scene &scene)
  {
    std::ostream &out = output();
    if (is_root_process() && !command.validate)
      set_interruption_message("interrupted before anything was solved. " +
                               command.output + " is as it was.");
    if (!scene.goals.tolerances.empty() && !command.validate)
      return run_to_tolerance(command, scene, out);
    if (scene.solve.rotations == Rotations::automatic && !command.validate)
      return run_automatic_rotations(command, text, scene, out);
    // What a run to a tolerance would begin with, and why.
    std::vector<std::string> why;
    const auto               simulation =
      make_simulation(command.validate ? initial_model(scene, &why) : scene,
                      text,
                      out);
    for (const std::string &one : why)
      out << one << ".\n";
    if (command.validate)
      {
        print_validation(*simulation,
                         command.output_is_given ? command.output : "");
        if (scene.solve.rotations == Rotations::automatic)
          out << "Rotations = auto: a linear run decides." << std::endl;
      }
    else
      run_scene(*simulation,
                command.output,
                command.resume,
                make_error_bars(*simulation));
  }



  /// What @p command asks of @p scene.
  void
  run(const CommandLine &command, const SceneText &text, const Scene &scene)
  {
    if (command.task == CommandLine::Task::trade)
      run_trade(command, scene);
    if (command.task == CommandLine::Task::export_calculix)
      {
        export_calculix(scene,
                        {command.output,
                         command.element,
                         command.contact_stiffness},
                        output());
        return;
      }
    if (command.print_parameters)
      {
        output() << scene.resolved;
        return;
      }
    solve(command, text, scene);
  }



  /// Returns a line per message: identifier, kind and text, with tabs between.
  std::string
  diagnostics()
  {
    std::ifstream file(path_of_script("messages.txt"));
    return {std::istreambuf_iterator<char>(file), {}};
  }



  void
  run(const CommandLine &command)
  {
    if (command.help || command.version || command.list_diagnostics)
      {
        output() << (command.help    ? usage() :
                     command.version ? full_version() :
                                       diagnostics());
        return;
      }
    if (command.task != CommandLine::Task::run && n_processes() > 1)
      throw InputError("run.task-in-parallel: trade, export, report and new "
                       "work on one process. Start lamella without mpirun.");
    if (command.task == CommandLine::Task::report)
      make_page(command.scene, command.output);
    if (command.task == CommandLine::Task::new_scene)
      return write_new_scene(command.scene, command.kind, output());
    if (command.scene.empty())
      {
        output() << parameter_documentation();
        return;
      }

    limit_threads(command.threads);
    const SceneText text  = SceneText::read(command.scene, command.overrides);
    const Scene     scene = read_scene(text);
    try
      {
        run(command, text, scene);
      }
    catch (const InputError &error)
      {
        // This message has precedence over the end of another process.
        set_interruption_message("");
        throw text.placed(error);
      }
    catch (const NumericsError &)
      {
        set_interruption_message("");
        throw;
      }
  }



  /// Whether all processes arrive here within seconds, by an own communicator.
  bool
  all_processes_arrive(MPI_Comm arrivals)
  {
    constexpr std::chrono::seconds patience(10);
    MPI_Request                    request;
    MPI_Ibarrier(arrivals, &request);
    int        arrived = 0;
    const auto start   = std::chrono::steady_clock::now();
    do
      {
        MPI_Test(&request, &arrived, MPI_STATUS_IGNORE);
        if (arrived == 0)
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    while (arrived == 0 && std::chrono::steady_clock::now() - start < patience);
    return arrived != 0;
  }



  /// Ends all processes if this one alone has met the fault.
  void
  report_failure(const int          status,
                 const std::string &message,
                 MPI_Comm           arrivals)
  {
    // Usually all processes throw the same error and one prints it. An error of
    // one process (a full disk) is unknown to the others, which wait for it.
    const bool common = n_processes() == 1 || all_processes_arrive(arrivals);
    if (!common || is_root_process())
      std::cerr << "lamella: " << message << std::endl;
    if (!common)
      MPI_Abort(communicator(), status);
  }
} // namespace



int
main(int argc, char **argv)
{
  if (const auto [status, message] = outcome_of(require_address_space);
      status != 0)
    {
      std::cerr << "lamella: " << message << std::endl;
      // What libraries do at the end of a process may want memory, too.
      std::_Exit(status);
    }
  const auto all = [&] { run(CommandLine::parse({argv + 1, argv + argc})); };
  const std::string task = argc > 1 ? argv[1] : "";
  if ((task == "trade" || task == "report" || task == "new") &&
      n_launched_processes() == 1)
    {
      // Variants start MPI in their own processes; the other tasks need none.
      ignore_write_signals();
      const auto [status, message] = outcome_of(all);
      if (status != 0)
        std::cerr << "lamella: " << message << std::endl;
      return status;
    }

  MpiSession mpi(argc, argv);
  MPI_Comm   arrivals;
  MPI_Comm_dup(communicator(), &arrivals);

  const auto [status, message] = outcome_of(all);
  if (status != 0)
    report_failure(status, message, arrivals);
  MPI_Comm_free(&arrivals);
  return status;
}
