// SPDX-License-Identifier: LGPL-2.1-or-later

// Reads scenes that are wrong, one after another in one process, and checks how
// they are refused: the whole of what `lamella SCENE --set ...` does before it
// solves anything.
//
// Usage: bad_inputs FILE.table...
//
// A table has comments (#) and cases,
//     case NAME
//     run SCENE.prm [--set "PATH=VALUE"]...   the scene, relative to the table
//     id IDENTIFIER                           of the message, contact.no-pairs
//     says FRAGMENT                           occurs in the message: an entry,
//     a
//                                             value; repeatable
//     never FRAGMENT                          does not
//     notes IDENTIFIER                        of a note; a line for each
//     quiet FOLDER                            in the place of run
// Each ends with an InputError whose message has at most twelve lines and no
// words of the machinery; with `notes` the scene is accepted, and has so many
// notes on magnitudes and loads, no more. `quiet` takes all scenes of a folder
// that are not refused (or all templates, of the folder `new`), which have
// none. What needs the program itself (exit status, files, failures of the
// numerics, its tasks) is a case of a .bad file.

#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>
#include <lamella/material/parameters.h>
#include <lamella/run/command_line.h>
#include <lamella/run/run_scene.h>
#include <lamella/scene/scene.h>
#include <lamella/scene/scene_checks.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>

using namespace lamella;

namespace
{
  struct Case
  {
    std::string              name, scene, folder;
    std::vector<std::string> overrides, says, never, notes;
  };



  /// Splits the words of a shell's line: quotes keep blanks, --set goes.
  void
  read_run(const std::string &line, Case &found)
  {
    std::istringstream words(line);
    words >> found.scene;
    for (std::string option, value; words >> option;)
      {
        words >> std::quoted(value);
        if (option != "--set" || !words)
          throw InputError("not understood: " + line).at(found.name + ": ");
        found.overrides.push_back(value);
      }
  }



  std::vector<Case>
  read_table(const std::string &path)
  {
    std::ifstream     file(path);
    std::vector<Case> cases;
    for (std::string line; std::getline(file, line);)
      {
        const std::size_t blank = line.find(' ');
        const std::string word  = line.substr(0, blank);
        const std::string rest =
          blank == std::string::npos ? "" : line.substr(blank + 1);
        if (word.empty() || word[0] == '#')
          continue;
        if (word == "case")
          cases.push_back({rest, "", "", {}, {}, {}, {}});
        else if (cases.empty() ||
                 (word != "run" && word != "id" && word != "says" &&
                  word != "never" && word != "notes" && word != "quiet"))
          throw InputError("not understood: " + line).at(path + ": ");
        else if (word == "run")
          read_run(rest, cases.back());
        else if (word == "quiet")
          cases.back().folder = rest;
        else if (word == "notes")
          cases.back().notes.push_back(rest);
        else if (word == "id")
          cases.back().says.push_back("[" + rest + "]");
        else
          (word == "says" ? cases.back().says : cases.back().never)
            .push_back(rest);
      }
    return cases;
  }



  /// The notes of @p text that come of magnitudes, and of loads that do
  /// nothing, which takes the whole scene.
  std::vector<std::string>
  notes_on(const SceneText &text)
  {
    std::ostream             nowhere(nullptr);
    const Scene              scene = read_scene(text);
    std::vector<std::string> notes =
      magnitude_warnings(scene, build_section_meshes(scene));
    for (const auto &[name, material] : scene.materials)
      for (const std::string &doubt :
           material_warnings(name, material, scene.units))
        notes.push_back(doubt);
    const auto simulation = make_simulation(scene, text, nowhere);
    for (const std::string &note : simulation->results().notes)
      if (note.find("solve.load-on-supports") != std::string::npos)
        notes.push_back(note);
    // Each is among the notes of the run, once.
    const auto              &all = simulation->results().notes;
    std::vector<std::string> faults;
    for (const std::string &note : notes)
      if (std::count(all.begin(), all.end(), note) != 1)
        faults.push_back("not told once: " + note);
    notes.insert(notes.end(), faults.begin(), faults.end());
    return notes;
  }



  /// Whether each note of @p one is found once, and no other.
  std::vector<std::string>
  faults_of_notes(const Case &one, const std::string &folder)
  {
    const std::vector<std::string> found =
      notes_on(SceneText::read(folder + "/" + one.scene, one.overrides));
    std::vector<std::string> faults;
    for (const std::string &fragment : one.notes)
      if (std::count_if(found.begin(), found.end(), [&](const auto &note) {
            return note.find(fragment) != std::string::npos;
          }) != std::count(one.notes.begin(), one.notes.end(), fragment))
        faults.push_back("not noted so often: " + fragment);
    if (found.size() != one.notes.size())
      faults.push_back("other notes");
    for (const std::string &note : faults.empty() ? faults : found)
      faults.push_back("it noted: " + note);
    return faults;
  }



  /// The notes of all scenes in @p path and the folders of it.
  std::vector<std::string>
  faults_of_folder(const std::filesystem::path &path)
  {
    std::vector<std::string> faults;
    for (const auto &file : std::filesystem::recursive_directory_iterator(path))
      if (file.path().extension() == ".prm")
        outcome_of([&] {
          for (const std::string &note :
               notes_on(SceneText::read(file.path(), {})))
            faults.push_back(file.path().string() + ": " + note);
        });
    return faults;
  }



  /// Those of the templates, which are written into @p folder.
  std::vector<std::string>
  faults_of_templates(const std::filesystem::path &folder)
  {
    std::ostream nowhere(nullptr);
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    for (const std::string &kind : kinds_of_new_scenes())
      write_new_scene(folder / kind, kind, nowhere);
    return faults_of_folder(folder);
  }



  /// What is wrong with how the scene of @p one is refused.
  std::vector<std::string>
  faults_of(const Case &one, const std::string &folder)
  {
    if (one.folder == "new")
      return faults_of_templates("new_scenes");
    if (!one.folder.empty())
      return faults_of_folder(folder + "/" + one.folder);
    if (!one.notes.empty())
      return faults_of_notes(one, folder);
    std::ostream nowhere(nullptr);
    const auto [status, message] = outcome_of([&] {
      const SceneText text =
        SceneText::read(folder + "/" + one.scene, one.overrides);
      make_simulation(read_scene(text), text, nowhere);
    });
    std::vector<std::string> faults;
    if (status != 1)
      faults.push_back("status " + std::to_string(status));
    const auto has = [&text = message](const std::string &fragment) {
      return text.find(fragment) != std::string::npos;
    };
    for (const std::string &fragment : one.says)
      if (!has(fragment))
        faults.push_back("does not say: " + fragment);
    for (const std::string &fragment : one.never)
      if (has(fragment))
        faults.push_back("says: " + fragment);
    for (const std::string fragment :
         {"Exception", "Stack trace", "Stacktrace", "terminate called"})
      if (has(fragment))
        faults.push_back("words of the machinery: " + fragment);
    if (std::count(message.begin(), message.end(), '\n') > 11)
      faults.push_back("more than twelve lines");
    if (one.says.empty())
      faults.push_back("nothing that it has to say");
    if (!faults.empty())
      faults.push_back("it said: " + message);
    return faults;
  }
} // namespace



int
main(int argc, char **argv)
{
  unsigned int n_cases = 0, n_wrong = 0;
  const auto   all = [&] {
    const MpiSession mpi(argc, argv);
    for (int k = 1; k < argc; ++k)
      {
        const std::string folder =
          std::filesystem::absolute(argv[k]).parent_path();
        for (const Case &one : read_table(argv[k]))
          {
            const auto faults = faults_of(one, folder);
            ++n_cases;
            n_wrong += !faults.empty();
            for (const std::string &fault : faults)
              std::cout << one.name << ": " << fault << "\n";
          }
      }
  };
  const auto [status, message] = outcome_of(all);
  std::cout << n_cases << " scenes, " << n_wrong
            << " not refused or noted as they should" << std::endl;
  if (status != 0)
    std::cerr << message << std::endl;
  return status != 0 || n_wrong > 0 || n_cases == 0 ? 1 : 0;
}
