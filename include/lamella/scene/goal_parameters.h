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
  /// Options for error bars (error estimates) of the goals of a run.
  enum class ErrorBars
  {
    undefined,
    automatic, ///< if they cost at most half of the run
    always,
    richer, ///< always, by comparison with finer models
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

  /// Entries of `subsection Goals`: the quantities of interest of a run, with
  /// the tolerances of their errors.
  struct GoalParameters
  {
    /// The goals; by default quantities with References or named in Trade.
    std::vector<NamedQuantity> quantities;
    /// Probes; without `quantities`, the largest displacement and the largest
    /// stress among these probes are the goals.
    std::vector<std::string> probes_as_goals;
    /// Tolerance of the error of each goal, or one for all; may be empty.
    std::vector<Tolerance> tolerances;
    ErrorBars              bars = ErrorBars::undefined;
    /// Limits of DoFs and of time [s] of a run to a tolerance; 0: no limit.
    unsigned int budget_dofs    = 0;
    double       budget_seconds = 0.;
    /// True if the scene sets no Theory; a run to a tolerance then chooses it.
    bool theory_is_default = false;
    /// Names of the bodies for which the scene sets no number of axis elements.
    std::set<std::string> axes_are_default;

    /// Declares the entries in @p prm, which must be in `subsection Goals`.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the entries of `subsection Goals`. @p of_trade are the
    /// quantities named in `subsection Trade`. Throws InputError for
    /// - a quantity not in @p names;
    /// - a tolerance outside of 1e-6 to 100 per cent, or in another unit than
    ///   its quantity has by @p units;
    /// - one absolute tolerance for quantities of different units;
    /// - a number of tolerances other than one or the number of goals.
    static GoalParameters
    parse(const Entries                    &in,
          const QuantityNames              &names,
          const std::vector<NamedQuantity> &of_trade,
          const Units                      &units);
  };
} // namespace lamella

#endif
