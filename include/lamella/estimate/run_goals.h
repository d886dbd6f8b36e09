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
  /// Goals (output quantities) of a run: values, scales and rounding errors.
  class RunGoals
  {
  public:
    /// Returns why no goal of @p run needs an error bar; empty if one does.
    static std::string
    unavailable_reason(const Simulation &run);

    /// Returns true if @p run has contacts and none is active in its last step.
    static bool
    has_no_active_contact(const Simulation &run);

    /// Evaluates the goals at the last load step. Keeps a reference to @p run.
    explicit RunGoals(const Simulation &run, const GoalRules &rules = {});

    /// Returns the goals of the input file, including all columns of probes.
    const std::vector<NamedQuantity> &
    quantities() const
    {
      return all;
    }

    /// Returns the numerical results of the last load step.
    const ResultNumbers &
    numbers() const
    {
      return values;
    }

    /// Returns why @p quantity, a strain or stress at a probe, is singular
    /// there. Empty if it is not singular, or averaged over a box.
    std::string
    singularity_reason(const NamedQuantity &quantity) const;

    /// Returns the reference value of relative errors of @p quantity: |value|,
    /// or if this is near zero the largest value of its kind in its material
    /// (ResultNumbers::largest_in_material()).
    double
    scale_of(const NamedQuantity &quantity) const;

    /// Returns an estimate of the rounding error of @p quantity: the last
    /// relative correction of the displacements times the largest absolute
    /// value of all quantities of the same type (displacement, strain, stress,
    /// force).
    double
    rounding_of(const NamedQuantity &quantity) const;

    /// Returns the result of goal @p number with the error bar @p bar. A goal
    /// at a singularity is not compared with its tolerance. A goal that is zero
    /// because no contact is active does not meet its tolerance.
    GoalResult
    with_error_bar(const unsigned int number, const ErrorBar &bar) const;

    /// Returns the result of goal @p number without an error bar. If the goal
    /// is at a singularity, the result states this as the reason.
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
