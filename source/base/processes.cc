// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/processes.h>

#include <deal.II/base/multithread_info.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <dlfcn.h>

namespace lamella
{
  namespace
  {
    bool
    was_launched()
    {
      for (const char *variable :
           {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK", "SLURM_PROCID"})
        if (std::getenv(variable) != nullptr)
          return true;
      return false;
    }



    /// Before MPI starts, which reads its settings once; returns its argument.
    int &
    configure_single_process(int &argc)
    {
      if (!was_launched())
        for (const auto &[setting, value] :
             {std::make_pair("OMPI_MCA_ess_singleton_isolated", "1"),
              std::make_pair("OMPI_MCA_orte_create_session_dirs", "0"),
              std::make_pair("OMPI_MCA_btl", "self"),
              std::make_pair("OMPI_MCA_pml", "ob1")})
          setenv(setting, value, 0);
      return argc;
    }
  } // namespace



  MpiSession::MpiSession(int &argc, char **&argv)
    : session(configure_single_process(argc), argv, 1)
  {
    // After what MPI brings with it, which has handlers of its own.
    ignore_write_signals();
  }



  void
  ignore_write_signals()
  {
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
  }



  unsigned int
  n_launched_processes()
  {
    for (const char *variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
      if (const char *n = std::getenv(variable))
        return std::max(1, std::atoi(n));
    return 1;
  }



  void
  limit_threads(const unsigned int n)
  {
    dealii::MultithreadInfo::set_thread_limit(n);
    using SetThreads = void (*)(int);
    if (const auto set_threads = reinterpret_cast<SetThreads>(
          dlsym(RTLD_DEFAULT, "openblas_set_num_threads")))
      set_threads(n);
  }
} // namespace lamella
