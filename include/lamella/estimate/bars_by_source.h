// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_bars_by_source_h
#define lamella_estimate_bars_by_source_h

#include <lamella/estimate/contact_shares.h>
#include <lamella/estimate/other_models.h>
#include <lamella/estimate/run_goals.h>

#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// What bars by source are made by.
  struct SourceRules
  {
    /// Of what a model is poorer in: wave numbers.
    unsigned int fewer_waves = 3;
    /// Of the section: with tolerances lower ones are compared with richer
    /// ones, since order 1 says nothing of 2.
    unsigned int least_order = 3;
    /// What the error is held to be at most, of the change that poorer fields
    /// and sections make; halves of the elements, which divide it by two at
    /// least, also beside corners; and richer fields and axes.
    double of_fields = 2., of_axis = 1., of_richer = 2.;
    /// No bar where all three change a goal by more than this share of the
    /// scale.
    double most_changed = 0.1;
  };

  /**
   * The errors of the goals of a run with bodies of SV-N, from three models
   * each of which differs from it in one source. They share its end fields,
   * which most of its seconds go into:
   *   axis      half of the elements; where goals have tolerances, twice as
   *             many
   *   fields    three wave numbers less; with tolerances four more
   *   section   one order or degree less; with tolerances one more where the
   *             order is below least_order.
   * A bar sums the sizes of what they change, by SourceRules: where fields
   * settle fast that of richer models is far shorter, which a tolerance is met
   * by, and poorer ones cost half of them. Richer ones are the estimate, with
   * what penalties and load steps do; of poorer ones nobody has looked at how
   * much is left. Penalties: as in BarsFromBelow.
   */
  class BarsBySource
  {
  public:
    /// Why there are none of @p run: a sentence without a full stop; empty if
    /// there are.
    static std::string
    reason_for_none(const Simulation &run);

    /// As BarsFromBelow().
    BarsBySource(const Simulation &run, std::ostream &out, ModelCache &cache);

    std::vector<GoalResult>
    goals() const;

  private:
    /// A model that differs in one source, and what its change counts in a bar.
    struct Other
    {
      Source        source;
      bool          is_richer = false;
      double        factor    = 0.;
      ResultNumbers numbers;
    };

    void
    compare_with_poorer(OtherModels &models, const Scene &scene);
    void
    compare_with_richer(OtherModels &models, const Scene &scene);
    void
    compare_sections(OtherModels &models, const Scene &scene);
    /// Of @p goal what @p other changes, the richer less the poorer one.
    double
    change_by(const Other &other, const NamedQuantity &goal) const;
    ErrorBar
    bar_of(const NamedQuantity &goal) const;
    GoalResult
    goal(const unsigned int number) const;

    const Simulation  &run;
    SourceRules        rules;
    RunGoals           of_run;
    ContactShares      of_contact;
    std::vector<Other> others;
    /// Of each of the quantities, from the model with shorter elements; empty
    /// where nobody asks where errors are.
    std::vector<std::optional<LocalErrors>> local;
  };
} // namespace lamella

#endif
