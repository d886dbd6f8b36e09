// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_run_goals_h
#define lamella_estimate_run_goals_h

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

    explicit RunGoals(const Simulation &run);

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

    /// |value| of @p quantity, or the largest of its kind where that is near
    /// zero.
    double
    scale_of(const NamedQuantity &quantity) const;

    /// What the arithmetic leaves open of @p quantity: the last correction of
    /// the displacements, as a share of the largest of its kind.
    double
    rounding_of(const NamedQuantity &quantity) const;

    /// Name, value, scale and tolerance of the goal @p number, no bar.
    GoalResult
    bare(const unsigned int number) const;

  private:
    const Simulation          &run;
    ResultNumbers              values;
    std::vector<NamedQuantity> all;
  };
} // namespace lamella

#endif
