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
  /// Constants of EnrichmentEstimate.
  struct EnrichmentRules
  {
    /// Number of wave numbers that the model with poorer fields lacks.
    unsigned int fewer_waves = 3;
    /// Section order below which runs with tolerances are compared with a
    /// richer section, as order 1 does not bound the error of order 2.
    unsigned int min_order = 3;
    /// Factors from a change to a bar: for poorer fields and sections; for
    /// halved axes, whose error falls by two or more; for richer models.
    double of_fields = 2., of_axis = 1., enriched_factor = 2.;
    /// Largest sum of |changes|, as a share of the scale, that has a bar.
    double max_change_share = 0.1;
  };

  /**
   * Error bars of the goals of a run with bodies of SV-N, from three models
   * that differ from the run in one source each and share its end fields:
   *   axis      half of the elements; with tolerances twice as many
   *   fields    three wave numbers less; with tolerances four more
   *   section   one order or degree less; with tolerances one more if the
   *             order is below EnrichmentRules::min_order.
   * A bar is the sum of |change| times the factor in EnrichmentRules. Richer
   * models give much shorter bars where fields converge fast; poorer ones cost
   * half as much. The estimate sums the changes by richer models only.
   * Penalties and load steps: see ContactShares.
   */
  class EnrichmentEstimate
  {
  public:
    /// Returns why @p run has no such bars; empty if it has.
    static std::string
    unavailable_reason(const Simulation &run);

    /// Solves the other models, as CoarserModelEstimate() does.
    EnrichmentEstimate(const Simulation &run,
                       std::ostream     &out,
                       ModelCache       &cache);

    std::vector<GoalResult>
    goals() const;

  private:
    /// Numbers of a model that differs in one source, and its factor.
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
    /// Returns the change of @p goal by @p other: richer less poorer.
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
    /// Local errors of each quantity, from more elements.
    std::vector<std::optional<LocalErrors>> local;
  };
} // namespace lamella

#endif
