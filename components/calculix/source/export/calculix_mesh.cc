// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/adapt/graded_axis.h>
#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/body/solid.h>
#include <lamella/body/surface_topology.h>
#include <lamella/export/calculix_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Of a hexahedron; they come first.
    constexpr unsigned int n_corners = 8;



    /// The scene with all bodies as solids of @p degree.
    Scene
    with_solids(const Scene &scene, const unsigned int degree)
    {
      Scene solid = scene;
      for (BodyDescription &body : solid.bodies)
        {
          if (!body.refinement.balls.empty())
            throw InputError(
              "Body " + body.name + "/Kinematics/Refine near",
              "",
              "export.hanging-nodes: Refine near creates hanging nodes, which "
              "the export to CalculiX does not support",
              "Remove Refine near (--set \"Body " + body.name +
                "/Kinematics/Refine near=\") and refine with Refinements, the "
                "cells of the section and Axis elements.");
          if (!body.theory.is_solid())
            body.refinement = {};
          body.theory = Theory::solid(degree);
          // Who computes with them is CalculiX.
          body.has_finite_rotations = false;
        }
      return solid;
    }



    bool
    is_isotropic(const EngineeringConstants &m)
    {
      const auto same = [](const double a, const double b) {
        return std::abs(a - b) <= arithmetic::rounding_of_results * std::abs(a);
      };
      return same(m.E1, m.E2) && same(m.E1, m.E3) && same(m.nu12, m.nu13) &&
             same(m.nu12, m.nu23) && same(m.G12, m.G13) && same(m.G12, m.G23) &&
             same(m.G12, m.E1 / (2. * (1. + m.nu12)));
    }



    std::string
    numbers_line(const std::vector<double> &values)
    {
      std::vector<std::string> texts;
      for (const double value : values)
        texts.push_back(calculix_number(value));
      return joined(texts) + "\n";
    }



    /// Throws InputError for obstacles under a given force.
    void
    check_obstacles(const Scene &scene)
    {
      for (const auto &obstacle : scene.obstacles)
        if (obstacle->body)
          throw InputError("Obstacle " + obstacle->name + "/Force",
                           to_text(obstacle->force),
                           "export.force-on-obstacle: obstacles of the "
                           "exported file have prescribed displacements",
                           "Solve the scene, and export it with u, the "
                           "displacement of the obstacle that was found.");
    }
  } // namespace



  std::string
  calculix_number(const double value)
  {
    char text[32];
    std::snprintf(text, sizeof(text), "%.12e", value == 0. ? 0. : value);
    return text;
  }



  void
  write_node(std::ostream      &deck,
             const unsigned int number,
             const Point<3>    &position)
  {
    deck << number;
    for (unsigned int d = 0; d < 3; ++d)
      deck << ", " << calculix_number(position[d]);
    deck << '\n';
  }



  void
  write_element(std::ostream                    &deck,
                const unsigned int               number,
                const std::vector<unsigned int> &nodes)
  {
    deck << number;
    for (unsigned int i = 0; i < nodes.size(); ++i)
      deck << (i == 10 ? ",\n" : ", ") << nodes[i];
    deck << '\n';
  }



  void
  write_set(std::ostream                 &deck,
            const std::string            &keyword,
            const std::set<unsigned int> &set)
  {
    deck << keyword << '\n';
    unsigned int n = 0;
    for (const unsigned int number : set)
      deck << number << (++n == set.size() || n % 16 == 0 ? ",\n" : ", ");
  }



  CalculixMesh::CalculixMesh(const Scene &scene, const CalculixElement &element)
    : scene(scene)
    , element_type(element)
  {
    check_obstacles(scene);
    Scene      solid  = with_solids(scene, element.degree());
    const auto meshes = build_section_meshes(solid);
    grade_axes(solid.bodies,
               meshes,
               solid.supports,
               solid.loads,
               solid.contacts,
               solid.gravity);
    solids = make_bodies(solid.bodies, meshes, solid.solve.memory_limit);
    for (unsigned int body = 0; body < solids.size(); ++body)
      {
        number(body);
        if (element.name() == "C3D20R")
          refuse_single_row(body);
      }
    firsts.emplace_back(nodes.size() + 1, elements.size() + 1);
  }



  void
  CalculixMesh::number(const unsigned int body)
  {
    firsts.emplace_back(nodes.size() + 1, elements.size() + 1);
    const HexahedralMesh &mesh =
      dynamic_cast<const Solid &>(*solids[body]).hexahedra();
    Assert(mesh.hanging_nodes().empty(), ExcInternalError());

    // CalculiX' nodes among those of FE_Q.
    const Hexahedron          ours(element_type.degree());
    std::vector<unsigned int> of_node;
    for (unsigned int i = 0; i < element_type.n_nodes(); ++i)
      for (unsigned int k = 0; k < ours.n_nodes(); ++k)
        if (ours.unit_node(k).distance(element_type.unit_node(i)) <
            arithmetic::same_in_element)
          of_node.push_back(k);

    std::vector<unsigned int> numbers(mesh.nodes().size(), 0);
    for (const HexahedralMesh::Cell &cell : mesh.cells())
      {
        elements.emplace_back();
        plies.push_back(cell.ply);
        for (const unsigned int k : of_node)
          {
            unsigned int &number = numbers[cell.nodes[k]];
            if (number == 0)
              {
                nodes.push_back(scene.bodies[body].placement.to_scene(
                  mesh.nodes()[cell.nodes[k]]));
                number = nodes.size();
              }
            elements.back().push_back(number);
          }
      }
  }



  void
  CalculixMesh::refuse_single_row(const unsigned int body) const
  {
    const auto corners = [this](const unsigned int e, const unsigned int face) {
      std::vector<unsigned int> numbers;
      for (const unsigned int i : element_type.face_nodes(face))
        if (i < n_corners)
          numbers.push_back(elements[e][i]);
      std::sort(numbers.begin(), numbers.end());
      return numbers;
    };
    std::map<std::vector<unsigned int>, unsigned int> sharing;
    const unsigned int first = firsts[body].second - 1;
    for (unsigned int e = first; e < elements.size(); ++e)
      for (unsigned int face = 0; face < 6; ++face)
        ++sharing[corners(e, face)];
    for (unsigned int e = first; e < elements.size(); ++e)
      {
        unsigned int alone = 0;
        for (unsigned int d = 0; d < 3; ++d)
          alone += sharing[corners(e, 2 * d)] == 1 &&
                   sharing[corners(e, 2 * d + 1)] == 1;
        if (alone < 2)
          return;
      }
    throw InputError(
      "Body " + scene.bodies[body].name,
      "",
      "export.single-row: has only one element C3D20R across or through the "
      "thickness; such a mesh has hourglass modes, and displacements are wrong "
      "by 40 to 70 %",
      "Use at least two elements (Cells across, Cells per ply, Axis elements, "
      "or Cells divided = 1), or export with --element C3D8I.");
  }



  CalculixFaces
  CalculixMesh::faces(const unsigned int body, const std::string &surface) const
  {
    CalculixFaces result;
    for (const SurfaceFacet &facet : surface_facets(*solids[body], surface))
      {
        unsigned int normal = 0;
        while (facet.along_s[normal] != 0. || facet.along_t[normal] != 0.)
          ++normal;
        const unsigned int face =
          2 * normal + (facet.origin[normal] == 0. ? 0 : 1);
        result.emplace_back(element_of(body, facet.cell), face);
      }
    return result;
  }



  unsigned int
  CalculixMesh::node_at(const unsigned int body, const Location &location) const
  {
    for (const Location::Place &place : location.places)
      for (unsigned int i = 0; i < element_type.n_nodes(); ++i)
        if (place.unit.distance(element_type.unit_node(i)) <
            arithmetic::same_in_element)
          return nodes_of(element_of(body, place.cell))[i];
    return 0;
  }



  std::set<unsigned int>
  CalculixMesh::line_nodes(const Region &region, const std::string &path) const
  {
    const Body               &body = *solids[region.body];
    const std::vector<double> breaks =
      body.line_breaks(region.at[0], region.at[1]);
    const auto at = [&region](const double t) {
      return region.at[0] + t * (region.at[1] - region.at[0]);
    };
    std::set<unsigned int> result;
    const auto             add = [&](const double t, const bool corner) {
      const Location location = locate_all(body, {at(t)}, path)[0];
      // On an edge two unit coordinates, at a corner all three are 0 or 1.
      unsigned int at_sides = 0;
      for (const Location::Place &place : location.places)
        {
          unsigned int n = 0;
          for (unsigned int d = 0; d < 3; ++d)
            n += std::abs(std::abs(place.unit[d] - 0.5) - 0.5) <
                 arithmetic::same_in_element;
          at_sides = std::max(at_sides, n);
        }
      if (at_sides < (corner ? 3 : 2))
        throw InputError(path,
                         "",
                         "export.line-off-edges: the line of On and At does "
                                     "not follow edges of the hexahedra near " +
                           to_text(at(t)),
                         "Choose the cells of the section and Axis elements "
                                     "(or Axis breaks) so that edges follow it.");
      if (const unsigned int number = node_at(region.body, location))
        result.insert(number);
    };
    for (unsigned int k = 0; k < breaks.size(); ++k)
      {
        add(breaks[k], true);
        if (k + 1 < breaks.size())
          add(0.5 * (breaks[k] + breaks[k + 1]), false);
      }
    return result;
  }



  std::set<unsigned int>
  CalculixMesh::region_nodes(const Region      &region,
                             const std::string &path) const
  {
    std::set<unsigned int> result;
    switch (region.kind)
      {
        case Region::Kind::point:
          for (const Location &location :
               locate_all(*solids[region.body], region.at, path))
            {
              const unsigned int number = node_at(region.body, location);
              if (number == 0)
                throw InputError(
                  path,
                  "",
                  "export.point-off-nodes: the point " +
                    to_text(location.position) +
                    " is no node of the exported hexahedra",
                  "Choose the cells of the section and Axis elements (or Axis "
                  "breaks) so that a corner lies at this point.");
              result.insert(number);
            }
          return result;
        case Region::Kind::line:
          locate_all(*solids[region.body], region.at, path);
          return line_nodes(region, path);
        case Region::Kind::body:
          for (unsigned int n = firsts[region.body].first;
               n < firsts[region.body + 1].first;
               ++n)
            result.insert(n);
          return result;
        default:
          check_surface(*solids[region.body], region.surface, path);
          for (const auto &[number, face] : faces(region.body, region.surface))
            for (const unsigned int i : element_type.face_nodes(face))
              result.insert(nodes_of(number)[i]);
          return result;
      }
  }



  void
  CalculixMesh::write(std::ostream &deck) const
  {
    for (unsigned int body = 0; body < solids.size(); ++body)
      {
        const std::string name = "BODY" + std::to_string(body + 1);
        deck << "** " << name << " is the body '" << scene.bodies[body].name
             << "'\n*NODE, NSET=" << name << '\n';
        for (unsigned int n = firsts[body].first; n < firsts[body + 1].first;
             ++n)
          write_node(deck, n, node(n));
        const unsigned int n_plies = solids[body]->plies().size();
        for (unsigned int ply = 0; ply < n_plies; ++ply)
          {
            deck << "*ELEMENT, TYPE=" << element_type.name()
                 << ", ELSET=" << name << "_PLY" << ply + 1 << '\n';
            for (unsigned int e = firsts[body].second;
                 e < firsts[body + 1].second;
                 ++e)
              if (plies[e - 1] == ply)
                write_element(deck, e, nodes_of(e));
          }
      }
    write_materials(deck);
    for (unsigned int body = 0; body < solids.size(); ++body)
      write_sections(deck, body);
  }



  void
  CalculixMesh::write_materials(std::ostream &deck) const
  {
    unsigned int number = 0;
    for (const auto &[name, material] : scene.materials)
      {
        const EngineeringConstants &m = material.elastic;
        deck << "*MATERIAL, NAME=MATERIAL" << ++number << "\n** '" << name
             << "'\n";
        if (is_isotropic(m))
          deck << "*ELASTIC\n" << numbers_line({m.E1, m.nu12});
        else
          {
            deck << "** E1, E2, E3, nu12, nu13, nu23, G12, G13,\n** G23\n"
                    "*ELASTIC, TYPE=ENGINEERING CONSTANTS\n";
            std::string first = numbers_line(
              {m.E1, m.E2, m.E3, m.nu12, m.nu13, m.nu23, m.G12, m.G13});
            first.insert(first.size() - 1, ",");
            deck << first << numbers_line({m.G23});
          }
        if (material.density)
          deck << "*DENSITY\n" << numbers_line({*material.density});
      }
  }



  namespace
  {
    /// Returns the line of the axes 1 and 2 of @p ply in the scene at the point
    /// @p x in @p body.
    std::string
    axes_line(const Ply &ply, const Placement &body, const Point<3> &x)
    {
      const Triad axes = ply.axes(Point<2>(x[0], x[2])) * body.axes;
      return numbers_line({axes[0][0],
                           axes[0][1],
                           axes[0][2],
                           axes[1][0],
                           axes[1][1],
                           axes[1][2]});
    }
  } // namespace



  void
  CalculixMesh::write_orientation(std::ostream      &deck,
                                  const std::string &set,
                                  const unsigned int body,
                                  const unsigned int index) const
  {
    const Placement  &placement = scene.bodies[body].placement;
    const Ply        &ply       = solids[body]->plies()[index];
    const std::string head =
      "*ORIENTATION, NAME=" + set + "_AXES, SYSTEM=RECTANGULAR\n";
    deck << "** fiber at " << to_text(ply.angle) << " degrees\n";
    if (!ply.plane.normal_at)
      {
        deck << head << axes_line(ply, placement, Point<3>());
        return;
      }
    // In a curved wall, ply axes differ from element to element.
    const std::string table = set + "_TABLE";
    deck << "*DISTRIBUTION, NAME=" << table << "\n, "
         << numbers_line({1., 0., 0., 0., 1., 0.});
    for (unsigned int e = firsts[body].second; e < firsts[body + 1].second; ++e)
      if (plies[e - 1] == index)
        {
          Point<3> center;
          for (unsigned int i = 0; i < n_corners; ++i)
            center += node(nodes_of(e)[i]) / n_corners;
          deck << e << ", "
               << axes_line(ply, placement, placement.to_body(center));
        }
    deck << head << table << '\n';
  }



  void
  CalculixMesh::write_sections(std::ostream      &deck,
                               const unsigned int body) const
  {
    const std::vector<Ply> &plies = solids[body]->plies();
    for (unsigned int ply = 0; ply < plies.size(); ++ply)
      {
        const std::string set =
          "BODY" + std::to_string(body + 1) + "_PLY" + std::to_string(ply + 1);
        const auto place = scene.materials.find(plies[ply].material);
        Assert(place != scene.materials.end(), ExcInternalError());
        const std::string material =
          "MATERIAL" +
          std::to_string(std::distance(scene.materials.begin(), place) + 1);
        const bool isotropic = is_isotropic(plies[ply].properties.elastic);
        if (!isotropic)
          write_orientation(deck, set, body, ply);
        deck << "*SOLID SECTION, ELSET=" << set << ", MATERIAL=" << material
             << (isotropic ? "" : ", ORIENTATION=" + set + "_AXES") << '\n';
      }
  }
} // namespace lamella
