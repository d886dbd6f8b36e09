// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/axis/parameters.h>
#include <lamella/base/patterns.h>
#include <lamella/base/text.h>

namespace lamella
{
  using dealii::ParameterHandler;
  using dealii::Patterns::Selection;

  void
  AxisParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry("Axis element",
                      "B4",
                      Selection("B2|B3|B4"),
                      "Beam element with 2, 3 or 4 nodes: B2, B3 or B4. B4 is "
                      "exact for bending under forces at its ends.");
    prm.declare_entry(
      "Axis elements",
      "10",
      dealii::Patterns::Anything(),
      "Number of equal elements along the axis, or one number for each part "
      "between Axis breaks. auto: graded element lengths, short at clamps and "
      "contacts, with at least ten elements per span under a distributed load; "
      "auto 2: twice as many elements everywhere.");
    prm.declare_entry("Axis breaks",
                      "",
                      patterns::numbers(),
                      "Ascending distances from the start of the axis that "
                      "divide the axis into parts of equal elements [length].");
    prm.declare_entry("Axis nodes",
                      "Gauss-Lobatto",
                      Selection("Gauss-Lobatto|equidistant"),
                      "Positions of the nodes of a B4 element, Gauss-Lobatto "
                      "or equidistant. They change the positions of node to "
                      "node contact, not the displacements.");
    prm.declare_entry(
      "Shear strains",
      "auto",
      Selection("auto|assumed|full"),
      "assumed: transverse shear strains are interpolated one degree lower "
      "along the axis (MITC), against shear locking; full: those of the "
      "displacements; auto: assumed for B2 and B3, full for B4.");
  }



  namespace
  {
    // Far more than anybody solves for: a slip of the hand.
    constexpr unsigned int most_elements = 100000;



    /// `auto` or `auto FACTOR`: the factor; anything else: 0.
    double
    parse_fineness(const Entry &entry)
    {
      constexpr double   least = 0.01, most = 100.;
      const std::string &text = entry.text();
      if (text == "auto")
        return 1.;
      if (text.substr(0, 5) != "auto ")
        return 0.;
      const double refinement_factor = entry.number(text.substr(5));
      if (!(refinement_factor >= least && refinement_factor <= most))
        entry.refuse("axis.factor-out-of-range: the factor must lie between " +
                       to_text(least) + " and " + to_text(most),
                     "Write, for example, auto 2 for twice as many elements.");
      return refinement_factor;
    }



    /// One number for each of @p n_pieces.
    std::vector<unsigned int>
    parse_elements(const Entry &entry, const unsigned int n_pieces)
    {
      std::vector<unsigned int> elements =
        entry.whole_numbers(1, most_elements);
      if (elements.size() != n_pieces)
        entry.refuse(
          "axis.count-of-elements: Axis breaks divide the axis into " +
            std::to_string(n_pieces) + " parts, but there are " +
            std::to_string(elements.size()) + " number(s) here",
          "Give the number of elements of each part, as in 4, 8, 4.");
      return elements;
    }
  } // namespace



  AxisMesh
  AxisParameters::parse(const Entries &in, const double length)
  {
    AxisMesh mesh;
    mesh.length = length;
    // B2, B3, B4: one less than the number of nodes.
    mesh.degree            = in["Axis element"].text()[1] - '1';
    mesh.equidistant_nodes = in["Axis nodes"].text() == "equidistant";

    const std::string shear_strains = in["Shear strains"].text();
    mesh.assumed_shear              = shear_strains == "assumed" ||
                         (shear_strains == "auto" && mesh.degree < 3);

    const Entry elements   = in["Axis elements"];
    mesh.refinement_factor = parse_fineness(elements);
    mesh.breaks            = in["Axis breaks"].ascending(length, "the length");
    if (mesh.refinement_factor == 0.)
      mesh.elements = parse_elements(elements, mesh.breaks.size() + 1);
    else if (!mesh.breaks.empty())
      in["Axis breaks"].refuse(
        "axis.breaks-with-auto: Axis elements = " + elements.text() +
          " chooses the lengths of all elements, so Axis breaks has no effect",
        "Remove Axis breaks, or write Axis elements = 4, 8, 4, for example.");
    return mesh;
  }
} // namespace lamella
