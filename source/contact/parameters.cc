// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/conditions/parameters.h>
#include <lamella/contact/parameters.h>

#include <algorithm>

namespace lamella
{
  using dealii::ParameterHandler;
  using dealii::Tensor;
  using dealii::Patterns::Anything;

  namespace
  {
    // The penetration that this leaves is a millionth of what the cells below
    // the contact are compressed by; doc/penalty.md shows the plateau it is on.
    constexpr double automatic_multiple = 1e6;
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
      "BODY: SURFACE opposite, or the name of an obstacle; the contact force "
      "is reported as it acts on this one.");
    prm.declare_entry(
      "Discretisation",
      "node to node",
      Anything(),
      "node to node: rows between nodes that face each other; node to surface: "
      "between the nodes of one side and the places of the other that they "
      "face; surface to surface: gaps averaged around the nodes of one side, "
      "as in mortar methods, whatever the nodes of the other.");
    prm.declare_entry("Points on",
                      "auto",
                      Anything(),
                      "first or second: the side whose nodes the rows belong "
                      "to; auto: the one with the finer grid where the two "
                      "face each other. Unused with node to node.");
    prm.declare_entry("Search distance",
                      "auto",
                      Anything(),
                      "Places further apart than this, along the normal, are "
                      "not paired [length]; auto: the length of the smaller "
                      "body.");
    prm.declare_entry(
      "Overclosure",
      "push apart",
      Anything(),
      "Of bodies that overlap from the start: push apart (contact forces do, "
      "an interference fit), adjust (the overlap is taken out of the gaps, "
      "without strain), or error.");
    prm.declare_entry(
      "Enforcement",
      "penalty",
      Anything(),
      "penalty: a force of Penalty times the penetration; augmented "
      "lagrangian: the same, corrected until no penetration is left; exact: "
      "multipliers.");
    prm.declare_entry("Penalty",
                      "auto",
                      Anything(),
                      "auto, or a positive number in the unit of Penalty per. "
                      "auto is 1e6 times the local stiffness E_n A / h of the "
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
    prm.declare_entry("Friction",
                      "none",
                      Anything(),
                      "Not modelled: none, or 0.");
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



    /// The value of @p entry among @p choices, a text and what it stands for.
    template <typename Choice>
    Choice
    parse_choice(const ParameterHandler                            &prm,
                 const std::string                                 &entry,
                 const std::vector<std::pair<std::string, Choice>> &choices,
                 const std::string                                 &what)
    {
      const std::string        value = prm.get(entry);
      std::vector<std::string> names;
      for (const auto &[name, choice] : choices)
        {
          if (name == value)
            return choice;
          names.push_back("'" + name + "'");
        }
      throw InputError(what + "/" + entry + " = " + value +
                       ": must be one of " + joined(names) + ".");
    }



    std::shared_ptr<const Obstacle>
    find_obstacle(const std::string &name, const Obstacles &obstacles)
    {
      for (const auto &obstacle : obstacles)
        if (obstacle->name == name)
          return obstacle;
      return nullptr;
    }



    /// First and Second.
    void
    parse_sides(const ParameterHandler         &prm,
                const std::vector<std::string> &bodies,
                const Obstacles                &obstacles,
                const std::string              &what,
                ContactPair                    &contact)
    {
      const std::string first  = trimmed(prm.get("First")),
                        second = trimmed(prm.get("Second"));
      if (find_obstacle(first, obstacles) != nullptr)
        throw InputError(what + "/First = " + first +
                         ": is an obstacle. First must be a surface of a "
                         "body; name the obstacle in Second.");
      contact.first    = parse_surface(first, bodies, what + "/First");
      contact.obstacle = find_obstacle(second, obstacles);
      if (contact.obstacle != nullptr)
        return;
      const std::string name = trimmed(second.substr(0, second.find(':')));
      if (find_obstacle(name, obstacles) != nullptr)
        throw InputError(what + "/Second = " + second + ": '" + name +
                         "' is an obstacle, which has no named surfaces. Write "
                         "its name alone.");
      std::vector<std::string> known = bodies;
      for (const auto &obstacle : obstacles)
        known.push_back(obstacle->name);
      if (!second.empty() && second.find(':') == std::string::npos)
        throw InputError(what + "/Second = " + second +
                         ": is no obstacle, and for a body write BODY: "
                         "SURFACE, as in upper: bottom. The nearest name is '" +
                         nearest_name(second, known) + "'.");
      contact.second = parse_surface(second, bodies, what + "/Second");
      if (contact.first.body == contact.second.body)
        throw InputError(what + ": First and Second are the same body '" +
                         bodies[contact.first.body] +
                         "'. Contact of a body with itself is not modelled.");
    }



    void
    check_no_friction(const ParameterHandler &prm, const std::string &what)
    {
      const std::string value = trimmed(prm.get("Friction"));
      if (value != "none" && value != "" &&
          to_number(value, what + "/Friction = " + value) != 0.)
        throw InputError(what + "/Friction = " + value +
                         ": friction is not modelled. Contacts are "
                         "frictionless; leave the entry out.");
    }



    std::optional<double>
    parse_search_distance(const ParameterHandler &prm, const std::string &what)
    {
      const std::string value = trimmed(prm.get("Search distance"));
      if (value == "auto")
        return {};
      const double number = to_number(value, what + "/Search distance");
      if (!(number > 0.))
        throw InputError(what + "/Search distance = " + value +
                         ": must be positive, or auto.");
      return number;
    }



    /// What an obstacle does not have.
    void
    check_obstacle(const ContactPair &contact, const std::string &what)
    {
      if (contact.discretisation == Discretisation::node_to_node)
        throw InputError(what +
                         "/Discretisation = node to node: the obstacle '" +
                         contact.obstacle->name +
                         "' has no nodes. Use surface to surface, or node to "
                         "surface.");
      if (contact.points_on == PointsOn::second)
        throw InputError(what + "/Points on = second: the obstacle '" +
                         contact.obstacle->name +
                         "' has no nodes. Use first, or auto.");
    }
  } // namespace



  ContactPair
  parse_contact(const ParameterHandler         &prm,
                const std::string              &name,
                const std::vector<std::string> &bodies,
                const Obstacles                &obstacles)
  {
    const std::string what = "Contact " + name;
    ContactPair       contact;
    contact.name = name;
    parse_sides(prm, bodies, obstacles, what, contact);
    check_no_friction(prm, what);
    contact.discretisation = parse_choice<Discretisation>(
      prm,
      "Discretisation",
      {{"node to node", Discretisation::node_to_node},
       {"node to surface", Discretisation::node_to_surface},
       {"surface to surface", Discretisation::surface_to_surface}},
      what);
    contact.enforcement =
      parse_choice<Enforcement>(prm,
                                "Enforcement",
                                {{"penalty", Enforcement::penalty},
                                 {"augmented lagrangian",
                                  Enforcement::augmented_lagrangian},
                                 {"exact", Enforcement::exact}},
                                what);
    contact.points_on = parse_choice<PointsOn>(prm,
                                               "Points on",
                                               {{"auto", PointsOn::automatic},
                                                {"first", PointsOn::first},
                                                {"second", PointsOn::second}},
                                               what);
    contact.overclosure =
      parse_choice<Overclosure>(prm,
                                "Overclosure",
                                {{"push apart", Overclosure::push_apart},
                                 {"adjust", Overclosure::adjust},
                                 {"error", Overclosure::refuse}},
                                what);
    if (contact.obstacle != nullptr)
      check_obstacle(contact, what);
    contact.search_distance = parse_search_distance(prm, what);
    contact.penalty         = parse_penalty(prm, what);
    contact.tolerance = to_number(prm.get("Tolerance"), what + "/Tolerance");
    if (!(contact.tolerance > 0. && contact.tolerance < 0.5))
      throw InputError(what + "/Tolerance = " + prm.get("Tolerance") +
                       ": must lie between 0 and 0.5.");
    return contact;
  }



  void
  declare_obstacle(ParameterHandler &prm)
  {
    prm.declare_entry("Shape",
                      "",
                      Anything(),
                      "plane: a floor, the half space behind a plane; or "
                      "cylinder: a roller, circular and without ends. Both are "
                      "rigid.");
    prm.declare_entry("Through",
                      "0, 0, 0",
                      Anything(),
                      "A point of the plane, or of the cylinder's axis "
                      "[length].");
    prm.declare_entry("Normal",
                      "0, 0, 1",
                      Anything(),
                      "Of a plane: the direction that points away from the "
                      "half space, to where bodies may be.");
    prm.declare_entry("Axis",
                      "1, 0, 0",
                      Anything(),
                      "Of a cylinder: the direction of its axis.");
    prm.declare_entry("Radius", "", Anything(), "Of a cylinder [length].");
    prm.declare_entry("u",
                      "0, 0, 0",
                      Anything(),
                      "Displacement at load factor 1 [length].");
  }



  namespace
  {
    Tensor<1, 3>
    parse_direction(const ParameterHandler &prm,
                    const std::string      &entry,
                    const std::string      &what)
    {
      const Tensor<1, 3> direction =
        to_point(prm.get(entry), what + "/" + entry);
      if (!(direction.norm() > 0.))
        throw InputError(what + "/" + entry + " = " + prm.get(entry) +
                         ": must be a direction, not zero.");
      return direction / direction.norm();
    }
  } // namespace



  std::shared_ptr<const Obstacle>
  parse_obstacle(const ParameterHandler &prm, const std::string &name)
  {
    const std::string what     = "Obstacle " + name;
    auto              obstacle = std::make_shared<Obstacle>();
    obstacle->name             = name;
    obstacle->shape =
      parse_choice<Obstacle::Shape>(prm,
                                    "Shape",
                                    {{"plane", Obstacle::Shape::plane},
                                     {"cylinder", Obstacle::Shape::cylinder}},
                                    what);
    obstacle->point          = to_point(prm.get("Through"), what + "/Through");
    obstacle->displacement   = to_point(prm.get("u"), what + "/u");
    const std::string radius = trimmed(prm.get("Radius"));
    if (obstacle->shape == Obstacle::Shape::plane)
      {
        if (!radius.empty())
          throw InputError(what + "/Radius = " + radius +
                           ": a plane has no radius. Leave the entry out, or "
                           "set Shape = cylinder.");
        obstacle->direction = parse_direction(prm, "Normal", what);
        return obstacle;
      }
    obstacle->direction = parse_direction(prm, "Axis", what);
    if (radius.empty())
      throw InputError(what +
                       "/Radius is missing: give the cylinder a positive "
                       "radius.");
    obstacle->radius = to_number(radius, what + "/Radius");
    if (!(obstacle->radius > 0.))
      throw InputError(what + "/Radius = " + radius + ": must be positive.");
    return obstacle;
  }
} // namespace lamella
