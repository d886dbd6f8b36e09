// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/axis/parameters.h>
#include <lamella/base/patterns.h>
#include <lamella/body/beam.h>
#include <lamella/body/geometrically_exact_beam.h>
#include <lamella/body/parameters.h>
#include <lamella/body/solid.h>
#include <lamella/body/total_lagrangian_beam.h>
#include <lamella/body/total_lagrangian_solid.h>
#include <lamella/section/lagrange_element.h>

#include <deal.II/grid/grid_tools.h>

#include <cmath>
#include <map>
#include <utility>

namespace lamella
{
  using dealii::ParameterHandler;
  using dealii::Patterns::Anything;

  namespace
  {
    // Each division has eight times the cells of the one before.
    constexpr unsigned int max_ellipse_refinements = 8;



    /// How often @p piece of @p entry says to divide.
    unsigned int
    times(const Entry &entry, const std::string &piece)
    {
      const double n = entry.number(piece);
      if (!(n >= 0. && n <= max_ellipse_refinements && n == std::floor(n)))
        entry.refuse("body.times-out-of-range: the number of refinements "
                     "(times) must be a whole number from 0 to " +
                     std::to_string(max_ellipse_refinements) +
                     "; each refinement divides hexahedra into eight");
      return static_cast<unsigned int>(n);
    }



    /// `x, y, z: radius: times`, the center in the scene's axes.
    SolidRefinement::Ball
    parse_ball(const Entry &entry, const Placement &placement)
    {
      const std::vector<std::string> parts = entry.items(':');
      if (parts.size() != 3)
        entry.refuse("body.invalid-ball: write the center, the radius and the "
                     "number of refinements of a ball as x, y, z: radius: "
                     "times, for example 0, 1, 0: 0.2: 2");
      SolidRefinement::Ball ball;
      ball.center = placement.to_body(entry.point(parts[0]));
      ball.radius = entry.number(parts[1]);
      ball.times  = times(entry, parts[2]);
      if (!(ball.radius > 0.))
        entry.refuse("entry.not-positive: the ball's radius must be positive");
      return ball;
    }



    // Above it a body could no longer be called held by contact alone.
    constexpr double largest_stabilization = 1e-2;



    Placement
    parse_placement(const Entries &in)
    {
      const auto origin = in["Origin"].point(), axis = in["Axis"].point(),
                 up = in["Up"].point();
      try
        {
          return Placement::from_directions(origin, axis, up);
        }
      catch (const InputError &error)
        {
          in.refuse(error.marked(error.rule()), error.remedy());
        }
    }



    std::optional<double>
    parse_stabilization(const Entry &entry)
    {
      if (entry.text() == "auto")
        return {};
      const double share = entry.number();
      if (!(share >= 0. && share <= largest_stabilization))
        entry.refuse(
          "body.stabilization-out-of-range: the value must lie between 0 and " +
          to_text(largest_stabilization) +
          "; springs of 1e-6 constrain a body and do not change the result");
      return share;
    }



    /// The `subsection Kinematics`.
    void
    parse_kinematics(const Entries   &in,
                     const double     length,
                     const Entry     &scene_theory,
                     BodyDescription &body)
    {
      body.pieces = TheoryParameters::parse_pieces(in, length);
      body.theory = body.pieces.empty() ?
                      TheoryParameters::parse(in, scene_theory) :
                      body.pieces.leading();
      body.axis   = AxisParameters::parse(in, length);
      if (body.theory.keeps_sections_normal() && body.axis.degree != 3)
        in["Axis element"].refuse(
          "body.ebbt-needs-b4: Theory = EBBT needs deflections with continuous "
          "slopes between elements, that is cubic elements",
          "Use Axis element = B4, or Theory = TBT.");
      body.refinement = SolidParameters::parse(in, body.placement);
    }



    void
    check_slenderness(const BodyDescription &body, const SectionMesh &mesh)
    {
      // Forces of a beam lose digits by a factor (L / h)^2: at L / h = 1e6
      // three of sixteen are left (doc/theory/stable-basis.md).
      constexpr double most = 1e7, sensible = 1e6;

      const auto corners = dealii::GridTools::compute_bounding_box(mesh.mesh)
                             .get_boundary_points();
      const double extent = corners.first.distance(corners.second);
      if (body.axis.length > most * extent)
        throw InputError("Body " + body.name + "/Length",
                         to_text(body.axis.length),
                         "body.too-slender: the length is " +
                           to_text(body.axis.length / extent, 2) +
                           " times the size of the section, " +
                           to_text(extent, 3) +
                           "; double precision allows at most " +
                           to_text(sensible) + " times",
                         "Check the units of Length and of the section.");
    }



    /// Functions in columns are no leading ones of each other.
    void
    check_degrees(const BodyDescription                    &body,
                  const std::shared_ptr<const SectionMesh> &mesh)
    {
      if (!body.theory.hierarchical || !LagrangeElement(mesh, 1).has_columns())
        return;
      std::string all;
      for (const Theory &theory : body.pieces.theories)
        all += (all.empty() ? "" : ", ") + theory.name();
      throw InputError(
        "Body " + body.name + "/Kinematics/Theories",
        all,
        "body.column-functions: the section '" + body.section +
          "' is more than " + to_text(LagrangeElement::default_column_aspect) +
          " times as wide as thick. LE-N then uses functions that extend over "
          "all plies, which cannot be joined for different N",
        "Use the same N for each LE-N in Theories, and Section order = auto.");
    }



    std::unique_ptr<Body>
    make_solid(const BodyDescription                    &body,
               const std::shared_ptr<const SectionMesh> &mesh,
               const double                              memory_limit)
    {
      SolidRefinement refinement = body.refinement;
      refinement.memory_limit    = memory_limit;
      if (body.has_finite_rotations)
        return std::make_unique<TotalLagrangianSolid>(body.name,
                                                      mesh,
                                                      body.axis,
                                                      body.placement,
                                                      body.theory.order,
                                                      refinement);
      return std::make_unique<Solid>(body.name,
                                     mesh,
                                     body.axis,
                                     body.placement,
                                     body.theory.order,
                                     refinement);
    }



    /// The beam with all fields of @p section. One that is going to have fields
    /// of its section's own turns when it has them.
    std::unique_ptr<Body>
    make_beam(const BodyDescription                &body,
              const std::shared_ptr<const Section> &section,
              const std::shared_ptr<const Axis>    &axis)
    {
      const std::string &name      = body.name;
      const bool         has_modes = body.theory.is_saint_venant();
      if (body.has_finite_rotations && body.theory.has_rotating_sections() &&
          !has_modes)
        return std::make_unique<GeometricallyExactBeam>(
          name,
          section,
          axis,
          body.placement,
          body.theory.name(),
          body.theory.keeps_sections_normal());
      if (body.has_finite_rotations && !has_modes)
        return std::make_unique<TotalLagrangianBeam>(name,
                                                     section,
                                                     axis,
                                                     body.placement);
      return std::make_unique<Beam>(name, section, axis, body.placement);
    }
  } // namespace



  void
  SolidParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry(
      "Refinements",
      "0",
      patterns::number(),
      "For solids: how often all hexahedra (a section cell times an axis "
      "element each) are divided into eight. No effect on beams.");
    prm.declare_entry(
      "Refine near",
      "",
      Anything(),
      "For solids: balls x, y, z: radius: times, with '|' between, in scene "
      "coordinates. Hexahedra that intersect a ball are divided further, that "
      "many times. No effect on beams.");
  }



  SolidRefinement
  SolidParameters::parse(const Entries &in, const Placement &placement)
  {
    SolidRefinement refinement;
    const Entry     everywhere = in["Refinements"], near = in["Refine near"];
    refinement.everywhere = times(everywhere, everywhere.text());
    for (const std::string &ball : near.items('|'))
      refinement.balls.push_back(
        parse_ball(Entry(near.path(), ball), placement));
    return refinement;
  }



  using dealii::ParameterHandler;
  using dealii::Patterns::Anything;



  void
  BodyParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry("Section", "", Anything(), "A name of Sections.");
    prm.declare_entry(
      "Origin",
      "0, 0, 0",
      patterns::numbers(3),
      "Position, in scene coordinates, of the lower left corner of the section "
      "(of a mesh file: of its origin) at the start of the axis [length].");
    prm.declare_entry("Axis",
                      "0, 1, 0",
                      patterns::numbers(3),
                      "Direction of the axis, y of the body.");
    prm.declare_entry("Up",
                      "0, 0, 1",
                      patterns::numbers(3),
                      "Approximate direction of z of the section.");
    prm.declare_entry("Length",
                      "",
                      patterns::optional(patterns::positive()),
                      "Of the axis [length].");
    prm.declare_entry(
      "Copies",
      "",
      patterns::optional(patterns::positive()),
      "Number of copies of the body, named NAME-1, NAME-2 and so on. NAME in "
      "On, First or Second means all copies; a contact of NAME with NAME is "
      "between neighboring copies.");
    prm.declare_entry("Origin step",
                      "",
                      patterns::numbers(),
                      "Vector from the Origin of one copy to that of the next "
                      "[length]; default 0, 0, 0.");
    prm.declare_entry(
      "Length step",
      "",
      patterns::optional(patterns::number()),
      "Difference in Length of neighboring copies [length]; default 0.");
    prm.declare_entry(
      "Stabilization",
      "auto",
      patterns::WordOrPattern("auto", patterns::number()),
      "Stiffness of springs to the ground, as a fraction of E A / L, in "
      "rigid-body motions that supports do not prevent, for a body that only "
      "contact constrains (a roller under a force). auto: 1e-6 for a body in "
      "contact, else 0. Iterations remove the effect of the springs from the "
      "result. 0: no springs; a body that can move freely is an error.");
    prm.declare_entry(
      "Isostatic support",
      "false",
      dealii::Patterns::Bool(),
      "Whether rigid-body motions that no support prevents are removed, true "
      "or false. If no contact can prevent a motion, the middle of the body "
      "stays in place and the loads must be in equilibrium. If a contact can, "
      "springs as of Stabilization = auto act.");
    prm.enter_subsection("Kinematics");
    TheoryParameters::declare(prm);
    AxisParameters::declare(prm);
    SolidParameters::declare(prm);
    prm.leave_subsection();
  }



  BodyDescription
  BodyParameters::parse(ParameterHandler               &prm,
                        const std::string              &name,
                        const Entry                    &scene_theory,
                        const std::vector<std::string> &sections)
  {
    const Entries   in(prm, "Body " + name);
    BodyDescription body;
    body.name           = name;
    body.section        = in["Section"].among(sections, "section", "Sections");
    const double length = in["Length"].positive();
    body.placement      = parse_placement(in);
    body.stabilization  = parse_stabilization(in["Stabilization"]);
    body.is_held        = in["Isostatic support"].boolean();
    if (body.is_held && body.stabilization.value_or(0.) == 0.)
      body.stabilization = stabilization_of_contact;
    prm.enter_subsection("Kinematics");
    parse_kinematics(Entries(prm, in.path() + "/Kinematics"),
                     length,
                     scene_theory,
                     body);
    prm.leave_subsection();
    return body;
  }



  Bodies
  make_bodies(const std::vector<BodyDescription> &descriptions,
              const SectionMeshes                &meshes,
              const double                        memory_limit)
  {
    std::map<std::pair<std::string, Theory>, std::shared_ptr<const Section>>
           sections;
    Bodies bodies;
    for (const BodyDescription &description : descriptions)
      {
        const auto &mesh = meshes.at(description.section);
        check_slenderness(description, *mesh);
        if (description.theory.is_solid())
          {
            bodies.push_back(make_solid(description, mesh, memory_limit));
            continue;
          }
        const Theory theory = description.has_finite_rotations ?
                                description.theory.of_rotating() :
                                description.theory;
        auto &section = sections[{description.section, theory.of_section()}];
        if (section == nullptr)
          {
            check_degrees(description, mesh);
            section = make_section(mesh, theory);
          }
        const auto axis = std::make_shared<Axis>(description.axis);
        bodies.push_back(make_beam(description, section, axis));
      }
    return bodies;
  }
} // namespace lamella
