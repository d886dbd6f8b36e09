// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_goal_parameters_h
#define lamella_scene_goal_parameters_h

#include <lamella/base/entry.h>
#include <lamella/base/names.h>
#include <lamella/base/units.h>
#include <lamella/recover/goal_result.h>
#include <lamella/recover/named_quantity.h>

#include <deal.II/base/parameter_handler.h>

#include <set>
#include <string>
#include <vector>

namespace lamella
{
  /// Whether a run estimates the errors of its goals.
  enum class ErrorBars
  {
    undefined,
    automatic, ///< where that costs at most half of what the run does
    always,
    richer, ///< always, from richer models
    never
  };

  template <>
  struct Names<ErrorBars>
  {
    static constexpr NameOf<ErrorBars> all[] = {{ErrorBars::automatic, "auto"},
                                                {ErrorBars::always, "true"},
                                                {ErrorBars::richer, "richer"},
                                                {ErrorBars::never, "false"}};
  };

  /// The entries of `subsection Goals`: the numbers that a run is made for.
  struct GoalParameters
  {
    /// Those named; else those that the scene gives References for, or that
    /// its Trade names.
    std::vector<NamedQuantity> quantities;
    /// Probes of which, where nothing is named, the largest displacement and
    /// stress are taken.
    std::vector<std::string> whole_probes;
    /// Of each quantity, or one for all. Empty: none is asked for.
    std::vector<Tolerance> tolerances;
    ErrorBars              bars = ErrorBars::undefined;
    /// What a run to a tolerance may take; 0: what it wants.
    unsigned int budget_dofs    = 0;
    double       budget_seconds = 0.;
    /// Whether the scene says nothing of its Theory, so that a run to a
    /// tolerance may begin with what suits it.
    bool theory_is_assumed = false;
    /// Names of the bodies whose axis elements the scene leaves open.
    std::set<std::string> axes_are_assumed;

    /// Declares them in `subsection Goals`, which must be entered.
    static void
    declare(dealii::ParameterHandler &prm);

    /// From `subsection Goals`. @p of_trade are the quantities that a trade
    /// names. Throws InputError for a quantity that nothing of @p names gives,
    /// a tolerance that is not above 0 and at most 100 per cent or below
    /// 1e-6 per cent, the least that a bar can be (error_bar.h), one with
    /// another unit than @p units label its quantity with, one without per
    /// cent for quantities that have no unit in common, and another number of
    /// them than one or one for each quantity.
    static GoalParameters
    parse(const Entries                    &in,
          const QuantityNames              &names,
          const std::vector<NamedQuantity> &of_trade,
          const Units                      &units);
  };
} // namespace lamella

#endif
