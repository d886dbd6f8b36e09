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
  /// Variant of a trade (comparison of cost and accuracy): a theory with
  /// refinement factors of the meshes of the scene, or a run to a tolerance.
  struct TradeVariant
  {
    /// Name in the scene file, such as `LE-2, axis 2`.
    std::string name;
    /// Theory as in a scene file; `tolerance 1` for a run to 1 % error.
    std::string theory;
    /// Factors, 0.05 to 20, that multiply the scene's number of axis elements
    /// and of section cells per direction.
    double axis = 1., section = 1.;
    /// Changes of entries, PATH=VALUE as in the option --set.
    std::vector<std::string> overrides;
    /// Error tolerance (fraction of the value) of a run to a tolerance: above
    /// 0, at most 1; empty for other variants.
    std::optional<double> tolerance = {};
  };

  /// Names of the scene's bodies and quantities to which a trade can refer.
  struct TradeNames
  {
    std::vector<std::string> bodies;
    QuantityNames            quantities;
    /// Quantities named in `subsection Goals`.
    std::vector<NamedQuantity> of_goals = {};
  };

  /// Entries of `subsection Trade`: variants of a scene (theories and meshes)
  /// whose cost and accuracy `lamella trade` compares.
  struct TradeParameters
  {
    /// Variants, at least two, from the cheapest to the finest.
    std::vector<TradeVariant> variants;
    /// Compared quantities; by default those of Goals or with References.
    std::vector<NamedQuantity> quantities;
    /// Probes. If `quantities` is empty, the largest displacement and stress
    /// among these are compared. Empty if the reference is `given`.
    std::vector<std::string> probes_as_goals;
    /// Names of the bodies whose theory and mesh the variants change; by
    /// default all bodies.
    std::vector<std::string> bodies;
    /// Reference solution for errors: `finest`, the last variant that succeeds;
    /// `solid`, the last variant of hexahedra; `given`, the References of the
    /// scene; or the name of a variant.
    std::string reference = "finest";
    /// Relative errors (fractions); for each of them the report names the
    /// cheapest variant whose errors are below it.
    std::vector<double> tolerances;
    /// True if error bars are computed for each variant; runs to a tolerance
    /// always compute error bars.
    bool error_bars = false;
    /// Limit of the processor time of a variant [s]; 0: no limit.
    double time_limit = 0.;

    /// Declares the entries in @p prm, which must be in `subsection Trade`.
    static void
    declare(dealii::ParameterHandler &prm);
    /// Returns the entries of `subsection Trade`. Throws InputError for invalid
    /// variants, for quantities that are not in @p names, and for missing or
    /// zero reference values if the reference is `given`.
    static TradeParameters
    parse(const Entries &in, const TradeNames &names);
  };
} // namespace lamella

#endif
