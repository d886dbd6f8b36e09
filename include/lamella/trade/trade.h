// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `trade`: accuracy against cost. It owns ladders of theories and
// meshes, the runs of their rungs, each in a process of its own, and the table,
// the sentences and the picture that say what is the cheapest. A rung is a
// scene like any other: it never looks into a solution beyond its Results.

#ifndef lamella_trade_trade_h
#define lamella_trade_trade_h

#include <lamella/base/child_process.h>
#include <lamella/scene/scene.h>
#include <lamella/trade/ladder.h>
#include <lamella/trade/trade_table.h>

#include <nlohmann/json_fwd.hpp>

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
   * Simulation runs the scene with the rung's overrides: seconds and memory are
   * those of a whole run (but for the loading of libraries, which this process
   * has done), and a rung that fails, whatever of, is a row that says why. Its
   * numbers come back through a pipe. When it has ended, a
   * record of it is put into its folder in one step; an interrupted trade
   * (also a killed one) goes on with the rungs that have none. A record counts
   * only for the same scene, mesh files, program and number of
   * threads, and if the rung succeeded.
   */
  class Trade
  {
  public:
    /// The scene in the file @p scene_file with @p overrides, as it was read
    /// into @p scene; rungs run on @p threads. MPI must not have been started:
    /// each rung starts its own. Throws InputError for overrides of rungs that
    /// no scene has.
    Trade(const std::string              &scene_file,
          const std::vector<std::string> &overrides,
          const Scene                    &scene,
          const unsigned int              threads,
          std::ostream                   &out);

    /// Runs what is missing of the ladder in @p directory and writes trade.csv,
    /// trade.gp, trade.png and trade.svg there. Throws InputError if another
    /// trade is at work there or nothing can be written, NumericsError if no
    /// reference succeeded.
    void
    run(const std::string &directory);

  private:
    /// What the rung's record must say to be of this scene and this program.
    std::string
    fingerprint(const std::vector<std::string> &rung_overrides) const;
    /// Runs the rungs of the ladder that differ from those before them.
    void
    climb(const std::string &directory);
    /// Runs the scene with the overrides @p all into @p output, in a process of
    /// its own whose answer is RungValues; what it prints goes into @p folder.
    ProcessEnd
    run_scene(const std::vector<std::string> &all,
              const std::string              &folder,
              const std::string              &output) const;
    /// Runs it, a few times where that is soon done, keeps the fastest in
    /// @p folder and returns what the record says; @p of is its fingerprint.
    nlohmann::json
    new_record(const std::vector<std::string> &all,
               const std::string              &of,
               const std::string              &folder) const;
    /// Reads the rung's record in @p folder, or makes one; adds the rung to
    /// results and numbers.
    void
    run_rung(const LadderEntry              &entry,
             const std::vector<std::string> &all,
             const std::string              &of,
             const std::string              &folder);
    /// Adds the largest quantities of the probes of which the scene only says
    /// that they are compared, as the finest run has them.
    void
    complete_quantities();
    void
    take_values();

    std::string              scene_file;
    std::vector<std::string> overrides;
    const Scene             &scene;
    unsigned int             threads;
    std::ostream            &out;
    /// The fingerprint of the scene without a rung's overrides, as it was read.
    std::string base;

    std::vector<TradeQuantity> quantities;
    std::vector<RungResult>    results;
    /// As the scene says; the rung that stands for it if it was left out.
    std::string reference;
    /// Of each result, if it did not fail.
    std::vector<RungValues> numbers;
  };
} // namespace lamella

#endif
