// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_child_process_h
#define lamella_base_child_process_h

#include <functional>
#include <string>
#include <vector>

namespace lamella
{
  /// End of a child process. Success: status 0 and signal 0.
  struct ProcessEnd
  {
    /// Exit status; -1 if a signal ended the process.
    int status = 0;
    /// The signal, or 0.
    int signal = 0;
    /// True if the limit of processor time was reached; the signal is SIGXCPU.
    bool time_limit_reached = false;
    /// Wall seconds from start to end; the limit counts processor seconds.
    double seconds = 0.;
    /// Result of the work of run_forked(); empty if the work failed.
    std::string result;
  };

  /**
   * Runs @p program, a path that no shell interprets, with the arguments
   * @p words and waits for its end. The program is killed with this process and
   * gets neither standard input nor MPI's environment variables. It overwrites
   * the files @p output and @p errors; if empty, its output goes where this
   * process prints. It is killed one second after @p processor_seconds of all
   * threads together, in whole seconds (0: no limit). Throws InputError if it
   * cannot be started.
   */
  ProcessEnd
  run_process(const std::string              &program,
              const std::vector<std::string> &words,
              const std::string              &output,
              const std::string              &errors,
              const double                    processor_seconds = 0.);

  /**
   * Runs @p work in a copy of this process and waits for its end. Files, time
   * limit and lifetime are as in run_process(); exit status and error message
   * are those of outcome_of(). Loaded libraries are reused, which saves a third
   * of a second. MPI must not have been started here; @p work starts its own.
   *
   * ProcessEnd::result contains the result of @p work. The copy ends by
   * _exit(), without destructors of this process's objects. Throws InputError
   * if no process can be created. This process no longer ignores SIGCHLD
   * afterwards.
   */
  ProcessEnd
  run_forked(const std::function<std::string()> &work,
             const std::string                  &output,
             const std::string                  &errors,
             const double                        processor_seconds = 0.);

  /// Replaces this process by @p program, a path that no shell interprets, with
  /// the arguments @p words. MPI must not have been started here. Throws
  /// InputError if the program cannot be started.
  [[noreturn]] void
  exec_program(const std::string              &program,
               const std::vector<std::string> &words);

  /// Returns the path of a python3 with the module @p module; empty if there is
  /// none. The system's is tried before the first in PATH.
  std::string
  python_with(const std::string &module);

  /// Returns the path of Lamella's script @p name, installed or in the source
  /// tree. Throws InputError if there is none.
  std::string
  path_of_script(const std::string &name);

  /// Returns the absolute path of the program that this process runs.
  std::string
  executable_path();
} // namespace lamella

#endif
