// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/child_process.h>
#include <lamella/base/exceptions.h>

#include <boost/dll/runtime_symbol_info.hpp>
#include <boost/process.hpp>
#include <boost/process/extend.hpp>

#include <sys/resource.h>
#include <unistd.h>

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
    /// child would take itself for one of its processes. (Not by
    /// boost::process::environment, whose copies read behind their end.)
    std::vector<std::string>
    environment_without_mpi()
    {
      const auto begins = [](const std::string &text, const char *prefix) {
        return text.rfind(prefix, 0) == 0;
      };
      std::vector<std::string> kept;
      for (char **variable = environ; *variable != nullptr; ++variable)
        if (begins(*variable, "OMPI_ALLOW") ||
            !(begins(*variable, "PMIX_") || begins(*variable, "ORTE_") ||
              begins(*variable, "OMPI_")))
          kept.emplace_back(*variable);
      return kept;
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

    std::vector<std::string> variables = environment_without_mpi();
    std::vector<char *>      pointers;
    for (std::string &variable : variables)
      pointers.push_back(variable.data());
    pointers.push_back(nullptr);
    try
      {
        bp::child child(
          program,
          bp::args(words),
          bp::std_in<bp::null, bp::std_out> output,
          bp::std_err > errors,
          bp::extend::on_setup =
            [&](auto &executor) { executor.env = pointers.data(); },
          bp::extend::on_exec_setup =
            [&](auto &) { limit_child(processor_seconds); });
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
