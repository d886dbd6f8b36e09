// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_child_process_h
#define lamella_base_child_process_h

#include <functional>
#include <string>
#include <vector>

namespace lamella
{
  /// Exit status and result of a child process that has ended. It succeeded if
  /// its exit status and its signal are both 0.
  struct ProcessEnd
  {
    /// Exit status; -1 if a signal ended the process.
    int status = 0;
    /// Number of the signal that ended the process; 0 if there was none.
    int signal = 0;
    /// True if the limit of processor time was reached; the signal is SIGXCPU.
    bool time_limit_reached = false;
    /// Elapsed (wall-clock) time of the process in seconds.
    double seconds = 0.;
    /// Return value of the function run by run_forked(), if it succeeded.
    std::string result;
  };

  /// Runs the executable at the path @p program, without a shell, with the
  /// arguments @p words, and waits for its end. The child process is killed if
  /// this process ends. It has neither standard input nor environment variables
  /// of MPI. Its standard output and standard error overwrite the files @p
  /// output and @p errors; with empty names, they are those of this process.
  /// The child is killed one second after its threads have used @p
  /// processor_seconds (0: no limit). Throws InputError if the start fails.
  ProcessEnd
  run_process(const std::string              &program,
              const std::vector<std::string> &words,
              const std::string              &output,
              const std::string              &errors,
              const double                    processor_seconds = 0.);

  /// Runs @p work in a child process created by fork() and waits for its end.
  /// Output files, time limit and lifetime are as for run_process(); exit
  /// status and error message are those of outcome_of(), ProcessEnd::result is
  /// the return value of @p work. Starts 0.3 s faster, since libraries are
  /// loaded. MPI must not have been started before; @p work starts MPI in the
  /// child. The child ends by _exit() without calling destructors. Throws
  /// InputError if fork() fails. Resets the handling of SIGCHLD to the default.
  ProcessEnd
  run_forked(const std::function<std::string()> &work,
             const std::string                  &output,
             const std::string                  &errors,
             const double                        processor_seconds = 0.);

  /// Replaces this process by the executable at the path @p program, without a
  /// shell, with the arguments @p words. MPI must not have been started before.
  /// Throws InputError if the program cannot be started.
  [[noreturn]] void
  exec_program(const std::string              &program,
               const std::vector<std::string> &words);

  /// Returns the path of a python3 that can import @p module: /usr/bin/python3
  /// or the first python3 in PATH. Returns an empty path if there is none.
  std::string
  python_with(const std::string &module);

  /// Returns the path of Lamella's script @p name in the installation or the
  /// source tree. Throws InputError if it is in neither.
  std::string
  path_of_script(const std::string &name);

  /// Returns the absolute path of the program that this process runs.
  std::string
  executable_path();
} // namespace lamella

#endif
