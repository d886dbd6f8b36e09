// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_command_line_h
#define lamella_run_command_line_h

#include <lamella/base/names.h>

#include <string>
#include <vector>

namespace lamella
{
  /// What the user asks for, word for word: nothing is looked up in files yet.
  struct CommandLine
  {
    enum class Task
    {
      run,             ///< solves the scene (Simulation)
      trade,           ///< a ladder of theories and meshes on it (Trade)
      export_calculix, ///< needs --calculix, the one format that there is
      report,          ///< a page of what a run has left (make_page)
      new_scene        ///< a commented scene to begin with (write_new_scene)
    };
    Task task = Task::run;
    /// The scene's file, of a report the folder of results, of a new scene its
    /// name; may be empty with
    /// --help, --version and --print-parameters only.
    std::string scene;
    /// As given, or the default of the task: a folder, of an export the deck,
    /// of a report the page.
    std::string output;
    /// Whether it is as given: then --validate leaves its sections there.
    bool output_is_given = false;
    /// Of CalculiX; empty if not given.
    std::string element, contact_stiffness;
    /// Of a new scene: which template.
    std::string kind;
    /// PATH=VALUE each, of --set, in their order.
    std::vector<std::string> overrides;
    /// Of this process, 1 to 1024.
    unsigned int threads = 1;
    /// Go on with the run in `output`.
    bool resume = false;
    /// Build the scene and print what it amounts to, without solving.
    bool validate = false;
    /// Print all entries; with a scene as they are resolved.
    bool print_parameters = false;
    /// Print these and do nothing else.
    bool version = false;
    bool help    = false;

    /// The words behind the program's name. Throws InputError for words that it
    /// does not know, for an option without its value, for options that belong
    /// to another task or contradict each other, and for no scene where one is
    /// needed.
    static CommandLine
    parse(const std::vector<std::string> &words);
  };

  /// The word before the scene; none for a run.
  template <>
  struct Names<CommandLine::Task>
  {
    static constexpr NameOf<CommandLine::Task> all[] = {
      {CommandLine::Task::trade, "trade"},
      {CommandLine::Task::export_calculix, "export"},
      {CommandLine::Task::report, "report"},
      {CommandLine::Task::new_scene, "new"}};
  };

  /// The text of --help, with what the exit status means: 0 done, 1 a fault of
  /// the input (InputError), 2 a failure of the numerics (NumericsError).
  std::string
  usage();
} // namespace lamella

#endif
