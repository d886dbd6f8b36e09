// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/patterns.h>
#include <lamella/body/fields.h>
#include <lamella/conditions/parameters.h>
#include <lamella/recover/named_quantity.h>
#include <lamella/recover/requests.h>

#include <algorithm>

namespace lamella
{
  using dealii::ParameterHandler;
  using dealii::Patterns::Anything;

  std::vector<Reference>
  parse_references(const Entry                    &entry,
                   const std::vector<std::string> &quantities)
  {
    std::vector<Reference> references;
    for (const std::string &piece : entry.items('|'))
      {
        const auto parts = split(piece, ':');
        if (parts.size() < 3)
          entry.refuse(
            "recover.reference-syntax: '" + piece +
            "' is not a reference value. Write quantity: value: source, and "
            "'|' between references, as in uz: 0.012: Euler beam");
        if (std::find(quantities.begin(), quantities.end(), parts[0]) ==
            quantities.end())
          entry.refuse("recover.unknown-column: there is no quantity '" +
                         parts[0] + "'",
                       "Check the spelling: the most similar name is '" +
                         nearest_name(parts[0], quantities) +
                         "'; the names are " + joined(quantities) + ".");
        references.push_back({parts[0],
                              entry.number(parts[1]),
                              joined({parts.begin() + 2, parts.end()}, ": ")});
      }
    return references;
  }



  namespace
  {
    constexpr unsigned int most_on_line = 100000, most_in_cut = 100;



    std::pair<unsigned int, dealii::Point<3>>
    parse_place(const Entry &entry, const std::vector<std::string> &bodies)
    {
      if (entry.is_empty())
        entry.refuse_missing("recover.position-missing: write BODY: x, y, z, "
                             "for example upper: 0, 1, 0.1.");
      const auto [body, place] = parse_on_body(entry, bodies);
      return {body, entry.point(place)};
    }



    void
    declare_stress(ParameterHandler &prm)
    {
      prm.declare_entry(
        "Stress",
        name_of(StressValues::element),
        selection<StressValues>(),
        "Recovery of strains and stresses from elements. element: values of "
        "the element, averaged where elements of one ply meet; nodal: "
        "interpolated averages at nodes; recovered: superconvergent patch "
        "recovery, an order more accurate for smooth fields; equilibrium: as "
        "recovered, with transverse stresses from equilibrium through the "
        "thickness of a laminate, continuous across interfaces. The others "
        "never average across interfaces.");
    }
  } // namespace



  void
  ProbeParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry("At",
                      "",
                      Anything(),
                      "Position of the probe, BODY: x, y, z in scene "
                      "coordinates inside the body [length].");
    prm.declare_entry(
      "Box",
      "0, 0, 0",
      patterns::numbers(3),
      "Edge lengths along x, y and z of the scene of a box around At, inside "
      "the body [length]. Results are means over the box. An edge of 0 gives "
      "an area or a line; three zeros, the point.");
    declare_stress(prm);
    prm.declare_entry("References",
                      "",
                      Anything(),
                      "Reference values, quantity: value: source, with '|' "
                      "between. Quantities are columns of probes.csv.");
  }



  Probe
  ProbeParameters::parse(const Entries                  &in,
                         const std::string              &name,
                         const std::vector<std::string> &bodies)
  {
    const auto [body, position] = parse_place(in["At"], bodies);
    const dealii::Point<3> box  = in["Box"].point();
    if (box[0] < 0. || box[1] < 0. || box[2] < 0.)
      in["Box"].refuse(
        "recover.negative-edge: the edge lengths of Box must not be negative",
        "Write three lengths (0 for no extent), as in 0.1, 0.1, 0.");
    return {name,
            body,
            position,
            in["Stress"].choice<StressValues>(),
            parse_references(in["References"], field_names()),
            box};
  }



  void
  LineParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry("From",
                      "",
                      Anything(),
                      "Start of the line, BODY: x, y, z [length].");
    prm.declare_entry("To",
                      "",
                      Anything(),
                      "End of the line, in the same body: x, y, z [length].");
    declare_stress(prm);
    prm.declare_entry("Samples",
                      "10",
                      patterns::Whole(2, most_on_line),
                      "Number of points in each ply that the line crosses; "
                      "both sides of each interface are among them.");
  }



  Line
  LineParameters::parse(const Entries                  &in,
                        const std::string              &name,
                        const std::vector<std::string> &bodies)
  {
    const auto [first, from] = parse_place(in["From"], bodies);
    const auto [second, to]  = parse_place(in["To"], bodies);
    if (first != second)
      in.refuse("recover.two-bodies: From and To must be in the same body");
    if (from.distance(to) == 0.)
      in.refuse("recover.same-point: From and To are the same point",
                "Write two different points.");
    return {name,
            first,
            from,
            to,
            in["Stress"].choice<StressValues>(),
            in["Samples"].whole(2, most_on_line)};
  }



  void
  CutParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry("At",
                      "",
                      Anything(),
                      "BODY: distance along the axis [length].");
    declare_stress(prm);
    prm.declare_entry("Samples",
                      "8",
                      patterns::Whole(1, most_in_cut),
                      "Intervals in each direction of a section cell.");
  }



  Cut
  CutParameters::parse(const Entries                  &in,
                       const std::string              &name,
                       const std::vector<std::string> &bodies)
  {
    const Entry at = in["At"];
    if (at.is_empty())
      at.refuse_missing(
        "recover.position-missing: write a body and the distance from the "
        "start of its axis, as in upper: 0.5.");
    const auto [body, distance] = parse_on_body(at, bodies);
    return {name,
            body,
            at.number(distance),
            in["Stress"].choice<StressValues>(),
            in["Samples"].whole(1, most_in_cut)};
  }



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
