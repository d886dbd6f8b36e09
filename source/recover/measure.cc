// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/recover/measure.h>

#include <algorithm>

namespace lamella
{
  using dealii::ParameterHandler;
  using dealii::Patterns::Anything;

  void
  MeasureParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry(
      "Difference",
      "",
      Anything(),
      "Difference of two results of probes, PROBE: COLUMN - PROBE: COLUMN, as "
      "in tip: uz - root: uz. Columns are those of probes.csv and of one kind; "
      "PROBE/PLY for a point on a ply interface.");
    prm.declare_entry("Divided by",
                      "1",
                      Anything(),
                      "Divisor of the difference: a number, or distance, the "
                      "initial distance of the two probes [length].");
    prm.declare_entry("References",
                      "",
                      Anything(),
                      "Reference values to print beside the result, value: "
                      "NUMBER: source, with '|' between.");
  }



  namespace
  {
    const std::string difference = " - ";



    /// Returns the two sides of the only minus between blanks.
    std::vector<Entry>
    sides_of(const Entry &entry)
    {
      if (entry.is_empty())
        entry.refuse_missing(
          "recover.difference-missing: write the difference of two results, "
          "PROBE: COLUMN - PROBE: COLUMN, as in tip: uz - root: uz.");
      const std::string &text  = entry.text();
      const auto         minus = text.find(difference);
      if (minus == std::string::npos ||
          text.find(difference, minus + 1) != std::string::npos)
        entry.refuse(
          "recover.difference-syntax: write two results of probes with one "
          "minus sign between blanks, as in tip: uz - root: uz");
      return {Entry(entry.path(), trimmed(text.substr(0, minus))),
              Entry(entry.path(),
                    trimmed(text.substr(minus + difference.size())))};
    }



    /// Returns the divisor in @p entry; @p distance is between the probes.
    double
    parse_over(const Entry &entry, const double distance)
    {
      if (entry.text() == "distance")
        {
          if (distance == 0.)
            entry.refuse(
              "recover.same-point: Divided by = distance needs two probes at "
              "different points, but both are at the same point",
              "Move one of the probes (At), or write a number in Divided by.");
          return distance;
        }
      const double over = entry.number();
      if (over == 0.)
        entry.refuse("recover.zero-divisor: the difference is divided by this "
                     "number, so the number must not be zero",
                     "Write a number such as 1 in Divided by, or distance.");
      return over;
    }
  } // namespace



  Measure
  MeasureParameters::parse(const Entries            &in,
                           const std::string        &name,
                           const std::vector<Probe> &probes)
  {
    const Entry   of = in["Difference"];
    NamedQuantity quantity;
    quantity.of     = NamedQuantity::ObjectKind::measure;
    quantity.name   = name;
    quantity.column = "value";
    quantity.path   = of.path();
    std::vector<dealii::Point<3>> places;
    for (const Entry &side : sides_of(of))
      {
        const NamedQuantity term = parse_probe_quantity(side, probes);
        for (const Probe &probe : probes)
          if (probe.name == term.name)
            places.push_back(probe.position);
        quantity.terms.push_back(term);
      }
    const NamedQuantity &a = quantity.terms[0], &b = quantity.terms[1];
    if (a.kind() != b.kind())
      of.refuse("recover.kinds-differ: " + a.column + " and " + b.column +
                  " are of different kinds and cannot be subtracted",
                "Name two displacements, two strains or two stresses.");
    if (a.label() == b.label())
      of.refuse("recover.same-column: a quantity minus itself is always zero",
                "Name two different probes, or two different columns.");
    quantity.over =
      parse_over(in["Divided by"], places.front().distance(places.back()));
    quantity.keeps_unit =
      quantity.over == 1. && in["Divided by"].text() != "distance";
    const std::vector<Reference> references =
      parse_references(in["References"], {quantity.column});
    if (!references.empty())
      quantity.given = references.front().value;
    return {name, quantity, references};
  }



  void
  check_names_of_measures(const QuantityNames &names)
  {
    for (const Measure &measure : names.measures)
      {
        const auto refuse = [&measure](const std::string &kind) {
          Entry("Measures", measure.name)
            .refuse("recover.ambiguous-name: '" + measure.name +
                      "' is the name of both a Measure and a " + kind,
                    "Rename one of the two.");
        };
        if (std::any_of(names.probes.begin(),
                        names.probes.end(),
                        [&measure](const Probe &probe) {
                          return probe.name == measure.name;
                        }))
          refuse("probe");
        if (names.supports.count(measure.name) > 0)
          refuse("support");
        if (names.contacts.count(measure.name) > 0)
          refuse("contact");
      }
  }
} // namespace lamella
