// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/patterns.h>
#include <lamella/conditions/parameters.h>
#include <lamella/contact/parameters.h>

namespace lamella
{
  using dealii::ParameterHandler;
  using dealii::Tensor;
  using dealii::Patterns::Anything;

  namespace
  {
    // The penetration is a millionth of the compression of the cells below the
    // contact (doc/theory/penalty.md).
    constexpr double automatic_multiple = 1e6;



    void
    declare_enforcement(ParameterHandler &prm)
    {
      prm.declare_entry(
        "Enforcement",
        name_of(Enforcement::penalty),
        selection<Enforcement>(),
        "penalty: the contact force is Penalty times the penetration; "
        "augmented lagrangian: penalty with iterations that remove the "
        "penetration; exact: Lagrange multipliers; tied: the surfaces hold "
        "together, also in tension and shear (doc/guides/bonds.md).");
      prm.declare_entry("Penalty",
                        "auto",
                        patterns::WordOrPattern("auto", patterns::positive()),
                        "Penalty stiffness: auto, or a positive number in the "
                        "unit of Penalty per. auto is 1e6 times the local "
                        "stiffness E_n A / h of the softer side.");
      prm.declare_entry("Penalty per",
                        name_of(PenaltyKind::per_area),
                        selection<PenaltyKind>(),
                        "area: Penalty in force/length^3, multiplied by the "
                        "tributary area, independent of the mesh; node: "
                        "Penalty in force/length per node, as in the paper. "
                        "Unused with Penalty = auto.");
    }



    void
    declare_adhesive(ParameterHandler &prm)
    {
      prm.declare_entry("Adhesive thickness",
                        "",
                        patterns::optional(patterns::positive()),
                        "Thickness of an elastic adhesive layer between tied "
                        "surfaces [length]. The surfaces touch in the scene: "
                        "the layer has no volume. Empty: no layer.");
      prm.declare_entry("Adhesive moduli",
                        "",
                        patterns::optional(patterns::numbers(2)),
                        "Modulus E across the adhesive layer and shear modulus "
                        "G [force/length^2]: traction = modulus / thickness "
                        "times relative displacement.");
    }



    /// The adhesive of tied surfaces; refuses what does not fit ties.
    Adhesive
    parse_adhesive(const Entries &in, const ContactPair &contact)
    {
      const Entry thickness = in["Adhesive thickness"],
                  moduli    = in["Adhesive moduli"];
      const bool is_tied    = contact.is_tied();
      for (const Entry &entry : {thickness, moduli})
        if (!entry.is_empty() && !is_tied)
          entry.refuse("contact.adhesive-without-tie: only tied surfaces have "
                       "an adhesive",
                       "Write Enforcement = tied, or remove this entry.");
      if (thickness.is_empty() != moduli.is_empty())
        (thickness.is_empty() ? thickness : moduli)
          .refuse_missing("contact.adhesive-incomplete: an adhesive has both "
                          "Adhesive thickness and Adhesive moduli; write, for "
                          "example, 0.2 and 3000, 1100.");
      if (thickness.is_empty())
        return {};
      const std::vector<double> values = moduli.numbers();
      if (!(values[0] > 0. && values[1] > 0.))
        moduli.refuse("contact.adhesive-not-positive: both moduli must be "
                      "positive",
                      "Write E, G, as in 3000, 1100.");
      return {thickness.positive(), values[0], values[1]};
    }



    /// Refuses entries that ties do not have.
    void
    check_tie(const ContactPair &contact, const Entries &in)
    {
      if (!contact.is_tied())
        return;
      if (contact.obstacle != nullptr)
        in["Enforcement"].refuse(
          "contact.tied-to-obstacle: obstacles cannot be "
          "tied to a body",
          "Write a Support on the surface of the body.");
      if (contact.friction > 0.)
        in["Friction"].refuse(
          "contact.tied-with-friction: tied surfaces do not "
          "slip",
          "Remove Friction, or write another Enforcement.");
    }



    Region
    parse_surface(const Entry &entry, const std::vector<std::string> &bodies)
    {
      if (entry.is_empty())
        entry.refuse_missing(
          "contact.side-missing: write a body and one of its surfaces as BODY: "
          "SURFACE, as in upper: bottom.");
      const auto [body, surface] = parse_on_body(entry, bodies);
      Region region;
      region.body    = body;
      region.kind    = Region::Kind::surface;
      region.surface = surface;
      return region;
    }



    Penalty
    parse_penalty(const Entries &in)
    {
      const PenaltyKind kind = in["Penalty per"].choice<PenaltyKind>();
      if (in["Penalty"].text() == "auto")
        return {PenaltyKind::automatic, automatic_multiple};
      return {kind, in["Penalty"].positive()};
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
    parse_sides(const Entries                  &in,
                const std::vector<std::string> &bodies,
                const Obstacles                &obstacles,
                ContactPair                    &contact)
    {
      const Entry first = in["First"], second = in["Second"];
      if (find_obstacle(first.text(), obstacles) != nullptr)
        first.refuse(
          "contact.first-is-obstacle: First must be a surface of a body",
          "Write BODY: SURFACE in First, the obstacle in Second.");
      contact.first    = parse_surface(first, bodies);
      contact.obstacle = find_obstacle(second.text(), obstacles);
      if (contact.obstacle != nullptr)
        return;
      const auto        colon = second.text().find(':');
      const std::string name  = trimmed(second.text().substr(0, colon));
      if (find_obstacle(name, obstacles) != nullptr)
        second.refuse("contact.obstacle-with-surface: '" + name +
                        "' is an obstacle, which has no named surfaces",
                      "Write the name of the obstacle alone.");
      std::vector<std::string> known = bodies;
      for (const auto &obstacle : obstacles)
        known.push_back(obstacle->name);
      if (!second.is_empty() && colon == std::string::npos)
        second.refuse(
          "contact.unknown-second: this is not the name of an obstacle; for a "
          "body write BODY: SURFACE, as in upper: bottom",
          "Check the spelling: the most similar name is '" +
            nearest_name(second.text(), known) + "'.");
      contact.second = parse_surface(second, bodies);
      if (contact.first.body == contact.second.body)
        in.refuse("contact.same-body: First and Second are on the same body '" +
                    bodies[contact.first.body] + "'",
                  "Name surfaces of two different bodies; contact of a body "
                  "with itself is not supported.");
    }



    /// Zero for none.
    double
    parse_friction(const Entry &friction)
    {
      // Rubber on rubber has 1 to 2; above that something else was meant.
      constexpr double most = 10.;
      if (friction.text() == "none" || friction.is_empty())
        return 0.;
      const double mu = friction.number();
      if (!(mu >= 0. && mu <= most))
        friction.refuse(
          "contact.friction-out-of-range: mu must lie between 0 and 10",
          "Write the coefficient of friction, as in 0.3, or none.");
      return mu;
    }



    double
    parse_tolerance(const Entry &tolerance)
    {
      const double value = tolerance.positive();
      if (!(value < 0.5))
        tolerance.refuse(
          "contact.tolerance-out-of-range: the tolerance must be more than 0 "
          "and less than 0.5, for example 1e-6");
      return value;
    }



    /// The end faces of a body have no edges of their own.
    void
    check_edges(const ContactPair &contact, const Entries &in)
    {
      const bool         on_second = contact.slave_side == SlaveSide::second;
      const std::string &surface =
        (on_second ? contact.second : contact.first).surface;
      for (const char *const end : {"start", "end", "ends"})
        if (surface == end)
          in[on_second ? "Second" : "First"].refuse(
            "contact.edges-of-end-face: edge to surface contact needs a "
            "lateral surface, which has edges at the ends of the body",
            "Name a surface such as bottom, as in upper: bottom.");
    }



    /// What an obstacle does not have.
    void
    check_obstacle(const ContactPair &contact, const Entries &in)
    {
      const std::string rule =
        "contact.obstacle-without-nodes: the obstacle '" +
        contact.obstacle->name +
        "' is rigid and has no nodes, which this kind of contact needs on "
        "both sides";
      if (contact.discretization == Discretization::node_to_node)
        in["Discretization"].refuse(
          rule, "Use auto, surface to surface, or node to surface.");
      if (contact.discretization == Discretization::edge_to_surface)
        in["Discretization"].refuse(
          "contact.edges-on-obstacle: the obstacle '" + contact.obstacle->name +
            "' needs no edge to surface contact: it is in contact with all "
            "nodes of First, also those at the ends",
          "Write Discretization = node to surface.");
      if (contact.discretization == Discretization::line_to_roller &&
          contact.obstacle->shape != Obstacle::Shape::cylinder)
        in["Discretization"].refuse(
          "contact.not-a-cylinder: the obstacle '" + contact.obstacle->name +
            "' is no cylinder, which line to roller contact needs",
          "Write Discretization = auto.");
      if (contact.slave_side == SlaveSide::second)
        in["Slave side"].refuse(rule, "Use first, or auto.");
    }



    /// The unit vector along what stands there.
    Tensor<1, 3>
    parse_direction(const Entry &entry)
    {
      const Tensor<1, 3> direction = entry.point();
      if (!(direction.norm() > 0.))
        entry.refuse("contact.zero-direction: the direction must not be the "
                     "zero vector; write, for example, 0, 0, 1");
      return direction / direction.norm();
    }



    /// Force, in place of u; sets the index @p body of its DoF.
    void
    parse_force(const Entries &in, const unsigned int body, Obstacle &obstacle)
    {
      const Entry force = in["Force"];
      if (force.is_empty())
        return;
      obstacle.force = force.point();
      obstacle.body  = body;
      if (!(obstacle.force.norm() > 0.))
        force.refuse("contact.zero-force: Force must not be the zero vector, "
                     "since the obstacle is guided along it",
                     "Remove Force, or write a force, as in 0, 0, -500.");
      if (obstacle.displacement.norm() > 0.)
        force.refuse("contact.force-and-displacement: Force and u exclude each "
                     "other: the displacement under a Force is unknown",
                     "Remove u, or remove Force.");
      if (obstacle.shape == Obstacle::Shape::plane &&
          !(obstacle.force * obstacle.direction > 0.))
        force.refuse("contact.force-away: the force on the plane does not "
                     "press it against bodies (Force . Normal is not positive)",
                     "Reverse Force, or let Normal point towards the bodies.");
    }
  } // namespace



  void
  ContactParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry("First",
                      "",
                      Anything(),
                      "First contact surface, BODY: SURFACE. Its outward "
                      "normal is the contact normal.");
    prm.declare_entry(
      "Second",
      "",
      Anything(),
      "Second contact surface, BODY: SURFACE, or the name of an obstacle. The "
      "contact force on this side is reported.");
    prm.declare_entry("Where",
                      "",
                      Anything(),
                      "Part of the surfaces with constraints: a condition in "
                      "x, y, z of the scene, such as y > 30, for elements of "
                      "the slave side by their centers. Empty: everywhere.");
    prm.declare_entry(
      "Discretization",
      name_of(Discretization::automatic),
      selection<Discretization>(),
      "node to node: constraints between nodes that face each other; node to "
      "surface: between the nodes of one side and their projections onto the "
      "other; surface to surface: gaps averaged around the nodes of one side, "
      "as in mortar methods; edge to surface: between the nodes at the ends of "
      "one body and the other surface; line to roller: along the line of a "
      "beam that is nearest to a cylinder across the beam, also as it moves; "
      "auto: node to node if all facing nodes match, line to roller if the "
      "roller is smaller than the elements (doc/theory/contact.md), else "
      "surface to surface, with edge to surface at ends that press.");
    prm.declare_entry("Slave side",
                      name_of(SlaveSide::automatic),
                      selection<SlaveSide>(),
                      "Slave (nonmortar) side, whose nodes have the gap "
                      "constraints; auto: the side with the finer mesh (edge "
                      "to surface: first). Unused with node to node.");
    prm.declare_entry("Search distance",
                      "auto",
                      patterns::WordOrPattern("auto", patterns::positive()),
                      "Largest distance along the normal at which points are "
                      "paired [length]; auto: the length of the smaller body.");
    prm.declare_entry(
      "Overclosure",
      name_of(Overclosure::resolve),
      selection<Overclosure>(),
      "Treatment of bodies that overlap at the start: resolve (contact "
      "forces push them apart, an interference fit), adjust (the overlap is "
      "subtracted from the gaps, without strain), or error.");
    declare_enforcement(prm);
    declare_adhesive(prm);
    prm.declare_entry("Tolerance",
                      "1e-6",
                      patterns::positive(),
                      "Largest tangential offset of two nodes that are paired, "
                      "divided by the square root of the tributary area.");
    prm.declare_entry(
      "Friction",
      "none",
      patterns::WordOrPattern("none", patterns::optional(patterns::number())),
      "Coefficient mu of Coulomb friction: shear tractions are at most mu "
      "times the pressure, and equal to it under slip; none: no friction.");
  }



  ContactPair
  ContactParameters::parse(const Entries                  &in,
                           const std::string              &name,
                           const std::vector<std::string> &bodies,
                           const Obstacles                &obstacles)
  {
    ContactPair contact;
    contact.name = name;
    parse_sides(in, bodies, obstacles, contact);
    contact.discretization = in["Discretization"].choice<Discretization>();
    contact.is_automatic = contact.discretization == Discretization::automatic;
    contact.enforcement  = in["Enforcement"].choice<Enforcement>();
    contact.slave_side   = in["Slave side"].choice<SlaveSide>();
    contact.overclosure  = in["Overclosure"].choice<Overclosure>();
    if (contact.obstacle != nullptr)
      check_obstacle(contact, in);
    else if (contact.discretization == Discretization::line_to_roller)
      in["Discretization"].refuse(
        "contact.second-not-obstacle: line to roller needs a cylinder",
        "Write auto, or name a cylinder of Obstacles in Second.");
    else if (contact.discretization == Discretization::edge_to_surface)
      check_edges(contact, in);
    if (in["Search distance"].text() != "auto")
      contact.search_distance = in["Search distance"].positive();
    contact.penalty   = parse_penalty(in);
    contact.tolerance = parse_tolerance(in["Tolerance"]);
    contact.friction  = parse_friction(in["Friction"]);
    contact.adhesive  = parse_adhesive(in, contact);
    if (const Entry where = in["Where"]; !where.is_empty())
      contact.where = std::make_shared<const Expression>(where.text(), where);
    check_tie(contact, in);
    return contact;
  }



  void
  ObstacleParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry("Shape",
                      "",
                      patterns::optional(selection<Obstacle::Shape>()),
                      "Shape of the rigid obstacle. plane: a floor, the half "
                      "space behind a plane; cylinder: a roller with circular "
                      "section, infinitely long.");
    prm.declare_entry("Through",
                      "0, 0, 0",
                      patterns::numbers(3),
                      "A point on the plane or on the cylinder axis [length].");
    prm.declare_entry("Normal",
                      "0, 0, 1",
                      patterns::numbers(3),
                      "For a plane: the normal that points out of the half "
                      "space, towards the bodies.");
    prm.declare_entry("Axis",
                      "1, 0, 0",
                      patterns::numbers(3),
                      "For a cylinder: direction of its axis.");
    prm.declare_entry("Radius",
                      "",
                      patterns::optional(patterns::positive()),
                      "Of a cylinder [length].");
    prm.declare_entry("u",
                      "0, 0, 0",
                      patterns::numbers(3),
                      "Obstacle displacement at load factor 1 [length].");
    prm.declare_entry(
      "Force",
      "",
      patterns::optional(patterns::numbers(3)),
      "Force that presses the obstacle at load factor 1 [force], in place of "
      "u. The obstacle is guided along the direction of Force, as the "
      "crosshead of a testing machine: it moves along this direction only, "
      "by an unknown displacement at which the contact forces along it "
      "balance Force times the load factor (Factors).");
    HistoryParameters::declare(prm);
  }



  std::shared_ptr<Obstacle>
  ObstacleParameters::parse(const Entries     &in,
                            const std::string &name,
                            const unsigned int body)
  {
    auto        obstacle = std::make_shared<Obstacle>();
    const Entry shape = in["Shape"], radius = in["Radius"];
    if (shape.is_empty())
      shape.refuse_missing("contact.shape-missing: write plane or cylinder, "
                           "the shape of the obstacle.");
    obstacle->name         = name;
    obstacle->shape        = shape.choice<Obstacle::Shape>();
    obstacle->point        = in["Through"].point();
    obstacle->displacement = in["u"].point();
    if (obstacle->shape == Obstacle::Shape::plane)
      {
        if (!radius.is_empty())
          radius.refuse("contact.radius-of-plane: a plane has no radius",
                        "Remove Radius, or write Shape = cylinder.");
        obstacle->direction = parse_direction(in["Normal"]);
        parse_force(in, body, *obstacle);
        return obstacle;
      }
    obstacle->direction = parse_direction(in["Axis"]);
    if (radius.is_empty())
      radius.refuse_missing(
        "contact.radius-missing: write the radius of the cylinder, as in 0.5.");
    obstacle->radius = radius.positive();
    parse_force(in, body, *obstacle);
    return obstacle;
  }
} // namespace lamella
