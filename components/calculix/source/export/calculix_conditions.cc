// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/export/calculix_mesh.h>

#include <cmath>
#include <ostream>

namespace lamella
{
  using namespace dealii;

  CalculixElement::CalculixElement(const std::string &name)
    : element_name(name)
  {
    const std::vector<std::string> names{"C3D20R", "C3D8I", "C3D8R"};
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw InputError(
        "export.unknown-element: there is no such element. Choose one of " +
        joined(names) + "; the most similar is " + nearest_name(name, names) +
        ".")
        .at("--element " + name + ": ");
    // Corners around the bottom, then around the top.
    for (const double z : {0., 1.})
      for (const auto &[x, y] : std::array<std::array<double, 2>, 4>{
             {{{0., 0.}}, {{1., 0.}}, {{1., 1.}}, {{0., 1.}}}})
        unit_nodes.emplace_back(x, y, z);
    if (name != "C3D20R")
      return;
    // The middles of the edges: around the bottom, the top, then upright.
    const auto add_middle = [this](const unsigned int a, const unsigned int b) {
      unit_nodes.push_back(unit_nodes[a] +
                           0.5 * (unit_nodes[b] - unit_nodes[a]));
    };
    for (const unsigned int first : {0, 4})
      for (unsigned int v = 0; v < 4; ++v)
        add_middle(first + v, first + (v + 1) % 4);
    for (unsigned int v = 0; v < 4; ++v)
      add_middle(v, v + 4);
  }



  std::vector<double>
  CalculixElement::shape_values(const Point<3> &unit) const
  {
    std::vector<double> values;
    for (const Point<3> &node : unit_nodes)
      {
        double product = 1., sum = 0.;
        bool   corner = true;
        for (unsigned int d = 0; d < 3; ++d)
          {
            const double r = 2. * unit[d] - 1., at = 2. * node[d] - 1.;
            product *= at == 0. ? 1. - r * r : 0.5 * (1. + at * r);
            sum += at * r;
            corner = corner && at != 0.;
          }
        // A corner's function of 20 nodes vanishes at the middles of its edges.
        values.push_back(product * (degree() == 2 && corner ? sum - 2. : 1.));
      }
    return values;
  }



  std::vector<unsigned int>
  CalculixElement::face_nodes(const unsigned int face) const
  {
    std::vector<unsigned int> nodes;
    for (unsigned int i = 0; i < n_nodes(); ++i)
      if (unit_nodes[i][face / 2] == face % 2)
        nodes.push_back(i);
    return nodes;
  }



  unsigned int
  calculix_face(const unsigned int face)
  {
    // x = 0, x = 1, y = 0, y = 1, z = 0, z = 1 by their corners: 4-8-5-1,
    // 2-6-7-3, 1-5-6-2, 3-7-8-4, 1-2-3-4, 5-8-7-6.
    constexpr std::array<unsigned int, 6> number{{6, 4, 3, 5, 1, 2}};
    return number[face];
  }



  namespace
  {
    /// The nodes of @p surface of @p body with the outward normals there.
    std::map<unsigned int, Tensor<1, 3>>
    node_normals(const CalculixMesh &mesh, const Region &region)
    {
      std::map<unsigned int, Tensor<1, 3>> normals;
      for (const SurfacePoint &point :
           mesh.bodies()[region.body]->surface_points(region.surface))
        if (const unsigned int node = mesh.node_at(region.body, point.location))
          normals[node] = point.normal;
      return normals;
    }



    /// Returns the number of rigid motions that supports leave free. Throws
    /// InputError for one in a static step, and for bodies that an isostatic
    /// support or Stabilization constrains.
    unsigned int
    count_free_motions(const Scene        &scene,
                       const CalculixMesh &mesh,
                       const bool          has_static_steps)
    {
      for (const BodyDescription &body : scene.bodies)
        if (body.is_held)
          throw InputError(
            "Body " + body.name + "/Isostatic support",
            "true",
            "export.isostatic-support: isostatic supports are not exported",
            "Constrain the body by a Support, and remove Isostatic support.");
        else if (body.stabilization.value_or(0.) != 0.)
          throw InputError(
            "Body " + body.name + "/Stabilization",
            to_text(*body.stabilization),
            "export.stabilization-not-exported: Stabilization is not exported",
            "Constrain the body by a Support and write Stabilization = 0.");
      const std::vector<PrescribedFunctional> rows =
        prescribed_functionals(scene.supports, mesh.bodies());
      const bool has_ties =
        std::any_of(scene.contacts.begin(),
                    scene.contacts.end(),
                    [](const auto &pair) { return pair.is_tied(); });
      unsigned int n = 0;
      for (unsigned int body = 0; body < scene.bodies.size(); ++body)
        for (const FreeMotion &motion :
             free_rigid_motions(*mesh.bodies()[body], body, rows))
          if (++n; has_static_steps && !has_ties)
            throw InputError(
              "Body " + scene.bodies[body].name,
              "",
              "export.unconstrained-motion: only contact prevents the " +
                motion.words +
                ", so the stiffness of CalculiX would be singular",
              "Constrain this motion by a Support.");
      return n;
    }



    /// What acts in volumes the deck does not say.
    void
    check_no_volume_loads(const Scene &scene)
    {
      for (const Load &load : scene.loads)
        if (!load.temperature.empty())
          throw InputError(
            "Load " + load.name + "/Temperature",
            load.temperature.text(),
            "export.temperature-not-exported: temperatures are not exported",
            "Remove this load from Loads.");
      if (scene.gravity.norm() > 0.)
        throw InputError("Gravity",
                         to_text(scene.gravity),
                         "export.gravity-not-exported: weight is not exported",
                         "Write Gravity = 0, 0, 0.");
    }



    /// Nodal forces of a deck keep their direction.
    void
    check_loads_are_dead(const Scene &scene)
    {
      if (scene.solve.rotations == Rotations::automatic)
        throw InputError("Rotations",
                         name_of(scene.solve.rotations),
                         "export.automatic-rotations: auto is for runs only",
                         "Write Rotations = linear or large.");
      if (scene.solve.rotations == Rotations::linear)
        return;
      for (const Load &load : scene.loads)
        if (load.couple || load.is_follower)
          throw InputError(
            "Load " + load.name + "/" + (load.couple ? "Couple" : "Pressure"),
            load.couple ? to_text(*load.couple) :
                          load.pressure.text() + ", follows",
            "export.follower-load: follower loads are not exported to CalculiX",
            "Use a Force, or remove 'follows' from the Pressure.");
    }



    /// The turn of @p support, if it has one.
    std::optional<RigidRotation>
    rotation_of(const Support      &support,
                const Scene        &scene,
                const CalculixMesh &mesh)
    {
      if (!support.rotation)
        return {};
      if (scene.solve.rotations == Rotations::large)
        throw InputError(
          "Support " + support.name + "/Rotation",
          to_text(*support.rotation),
          "export.large-rotation: CalculiX scales displacements by the load "
          "factor, but those of a finite rotation are not proportional to it",
          "Use Rotations = linear, or a Load with a Couple.");
      return rigid_rotation(support, mesh.bodies());
    }
  } // namespace



  CalculixConditions::CalculixConditions(const Scene        &scene,
                                         const CalculixMesh &mesh)
    : scene(scene)
    , held(scene.supports.size())
  {
    check_no_volume_loads(scene);
    for (unsigned int s = 0; s < scene.supports.size(); ++s)
      add_support(s, mesh);
    has_statics =
      !scene.find.modes || !scene.loads.empty() || !scene.contacts.empty() ||
      std::any_of(values.begin(), values.end(), [](const auto &prescribed) {
        return prescribed.second != 0.;
      });
    n_free_motions = count_free_motions(scene, mesh, has_statics);

    std::vector<Load> loads = scene.loads;
    check_loads_are_dead(scene);
    distribute_total_forces(loads, mesh.bodies());
    for (const Load &load : loads)
      for (const Region &region : load.on)
        {
          const PointForces at =
            point_forces(load, region, *mesh.bodies()[region.body]);
          for (unsigned int k = 0; k < at.forces.size(); ++k)
            {
              const Location::Place    &place = at.locations[k].places[0];
              const std::vector<double> N =
                mesh.element().shape_values(place.unit);
              const auto &nodes =
                mesh.nodes_of(mesh.element_of(region.body, place.cell));
              for (unsigned int i = 0; i < N.size(); ++i)
                if (std::abs(N[i]) > arithmetic::rounding_of_sums)
                  nodal_forces[nodes[i]] += N[i] * at.forces[k];
            }
        }
  }



  void
  CalculixConditions::add_support(const unsigned int  s,
                                  const CalculixMesh &mesh)
  {
    const Support                     &support = scene.supports[s];
    const std::string                  path    = "Support " + support.name;
    const std::optional<RigidRotation> rotation =
      rotation_of(support, scene, mesh);
    for (const Region &region : support.on)
      if (support.normal)
        for (const auto &[node, normal] : node_normals(mesh, region))
          {
            unsigned int c = 0;
            while (c < 3 &&
                   std::abs(normal[c]) < 1. - arithmetic::rounding_of_results)
              ++c;
            if (c == 3)
              throw InputError(
                path + "/Normal displacement",
                "",
                "export.oblique-normal: at " + to_text(mesh.node(node)) +
                  " the normal is not along an axis of the scene, but CalculiX "
                  "input files prescribe displacements along these only",
                "Align the normal with an axis, or prescribe u.");
            hold(
              node, c, std::copysign(1., normal[c]) * *support.normal, s, mesh);
          }
      else
        for (const unsigned int node : mesh.region_nodes(region, path))
          for (unsigned int c = 0; c < 3; ++c)
            if (support.u[c])
              hold(node,
                   c,
                   rotation ? rotation->rate(0., mesh.node(node))[c] :
                              *support.u[c],
                   s,
                   mesh);
  }



  void
  CalculixConditions::hold(const unsigned int  node,
                           const unsigned int  component,
                           const double        value,
                           const unsigned int  s,
                           const CalculixMesh &mesh)
  {
    const auto [place, is_new] = values.insert({{node, component}, value});
    if (is_new)
      held[s][component].insert(node);
    else if (std::abs(place->second - value) >
             arithmetic::rounding_of_results *
               std::max(std::abs(value), std::abs(place->second)))
      throw InputError("Support " + scene.supports[s].name,
                       "",
                       "export.contradicting-supports: at " +
                         to_text(mesh.node(node)) +
                         " this support prescribes " + to_text(value) +
                         ", but another support " + to_text(place->second) +
                         " there",
                       "Write equal values, or free in one support.");
  }



  double
  CalculixConditions::load_vector_on(const unsigned int s,
                                     const unsigned int c) const
  {
    double sum = 0.;
    for (const auto &[node, force] : nodal_forces)
      if (held[s][c].count(node) > 0)
        sum += force[c];
    return sum;
  }



  std::string
  CalculixConditions::set_name(const unsigned int s, const unsigned int c)
  {
    return "SUPPORT" + std::to_string(s + 1) + "_" + "XYZ"[c];
  }



  void
  CalculixConditions::write_sets(std::ostream &deck) const
  {
    for (unsigned int s = 0; s < held.size(); ++s)
      {
        deck << "** SUPPORT" << s + 1 << " is the support '"
             << scene.supports[s].name << "'\n";
        for (unsigned int c = 0; c < 3; ++c)
          if (!held[s][c].empty())
            write_set(deck, "*NSET, NSET=" + set_name(s, c), held[s][c]);
      }
  }



  void
  CalculixConditions::write_step(std::ostream &deck, const double factor) const
  {
    if (!values.empty())
      deck << "*BOUNDARY\n";
    for (const auto &[where, value] : values)
      deck << where.first << ", " << where.second + 1 << ", "
           << where.second + 1 << ", " << calculix_number(factor * value)
           << '\n';
    if (!nodal_forces.empty())
      deck << "*CLOAD\n";
    for (const auto &[node, force] : nodal_forces)
      for (unsigned int c = 0; c < 3; ++c)
        if (force[c] != 0.)
          deck << node << ", " << c + 1 << ", "
               << calculix_number(factor * force[c]) << '\n';
  }
} // namespace lamella
