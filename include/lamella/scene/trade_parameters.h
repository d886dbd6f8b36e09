// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_trade_parameters_h
#define lamella_scene_trade_parameters_h

#include <lamella/base/entry.h>
#include <lamella/recover/named_quantity.h>

#include <deal.II/base/parameter_handler.h>

#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// A variant of the scene for `lamella trade`, the comparison of cost and
  /// accuracy: a theory with factors of mesh refinement, or a run that refines
  /// the model to an error tolerance.
  struct TradeVariant
  {
    /// Name in the scene file, such as `LE-2, axis 2`.
    std::string name;
    /// Theory as in a scene file, or `tolerance 1` for refinement to 1 % error.
    std::string theory;
    double axis = 1., ///< Factor on the number of axis elements, 0.05 to 20.
      section   = 1.; ///< Factor on the number of section cells, 0.05 to 20.
    /// Changes of entries, PATH=VALUE as in the option --set.
    std::vector<std::string> overrides;
    /// Error tolerance as a fraction of the value, above 0 and at most 1, of a
    /// run that refines the model; empty for other variants.
    std::optional<double> tolerance = {};
  };

  /// Names in the scene to which entries of `subsection Trade` can refer.
  struct TradeNames
  {
    std::vector<std::string> bodies;     ///< Names of bodies.
    QuantityNames            quantities; ///< Names of quantities.
    /// Quantities named in `subsection Goals`.
    std::vector<NamedQuantity> of_goals = {};
  };

  /// Entries of `subsection Trade`: the variants of a scene (theories and
  /// meshes) whose cost and accuracy `lamella trade` compares.
  struct TradeParameters
  {
    /// At least two variants, from the cheapest to the most accurate.
    std::vector<TradeVariant> variants;
    /// Compared quantities; by default the goals or those with References.
    std::vector<NamedQuantity> quantities;
    /// Names of probes. If `quantities` is empty, the largest displacement and
    /// stress among them are compared. Empty if the reference is `given`.
    std::vector<std::string> probes_as_goals;
    /// Names of bodies with theory and mesh of the variant; by default all.
    std::vector<std::string> bodies;
    /// Solution from which errors are computed: `finest`, the last variant that
    /// succeeds; `solid`, the last variant of hexahedra; `given`, the reference
    /// values of the scene; or the name of a variant.
    std::string reference = "finest";
    /// Relative errors (fractions). The report names for each of them the
    /// cheapest variant with smaller errors.
    std::vector<double> tolerances;
    /// True if error bounds are computed for each variant; variants with a
    /// tolerance always have error bounds.
    bool error_bars = false;
    /// Largest processor time of a variant [s]; zero means unlimited.
    double time_limit = 0.;

    /// Declares the entries in @p prm, which must be in `subsection Trade`.
    static void
    declare(dealii::ParameterHandler &prm);
    /// Returns the entries @p in of `subsection Trade`. Throws InputError for
    /// invalid variants, quantities that are not in @p names, and missing or
    /// zero reference values if the reference is `given`.
    static TradeParameters
    parse(const Entries &in, const TradeNames &names);
  };
} // namespace lamella

#endif
