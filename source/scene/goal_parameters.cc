// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/patterns.h>
#include <lamella/scene/goal_parameters.h>

namespace lamella
{
  using dealii::ParameterHandler;
  using dealii::Patterns::Anything;

  namespace
  {
    void
    declare_budgets(ParameterHandler &prm)
    {
      prm.declare_entry("Budget DoFs",
                        "0",
                        patterns::number(),
                        "With Tolerance: largest number of DoFs; 0: any.");
      prm.declare_entry("Budget seconds",
                        "0",
                        patterns::number(),
                        "For a run with a Tolerance: time in seconds from the "
                        "start of the run; a refinement pass that is predicted "
                        "to end later is not begun. 0: no limit.");
    }



    /// Returns @p per_cent, given in a piece of @p entry, as a fraction.
    double
    share_of_one(const Entry &entry, const double per_cent)
    {
      // Shortest bar (error_bar.h), in per cent.
      constexpr double of_rounding = 1e-6;
      if (!(per_cent > 0. && per_cent <= 100.))
        entry.refuse("scene.invalid-per-cent: the tolerance must be more than "
                     "0 and at most 100 per cent, for example 1");
      if (per_cent < of_rounding)
        entry.refuse("scene.tolerance-below-rounding: the tolerance is less "
                     "than 1e-6 per cent, which rounding errors do not allow",
                     "Write at least 1e-6; a usual small tolerance is 0.1.");
      return per_cent / 100.;
    }



    /// Throws InputError unless all @p quantities are in @p unit, given in a
    /// piece of @p entry, or for `abs` of one kind.
    void
    check_unit(const Entry                      &entry,
               const std::string                &unit,
               const std::vector<NamedQuantity> &quantities,
               const Units                      &units)
    {
      for (const NamedQuantity &quantity : quantities)
        {
          const std::string label = "'" + quantity.label() + "'",
                            own   = quantity.unit(units);
          if (unit != "abs" && unit != own)
            entry.refuse(
              "scene.wrong-unit: the tolerance is in '" + unit +
                "', but the unit of " + label + " is " +
                (own.empty() ? "none" : own),
              "Write a number alone for a relative tolerance in per cent, or "
              "an absolute tolerance with a unit, for example 0.5 " +
                (own.empty() ? "abs" : own + " or 0.5 abs") + ".");
          if (unit == "abs" && quantity.kind() != quantities[0].kind())
            entry.refuse("scene.mixed-units: '" + quantities[0].label() +
                           "' and " + label +
                           " are quantities of different kinds, so one "
                           "tolerance with a unit cannot apply to both",
                         "Write one tolerance per quantity, or per cent.");
        }
    }



    /// Returns the tolerance that @p piece of @p entry gives for @p quantities
    /// of @p goals: in per cent, in their unit, or with `abs`.
    Tolerance
    parse_tolerance(const Entry                      &entry,
                    const std::string                &piece,
                    const std::vector<NamedQuantity> &quantities,
                    const GoalParameters             &goals,
                    const Units                      &units)
    {
      std::size_t end = piece.find_first_not_of("+-.0123456789eE");
      if (end == 0)
        end = std::string::npos;
      const double      number = entry.number(trimmed(piece.substr(0, end)));
      const std::string unit =
        end == std::string::npos ? "" : trimmed(piece.substr(end));
      if (unit.empty() || unit == "%")
        return {share_of_one(entry, number), false};
      if (!(number > 0.))
        entry.refuse("entry.not-positive: the tolerance must be more than 0");
      if (!goals.probes_as_goals.empty() || goals.modes_as_goals)
        entry.refuse("scene.mixed-units: the displacements and stresses of "
                     "probes, and modes, cannot have one tolerance with a unit",
                     "Write Quantities, or a tolerance in per cent.");
      check_unit(entry, unit, quantities, units);
      return {number, true};
    }



    /// Returns one tolerance per quantity of @p goals (@p n), or one for all.
    std::vector<Tolerance>
    parse_tolerances(const Entry          &entry,
                     const unsigned int    n,
                     const GoalParameters &goals,
                     const Units          &units)
    {
      if (entry.text().find_first_of("|;") != std::string::npos)
        entry.refuse(
          "scene.tolerance-separator: tolerances are separated by commas",
          "Write, for example, 1, 0.5 MPa.");
      const std::vector<std::string> pieces = entry.items();
      const bool                     is_one = pieces.size() <= 1;
      if (!is_one && pieces.size() != n)
        entry.refuse(
          "scene.tolerance-count: there are " + std::to_string(n) +
            " quantities and " + std::to_string(pieces.size()) + " tolerances",
          "Write one tolerance for all Quantities, or one for each.");
      std::vector<Tolerance> tolerances;
      for (const std::string &piece : pieces)
        tolerances.push_back(
          parse_tolerance(entry,
                          piece,
                          is_one ? goals.quantities :
                                   std::vector<NamedQuantity>{
                                     goals.quantities[tolerances.size()]},
                          goals,
                          units));
      return tolerances;
    }



    /// Returns the budget of @p entry, from 0 to @p most.
    double
    parse_budget(const Entry &entry, const double most)
    {
      const double value = entry.number();
      if (!(value >= 0. && value <= most))
        entry.refuse(
          "scene.budget-out-of-range: the budget must lie between 0 and " +
          to_text(most) + " (0 for no limit)");
      return value;
    }



    void
    check_no_budget(const Entries &in)
    {
      for (const char *budget : {"Budget DoFs", "Budget seconds"})
        if (in[budget].number() > 0.)
          in[budget].refuse(
            "scene.budget-without-tolerance: a budget limits a run that "
            "refines until a Tolerance is met, but Tolerance is empty",
            "Write Tolerance, as in Tolerance = 1, or remove this budget.");
    }



    void
    check_tolerance(const Entries &in, const GoalParameters &goals)
    {
      if (goals.bars == ErrorBars::never)
        in["Error bars"].refuse(
          "scene.tolerance-without-bars: a run with a Tolerance needs error "
          "estimates, but Error bars = false",
          "Write Error bars = auto, or remove Tolerance.");
      if (!goals.any())
        in["Tolerance"].refuse(
          "scene.no-goals: the Tolerance applies to no quantity: the scene "
          "has no probe, and no support or contact has values in References",
          "Add a Probe, or list quantities in Quantities of subsection Goals.");
    }
  } // namespace



  void
  GoalParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry(
      "Quantities",
      "",
      Anything(),
      "Quantities of interest, with '|' between: PROBE: COLUMN (of probes.csv; "
      "PROBE/PLY on an interface), SUPPORT: fx (fy, fz, mx, my, mz), CONTACT: "
      "fx (and so on, pressure, width, width x, dissipated), or of a strip of "
      "a contact CONTACT: fx in AXIS FROM TO, as in roller: fz in y 40 60; of "
      "Find, mode-3: frequency and buckling-1: factor. Empty: those of Trade, "
      "else all with References, for probes without References the largest "
      "displacement and stress, and all modes if none has Mode references.");
    prm.declare_entry(
      "Tolerance",
      "",
      Anything(),
      "Largest accepted error, one value for all Quantities or one for each, "
      "with commas between: in per cent of the value (1 or 1 %), or in the "
      "unit of the quantity (0.5 MPa, 0.01 mm; 1e-6 abs without a unit). "
      "Values below a thousandth of the largest of their kind in the scene "
      "(strains and stresses: in the material) count as that largest value. "
      "The run refines theory and meshes until all estimated errors are "
      "smaller. Empty: no refinement.");
    prm.declare_entry("Error bars",
                      name_of(ErrorBars::automatic),
                      selection<ErrorBars>(),
                      "Error estimates. auto: where they are cheap, by coarser "
                      "models or half of the axis elements; true: always; "
                      "richer: by finer models. With Rotations = large only "
                      "true estimates errors, by half of the axis elements.");
    declare_budgets(prm);
  }



  GoalParameters
  GoalParameters::parse(const Entries                    &in,
                        const QuantityNames              &names,
                        const std::vector<NamedQuantity> &of_trade,
                        const Units                      &units)
  {
    GoalParameters goals;
    const Entry    quantities  = in["Quantities"];
    goals.quantities           = parse_quantities(quantities, names);
    const unsigned int n_named = goals.quantities.size();
    if (goals.quantities.empty())
      goals.quantities = of_trade;
    if (goals.quantities.empty())
      {
        goals.quantities =
          quantities_with_references(names, goals.probes_as_goals);
        goals.modes_as_goals =
          !names.modes.empty() &&
          std::none_of(goals.quantities.begin(),
                       goals.quantities.end(),
                       [](const NamedQuantity &quantity) {
                         return quantity.of == NamedQuantity::ObjectKind::mode;
                       });
      }
    goals.tolerances = parse_tolerances(in["Tolerance"], n_named, goals, units);

    goals.bars           = in["Error bars"].choice<ErrorBars>();
    goals.budget_dofs    = parse_budget(in["Budget DoFs"], 1e9);
    goals.budget_seconds = parse_budget(in["Budget seconds"], 1e9);
    if (goals.tolerances.empty())
      check_no_budget(in);
    else
      {
        check_tolerance(in, goals);
        if (goals.bars == ErrorBars::automatic)
          goals.bars = ErrorBars::always;
      }
    return goals;
  }
} // namespace lamella
