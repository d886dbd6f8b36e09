// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `trade`: comparison of accuracy and cost. It runs variants of a
// scene (theories and meshes), each in its own process, and stores their
// results. scripts/trade.py creates a table, names the cheapest variants,
// and plots errors over cost. It does not solve anything itself.

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
  /// Implements `lamella trade SCENE.prm`: runs variants of a scene (a
  /// hierarchy of theories and meshes) and compares their costs and errors.
  ///
  /// Each variant runs in a forked process: Simulation or ToleranceRun solves
  /// the scene with changed entries (overrides), and Estimation computes error
  /// bars if requested. Time and memory are those of the whole process. A
  /// failed variant is reported with the reason. Results are stored in a file,
  /// the record, in the folder of the variant. An interrupted trade continues
  /// with the variants without a record. A record is valid for the same scene,
  /// mesh files, program and number of threads.
  class Trade
  {
  public:
    /// Prepares the trade of @p scene, which was read from @p scene_file with
    /// @p overrides. Keeps references to @p scene and @p out, which must
    /// outlive this object; variants use @p threads threads. MPI must not be
    /// initialized. Throws InputError for invalid overrides of variants, and
    /// for a scene without quantities to compare.
    Trade(const std::string              &scene_file,
          const std::vector<std::string> &overrides,
          const Scene                    &scene,
          const unsigned int              threads,
          std::ostream                   &out);

    /// Runs the variants that have no results yet, each in the folder
    /// variants/NN_NAME of @p directory, and presents all results
    /// (present_trade()). Throws InputError if another trade runs in @p
    /// directory, a file cannot be written, the scene has changed or a variant
    /// lacks a quantity; NumericsError if no reference solution is found.
    void
    run(const std::string &directory);

  private:
    /// A variant to be run.
    struct Job
    {
      const TradeVariant &entry;
      /// Overrides of the command line and of the variant.
      std::vector<std::string> overrides;
      /// Fingerprint (see below) that a valid record has.
      std::string fingerprint;
      /// True if error bars are computed that the run itself does not need.
      bool bars;
      /// Folder for the results and the record.
      std::string folder;
    };

    /// Returns a text that changes if a stored record becomes invalid: the
    /// scene with @p variant_overrides and without `Trade`, size and time of
    /// mesh files and program, version, number of threads.
    std::string
    fingerprint(const std::vector<std::string> &variant_overrides) const;
    /// Returns the fingerprint of the variant @p entry with @p all overrides
    /// and its kind of run (plain, with error bars, to a tolerance).
    std::string
    fingerprint(const TradeVariant             &entry,
                const std::vector<std::string> &all) const;
    /// Runs the variants; those with equal fingerprints once. Invalid variants
    /// are stored as failed.
    void
    run_variants(const std::string &directory);
    /// Runs @p job in this process, writes results to the folder @p output, and
    /// returns the data of the record: `values` (VariantValues), and
    /// `seconds_of_bars`, the time of error bars that the run does not need.
    nlohmann::json
    run_job(const Job &job, const std::string &output) const;
    /// Calls run_job() in a new process; console output goes to the folder.
    ProcessEnd
    run_scene(const Job &job, const std::string &output) const;
    /// Calls @p work in a new process with its own MPI. Its return value is
    /// ProcessEnd::result.
    ProcessEnd
    run_in_process(const std::function<nlohmann::json()> &work,
                   const std::string                     &output,
                   const std::string                     &errors,
                   const double                           time_limit) const;
    /// Sets the ply of quantities that are compared since they have References.
    /// Throws InputError for quantities that the scene does not have.
    void
    check_quantities(const std::string &directory);
    /// Runs @p job, three times if a run takes less than a second, and returns
    /// the record with the cost of the fastest run. Error bars are computed by
    /// the first run only. Throws InputError if scene, mesh files or program
    /// have changed since the trade began.
    nlohmann::json
    new_record(const Job &job) const;
    /// Repeats @p job if its run took less than a second. Sets @p result and @p
    /// seconds to the cost of the fastest run.
    void
    repeat_short_run(const Job      &job,
                     nlohmann::json &result,
                     double         &seconds) const;
    /// Reads the record of the variant or runs it; appends to `results`.
    void
    run_variant(const Job &job);
    /// Appends the variant @p entry, which failed because of @p why.
    void
    fail(const TradeVariant &entry, const std::string &why);
    /// Adds the quantities that are largest among probes in the finest run.
    void
    complete_quantities();
    /// Sets values and error bars of all quantities in the successful results.
    void
    store_values();

    std::string scene_file;
    /// Overrides of the command line; those of a variant are appended.
    std::vector<std::string> overrides;
    const Scene             &scene;
    unsigned int             threads;
    std::ostream            &out;
    /// Fingerprint of the scene without overrides of a variant.
    std::string base;

    /// Compared quantities; complete_quantities() adds more.
    std::vector<NamedQuantity> quantities;
    /// Result of each variant, in the order of variants.
    std::vector<VariantResult> results;
    /// Reference solution (TradeParameters::reference or its replacement).
    std::string reference;
    /// All output values of each variant; empty if the variant failed.
    std::vector<VariantValues> numbers;
  };
} // namespace lamella

#endif
