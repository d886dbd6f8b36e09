// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/patterns.h>
#include <lamella/scene/goal_parameters.h>

namespace lamella
{
  using dealii::ParameterHandler;
  using dealii::Patterns::Anything;

  void
  GoalParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry(
      "Quantities",
      "",
      Anything(),
      "The numbers that the run is made for, between '|': PROBE: COLUMN (of "
      "probes.csv; PROBE/PLY on an interface), SUPPORT: fx (fy, fz, mx, my, "
      "mz), CONTACT: fx (and so on, pressure, width, width x), or of a strip "
      "of a contact CONTACT: fx in AXIS FROM TO, as in roller: fz in y 40 60. "
      "By default those of Trade, else what the scene gives References for, "
      "and of probes without any the largest displacement and stress.");
    prm.declare_entry("Tolerance",
                      "",
                      patterns::numbers(),
                      "In per cent of the value (of the largest of its kind "
                      "in the scene where it is below a thousandth of that), "
                      "one for all quantities or one each: the "
                      "run refines its theory and its meshes until all errors "
                      "are estimated to be below. Empty: what the scene says "
                      "is run, and nothing else.");
    prm.declare_entry("Error bars",
                      name_of(ErrorBars::automatic),
                      selection<ErrorBars>(),
                      "Whether errors are estimated: true, auto where that is "
                      "cheap, by what the run itself has if it can, else by "
                      "richer models of the scene; richer: by these.");
    prm.declare_entry("Budget DoFs",
                      "0",
                      patterns::number(),
                      "Of a run to a Tolerance: the largest model that it may "
                      "solve; 0: any.");
    prm.declare_entry("Budget seconds",
                      "0",
                      patterns::number(),
                      "Of a run to a Tolerance: no new model is begun after "
                      "that many seconds; 0: never mind.");
  }



  namespace
  {
    /// As shares of 1, one for each of @p n quantities or one for all.
    std::vector<double>
    parse_tolerances(const Entry &entry, const unsigned int n)
    {
      // The floor of every bar (error_bar.h), in per cent.
      constexpr double    of_rounding = 1e-6;
      std::vector<double> tolerances;
      for (const double per_cent : entry.numbers())
        {
          if (!(per_cent > 0. && per_cent <= 100.))
            entry.refuse("must be more than 0 and at most 100 per cent");
          if (per_cent < of_rounding)
            entry.refuse("is below what the arithmetic leaves of any number, "
                         "1e-6 per cent",
                         "Give 1e-6 or more; 0.1 is a small tolerance.");
          tolerances.push_back(per_cent / 100.);
        }
      if (tolerances.size() > 1 && tolerances.size() != n)
        entry.refuse("there are " + std::to_string(n) + " quantities and " +
                       std::to_string(tolerances.size()) + " tolerances",
                     "Give one for all, or one for each in Quantities.");
      return tolerances;
    }



    /// From 0 to @p most.
    double
    parse_budget(const Entry &entry, const double most)
    {
      const double value = entry.number();
      if (!(value >= 0. && value <= most))
        entry.refuse("must be 0 (none) or more, at most " + to_text(most));
      return value;
    }
  } // namespace



  GoalParameters
  GoalParameters::parse(const Entries                    &in,
                        const QuantityNames              &names,
                        const std::vector<NamedQuantity> &of_trade)
  {
    GoalParameters goals;
    const Entry    quantities = in["Quantities"];
    goals.quantities          = parse_quantities(quantities, names);
    goals.tolerances =
      parse_tolerances(in["Tolerance"], goals.quantities.size());
    if (goals.quantities.empty())
      goals.quantities = of_trade;
    if (goals.quantities.empty())
      goals.quantities = quantities_with_references(names, goals.whole_probes);

    goals.bars           = in["Error bars"].choice<ErrorBars>();
    goals.budget_dofs    = parse_budget(in["Budget DoFs"], 1e9);
    goals.budget_seconds = parse_budget(in["Budget seconds"], 1e9);
    if (goals.tolerances.empty())
      {
        for (const char *budget : {"Budget DoFs", "Budget seconds"})
          if (in[budget].number() > 0.)
            in[budget].refuse("there is no Tolerance to reach within it",
                              "Give one, or leave out the budget.");
      }
    else
      {
        if (goals.bars == ErrorBars::never)
          in["Error bars"].refuse("a Tolerance cannot be reached without them",
                                  "Leave it at auto.");
        if (goals.quantities.empty() && goals.whole_probes.empty())
          in["Tolerance"].refuse("there is nothing to be accurate in, since "
                                 "the scene has neither probes nor References "
                                 "of supports and contacts",
                                 "Add a probe, or name Quantities.");
        goals.bars = ErrorBars::always;
      }
    return goals;
  }
} // namespace lamella
