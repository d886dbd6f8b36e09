// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_command_line_h
#define lamella_run_command_line_h

#include <lamella/base/names.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace lamella
{
  /// Options of the command line as entered; no file has been read.
  struct CommandLine
  {
    /// Command before the scene; without a command, the scene is solved.
    enum class Task
    {
      run,   ///< solves the scene (Simulation)
      trade, ///< compares theories and meshes for the scene (run_trade)
      export_calculix, ///< writes a CalculiX input file; needs --calculix
      report,          ///< HTML page with the results of a run (make_page)
      new_scene        ///< writes a template scene file (write_new_scene)
    };
    Task task = Task::run; ///< Command to execute.
    /// Scene file; for `report` the folder with results, for `new` the name of
    /// the scene. Empty only with options that need none.
    std::string scene;
    /// Path of the output folder, CalculiX input file or HTML page (--output).
    std::string output;
    /// True if --output was given; --validate then writes sections there.
    bool        output_is_given = false;
    std::string element, ///< Element type for CalculiX; empty if not given.
      contact_stiffness; ///< Penalty [force / length^3] for it, or empty.
    /// Name of the template for a new scene (--kind).
    std::string kind;
    /// Arguments PATH=VALUE of the options --set, in order.
    std::vector<std::string> overrides;
    /// Number of threads of this process, 1 to 1024.
    unsigned int threads = 1;
    /// Number of variants of a trade that run at the same time, 1 to 1024.
    unsigned int jobs = 1;
    /// True to continue the interrupted run whose results are in `output`.
    bool resume = false;
    /// True to build the scene and print a summary, without solving.
    bool validate = false;
    /// True to print all entries: their defaults, or the values in a scene.
    bool print_parameters = false;
    /// True to print identifier, kind and text of all messages.
    bool list_diagnostics = false;
    bool version          = false; ///< True to print the version and exit.
    bool help             = false; ///< True to print the help text and exit.

    /// Parses the arguments @p words without the name of the program. Throws
    /// InputError for unknown, missing and contradictory options.
    static CommandLine
    parse(const std::vector<std::string> &words);
  };

  /// Words of the command line that select a task; a run has no such word.
  template <>
  struct Names<CommandLine::Task>
  {
    /// Task and its word on the command line.
    static constexpr NameOf<CommandLine::Task> all[] = {
      {CommandLine::Task::trade, "trade"},
      {CommandLine::Task::export_calculix, "export"},
      {CommandLine::Task::report, "report"},
      {CommandLine::Task::new_scene, "new"}};
  };

  /// Returns the text that --help prints, with the meaning of exit statuses.
  std::string
  usage();

  /// Returns the names of the templates for new scenes, the default first.
  std::vector<std::string>
  kinds_of_new_scenes();

  /// Writes the template @p kind to the scene file NAME.prm, where @p name is
  /// NAME or FOLDER/NAME. Prints how to run it to @p out. Throws InputError for
  /// an unknown template, and if the file exists or cannot be written.
  void
  write_new_scene(const std::string &name,
                  const std::string &kind,
                  std::ostream      &out);
} // namespace lamella

#endif
