// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/run/command_line.h>

#include <cmath>
#include <filesystem>
#include <map>

namespace lamella
{
  std::string
  usage()
  {
    return R"(usage: lamella SCENE.prm [options]
       lamella trade SCENE.prm [options]
       lamella export --calculix SCENE.prm [options]
       lamella report DIR [--output FILE.html]
       lamella new NAME [--kind KIND]

runs the scene; or a hierarchy of theories and meshes on it, what each costs and how
far it is off; or writes it as an input deck of CalculiX; or makes one page of HTML,
to hand on, of what a run has left in DIR; or writes a commented scene, NAME.prm, that
runs as it is, to begin with.

  --output DIR          where results go (default: results/SCENE, of a trade
                        results/SCENE-trade; of an export the deck, SCENE.inp;
                        of a report the page, DIR/report.html)
  --set PATH=VALUE      override an entry, as in
                        --set "Body upper/Kinematics/Theory=LE-3"; repeatable
  --resume              go on with a run that did not come to its end, after the
                        load steps that its folder has
  --validate            check the scene and print its plies and stiffnesses; with
                        --output, write its sections there, for scripts/plot
  --print-parameters    print all entries (with a scene: as they are resolved)
  --threads N           threads (default 1)
  --jobs N              variants of a trade that run at the same time (default 1)
  --element NAME        of an exported deck: C3D20R (default), C3D8I or C3D8R
  --contact-stiffness K of an exported deck [force/length^3] (default: auto)
  --kind KIND           of a new scene: three-point (default), four-point,
                        short-beam, leaf-spring or indentation
  --list-diagnostics    print identifier, kind and text of all messages
  --version             with the commit and the libraries that it was built with
  --help

Exit status: 0 done, 1 a fault of the input, 2 a failure of the numerics, 130 ended
by Ctrl-C, which says what stands in the folder and how to go on.
)";
  }



  namespace
  {
    unsigned int
    count_of(const std::string &option, const std::string &text)
    {
      const bool   is_number = number_error(text).rule.empty();
      const double n         = is_number ? to_number(text) : 0.;
      if (!(n >= 1. && n <= 1024. && n == std::floor(n)))
        throw InputError(
          "run.threads-out-of-range: the number after " + option +
          " must be a whole number from 1 to 1024, as in " + option + " 4.");
      return static_cast<unsigned int>(n);
    }



    /// Throws InputError for options that a report does not have.
    void
    check_report(const CommandLine &command)
    {
      if (!command.overrides.empty() || command.validate ||
          command.print_parameters || command.resume)
        throw InputError(
          "run.option-not-for-report: report accepts --output only. Use --set, "
          "--validate, --print-parameters and --resume with a run.");
      if (!command.version && !command.help && command.scene.empty())
        throw InputError(
          "run.no-folder: no folder is given. Name the folder with the results "
          "of a run: lamella report DIR.");
    }



    /// Throws InputError for options that a new scene does not have.
    void
    check_new_scene(const CommandLine &command)
    {
      if (!command.overrides.empty() || command.validate ||
          command.print_parameters || command.resume || !command.output.empty())
        throw InputError(
          "run.option-not-for-new: the command new, which writes a scene, "
          "accepts --kind only. Use other options with lamella SCENE.prm.");
      if (!command.version && !command.help && command.scene.empty())
        throw InputError(
          "run.no-name: no name of a scene is given. Write lamella new NAME, "
          "which writes the scene NAME.prm.");
    }



    /// Throws InputError for options that belong to another task.
    void
    check_task(const CommandLine &command, const bool calculix)
    {
      using Task           = CommandLine::Task;
      const bool exporting = command.task == Task::export_calculix;
      if (exporting && !calculix)
        throw InputError(
          "run.export-without-format: export writes input files of CalculiX "
          "only. Write lamella export --calculix SCENE.prm.");
      if (!exporting && (calculix || !command.element.empty() ||
                         !command.contact_stiffness.empty()))
        throw InputError(
          "run.option-of-export: --calculix, --element and --contact-stiffness "
          "are for lamella export. Remove them, or write lamella export.");
      if (command.task != Task::new_scene && !command.kind.empty())
        throw InputError("run.option-of-new: the option --kind is for lamella "
                         "new only. Remove --kind, or write lamella new.");
      if (command.task == Task::report)
        return check_report(command);
      if (command.task == Task::new_scene)
        return check_new_scene(command);
      if (command.task != Task::run &&
          (command.validate || command.print_parameters || command.resume))
        throw InputError(
          "run.option-of-run: the options --validate, --print-parameters and "
          "--resume are for a run only. Remove them, or the command trade or "
          "export (lamella trade resumes without an option).");
      if (command.resume && (command.validate || command.print_parameters))
        throw InputError(
          "run.options-conflict: --resume continues a run, so --validate and "
          "--print-parameters have no use with it. Remove these two options.");
      const bool needs_scene = !command.version && !command.help &&
                               !command.print_parameters &&
                               !command.list_diagnostics;
      if (needs_scene && command.scene.empty())
        throw InputError("run.no-scene: no scene file is given. Name one, for "
                         "example: lamella my.prm\n" +
                         usage());
    }



    std::string
    default_output(const CommandLine &command)
    {
      const std::string name =
        std::filesystem::path(command.scene).stem().string();
      switch (command.task)
        {
          case CommandLine::Task::trade:
            return "results/" + name + "-trade";
          case CommandLine::Task::export_calculix:
            return name + ".inp";
          case CommandLine::Task::report:
            return command.scene + "/report.html";
          case CommandLine::Task::new_scene:
            return "";
          default:
            return "results/" + name;
        }
    }



    /// Reads words into a CommandLine: options by their names, then the scene.
    class WordReader
    {
    public:
      /// Refers to @p result.
      explicit WordReader(CommandLine &result)
        : result(result)
        , texts{{"--output", &result.output},
                {"--element", &result.element},
                {"--kind", &result.kind},
                {"--contact-stiffness", &result.contact_stiffness}}
        , counts{{"--threads", &result.threads}, {"--jobs", &result.jobs}}
        , flags{{"--calculix", &calculix},
                {"--resume", &result.resume},
                {"--validate", &result.validate},
                {"--print-parameters", &result.print_parameters},
                {"--list-diagnostics", &result.list_diagnostics},
                {"--version", &result.version},
                {"--help", &result.help}}
      {}
      WordReader(const WordReader &) = delete;

      /// @p words from number @p i on.
      void
      read(const std::vector<std::string> &words, unsigned int i)
      {
        for (; i < words.size(); ++i)
          {
            const std::string &word = words[i];
            if (flags.count(word) > 0)
              *flags.at(word) = true;
            else if (takes_value(word))
              {
                if (i + 1 == words.size())
                  throw InputError("run.value-missing: " + word +
                                   " needs a value after the option.");
                take(word, words[++i]);
              }
            else if (word.compare(0, 1, "-") == 0)
              throw InputError("run.unknown-option: there is no option " +
                               word +
                               ". Check the spelling: the most similar is " +
                               nearest_name(word, options()) + ".");
            else
              set_scene_file(word);
          }
      }

      bool
      is_calculix() const
      {
        return calculix;
      }

    private:
      bool
      takes_value(const std::string &word) const
      {
        return texts.count(word) > 0 || counts.count(word) > 0 ||
               word == "--set";
      }

      void
      take(const std::string &option, const std::string &value)
      {
        if (option == "--set")
          result.overrides.push_back(value);
        else if (counts.count(option) > 0)
          *counts.at(option) = count_of(option, value);
        else
          *texts.at(option) = value;
      }

      void
      set_scene_file(const std::string &word)
      {
        if (!result.scene.empty())
          throw InputError(
            "run.two-scenes: only one scene or folder can be given, not both "
            "'" +
            result.scene + "' and '" + word + "'.");
        result.scene = word;
      }

      std::vector<std::string>
      options() const
      {
        std::vector<std::string> names{"--set"};
        for (const auto &option : counts)
          names.push_back(option.first);
        for (const auto &option : texts)
          names.push_back(option.first);
        for (const auto &option : flags)
          names.push_back(option.first);
        return names;
      }

      CommandLine                               &result;
      bool                                       calculix = false;
      const std::map<std::string, std::string *> texts;
      /// Options with a number from 1 to 1024.
      const std::map<std::string, unsigned int *> counts;
      const std::map<std::string, bool *>         flags;
    };
  } // namespace



  CommandLine
  CommandLine::parse(const std::vector<std::string> &words)
  {
    CommandLine  result;
    unsigned int first = 0;
    if (const auto task = named<Task>(words.empty() ? "" : words[0]))
      {
        result.task = *task;
        ++first;
      }
    WordReader reader(result);
    reader.read(words, first);
    if (result.task != Task::trade && result.jobs > 1)
      throw InputError(
        "run.option-of-trade: the option --jobs is for lamella trade only. "
        "Remove --jobs, or write lamella trade.");
    check_task(result, reader.is_calculix());
    result.output_is_given = !result.output.empty();
    if (result.task == Task::new_scene && result.kind.empty())
      result.kind = kinds_of_new_scenes().front();
    if (result.output.empty())
      result.output = default_output(result);
    return result;
  }
} // namespace lamella
