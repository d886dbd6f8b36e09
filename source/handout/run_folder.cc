// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/handout/html.h>
#include <lamella/handout/run_folder.h>

#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace lamella
{
  using Json   = nlohmann::ordered_json;
  namespace fs = std::filesystem;

  namespace
  {
    std::string
    without_slash(std::string path)
    {
      while (path.size() > 1 && path.back() == '/')
        path.pop_back();
      return path;
    }



    /// Throws InputError unless @p path is a folder with the results of a run.
    std::string
    checked(const std::string &path)
    {
      std::error_code   error;
      const std::string place = "report " + path + ": ";
      if (!fs::exists(path, error))
        throw InputError("there is no such folder. Name the one that a run has "
                         "left its results in, as in results/cantilever.")
          .at(place);
      if (!fs::is_directory(path, error))
        throw InputError("that is not a folder. Name the one that a run has "
                         "left its results in: a scene is run first, by "
                         "lamella SCENE.prm.")
          .at(place);
      for (const char *name : {"summary.json", "scene.prm"})
        if (!fs::is_regular_file(path + "/" + name, error))
          throw InputError(
            "the folder holds no results of a run: there is no " +
            std::string(name) +
            " in it. A run that failed in its first load step "
            "leaves none; the rungs of a trade have theirs in "
            "rungs/NN_NAME/run.")
            .at(place);
      return path;
    }



    /// The JSON object in the file @p path.
    Json
    parsed(const std::string &path)
    {
      const Json json = Json::parse(content_of(path), nullptr, false);
      if (!json.is_object())
        throw InputError("it is not what a run writes there. The file was cut "
                         "off or changed; run the scene again.")
          .at(path + ": ");
      return json;
    }
  } // namespace



  std::string
  content_of(const std::string &path)
  {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
  }



  RunFolder::RunFolder(const std::string &given)
    : path(checked(without_slash(given)))
    , summary(parsed(path + "/summary.json"))
    , scene_text(content_of(path + "/scene.prm"))
    , scene(scene_text, path + "/scene.prm", {})
    , probes(CsvTable::read(path + "/probes.csv").last_step())
    , history(CsvTable::read(path + "/history.csv"))
    , goals(CsvTable::read(path + "/goals.csv"))
    , passes(CsvTable::read(path + "/passes.csv"))
    , plies(CsvTable::read(path + "/plies.csv"))
  {}



  CsvTable
  RunFolder::contact(const std::string &name) const
  {
    return CsvTable::read(path + "/contact_" + name + ".csv").last_step();
  }



  CsvTable
  RunFolder::section_mesh(const std::string &name) const
  {
    return CsvTable::read(path + "/sections/" + name + ".csv");
  }



  Json
  RunFolder::section_stiffness(const std::string &name) const
  {
    const std::string file = path + "/sections/" + name + ".json";
    return fs::exists(file) ? parsed(file) : Json();
  }



  std::string
  RunFolder::says(const std::string &entry) const
  {
    return scene.says(entry).value_or("");
  }



  std::vector<std::string>
  RunFolder::names(const std::string &entry) const
  {
    return split(says(entry), ',');
  }



  std::string
  RunFolder::unit(const std::string &kind) const
  {
    return summary.value("units", Json::object()).value(kind, std::string());
  }



  std::string
  RunFolder::unit_in_brackets(const std::string &kind) const
  {
    return in_brackets(unit(kind), kind);
  }



  std::string
  RunFolder::unit_behind(const std::string &kind) const
  {
    return unit(kind).empty() ? "" : "&nbsp;" + escaped(unit(kind));
  }



  std::string
  RunFolder::moment_unit_in_brackets() const
  {
    const std::string force = unit("force"), length = unit("length");
    return in_brackets(force.empty() ? "" : force + " " + length,
                       "force length");
  }



  std::string
  RunFolder::unit_of_column(const std::string &name) const
  {
    if (name == "pressure")
      return unit_in_brackets("stress");
    if (name == "width")
      return unit_in_brackets("length");
    if (name.empty() || name.size() > 3)
      return "";
    switch (name[0])
      {
        case 'u':
        case 'x':
        case 'y':
        case 'z':
          return unit_in_brackets("length");
        case 's':
          return unit_in_brackets("stress");
        case 'f':
          return unit_in_brackets("force");
        case 'm':
          return moment_unit_in_brackets();
        default:
          return "";
      }
  }



  std::string
  RunFolder::with_unit(const std::string &column) const
  {
    return trimmed(symbol(column) + " " + unit_of_column(column));
  }



  std::vector<std::string>
  RunFolder::table_files() const
  {
    std::vector<std::string> files;
    std::error_code          error;
    for (const std::string part : {"", "lines/", "cuts/", "sections/"})
      for (const auto &entry : fs::directory_iterator(path + "/" + part, error))
        if (entry.path().extension() == ".csv")
          files.push_back(part + entry.path().filename().string());
    std::sort(files.begin(), files.end());
    return files;
  }



  std::string
  RunFolder::date() const
  {
    struct stat file;
    char        text[40] = "";
    if (stat((path + "/summary.json").c_str(), &file) == 0)
      std::strftime(text,
                    sizeof(text),
                    "%Y-%m-%d %H:%M UTC",
                    std::gmtime(&file.st_mtime));
    return text;
  }



  const Json &
  member(const Json &json, const std::string &name)
  {
    static const Json nothing = Json::object();
    return json.contains(name) ? json[name] : nothing;
  }



  std::string
  number(const Json &json, const double scale, const int digits)
  {
    return json.is_number() ? number(json.dump(), scale, digits) : "–";
  }



  std::string
  components(const Json &json)
  {
    double size = 0.;
    for (const Json &component : json)
      if (component.is_number())
        size = std::max(size, std::abs(component.get<double>()));
    std::string text;
    for (const Json &component : json)
      text += (text.empty() ? "(" : ", ") + number(component, size);
    return text.empty() ? "–" : text + ")";
  }
} // namespace lamella
