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
  /// Goals of a solved run: values and reference sizes of errors.
  class RunGoals
  {
  public:
    /// Returns why no goals of @p run need bars; empty if some do.
    static std::string
    unavailable_reason(const Simulation &run);

    /// Returns whether @p run has contacts and none is active in its last step.
    static bool
    has_no_active_contact(const Simulation &run);

    explicit RunGoals(const Simulation &run, const GoalRules &rules = {});

    /// Returns the quantities of the scene, including those of whole probes.
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

    /// Returns why @p quantity, a strain or stress of a probe or a measure of
    /// such, has no limit at its place; empty for all others and for boxes.
    std::string
    singularity_reason(const NamedQuantity &quantity) const;

    /// Returns |value| of @p quantity, or if it is near zero the largest of its
    /// kind (of its material: ResultNumbers::largest_in_material()).
    double
    scale_of(const NamedQuantity &quantity) const;

    /// Returns the rounding error of @p quantity: the relative last correction
    /// of displacements times the largest value of its kind.
    double
    rounding_of(const NamedQuantity &quantity) const;

    /// Returns the goal @p number with @p bar. A goal without a limit is not
    /// checked; one that is zero without contact is not met.
    GoalResult
    with_error_bar(const unsigned int number, const ErrorBar &bar) const;

    /// Returns the goal @p number without a bar, with the reason if unlimited.
    GoalResult
    without_error_bar(const unsigned int number) const;

  private:
    const Simulation          &run;
    GoalRules                  rules;
    ResultNumbers              values;
    std::vector<NamedQuantity> all;
  };
} // namespace lamella

#endif
