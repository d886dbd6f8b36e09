// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/output_file.h>
#include <lamella/base/processes.h>
#include <lamella/base/version.h>
#include <lamella/material/material.h>
#include <lamella/report/results_folder.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace boost
{
  namespace serialization
  {
    template <typename Archive>
    void
    serialize(Archive                &archive,
              lamella::StatusChanges &changes,
              const unsigned int)
    {
      archive &changes.closed &changes.opened;
    }



    template <typename Archive>
    void
    serialize_blocks(Archive &archive, lamella::BlockVector &u)
    {
      std::vector<dealii::types::global_dof_index> sizes;
      for (unsigned int b = 0; b < u.n_blocks(); ++b)
        sizes.push_back(u.block(b).size());
      archive &sizes;
      if (Archive::is_loading::value)
        u.reinit(sizes);
      for (unsigned int b = 0; b < sizes.size(); ++b)
        archive &u.block(b);
    }



    template <typename Archive>
    void
    serialize(Archive &archive, lamella::State &state, const unsigned int)
    {
      serialize_blocks(archive, state.u);
      archive &state.free_sizes &state.force &state.active &state.rest &state
        .iterations &state.free_corrections &state.contact_corrections &state
        .pairings;
      for (unsigned int &number : state.solved_by)
        archive &number;
      lamella::FrictionState &friction = state.friction;
      archive &friction.shear &friction.direction &friction.before &friction
        .history &friction.path_gap;
    }



    template <typename Archive>
    void
    serialize(Archive                  &archive,
              lamella::FrictionHistory &point,
              const unsigned int)
    {
      archive &point.position &point.is_dropped &point.force &point.shear &point
        .gap &point.slid &point.length &point.dissipated;
    }



    template <typename Archive>
    void
    serialize(Archive                  &archive,
              lamella::StrategyHistory &memory,
              const unsigned int)
    {
      archive &memory.stiffening &memory.rows;
    }



    template <typename Archive>
    void
    serialize(Archive &archive, lamella::GapPoint &point, const unsigned int)
    {
      archive &point.slave.facet &point.slave.st &point.master.facet &point
        .master.st &point.area &point.part;
    }



    template <typename Archive>
    void
    serialize(Archive                 &archive,
              lamella::ContactHistory &memory,
              const unsigned int)
    {
      serialize_blocks(archive, memory.u);
      archive &memory.factor &memory.points &memory.discretization;
    }



    template <typename Archive>
    void
    serialize(Archive                       &archive,
              lamella::NonlinearityEstimate &beyond,
              const unsigned int)
    {
      archive &beyond.stiffening &beyond.stiffened &beyond.buckled &beyond
        .amplification;
      lamella::serialize_optional(archive, beyond.buckling_factor);
    }



    template <typename Archive>
    void
    serialize(Archive &archive, lamella::StepResults &step, const unsigned int)
    {
      archive &step.step &step.load_factor &step.state &step.memory &step
        .changes &step.warnings &step.plies &step.checks.beyond &step.substeps;
      lamella::serialize_optional(archive, step.change);
    }



    template <typename Archive>
    void
    serialize(Archive &archive, lamella::Restart &restart, const unsigned int)
    {
      // To be incremented with each change of what is stored.
      constexpr unsigned int layout = 6;
      unsigned int           found  = layout;
      archive               &found;
      if (found != layout)
        throw std::runtime_error("another layout");
      archive &restart.version &restart.scene &restart.finished &restart
        .steps &restart.sizes &restart.vtu_files;
    }
  } // namespace serialization
} // namespace boost



namespace lamella
{
  namespace
  {
    const char *const name = "/restart";
  }



  void
  write_restart(const Restart &restart, const std::string &directory)
  {
    std::ostringstream              text;
    boost::archive::binary_oarchive archive(text);
    archive << restart;
    write_file(directory + name, text.str());
  }



  namespace
  {
    /// Returns why the run in @p directory cannot resume @p scene, or nothing.
    std::string
    reason_not_to_resume(const Restart     &restart,
                         const std::string &directory,
                         const std::string &scene)
    {
      if (restart.version != version())
        return "report.restart-version: the run is of version " +
               restart.version + " of Lamella, but this is version " +
               version() + ". Run the scene from the start, without --resume.";
      if (restart.scene.size() > scene.size() &&
          restart.scene.compare(0, scene.size(), scene) == 0)
        return "report.restart-revised: the run has automatically changed axis "
               "elements or contacts of its scene (see the end of " +
               directory +
               "/scene.prm) and cannot be resumed. Run it without --resume.";
      if (restart.scene != scene)
        return "report.restart-of-other-scene: the run to resume is of a "
               "different scene, which is in " +
               directory +
               "/scene.prm. Name that scene, or run without --resume.";
      return restart.finished ?
               "report.restart-finished: the run to resume is finished "
               "already. To repeat it, run without --resume." :
               "";
    }
  } // namespace



  Restart
  read_restart(const std::string &directory, const std::string &scene)
  {
    const auto fail = [&directory](const std::string &message) {
      throw InputError(message).at("--resume --output " + directory + ": ");
    };
    std::ifstream file(directory + name, std::ios::binary);
    if (!file)
      fail("report.no-restart: the folder holds no interrupted run to resume. "
           "Run without --resume, or name the folder of the run by --output.");
    Restart restart;
    try
      {
        boost::archive::binary_iarchive archive(file);
        archive >> restart;
      }
    catch (const std::exception &)
      {
        fail("report.restart-damaged: the file 'restart' in the folder is "
             "damaged. Run the scene from the start, without --resume.");
      }
    const std::string reason = reason_not_to_resume(restart, directory, scene);
    if (!reason.empty())
      fail(reason);
    return restart;
  }



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



  namespace
  {
    /// The constants of @p material as the scene writes them.
    nlohmann::json
    constants_of(const Material &material)
    {
      const EngineeringConstants &e = material.elastic;
      nlohmann::json              constants;
      constants["elastic"] = {
        e.E1, e.E2, e.E3, e.G12, e.G13, e.G23, e.nu12, e.nu13, e.nu23};
      if (material.strengths)
        {
          const Strengths &s     = *material.strengths;
          constants["strengths"] = {
            s.Xt, s.Xc, s.Yt, s.Yc, s.Zt, s.Zc, s.S12, s.S13, s.S23};
        }
      return constants;
    }



    /// What the page says that no folder has.
    std::string
    program_data()
    {
      nlohmann::json known;
      known["version"] = version();
      for (const auto &[unit, pascal] :
           {std::pair("Pa", 1.), std::pair("MPa", 1e-6)})
        for (const std::string &name : library_materials())
          {
            Units units;
            units.pascal = pascal;
            known["materials"][unit][name] =
              constants_of(library_material(name, units));
          }
      return known.dump();
    }
  } // namespace



  void
  make_page(const std::string &folder, const std::string &target)
  {
    const std::string python = python_with("jinja2");
    if (python.empty())
      throw InputError(
        "report.no-jinja2: the report needs python3 with Jinja2, which was not "
        "found. Install the package python3-jinja2, as scripts/setup does.");
    // Names of files are UTF-8 whatever the user's language is.
    exec_program(python,
                 {"-X",
                  "utf8",
                  path_of_script("report.py"),
                  folder,
                  "--output=" + target,
                  "--program=" + program_data()});
  }
} // namespace lamella
