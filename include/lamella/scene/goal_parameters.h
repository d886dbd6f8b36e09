// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_goal_parameters_h
#define lamella_scene_goal_parameters_h

#include <lamella/base/entry.h>
#include <lamella/base/names.h>
#include <lamella/base/units.h>
#include <lamella/recover/goal_result.h>
#include <lamella/recover/named_quantity.h>

#include <deal.II/base/parameter_handler.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace lamella
{
  /// Choice whether error bounds of the goals are computed in a run.
  enum class ErrorBars
  {
    undefined, ///< not read yet
    automatic, ///< yes, if they take at most half of the time of the run
    always,    ///< yes, at any cost
    richer,    ///< yes, at any cost, by comparison with finer models
    never      ///< no
  };

  /// Names of the values of ErrorBars in scene files.
  template <>
  struct Names<ErrorBars>
  {
    /// Value and name of each choice; `undefined` has no name.
    static constexpr NameOf<ErrorBars> all[] = {{ErrorBars::automatic, "auto"},
                                                {ErrorBars::always, "true"},
                                                {ErrorBars::richer, "richer"},
                                                {ErrorBars::never, "false"}};
  };

  /// Entries of `subsection Goals`: the quantities of interest of a run, with
  /// the tolerances of their errors.
  struct GoalParameters
  {
    /// The goals: entry `Quantities`; if it is empty, the quantities named in
    /// `subsection Trade`; if there are none, those with reference values.
    std::vector<NamedQuantity> quantities;
    /// Names of probes. If `quantities` is empty, the goals are the largest
    /// displacement and the largest stress among these probes.
    std::vector<std::string> probes_as_goals;
    /// True if all modes of `Find` are goals too.
    bool modes_as_goals = false;
    /// Tolerance of the error of each goal, or one for all; empty if not set.
    std::vector<Tolerance> tolerances;
    ErrorBars              bars = ErrorBars::undefined; ///< Entry `Error bars`.
    /// Largest number of DoFs of a run that meets tolerances; 0: unlimited.
    unsigned int budget_dofs    = 0;
    double       budget_seconds = 0.; ///< Longest run [s]; 0: unlimited.
    /// True if a run to a tolerance may choose the theory (`Theory` not set).
    bool theory_is_default = false;
    /// Names of the bodies whose number of axis elements is not in the scene,
    /// but is chosen in a run with a tolerance.
    std::set<std::string> axes_are_default;

    /// Returns true if there are any goals.
    bool
    any() const
    {
      return !quantities.empty() || !probes_as_goals.empty() || modes_as_goals;
    }

    /// Declares the entries in @p prm, which must be in `subsection Goals`.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the goals from the entries @p in of `subsection Goals`, with the
    /// quantities @p of_trade of `subsection Trade`. Throws InputError for
    /// - a quantity that is not in @p names;
    /// - a tolerance outside of 1e-6 to 100 per cent, or in a unit that differs
    ///   from the unit of its quantity in @p units;
    /// - one absolute tolerance for quantities of different units;
    /// - a number of tolerances other than one or the number of goals.
    static GoalParameters
    parse(const Entries                    &in,
          const QuantityNames              &names,
          const std::vector<NamedQuantity> &of_trade,
          const Units                      &units);
  };

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
