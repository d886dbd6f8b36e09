// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/child_process.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/mpi_session.h>
#include <lamella/base/processes.h>
#include <lamella/run/calculix_deck.h>
#include <lamella/run/command_line.h>
#include <lamella/run/simulation.h>
#include <lamella/run/trade.h>
#include <lamella/scene/scene.h>

#include <dlfcn.h>

#include <chrono>
#include <csignal>
#include <iostream>
#include <memory>
#include <thread>

namespace
{
  using namespace lamella;

  /// One thread unless told otherwise; the BLAS starts with one a core.
  void
  limit_threads(const unsigned int n)
  {
    dealii::MultithreadInfo::set_thread_limit(n);
    using SetThreads = void (*)(int);
    if (const auto set_threads = reinterpret_cast<SetThreads>(
          dlsym(RTLD_DEFAULT, "openblas_set_num_threads")))
      set_threads(n);
  }



  /// Where messages go: nowhere, but for the process that speaks for all.
  std::ostream &
  output()
  {
    static std::ostream nowhere(nullptr);
    return is_speaker() ? std::cout : nowhere;
  }



  /// Faults that show when bodies are built get the line of the text, too.
  std::unique_ptr<Simulation>
  build(const Scene &scene, const SceneText &text)
  {
    try
      {
        return std::make_unique<Simulation>(scene, output());
      }
    catch (const InputError &error)
      {
        const std::string message = text.abbreviated(error.what());
        throw InputError(text.place_of(message) + message);
      }
  }



  void
  write_deck(const Scene       &scene,
             const SceneText   &text,
             const CommandLine &command)
  {
    try
      {
        export_calculix(scene, command, output());
      }
    catch (const InputError &error)
      {
        const std::string message = text.abbreviated(error.what());
        throw InputError(
          (message.compare(0, 2, "--") == 0 ? "" : text.place_of(message)) +
          message);
      }
  }



  void
  run(const CommandLine &command)
  {
    if (command.help || command.version)
      {
        output() << (command.help ? usage() : "lamella " LAMELLA_VERSION "\n");
        return;
      }
    if (command.scene.empty())
      {
        output() << parameter_documentation();
        return;
      }

    limit_threads(command.threads);
    const SceneText text  = SceneText::read(command.scene, command.overrides);
    const Scene     scene = read_scene(text);
    if (command.task != CommandLine::Task::run && n_processes() > 1)
      throw InputError("trade and export are the work of one process: start "
                       "lamella without mpirun.");
    if (command.task == CommandLine::Task::trade)
      return Trade(command.scene,
                   command.overrides,
                   scene,
                   own_program(),
                   command.threads,
                   output())
        .run(command.output);
    if (command.task == CommandLine::Task::export_calculix)
      {
        write_deck(scene, text, command);
        return;
      }
    if (command.print_parameters)
      {
        output() << scene.resolved;
        return;
      }
    const auto simulation = build(scene, text);
    if (command.validate)
      simulation->print_validation();
    else
      simulation->run(command.output, command.resume);
  }



  /// Whether all processes come here, too, within some seconds, through a
  /// communicator that nothing else uses.
  bool
  all_arrive(MPI_Comm arrivals)
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
} // namespace



int
main(int argc, char **argv)
{
  MpiSession mpi(argc, argv);
  // After what MPI brings with it, which has handlers of its own. A file that
  // has reached its limit, or a reader of the output that is gone
  // (`| head -1`), is an error of that writing and not the end of the run.
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  MPI_Comm arrivals;
  MPI_Comm_dup(communicator(), &arrivals);

  const auto [status, message] = outcome_of([&] {
    run(CommandLine::parse({argv + 1, argv + argc}));
  });
  if (status != 0)
    {
      // As a rule all processes meet the same fault and one of them tells it.
      // What only this one has met (a full disk, say) the others do not know,
      // and they wait for it.
      const bool common = n_processes() == 1 || all_arrive(arrivals);
      if (!common || is_speaker())
        std::cerr << "lamella: " << message << std::endl;
      if (!common)
        MPI_Abort(communicator(), status);
    }
  MPI_Comm_free(&arrivals);
  return status;
}
