// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_run_goals_h
#define lamella_estimate_run_goals_h

#include <lamella/estimate/error_bar.h>
#include <lamella/recover/named_quantity.h>
#include <lamella/run/simulation.h>

#include <string>
#include <vector>

namespace lamella
{
  /// The goals of a run that is solved: their values, and what errors of them
  /// are small against. Refers to the run.
  class RunGoals
  {
  public:
    /// Why @p run has none that want bars: a sentence without a full stop;
    /// empty if it has.
    static std::string
    reason_for_none(const Simulation &run);

    /// Returns whether @p run has contacts and none is active in its last step.
    static bool
    touches_nothing(const Simulation &run);

    explicit RunGoals(const Simulation &run, const GoalRules &rules = {});

    /// The quantities of the scene, those of whole probes among them.
    const std::vector<NamedQuantity> &
    quantities() const
    {
      return all;
    }

    const ResultNumbers &
    numbers() const
    {
      return values;
    }

    /// Why @p quantity, a strain or a stress of a probe, has no limit at its
    /// place (lamella::reason_for_no_limit()); empty of all others, of a
    /// measure that of its terms. The mean over a box has one.
    std::string
    reason_for_no_limit(const NamedQuantity &quantity) const;

    /// |value| of @p quantity, or where that is near zero the largest of its
    /// kind, of strains and stresses that in its material
    /// (ResultNumbers::largest_in_material()).
    double
    scale_of(const NamedQuantity &quantity) const;

    /// What the arithmetic leaves open of @p quantity: the last correction of
    /// the displacements, as a share of the largest of its kind,
    /// in whatever material: stresses of all come from the same solution.
    double
    rounding_of(const NamedQuantity &quantity) const;

    /// Returns the goal @p number with @p bar. A goal without a limit is not
    /// checked; a goal that is zero since no contact touches is not met.
    GoalResult
    with_bar(const unsigned int number, const ErrorBar &bar) const;

    /// Name, value, unit, scale and tolerance of the goal @p number, no bar,
    /// and why there cannot be one if it has no limit.
    GoalResult
    bare(const unsigned int number) const;

  private:
    const Simulation          &run;
    GoalRules                  rules;
    ResultNumbers              values;
    std::vector<NamedQuantity> all;
  };
} // namespace lamella

#endif
