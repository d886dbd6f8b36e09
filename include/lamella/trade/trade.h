// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `trade`: accuracy against cost. It owns ladders of theories and
// meshes, the runs of their rungs, each in a process of its own, and their
// results. From these, scripts/trade.py makes a table, sentences on the
// cheapest rung, and a picture. A rung is an ordinary scene: the room never
// reads more of a solution than its Results.

#ifndef lamella_trade_trade_h
#define lamella_trade_trade_h

#include <lamella/base/child_process.h>
#include <lamella/scene/scene.h>
#include <lamella/trade/ladder.h>
#include <lamella/trade/rung_result.h>

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace lamella
{
  /**
   * `lamella trade SCENE.prm`: runs a ladder of theories and meshes on a scene
   * and sets what each rung costs against how far it is off.
   *
   * Each rung is a process of its own, forked from this one, in which
   * Simulation, or ToleranceRun, runs the scene with the rung's overrides, and
   * Estimation makes its error bars where they are wanted: seconds and memory
   * are those of a whole run (but for the loading of libraries, which this
   * process has done), and a rung that fails, whatever of, is a row that says
   * why. Its numbers come back through a pipe. When it has ended, a record of
   * it is put into its folder in one step; an interrupted trade (also a killed
   * one) goes on with the rungs that have none. A record counts only for the
   * same scene, mesh files, program and number of threads, and if the rung
   * succeeded.
   */
  class Trade
  {
  public:
    /// The scene in the file @p scene_file with @p overrides, as it was read
    /// into @p scene, which is referred to, as is @p out; rungs run on
    /// @p threads. MPI must not have been started: each rung starts its own.
    /// Throws InputError for overrides of rungs that no scene has, and for a
    /// scene that has nothing to compare. Nothing runs or is written yet.
    Trade(const std::string              &scene_file,
          const std::vector<std::string> &overrides,
          const Scene                    &scene,
          const unsigned int              threads,
          std::ostream                   &out);

    /// Runs the rungs of the ladder that have no results in @p directory and
    /// presents all there (present_trade()). Results of rungs go into
    /// rungs/NN_NAME. Throws InputError if another trade runs there, a file
    /// cannot be written, the scene has changed meanwhile or a rung lacks a
    /// quantity; NumericsError if no reference succeeded.
    void
    run(const std::string &directory);

  private:
    /// A rung to be run.
    struct Job
    {
      const LadderEntry &entry;
      /// Of the command line and of the rung.
      std::vector<std::string> overrides;
      /// What its record must say.
      std::string fingerprint;
      /// Whether it makes bars that the run itself does not need.
      bool bars;
      /// Where its results and its record are put.
      std::string folder;
    };

    /// What the record of a rung must say to be of this scene and this program:
    /// the resolved scene with @p rung_overrides but without its Trade, size
    /// and time of mesh files and program, its version, the threads.
    std::string
    fingerprint(const std::vector<std::string> &rung_overrides) const;
    /// That of the rung @p entry with @p all overrides, with what is done with
    /// the scene: run, with or without bars, or run to a tolerance.
    std::string
    fingerprint(const LadderEntry              &entry,
                const std::vector<std::string> &all) const;
    /// Runs the rungs of the ladder that differ from those before them, by
    /// their fingerprints. A rung that cannot be made is a result that failed.
    void
    climb(const std::string &directory);
    /// Runs it into @p output and returns what its record needs: `values`
    /// (RungValues), and `seconds_of_bars`, those of bars that the run itself
    /// does not need. Its process does nothing else.
    nlohmann::json
    answer_of(const Job &job, const std::string &output) const;
    /// answer_of() in a process of its own; what it prints goes into the
    /// folder.
    ProcessEnd
    run_scene(const Job &job, const std::string &output) const;
    /// What @p work returns as ProcessEnd::answer, done in a process of its own
    /// with an MPI of its own.
    ProcessEnd
    run_in_child(const std::function<nlohmann::json()> &work,
                 const std::string                     &output,
                 const std::string                     &errors,
                 const double                           time_limit) const;
    /// Puts quantities that only References ask for into the ply that these
    /// are of. Throws InputError for one that the scene cannot give
    /// (Simulation::in_plies()): before any rung, not after the last.
    void
    check_quantities(const std::string &directory);
    /// Runs it, three times where that takes less than a second, and returns
    /// what the record says: the costs of the fastest, which is kept in the
    /// folder; but where the rung makes bars the first run is kept, which alone
    /// makes them. Throws InputError if scene, mesh files or program are not
    /// what they were when the trade began.
    nlohmann::json
    new_record(const Job &job) const;
    /// Runs @p job again where it took @p seconds and those are few: what else
    /// the machine does weighs most where a run is short. Leaves those of the
    /// fastest run there, its costs in @p answer and, unless the rung makes
    /// bars, its results in the folder.
    void
    try_again(const Job &job, nlohmann::json &answer, double &seconds) const;
    /// Reads the rung's record in its folder, or makes one; adds the rung to
    /// results and numbers.
    void
    run_rung(const Job &job);
    /// Adds a rung that cannot be made to results and numbers.
    void
    fail(const LadderEntry &entry, const std::string &why);
    /// Adds the largest quantities of the probes of which the scene only says
    /// that they are compared, as the finest run has them.
    void
    complete_quantities();
    /// The values of all quantities, and their bars, into the results of rungs
    /// that succeeded.
    void
    take_values();

    std::string scene_file;
    /// Of the command line; those of a rung come behind them.
    std::vector<std::string> overrides;
    const Scene             &scene;
    unsigned int             threads;
    std::ostream            &out;
    /// The fingerprint of the scene without a rung's overrides, as it was read.
    std::string base;

    /// Those of the scene, and after complete_quantities() the rest.
    std::vector<NamedQuantity> quantities;
    /// Of each rung that was not left out, in the order of the ladder.
    std::vector<RungResult> results;
    /// As the scene says; the rung that stands for it if it was left out.
    std::string reference;
    /// Of each result, if it did not fail.
    std::vector<RungValues> numbers;
  };
} // namespace lamella

#endif
