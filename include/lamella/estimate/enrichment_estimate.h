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
  /// Parameters of EnrichmentEstimate.
  struct EnrichmentRules
  {
    ///     Number of wave numbers that the coarser model of SV-N has less than
    ///     the run.
    unsigned int fewer_waves = 3;
    /// Smallest section order for which a run to a tolerance is compared with a
    /// lower order. Smaller orders are compared with a higher one.
    unsigned int min_order = 3;
    /// Factors by which the change of a goal is multiplied in its error bar:
    /// for models with coarser fields or sections; for halved axes, whose error
    /// decreases at least by half; for finer models.
    double of_fields = 2., of_axis = 1., enriched_factor = 2.;
    /// There is no bar if sum |change| exceeds this fraction of the scale.
    double max_change_share = 0.1;
  };

  /// Error bars of the goals of a run with bodies of SV-N. The run is compared
  /// with three models, each of which differs from it in one source of error.
  /// Runs to a tolerance use the finer models in parentheses:
  /// - axis: half of the elements (twice as many);
  /// - fields: three wave numbers less (four more);
  /// - section: one order or degree less (one more if the order is below
  ///   EnrichmentRules::min_order).
  ///
  /// All models have the same boundary-layer modes. A bar is the sum of
  /// |change| times the factors in EnrichmentRules. Finer models give much
  /// shorter bars if fields converge fast; coarser models cost half as much.
  /// The estimated error is the sum of the changes by finer models only.
  /// ContactShares adds penalties and load steps.
  class EnrichmentEstimate
  {
  public:
    /// Returns why this method is not possible for @p run; empty if it is.
    static std::string
    unavailable_reason(const Simulation &run);

    /// Solves the comparison models; arguments as of CoarserModelEstimate().
    EnrichmentEstimate(const Simulation &run,
                       std::ostream     &out,
                       ModelCache       &cache);

    std::vector<GoalResult>
    goals() const;

  private:
    /// Results of a comparison model with its factor in the bar.
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
    /// Returns the change of @p goal by @p other: finer minus coarser model.
    double
    change_by(const Other &other, const NamedQuantity &goal) const;
    ErrorBar
    error_bar_of(const NamedQuantity &goal) const;
    GoalResult
    goal(const unsigned int number) const;

    const Simulation  &run;
    EnrichmentRules    rules;
    RunGoals           of_run;
    ContactShares      of_contact;
    std::vector<Other> others;
    /// Local errors of each goal, from the model with more elements.
    std::vector<std::optional<LocalErrors>> local;
  };
} // namespace lamella

#endif
