// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_trade_h
#define lamella_run_trade_h

#include <lamella/base/child_process.h>
#include <lamella/run/ladder.h>
#include <lamella/run/trade_table.h>
#include <lamella/scene/scene.h>

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
   * Each rung is a process of its own, `lamella SCENE.prm` with the rung's
   * overrides, so that seconds and memory are those of a whole run, and a rung
   * that fails, whatever of, is a row that says why. When it has ended, a
   * record of it is put into its folder in one step; an interrupted trade
   * (also a killed one) goes on with the rungs that have none. A record counts
   * only for the same scene, mesh files, program and number of
   * threads, and if the rung succeeded.
   */
  class Trade
  {
  public:
    /// The scene in the file @p scene_file with @p overrides, as it was read
    /// into @p scene; @p program runs the rungs, on @p threads. Throws
    /// InputError for overrides of rungs that no scene has.
    Trade(const std::string              &scene_file,
          const std::vector<std::string> &overrides,
          const Scene                    &scene,
          const std::string              &program,
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
    /// Runs the scene with the overrides @p all into @p output; what it prints
    /// goes into @p folder.
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
    /// Reads the rung's record in @p folder, or makes one.
    RungResult
    run_rung(const LadderEntry              &entry,
             const std::vector<std::string> &all,
             const std::string              &of,
             const std::string              &folder) const;
    /// Adds the largest quantities of the probes of which the scene only says
    /// that they are compared, as the finest run has them.
    void
    complete_quantities();
    void
    read_values();

    std::string              scene_file;
    std::vector<std::string> overrides;
    const Scene             &scene;
    std::string              program;
    unsigned int             threads;
    std::ostream            &out;
    /// The fingerprint of the scene without a rung's overrides, as it was read.
    std::string base;

    std::vector<TradeQuantity> quantities;
    std::vector<RungResult>    results;
    /// As the scene says; the rung that stands for it if it was left out.
    std::string reference;
    /// Of each result, where its run is.
    std::vector<std::string> folders;
  };
} // namespace lamella

#endif
