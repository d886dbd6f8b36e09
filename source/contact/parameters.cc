// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/conditions/parameters.h>
#include <lamella/contact/parameters.h>

namespace lamella
{
  using dealii::ParameterHandler;
  using dealii::Patterns::Anything;

  namespace
  {
    // The penetration that this leaves is a thousandth of what the cells below
    // the contact are compressed by; doc/contact.md shows the plateau it is on.
    constexpr double automatic_multiple = 1000.;
  } // namespace



  void
  declare_contact(ParameterHandler &prm)
  {
    prm.declare_entry("First",
                      "",
                      Anything(),
                      "BODY: SURFACE whose outward normal is that of Eq. 16.");
    prm.declare_entry(
      "Second",
      "",
      Anything(),
      "BODY: SURFACE opposite; the contact force is reported as "
      "it acts on this one.");
    prm.declare_entry("Discretisation",
                      "node to node",
                      Anything(),
                      "node to node: rows between nodes that face each other.");
    prm.declare_entry("Enforcement",
                      "penalty",
                      Anything(),
                      "penalty: a force of Penalty times the penetration.");
    prm.declare_entry("Penalty",
                      "auto",
                      Anything(),
                      "auto, or a positive number in the unit of Penalty per. "
                      "auto is 1000 times the local stiffness E_n A / h of the "
                      "softer side of each pair.");
    prm.declare_entry("Penalty per",
                      "area",
                      Anything(),
                      "area: force/length^3, times the tributary area, "
                      "independent of the mesh; node: force/length, as in the "
                      "paper. Unused with auto.");
    prm.declare_entry("Tolerance",
                      "1e-6",
                      Anything(),
                      "How far sideways facing nodes may be off, over the root "
                      "of the tributary area.");
  }



  namespace
  {
    Region
    parse_surface(const std::string              &text,
                  const std::vector<std::string> &bodies,
                  const std::string              &what)
    {
      if (trimmed(text).empty())
        throw InputError(what + " is missing: write BODY: SURFACE, as in "
                                "upper: bottom.");
      const auto [body, word] = parse_on_body(text, bodies, what);
      Region region;
      region.body    = body;
      region.kind    = Region::Kind::surface;
      region.surface = word;
      return region;
    }



    Penalty
    parse_penalty(const ParameterHandler &prm, const std::string &what)
    {
      const std::string value = trimmed(prm.get("Penalty"));
      const std::string per   = prm.get("Penalty per");
      if (per != "area" && per != "node")
        throw InputError(what + "/Penalty per = " + per +
                         ": must be area [force/length^3] or node "
                         "[force/length].");
      if (value == "auto")
        return {PenaltyKind::automatic, automatic_multiple};
      const double number = to_number(value, what + "/Penalty");
      if (!(number > 0.))
        throw InputError(what + "/Penalty = " + value +
                         ": must be positive, or auto.");
      return {per == "area" ? PenaltyKind::per_area : PenaltyKind::per_node,
              number};
    }
  } // namespace



  ContactPair
  parse_contact(const ParameterHandler         &prm,
                const std::string              &name,
                const std::vector<std::string> &bodies)
  {
    const std::string what = "Contact " + name;
    ContactPair       contact;
    contact.name   = name;
    contact.first  = parse_surface(prm.get("First"), bodies, what + "/First");
    contact.second = parse_surface(prm.get("Second"), bodies, what + "/Second");
    if (contact.first.body == contact.second.body)
      throw InputError(what + ": First and Second are the same body '" +
                       bodies[contact.first.body] +
                       "'. Contact of a body with itself is not modelled.");
    if (prm.get("Discretisation") != "node to node")
      throw InputError(what + "/Discretisation = " + prm.get("Discretisation") +
                       ": this version has 'node to node'.");
    contact.discretisation = Discretisation::node_to_node;
    if (prm.get("Enforcement") != "penalty")
      throw InputError(what + "/Enforcement = " + prm.get("Enforcement") +
                       ": this version has 'penalty'.");
    contact.enforcement = Enforcement::penalty;
    contact.penalty     = parse_penalty(prm, what);
    contact.tolerance   = to_number(prm.get("Tolerance"), what + "/Tolerance");
    if (!(contact.tolerance > 0. && contact.tolerance < 0.5))
      throw InputError(what + "/Tolerance = " + prm.get("Tolerance") +
                       ": must lie between 0 and 0.5.");
    return contact;
  }
} // namespace lamella
