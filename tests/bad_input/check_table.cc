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
//     says FRAGMENT                           occurs in the message; repeatable
//     never FRAGMENT                          does not
// Each ends with an InputError whose message has at most twelve lines and no
// words of the machinery. What needs the program itself (exit status, files,
// failures of the numerics, its tasks) is a .bad file of its own.

#include <lamella/base/exceptions.h>
#include <lamella/base/mpi_session.h>
#include <lamella/run/run_scene.h>
#include <lamella/scene/scene.h>

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
    std::string              name, scene;
    std::vector<std::string> overrides, says, never;
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
          cases.push_back({rest, "", {}, {}, {}});
        else if (cases.empty() ||
                 (word != "run" && word != "says" && word != "never"))
          throw InputError("not understood: " + line).at(path + ": ");
        else if (word == "run")
          read_run(rest, cases.back());
        else
          (word == "says" ? cases.back().says : cases.back().never)
            .push_back(rest);
      }
    return cases;
  }



  /// What is wrong with how the scene of @p one is refused.
  std::vector<std::string>
  faults_of(const Case &one, const std::string &folder)
  {
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
            << " not refused as they should" << std::endl;
  if (status != 0)
    std::cerr << message << std::endl;
  return status != 0 || n_wrong > 0 || n_cases == 0 ? 1 : 0;
}
