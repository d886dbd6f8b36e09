// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/child_process.h>
#include <lamella/base/exceptions.h>

#include <boost/dll/runtime_symbol_info.hpp>
#include <boost/process.hpp>
#include <boost/process/extend.hpp>

#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <csignal>
#ifdef __linux__
#  include <sys/prctl.h>
#endif

namespace lamella
{
  namespace
  {
    /// The environment without what an MPI that has started leaves in it: a
    /// child would take itself for one of its processes.
    boost::process::environment
    environment_without_mpi()
    {
      boost::process::environment all = boost::this_process::environment(),
                                  result;
      for (const auto &variable : all)
        {
          const std::string name = variable.get_name();
          bool              mpi  = false;
          for (const char *prefix : {"PMIX_", "ORTE_", "OMPI_"})
            mpi = mpi || name.compare(0, 5, prefix) == 0;
          if (!mpi || name.compare(0, 10, "OMPI_ALLOW") == 0)
            result[name] = variable.to_string();
        }
      return result;
    }



    /// What is set in the child before it becomes the program.
    void
    limit_child(const double processor_seconds)
    {
#ifdef __linux__
      prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
      if (processor_seconds > 0.)
        {
          const auto seconds =
            static_cast<rlim_t>(std::ceil(processor_seconds));
          const rlimit limit{seconds, seconds + 1};
          setrlimit(RLIMIT_CPU, &limit);
        }
    }
  } // namespace



  ProcessEnd
  run_process(const std::string              &program,
              const std::vector<std::string> &words,
              const std::string              &output,
              const std::string              &errors,
              const double                    processor_seconds)
  {
    namespace bp = boost::process;
    using Clock  = std::chrono::steady_clock;
    ProcessEnd end;
    const auto begin = Clock::now();
    try
      {
        bp::child child(
          program,
          bp::args(words),
          environment_without_mpi(),
          bp::std_in<bp::null, bp::std_out> output,
          bp::std_err > errors,
          bp::extend::on_exec_setup = [&](auto &) {
            limit_child(processor_seconds);
          });
        child.wait();
        const int native = child.native_exit_code();
        if (WIFSIGNALED(native))
          {
            end.status      = -1;
            end.signal      = WTERMSIG(native);
            end.out_of_time = end.signal == SIGXCPU;
          }
        else
          end.status = WEXITSTATUS(native);
      }
    catch (const bp::process_error &error)
      {
        throw InputError("cannot run " + program + ": " + error.what());
      }
    end.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    return end;
  }



  std::string
  own_program()
  {
    return boost::dll::program_location().string();
  }
} // namespace lamella
