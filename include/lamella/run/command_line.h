// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_command_line_h
#define lamella_run_command_line_h

#include <lamella/base/names.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Command line as typed; no file has been read.
  struct CommandLine
  {
    enum class Task
    {
      run,             ///< solves the scene (Simulation)
      trade,           ///< a hierarchy of theories and meshes on it (Trade)
      export_calculix, ///< needs --calculix, the one format that there is
      report,          ///< a page of what a run has left (make_page)
      new_scene        ///< a commented scene to begin with (write_new_scene)
    };
    Task task = Task::run;
    /// File of the scene; for a report the folder of results, for a new scene
    /// its name. Empty with --help, --version and --print-parameters only.
    std::string scene;
    /// Output folder, deck or page, as given, or the default of the task.
    std::string output;
    /// True if `output` was given: --validate writes its sections there then.
    bool output_is_given = false;
    /// Options of CalculiX; empty if not given.
    std::string element, contact_stiffness;
    /// Template of a new scene.
    std::string kind;
    /// Overrides PATH=VALUE of --set, in their order.
    std::vector<std::string> overrides;
    /// Number of threads of this process, 1 to 1024.
    unsigned int threads = 1;
    /// Resume the run in `output`.
    bool resume = false;
    /// Build the scene and print a summary of it, without solving.
    bool validate = false;
    /// Print all entries; with a scene, their resolved values.
    bool print_parameters = false;
    /// Print version or help and exit.
    bool version = false;
    bool help    = false;

    /// Returns the parsed words after the program's name. Throws InputError for
    /// unknown words, missing values and scenes, and contradicting options.
    static CommandLine
    parse(const std::vector<std::string> &words);
  };

  /// Word before the scene; none for a run.
  template <>
  struct Names<CommandLine::Task>
  {
    static constexpr NameOf<CommandLine::Task> all[] = {
      {CommandLine::Task::trade, "trade"},
      {CommandLine::Task::export_calculix, "export"},
      {CommandLine::Task::report, "report"},
      {CommandLine::Task::new_scene, "new"}};
  };

  /// Returns the text of --help, with the exit status: 0 success, 1 wrong
  /// input, 2 failed numerics.
  std::string
  usage();
} // namespace lamella

#endif
