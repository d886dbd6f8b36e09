// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/output_file.h>
#include <lamella/base/version.h>
#include <lamella/report/restart.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <fstream>
#include <sstream>
#include <stdexcept>

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
} // namespace lamella
