// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_enrichment_estimate_h
#define lamella_estimate_enrichment_estimate_h

#include <lamella/estimate/comparison_models.h>
#include <lamella/estimate/contact_shares.h>
#include <lamella/estimate/run_goals.h>

#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// Parameters of error bars from models that differ in one error source each.
  struct EnrichmentRules
  {
    /// Number of wave numbers that the coarser model of SV-N omits.
    unsigned int fewer_waves = 3;
    /// Smallest section order that a run to a tolerance compares with a lower
    /// order; smaller orders are compared with a higher order.
    unsigned int min_order = 3;
    /// Factor in the bar of the change by fewer waves or a lower order.
    double of_fields = 2.,
           of_axis = 1., ///< Factor in the bar of the change by a halved axis.
      enriched_factor = 2.; ///< Factor of the change by any finer model.
    /// Largest sum of |change| with a bar, as a fraction of the goal's scale.
    double max_change_share = 0.1;
  };

  /// Error bars of the goals of a run with bodies of SV-N (section functions
  /// computed for N wave numbers). The run is compared with three models, each
  /// of which differs from it in one error source. Runs to a tolerance use the
  /// finer models in parentheses:
  /// - axis: half of the elements (twice as many);
  /// - fields: three wave numbers less (four more);
  /// - section: one order or degree less (one more if the order is below
  ///   EnrichmentRules::min_order, otherwise also one less).
  ///
  /// All models have the same boundary-layer modes. A bar is the sum of
  /// |change| times the factors in EnrichmentRules. Finer models give shorter
  /// bars; coarser models cost half as much. The error estimate is the signed
  /// sum of the changes to finer models; changes to coarser models enter the
  /// bar only. ContactShares adds penalties and load steps.
  class EnrichmentEstimate
  {
  public:
    /// Returns the reason why @p run cannot have such error bars, a sentence
    /// for the user; empty if it can.
    static std::string
    unavailable_reason(const Simulation &run);

    /// Solves the comparison models of @p run, whose last load step must be
    /// solved. Prints a line per model to @p out; @p cache stores the models.
    EnrichmentEstimate(const Simulation &run,
                       std::ostream     &out,
                       ModelCache       &cache);

    /// Returns the goals of the input file with their error bars.
    std::vector<GoalResult>
    goals() const;

  private:
    /// Results of a comparison model, with the factor of its change in the bar.
    struct Other
    {
      Source        source;
      bool          is_enriched = false;
      double        factor      = 0.;
      ResultNumbers numbers;
    };

    void
    compare_with_coarser(ComparisonModels &models, const Scene &scene);
    void
    compare_with_enriched(ComparisonModels &models, const Scene &scene);
    void
    compare_sections(ComparisonModels &models, const Scene &scene);
    /// Returns the change of @p goal from the coarser to the finer of two
    /// models: the run and @p other.
    double
    change_by(const Other &other, const NamedQuantity &goal) const;
    ErrorBar
    error_bar_of(const NamedQuantity &goal) const;

    const Simulation  &run;
    EnrichmentRules    rules;
    RunGoals           of_run;
    ContactShares      of_contact;
    std::vector<Other> others;
    /// Error of each goal per axis element; empty if unknown.
    std::vector<std::optional<LocalErrors>> local;
  };
} // namespace lamella

#endif
