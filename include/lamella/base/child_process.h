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
    /// Result of the work of run_forked(); empty if it did not end, which is a
    /// failure whatever the status.
    std::string result;
  };

  /**
   * Runs @p program and waits for its end. The program is killed with this
   * process, and does not see its MPI: MPI's environment variables are removed.
   * Its standard input is empty. Throws InputError if it cannot be started.
   *
   * @param program path of the program; no shell reads it
   * @param words arguments, without the program's name
   * @param output, errors paths of files to be overwritten; if empty, output
   *   goes where this process prints
   * @param processor_seconds limit for all threads together, rounded up to
   *   whole seconds, one second after which the program is killed; 0: none
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
   * The result of @p work returns through a pipe as ProcessEnd::answer. The
   * copy ends by _exit(), without destructors of this process's objects. Throws
   * InputError if no process can be created; exceptions of @p work become the
   * copy's outcome. From now on this process waits for its children, even if it
   * was started with SIGCHLD ignored.
   */
  ProcessEnd
  run_forked(const std::function<std::string()> &work,
             const std::string                  &output,
             const std::string                  &errors,
             const double                        processor_seconds = 0.);

  /// Replaces this process by the program @p program (a path; no shell reads
  /// it) with the arguments @p words, without its own name. MPI must not have
  /// been started here. Throws InputError if it cannot be started.
  [[noreturn]] void
  exec_program(const std::string              &program,
               const std::vector<std::string> &words);

  /// Returns the path of a python3 with the module @p module; empty if there is
  /// none. The system's is tried before the first in PATH, which often lacks
  /// the distribution's packages.
  std::string
  python_with(const std::string &module);

  /// Returns the path of Lamella's script @p name, as installed or else in the
  /// source tree. Throws InputError if it is in neither.
  std::string
  path_of_script(const std::string &name);

  /// Returns the absolute path of the program that this process runs.
  std::string
  executable_path();
} // namespace lamella

#endif
