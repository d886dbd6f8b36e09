// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_child_process_h
#define lamella_base_child_process_h

#include <functional>
#include <string>
#include <vector>

namespace lamella
{
  /// How a program that was started came to its end. Ended well: status 0 and
  /// signal 0.
  struct ProcessEnd
  {
    /// Its exit status; -1 if a signal ended it.
    int status = 0;
    /// The signal, or 0.
    int signal = 0;
    /// Whether it had used up its processor time. The signal is SIGXCPU then.
    bool out_of_time = false;
    /// Wall seconds from before its start to its end; the limit counts
    /// processor seconds.
    double seconds = 0.;
    /// What run_forked()'s work returned; empty if it did not come to its end.
    /// A child that ends without having answered has failed, whatever its
    /// status.
    std::string answer;
  };

  /**
   * Runs @p program with the arguments @p words and waits for its end. What it
   * prints goes into the files @p output and @p errors; after
   * @p processor_seconds (0: never) the system ends it. It does not outlive
   * this process, even one that is killed.
   *
   * The program sees nothing of this process' MPI: it starts as a process of
   * its own. Throws InputError if it cannot be started.
   *
   * @param program the path of the program; no shell reads it
   * @param words   its arguments, without its own name
   * @param output, errors paths of files to be overwritten; if empty, the
   *   program prints where this process prints
   * @param processor_seconds of all its threads together, rounded up to whole
   *   seconds; one second later it is killed
   *
   * Its standard input is empty. Variables of the environment that an MPI has
   * left here are taken out, or the child would take itself for one of its
   * processes.
   */
  ProcessEnd
  run_process(const std::string              &program,
              const std::vector<std::string> &words,
              const std::string              &output,
              const std::string              &errors,
              const double                    processor_seconds = 0.);

  /**
   * Does @p work in a copy of this process and waits for its end; its files,
   * its processor time and its life are as those of run_process(), its exit
   * status that of outcome_of(), whose message ends in @p errors. The copy has
   * all libraries loaded, which takes a third of a second otherwise. MPI must
   * not have been started here; @p work starts its own.
   *
   * What @p work returns comes back through a pipe as ProcessEnd::answer, so
   * the numbers of a rung need no file. The copy leaves by _exit(): destructors
   * of this process's objects do not run there twice. Throws InputError if the
   * system has no room for another process; what @p work throws is the copy's
   * outcome and not ours. Children of this process are waited for from now on,
   * even if whoever started it had that switched off (SIGCHLD ignored).
   */
  ProcessEnd
  run_forked(const std::function<std::string()> &work,
             const std::string                  &output,
             const std::string                  &errors,
             const double                        processor_seconds = 0.);

  /**
   * Makes this process the program @p program with the arguments @p words: its
   * output, its errors and its exit status are those of the user's command.
   * MPI must not have been started here. Throws InputError if it cannot be
   * started.
   *
   * @param program the path of the program; no shell reads it
   * @param words   its arguments, without its own name
   */
  [[noreturn]] void
  become(const std::string &program, const std::vector<std::string> &words);

  /// The path of a python3 that has the module @p module; empty if there is
  /// none. That of the system before the first one in PATH, which is often a
  /// user's own, without the packages of the distribution.
  std::string
  python_with(const std::string &module);

  /// Returns the path of Lamella's script @p name, as installed or else in the
  /// source tree. Throws InputError if it is in neither.
  std::string
  path_of_script(const std::string &name);

  /// The path of the program that this process runs. Absolute, wherever the
  /// shell found it.
  std::string
  own_program();
} // namespace lamella

#endif
