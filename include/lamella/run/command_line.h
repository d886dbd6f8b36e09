// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_command_line_h
#define lamella_run_command_line_h

#include <lamella/base/names.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Options of the command line as entered; no file has been read.
  struct CommandLine
  {
    enum class Task
    {
      run,             ///< solves the scene (Simulation)
      trade,           ///< compares theories and meshes for the scene (Trade)
      export_calculix, ///< writes a CalculiX input file; needs --calculix
      report,          ///< HTML page with the results of a run (make_page)
      new_scene        ///< writes a template scene file (write_new_scene)
    };
    Task task = Task::run;
    /// Scene file; for a report the results folder, for a new scene its name.
    /// Empty only with --help, --version and --print-parameters.
    std::string scene;
    /// Path of the output folder, CalculiX input file or HTML page, or default.
    std::string output;
    /// True if `output` was given: --validate then writes sections there.
    bool output_is_given = false;
    /// Options for CalculiX; empty if not given.
    std::string element, contact_stiffness;
    /// Template of a new scene.
    std::string kind;
    /// Overrides PATH=VALUE of --set, in order.
    std::vector<std::string> overrides;
    /// Number of threads of this process, 1 to 1024.
    unsigned int threads = 1;
    /// True to resume the run in `output`.
    bool resume = false;
    /// True to build the scene and print a summary, without solving.
    bool validate = false;
    /// True to print all entries; with a scene, their resolved values.
    bool print_parameters = false;
    /// True to print the version, or help, and exit.
    bool version = false;
    bool help    = false;

    /// Parses the arguments @p words without the name of the program. Throws
    /// InputError for unknown, missing and contradictory options.
    static CommandLine
    parse(const std::vector<std::string> &words);
  };

  /// Word before the scene for each task; none for a run.
  template <>
  struct Names<CommandLine::Task>
  {
    static constexpr NameOf<CommandLine::Task> all[] = {
      {CommandLine::Task::trade, "trade"},
      {CommandLine::Task::export_calculix, "export"},
      {CommandLine::Task::report, "report"},
      {CommandLine::Task::new_scene, "new"}};
  };

  /// Returns the text of --help with the exit status (0, 1 input, 2 solution).
  std::string
  usage();
} // namespace lamella

#endif
