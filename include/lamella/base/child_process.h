// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_child_process_h
#define lamella_base_child_process_h

#include <functional>
#include <string>
#include <vector>

namespace lamella
{
  /// Exit status and result of a child process, which succeeded if both its
  /// exit status and its signal are 0.
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
    /// Return value of the function that run_forked() ran; empty if it failed.
    std::string result;
  };

  /// Runs the executable at the path @p program, without a shell, with the
  /// arguments @p words and waits for its end. The child process ends with this
  /// process, and gets neither standard input nor MPI's environment variables.
  /// The child's output and error output overwrite the files @p output and @p
  /// errors; with empty names, the child prints to the streams of this process.
  /// The child is killed one second after its threads have used @p
  /// processor_seconds in total (whole seconds; 0: no limit). Throws InputError
  /// if the program cannot be started.
  ProcessEnd
  run_process(const std::string              &program,
              const std::vector<std::string> &words,
              const std::string              &output,
              const std::string              &errors,
              const double                    processor_seconds = 0.);

  /// Runs @p work in a child process created by fork() and waits for its end.
  /// Output files, time limit and lifetime are as in run_process(); exit status
  /// and error message are those of outcome_of(). The child reuses the loaded
  /// libraries, which saves 0.3 s. MPI must not have been started in this
  /// process; @p work starts MPI in the child.
  ///
  /// ProcessEnd::result is the return value of @p work. The child ends by
  /// _exit() without calling destructors. Throws InputError if fork() fails.
  /// Sets the handling of SIGCHLD to the default.
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

  /// Returns the path of a python3 that can import @p module; empty if none is
  /// found. The system's python3 is tried first, then the first in PATH.
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
