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
  /// Modes of the error estimation of goals.
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

  /// Entries of `subsection Goals`: the numbers that a run is made for.
  struct GoalParameters
  {
    /// Quantities named; by default those with References or named by Trade.
    std::vector<NamedQuantity> quantities;
    /// Probes whose largest displacement and stress are the goals by default.
    std::vector<std::string> probes_as_goals;
    /// Tolerance of each quantity, or one for all; empty if there is none.
    std::vector<Tolerance> tolerances;
    ErrorBars              bars = ErrorBars::undefined;
    /// Limits of a run to a tolerance; 0: none.
    unsigned int budget_dofs    = 0;
    double       budget_seconds = 0.;
    /// True if the scene sets no Theory, so that a run to a tolerance chooses.
    bool theory_is_default = false;
    /// Names of the bodies whose axis elements the scene leaves open.
    std::set<std::string> axes_are_default;

    /// Declares the entries in `subsection Goals`, which must be entered.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the entries of `subsection Goals`. @p of_trade are the
    /// quantities that a trade names. Throws InputError for a quantity not in
    /// @p names; a tolerance that is not above 0 and at most 100 per cent, or
    /// is below 1e-6 per cent; a tolerance in another unit than @p units gives
    /// its quantity; a tolerance that is not in per cent for quantities without
    /// a common unit; and a wrong number of tolerances.
    static GoalParameters
    parse(const Entries                    &in,
          const QuantityNames              &names,
          const std::vector<NamedQuantity> &of_trade,
          const Units                      &units);
  };
} // namespace lamella

#endif
