// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/run/command_line.h>
#include <lamella/run/simulation.h>
#include <lamella/scene/scene.h>

#include <deal.II/base/mpi.h>

#include <dlfcn.h>

#include <cstdlib>
#include <iostream>
#include <memory>

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



  /// A process that no launcher started talks to nobody: Open MPI then need not
  /// look for networks, which takes longer than a small scene.
  void
  skip_network_search()
  {
    for (const char *launched :
         {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK", "SLURM_PROCID"})
      if (std::getenv(launched) != nullptr)
        return;
    setenv("OMPI_MCA_btl", "self", 0);
    setenv("OMPI_MCA_pml", "ob1", 0);
  }



  /// Faults that show when bodies are built get the line of the text, too.
  std::unique_ptr<Simulation>
  build(const Scene &scene, const SceneText &text)
  {
    try
      {
        return std::make_unique<Simulation>(scene, std::cout);
      }
    catch (const InputError &error)
      {
        throw InputError(text.place_of(error.what()) + error.what());
      }
  }



  void
  run(const CommandLine &command)
  {
    if (command.help || command.version)
      {
        std::cout << (command.help ? usage() : "lamella " LAMELLA_VERSION "\n");
        return;
      }
    if (command.scene.empty())
      {
        std::cout << parameter_documentation();
        return;
      }

    limit_threads(command.threads);
    const SceneText text  = SceneText::read(command.scene, command.overrides);
    const Scene     scene = read_scene(text);
    if (command.print_parameters)
      {
        std::cout << scene.resolved;
        return;
      }
    const auto simulation = build(scene, text);
    if (command.validate)
      simulation->print_validation();
    else
      simulation->run(command.output);
  }
} // namespace



int
main(int argc, char **argv)
{
  try
    {
      skip_network_search();
      dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
      if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
        throw InputError("this version runs on one process; start it without "
                         "mpirun.");
      run(CommandLine::parse({argv + 1, argv + argc}));
    }
  catch (const InputError &error)
    {
      std::cerr << "lamella: " << error.what() << std::endl;
      return 1;
    }
  catch (const NumericsError &error)
    {
      std::cerr << "lamella: " << error.what() << std::endl;
      return 2;
    }
  catch (const std::bad_alloc &)
    {
      std::cerr << "lamella: the scene does not fit in memory. Use a coarser "
                   "mesh or a lower order."
                << std::endl;
      return 2;
    }
  catch (const std::exception &error)
    {
      std::cerr << "lamella: internal error, please report it:\n"
                << error.what() << std::endl;
      return 2;
    }
  return 0;
}
