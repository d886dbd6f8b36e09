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
  /// Variant of a trade: a theory and refinement factors on the meshes of the
  /// scene, or a run to a tolerance.
  struct TradeVariant
  {
    /// Name in the scene: `LE-2, axis 2`.
    std::string name;
    /// Theory for Theory::parse(); `tolerance 1` for a run to a tolerance.
    std::string theory;
    /// Factors on the numbers of axis elements and of section cells per
    /// direction, 0.05 to 20.
    double axis = 1., section = 1.;
    /// Overrides PATH=VALUE, as in --set; not yet checked against the scene.
    std::vector<std::string> overrides;
    /// Tolerance of a run to one, as a fraction: above 0, at most 1.
    std::optional<double> tolerance = {};
  };

  /// Names of a scene that a trade can use.
  struct TradeNames
  {
    std::vector<std::string> bodies;
    QuantityNames            quantities;
    /// Quantities named by `Quantities` of Goals.
    std::vector<NamedQuantity> of_goals = {};
  };

  /// Entries of `subsection Trade` (`lamella trade`).
  struct TradeParameters
  {
    /// Variants, at least two, from cheap to the finest.
    std::vector<TradeVariant> variants;
    /// Quantities named; by default those of Goals, or those with References.
    std::vector<NamedQuantity> quantities;
    /// Probes in empty Quantities: the largest displacement and stress are
    /// taken there. None with the reference `given`.
    std::vector<std::string> probes_as_goals;
    /// Names of the bodies that the variants change; all by default.
    std::vector<std::string> bodies;
    /// Reference of the errors: `finest`, the last variant that succeeds;
    /// `solid`, the last hexahedra; `given`, the scene's References; or the
    /// name of a variant.
    std::string reference = "finest";
    /// Relative errors for the closing sentences, as fractions.
    std::vector<double> tolerances;
    /// True if each variant has error bars; runs to a tolerance always have.
    bool error_bars = false;
    /// Largest processor seconds of a variant; 0: no limit.
    double time_limit = 0.;

    /// Declares the entries of `subsection Trade`, which must be entered.
    static void
    declare(dealii::ParameterHandler &prm);
    /// Returns the entries of `subsection Trade`. Throws InputError for invalid
    /// variants, for quantities that no probe, support or contact of @p names
    /// gives, and for references that are missing or zero if `given` needs
    /// them.
    static TradeParameters
    parse(const Entries &in, const TradeNames &names);
  };
} // namespace lamella

#endif
