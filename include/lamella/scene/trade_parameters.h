// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_trade_parameters_h
#define lamella_scene_trade_parameters_h

#include <lamella/base/entry.h>
#include <lamella/recover/named_quantity.h>

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// One rung of a ladder: a theory, and how much finer than the scene's its
  /// meshes are; or a run to a tolerance, which chooses both.
  struct LadderEntry
  {
    /// As the scene says it: `LE-2, axis 2`.
    std::string name;
    /// `LE-2`, one that Theory::parse() knows; `tolerance 1` of a run to one.
    std::string theory;
    /// Factors on the axis elements and on the section's cells (per direction),
    /// from 0.05 to 20; 1 of a run to a tolerance.
    double axis = 1., section = 1.;
    /// PATH=VALUE each, as of --set. Not checked against the scene yet.
    std::vector<std::string> overrides;
    /// Of a run to a tolerance, as a share of 1 (the scene says it in per
    /// cent): above 0, at most 1.
    std::optional<double> tolerance = {};
  };

  /// What the names in a trade can mean: those of a scene.
  struct TradeNames
  {
    std::vector<std::string> bodies;
    QuantityNames            quantities;
    /// What `Quantities` of Goals names.
    std::vector<NamedQuantity> of_goals = {};
  };

  /// The entries of `subsection Trade`, see `lamella trade`.
  struct TradeParameters
  {
    /// At least two, cheap ones first and the finest last.
    std::vector<LadderEntry> ladder;
    /// Those named; or those that Goals names; or those that the scene gives
    /// References for.
    std::vector<NamedQuantity> quantities;
    /// Probes that Quantities, left empty, asks for without naming columns: the
    /// largest displacement and stress there are taken. None where the
    /// reference is `given`, which has no numbers for them.
    std::vector<std::string> whole_probes;
    /// Names of those whose theory and meshes the ladder changes; all by
    /// default.
    std::vector<std::string> bodies;
    /// What errors are taken against: `finest`, the last rung that succeeds;
    /// `solid`, the last hexahedra that do; `given`, the scene's References; or
    /// the name of a rung.
    std::string reference = "finest";
    /// Relative errors that the last sentences ask for, as shares of 1 (the
    /// scene says them in per cent).
    std::vector<double> tolerances;
    /// Whether each rung makes the error bars of its own values, too. Runs to a
    /// tolerance always do.
    bool error_bars = false;
    /// Processor seconds that a rung may take; 0: as long as it wants.
    double time_limit = 0.;

    /// Declares the entries of `subsection Trade`, which must be entered.
    static void
    declare(dealii::ParameterHandler &prm);
    /// From `subsection Trade`. Throws InputError for a rung that does not
    /// parse, factors of a run to a tolerance among it, a quantity that no
    /// probe, support or contact of @p names gives, and references that are
    /// missing or zero where `given` needs them.
    static TradeParameters
    parse(const Entries &in, const TradeNames &names);
  };
} // namespace lamella

#endif
