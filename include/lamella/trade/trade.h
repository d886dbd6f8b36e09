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
  /// Implements `lamella trade SCENE.prm`: solves variants of a scene with
  /// different theories and meshes, and compares their costs and errors.
  ///
  /// Each variant is solved in a forked process: Simulation or ToleranceRun
  /// solves the scene with changed entries (overrides), and Estimation computes
  /// error bars if requested. Time and memory are those of the whole process. A
  /// failed variant is reported with the reason. The results of each variant
  /// are stored in a file, the record, in its folder. An interrupted trade
  /// continues with the variants without a record. A record is valid for the
  /// same scene, mesh files, program and number of threads.
  class Trade
  {
  public:
    /// Prepares the comparison for @p scene, which was read from @p scene_file
    /// with @p overrides. Keeps references to @p scene and @p out, which must
    /// outlive this object; variants use @p threads threads. MPI must not be
    /// initialized. Throws InputError for invalid variants or quantities.
    Trade(const std::string              &scene_file,
          const std::vector<std::string> &overrides,
          const Scene                    &scene,
          const unsigned int              threads,
          std::ostream                   &out);

    /// Solves the variants that have no results yet, each in the folder
    /// variants/NN_NAME of @p directory, and reports all results
    /// (present_trade()). Throws InputError if another trade uses @p directory,
    /// a file cannot be written, the scene has changed or a variant lacks a
    /// quantity; NumericsError if no reference solution is found.
    void
    run(const std::string &directory);

  private:
    /// Data for the solution of a variant in its own process.
    struct Job
    {
      const TradeVariant &entry;
      /// Overrides of the command line and of the variant.
      std::vector<std::string> overrides;
      /// Text that a valid record contains, see fingerprint().
      std::string fingerprint;
      /// True if error bars are computed in addition to the solution.
      bool        bars;
      std::string folder; ///< Folder for the results and the record.
    };

    /// Returns a text that changes if a stored record becomes invalid: scene
    /// with @p variant_overrides but without `Trade`, size and time of mesh
    /// files and program, version, number of threads.
    std::string
    fingerprint(const std::vector<std::string> &variant_overrides) const;
    /// Returns the fingerprint of the variant @p entry with @p all overrides
    /// and its kind of solution (plain, with error bars, to a tolerance).
    std::string
    fingerprint(const TradeVariant             &entry,
                const std::vector<std::string> &all) const;
    /// Solves all variants in folders of @p directory; variants with equal
    /// fingerprints once. Invalid variants are stored as failed.
    void
    run_variants(const std::string &directory);
    /// Solves @p job in this process, writes results to the folder @p output,
    /// and returns the record: `values` (VariantValues), and `seconds_of_bars`,
    /// the time of error bars that the solution does not need.
    nlohmann::json
    run_job(const Job &job, const std::string &output) const;
    /// Calls run_job() in a new process; console output goes to the folder.
    ProcessEnd
    run_scene(const Job &job, const std::string &output) const;
    /// Calls @p work in a new process with its own MPI and returns the end of
    /// this process; ProcessEnd::result is the return value of @p work.
    ProcessEnd
    run_in_process(const std::function<nlohmann::json()> &work,
                   const std::string                     &output,
                   const std::string                     &errors,
                   const double                           time_limit) const;
    /// Determines the ply in which each compared quantity is evaluated. Throws
    /// InputError for unknown quantities.
    void
    check_quantities(const std::string &directory);
    /// Solves @p job, three times if this takes less than a second, and returns
    /// the record with the cost of the fastest solution. Error bars are
    /// computed once. Throws InputError if scene, mesh files or program have
    /// changed since the trade began.
    nlohmann::json
    new_record(const Job &job) const;
    /// Solves @p job again if this took less than a second. Sets @p result and
    /// @p seconds to the cost of the fastest solution.
    void
    repeat_short_run(const Job      &job,
                     nlohmann::json &result,
                     double         &seconds) const;
    /// Reads or computes the record of the variant; appends to `results`.
    void
    run_variant(const Job &job);
    /// Appends the variant @p entry as failed, for the reason @p why.
    void
    fail(const TradeVariant &entry, const std::string &why);
    /// Adds the quantities that are largest at probes in the finest variant.
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
    /// Fingerprint of the scene without overrides of variants.
    std::string base;

    /// Compared quantities; complete_quantities() adds more.
    std::vector<NamedQuantity> quantities;
    /// Result of each variant, in the order of variants.
    std::vector<VariantResult> results;
    /// Name of the reference, or of an equal variant solved in its place.
    std::string reference;
    /// All output values of each variant; empty if the variant failed.
    std::vector<VariantValues> numbers;
  };

  /// Results of a trade, which compares variants of a scene, for the report.
  struct TradeFindings
  {
    /// Variants from the cheapest to the finest. Successful variants have one
    /// value for each compared quantity.
    std::vector<VariantResult> variants;
    /// Compared quantities, with reference values if the reference is `given`.
    std::vector<NamedQuantity> quantities;
    /// Reference solution: `finest`, `solid`, `given` or the name of a variant.
    std::string reference;
    /// Relative errors; the report names the cheapest variant for each.
    std::vector<double> tolerances;
    std::string         title;       ///< Title of the plots.
    std::string         remark = {}; ///< Text that is printed after the tables.
  };

  /// Writes @p findings to trade.json in @p directory and runs
  /// scripts/trade.py, which prints tables and the cheapest variants, and
  /// writes trade.csv and plots (doc/guides/convergence-study.md). Throws
  /// NumericsError if the reference variant or every variant failed; InputError
  /// if python3 is not found or a file cannot be written.
  void
  present_trade(const TradeFindings &findings, const std::string &directory);
} // namespace lamella

#endif
