// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_command_line_h
#define lamella_run_command_line_h

#include <string>
#include <vector>

namespace lamella
{
  /// What the user asks for.
  struct CommandLine
  {
    enum class Task
    {
      run,
      /// `lamella trade SCENE`
      trade,
      /// `lamella export --calculix SCENE`
      export_calculix
    };
    Task        task = Task::run;
    std::string scene;
    /// As given, or the default of the task.
    std::string output;
    /// Of CalculiX; empty if not given.
    std::string              element, contact_stiffness;
    std::vector<std::string> overrides;
    unsigned int             threads = 1;
    /// Go on with the run in `output`.
    bool resume           = false;
    bool validate         = false;
    bool print_parameters = false;
    bool version          = false;
    bool help             = false;

    /// Throws InputError for words that it does not know.
    static CommandLine
    parse(const std::vector<std::string> &words);
  };

  /// The text of --help.
  std::string
  usage();
} // namespace lamella

#endif
