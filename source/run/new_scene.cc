// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/output_file.h>
#include <lamella/base/text.h>
#include <lamella/run/command_line.h>

#include <filesystem>
#include <ostream>
#include <utility>

namespace lamella
{
  namespace fs = std::filesystem;

  namespace
  {
    /// Kind and text, from source/run/templates.
    const std::vector<std::pair<std::string, std::string>> &
    templates()
    {
      static const std::vector<std::pair<std::string, std::string>> all{
#include LAMELLA_TEMPLATES
      };
      return all;
    }



    /// Of the template @p kind, with @p file and the name @p name in it.
    std::string
    text_of(const std::string &kind,
            const std::string &file,
            const std::string &name)
    {
      for (const auto &[known, text] : templates())
        if (known == kind)
          return replaced(replaced(text, "NAME.prm", file),
                          "results/NAME",
                          "results/" + name);
      throw InputError(
        "run.unknown-kind: there is no such template. Check the spelling: the most similar is " +
        nearest_name(kind, kinds_of_new_scenes()) + ", and the kinds are " +
        joined(kinds_of_new_scenes()) + ".")
        .at("--kind " + kind + ": ");
    }
  } // namespace



  std::vector<std::string>
  kinds_of_new_scenes()
  {
    std::vector<std::string> kinds;
    for (const auto &[kind, text] : templates())
      kinds.push_back(kind);
    return kinds;
  }



  void
  write_new_scene(const std::string &name,
                  const std::string &kind,
                  std::ostream      &out)
  {
    const bool        has_ending = fs::path(name).extension() == ".prm";
    const std::string file       = has_ending ? name : name + ".prm";
    const std::string place      = "new " + name + ": ";
    const std::string text =
      text_of(kind, file, fs::path(file).stem().string());
    std::error_code error;
    if (fs::exists(file, error))
      throw InputError(
        "run.scene-exists: " + file +
        " exists already. Choose another name, or remove the file.")
        .at(place);
    OutputFile target(file);
    target.stream() << text;
    if (!target.stream() || !target.commit())
      throw InputError(
        "run.scene-not-writable: " + file +
        " cannot be written. Choose a name in an existing, writable folder.")
        .at(place);
    out << "Scene: " << file << " (" << kind << "). It runs as it is: lamella "
        << file << std::endl;
  }
} // namespace lamella
