// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `trade`: accuracy against cost. It runs the variants of hierarchies
// of theories and meshes, each in its own process, and stores their results.
// scripts/trade.py makes a table, sentences on the cheapest variant, and a
// picture of them. A variant is an ordinary scene.

#ifndef lamella_trade_trade_h
#define lamella_trade_trade_h

#include <lamella/base/child_process.h>
#include <lamella/scene/scene.h>
#include <lamella/trade/variant_result.h>
#include <lamella/trade/variants.h>

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace lamella
{
  /**
   * Implements `lamella trade SCENE.prm`: runs variants of a scene (a hierarchy
   * of theories and meshes) and compares their costs and errors.
   *
   * Each variant is a forked process, in which Simulation or ToleranceRun runs
   * the scene with its overrides, and Estimation makes error bars if requested.
   * Seconds and memory are those of a whole run, except for the loading of
   * libraries. A variant that fails is a row with the reason. The results
   * return through a pipe and are stored in a record in the variant's folder,
   * atomically. An interrupted trade is resumed with the variants without a
   * record. A record is valid for the same scene, mesh files, program and
   * number of threads.
   */
  class Trade
  {
  public:
    /// Prepares the trade of the file @p scene_file with @p overrides, read
    /// into @p scene. Refers to @p scene and @p out; variants run on
    /// @p threads. MPI must not be initialized. Throws InputError for invalid
    /// overrides of variants, and for a scene without quantities to compare.
    Trade(const std::string              &scene_file,
          const std::vector<std::string> &overrides,
          const Scene                    &scene,
          const unsigned int              threads,
          std::ostream                   &out);

    /// Runs the variants without results in @p directory, into
    /// variants/NN_NAME, and presents all (present_trade()). Throws InputError
    /// if another trade runs there, a file cannot be written, the scene has
    /// changed or a variant lacks a quantity; NumericsError if no reference
    /// succeeded.
    void
    run(const std::string &directory);

  private:
    /// A variant to be run.
    struct Job
    {
      const TradeVariant &entry;
      /// Overrides of the command line and of the variant.
      std::vector<std::string> overrides;
      /// Fingerprint that its record must have.
      std::string fingerprint;
      /// True if it makes error bars that the run itself does not need.
      bool bars;
      /// Folder of its results and its record.
      std::string folder;
    };

    /// Returns the fingerprint for a record: the resolved scene with
    /// @p variant_overrides but without its Trade, size and time of mesh files
    /// and program, its version, the threads.
    std::string
    fingerprint(const std::vector<std::string> &variant_overrides) const;
    /// Returns the fingerprint of the variant @p entry with @p all overrides
    /// and its task (run, error bars, run to a tolerance).
    std::string
    fingerprint(const TradeVariant             &entry,
                const std::vector<std::string> &all) const;
    /// Runs the variants with different fingerprints. Invalid variants are
    /// failed results.
    void
    run_variants(const std::string &directory);
    /// Runs @p job into @p output, in its own process, and returns the data of
    /// its record: `values` (VariantValues), and `seconds_of_bars` for error
    /// bars that the run itself does not need.
    nlohmann::json
    run_job(const Job &job, const std::string &output) const;
    /// Runs run_job() in a process of its own; its output goes into the folder.
    ProcessEnd
    run_scene(const Job &job, const std::string &output) const;
    /// Runs @p work in a process of its own with its own
    /// MPI(ProcessEnd::result).
    ProcessEnd
    run_in_process(const std::function<nlohmann::json()> &work,
                   const std::string                     &output,
                   const std::string                     &errors,
                   const double                           time_limit) const;
    /// Sets quantities that only References request to the ply of these. Throws
    /// InputError for one that the scene does not have.
    void
    check_quantities(const std::string &directory);
    /// Runs @p job, three times if that takes less than a second, and returns
    /// the record with the costs of the fastest run. If the variant makes error
    /// bars, only the first run makes them and is kept. Throws InputError if
    /// scene, mesh files or program have changed since the trade began.
    nlohmann::json
    new_record(const Job &job) const;
    /// Repeats @p job if it took few @p seconds. Keeps the costs of the fastest
    /// run in @p result and @p seconds, and its results in the folder unless
    /// the variant makes error bars.
    void
    repeat_short_run(const Job      &job,
                     nlohmann::json &result,
                     double         &seconds) const;
    /// Reads or makes the record of the variant; adds the variant to results.
    void
    run_variant(const Job &job);
    /// Adds a variant that cannot be made to results and numbers.
    void
    fail(const TradeVariant &entry, const std::string &why);
    /// Adds the largest quantities of probes, from the finest run.
    void
    complete_quantities();
    /// Writes the values and error bars of all quantities into the successful
    /// results.
    void
    store_values();

    std::string scene_file;
    /// Overrides of the command line; those of a variant are appended.
    std::vector<std::string> overrides;
    const Scene             &scene;
    unsigned int             threads;
    std::ostream            &out;
    /// Fingerprint of the scene as read, without overrides of a variant.
    std::string base;

    /// Quantities of the scene; complete_quantities() adds the rest.
    std::vector<NamedQuantity> quantities;
    /// Result of each variant that was not left out, in their order.
    std::vector<VariantResult> results;
    /// Reference of the scene, or the variant that replaces it.
    std::string reference;
    /// Numbers of each result; empty if it failed.
    std::vector<VariantValues> numbers;
  };
} // namespace lamella

#endif
