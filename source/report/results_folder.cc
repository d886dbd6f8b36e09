// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>
#include <lamella/report/results_folder.h>

#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <regex>
#include <unistd.h>

namespace lamella
{
  namespace fs = std::filesystem;

  namespace
  {
    /// Files of a run, of `scripts/plot` and of `lamella report`, half done.
    bool
    is_result(const std::string &name)
    {
      static const std::regex form(
        R"re((summary\.json|restart|scene\.prm|report\.html|contact_.*\.(csv|pvd|vtu))re"
        R"re(|(probes|history|fields|goals|plies|indicators|passes|plies_along|failure|modes|response)\.csv)re"
        R"re(|(solution|mode|buckling)(_.*)?\.(pvd|vtu|pvtu)|(lines|cuts|sections)/.*\.csv)re"
        R"re(|sections/.*\.json)re"
        R"re(|pictures/.*\.png)(\.new)?)re");
      return std::regex_match(name, form);
    }



    void
    remove_earlier_results(const std::string &folder)
    {
      std::error_code error;
      // The summary first: without it nothing looks like a finished run.
      fs::remove(folder + "/summary.json", error);
      for (const std::string part :
           {"", "lines/", "cuts/", "sections/", "pictures/"})
        {
          bool removed = false;
          for (const auto &entry :
               fs::directory_iterator(folder + "/" + part, error))
            if (entry.is_regular_file(error) &&
                is_result(part + entry.path().filename().string()))
              removed = fs::remove(entry.path(), error) || removed;
          if (removed && !part.empty())
            fs::remove(folder + "/" + part, error);
        }
    }
  } // namespace



  ResultsFolder::ResultsFolder(const std::string &path)
    : folder(path)
  {
    bool writes = true, alone = true;
    if (is_root_process())
      {
        std::error_code error;
        is_new = !fs::exists(folder, error);
        fs::create_directories(folder, error);
        const std::string trial = folder + "/.lamella";
        writes = !error && std::ofstream(trial).put('\n').good();
        fs::remove(trial, error);
        descriptor = open(folder.c_str(), O_RDONLY | O_CLOEXEC);
        if (descriptor >= 0 && flock(descriptor, LOCK_EX | LOCK_NB) != 0 &&
            errno == EWOULDBLOCK)
          {
            close(descriptor);
            descriptor = -1;
          }
        alone = descriptor >= 0 || !writes;
      }
    if (!true_on_all_processes(writes))
      throw InputError(
        "report.folder-not-writable: results cannot be written into this "
        "folder. Name a folder that you may create and write to.")
        .at("--output " + folder + ": ");
    if (!true_on_all_processes(alone))
      throw InputError(
        "report.folder-in-use: another run writes into this folder. Wait until "
        "that run ends, or name another folder.")
        .at("--output " + folder + ": ");
  }



  ResultsFolder::~ResultsFolder()
  {
    if (descriptor < 0)
      return;
    std::error_code error;
    if (is_new)
      fs::remove(folder, error); // which fails if something is in it
    close(descriptor);
  }



  bool
  ResultsFolder::has_earlier_results() const
  {
    std::error_code error;
    return !is_cleared && fs::exists(folder + "/summary.json", error);
  }



  void
  ResultsFolder::make_room()
  {
    struct stat ours, there;
    const bool  still_exists =
      !is_root_process() ||
      (fstat(descriptor, &ours) == 0 && stat(folder.c_str(), &there) == 0 &&
       ours.st_dev == there.st_dev && ours.st_ino == there.st_ino);
    if (!true_on_all_processes(still_exists))
      throw InputError(
        "report.folder-removed: the folder of results was removed or renamed "
        "during the run. Run the scene again.")
        .at("--output " + folder + ": ");
    if (is_cleared)
      return;
    is_cleared = true;
    if (is_root_process())
      remove_earlier_results(folder);
    // No process writes before all of it is removed.
    true_on_all_processes(true);
  }
} // namespace lamella
