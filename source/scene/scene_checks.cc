// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/memory.h>
#include <lamella/base/text.h>
#include <lamella/material/parameters.h>
#include <lamella/scene/scene.h>
#include <lamella/scene/scene_checks.h>

#include <numeric>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  namespace
  {
    // Value, column in matrix and pattern; half again for the solver's format.
    constexpr double bytes_per_entry = 24.;

    // Smaller bodies are built quickly, with an exact check.
    constexpr double small = 2e5;

    double
    sum(const std::vector<unsigned int> &numbers)
    {
      return std::accumulate(numbers.begin(), numbers.end(), 0.);
    }



    /// Returns DoFs and a lower bound of the non-zeros of the stiffness.
    std::pair<double, double>
    displacement_scale(const BodyDescription &body,
                       const Laminate        &laminate,
                       const unsigned int     divisions)
    {
      const double times = 1u << divisions,
                   nx    = times * sum(laminate.cells_across),
                   nz    = times *
                        (laminate.cells_per_ply.size() == 1 ?
                           laminate.cells_per_ply[0] * laminate.angles.size() :
                           sum(laminate.cells_per_ply)),
                   ny = sum(body.axis.elements), p = body.theory.order;
      const double q    = body.theory.is_solid() ? p : body.axis.degree;
      const double dofs = 3. * (p * nx + 1.) * (p * nz + 1.) * (q * ny + 1.);
      // A node couples with 2 p + 1 nodes at element ends, p + 1 inside.
      return {dofs, dofs * 3. * (p + 2.) * (p + 2.) * (q + 2.)};
    }



    /// Throws InputError for dissipation of a contact without friction, for the
    /// contact area of a tie, and for peel and shear of a contact that is none.
    void
    check_contact_columns(const Scene &scene)
    {
      for (const auto *quantities :
           {&scene.goals.quantities, &scene.trade.quantities})
        for (const NamedQuantity &quantity : *quantities)
          for (const ContactPair &contact : scene.contacts)
            if (quantity.of == NamedQuantity::ObjectKind::contact &&
                contact.name == quantity.name)
              {
                const Entry        entry(quantity.path, quantity.label());
                const std::string &column  = quantity.column;
                const bool         is_tied = contact.is_tied();
                if (column == "dissipated" && contact.friction == 0.)
                  entry.refuse(
                    "scene.no-friction: contact " + contact.name +
                      " has no friction",
                    "Write Friction there, or remove this quantity.");
                if (is_tied &&
                    (column == "pressure" || column.rfind("width", 0) == 0))
                  entry.refuse(
                    "contact.area-of-tie: the surfaces of a tie have no "
                    "contact area that depends on the load",
                    "Use peel, shear, or the forces fx, fy, fz.");
                if (!is_tied && (column == "peel" || column == "shear"))
                  entry.refuse(
                    "contact.peel-without-tie: contact " + contact.name +
                      " is not tied",
                    "Write Enforcement = tied there, or use pressure.");
              }
    }
  } // namespace



  void
  check_sizes(const Scene &scene)
  {
    for (const BodyDescription &body : scene.bodies)
      {
        const auto *laminate =
          std::get_if<Laminate>(&scene.sections.at(body.section));
        if (laminate == nullptr ||
            !(body.theory.is_layerwise() || body.theory.is_solid()))
          continue;
        const auto [dofs, entries] =
          displacement_scale(body, *laminate, scene.divisions_of(body.section));
        const double bytes     = bytes_per_entry * entries,
                     available = available_memory(scene.solve.memory_limit);
        if (dofs > small && bytes > available)
          throw InputError(
            "Body " + body.name,
            "",
            "scene.too-large: " + body.theory.name() +
              " with this section and this axis has " + to_text(dofs, 3) +
              " DoFs, whose stiffness matrix alone needs more memory than " +
              gigabytes(bytes) + "; the machine has " + gigabytes(available) +
              " available",
            "Use fewer cells (Section " + body.section +
              "/Cells across, Cells per ply), fewer Axis "
              "elements, or a theory of lower order.");
      }
  }



  void
  check_friction(const Scene &scene, const Entries &in)
  {
    check_contact_columns(scene);
    const ContactPair *const contact = first_with_friction(scene);
    if (contact == nullptr)
      {
        if (scene.solve.substeps.number != 1)
          in["Substeps"].refuse("scene.substeps-without-friction: no contact "
                                "has friction, so substeps change nothing",
                                "Remove Substeps.");
        return;
      }
    if (!scene.goals.tolerances.empty())
      throw InputError(
        "Goals/Tolerance",
        "",
        "scene.tolerance-with-friction: contact " + contact->name +
          " has friction, but a Tolerance does not refine load steps",
        "Remove Tolerance; Error bars = true estimates errors.");
  }



  namespace
  {
    constexpr double pi = dealii::numbers::PI;



    /// Returns the lengths of @p units per meter.
    double
    meter(const Units &units)
    {
      return 1. / std::sqrt(units.pascal);
    }



    std::string
    check_units(const Units &units, const std::string &what)
    {
      return ". Units = " + units.length + ", " + units.force +
             " means lengths in " + units.length + "; check that " + what +
             " in this unit";
    }



    std::string
    angle_warning(const SectionMesh &section)
    {
      // Limit for radians, about pi, and a tolerance for three or more digits.
      constexpr double most = 3.2, written = 1e-3;
      const Ply       *told = nullptr;
      unsigned int     part = 0;
      for (const Ply &ply : section.plies)
        {
          if (std::abs(ply.angle) > most)
            return "";
          for (const unsigned int n : {2, 3, 4, 6})
            if (std::abs(std::abs(ply.angle) - pi / n) < written)
              {
                told = &ply;
                part = n;
              }
        }
      if (told == nullptr)
        return "";
      return "scene.angle-in-radians: the angle " + to_text(told->angle) +
             " of a ply equals pi / " + std::to_string(part) +
             ", as if in radians (no angle exceeds " + to_text(most) +
             "). Angles are in degrees: write " + std::to_string(180 / part) +
             " if this is meant";
    }



    std::string
    soft_material_warning(const SectionMesh &section, const Units &units)
    {
      // Lower limit of plies, metals, glass and wood [Pa]; density of foams
      // [kg / m^3] and Poisson's ratio of rubbers, which may be softer.
      constexpr double soft = 1e9, light = 600., incompressible = 0.45;
      const Ply       &stiffest =
        *std::max_element(section.plies.begin(),
                          section.plies.end(),
                          [](const Ply &a, const Ply &b) {
                            return largest_modulus(a.properties).second <
                                   largest_modulus(b.properties).second;
                          });
      const Material &material = stiffest.properties;
      const auto [name, E]     = largest_modulus(material);
      const bool is_soft =
        material.core || material.elastic.nu12 >= incompressible ||
        (material.density &&
         *material.density < light * units.pascal * units.pascal);
      if (E >= soft * units.pascal || is_soft ||
          !material_warnings("", material, units).empty())
        return "";
      return "scene.soft-material: the stiffest material of the section, " +
             stiffest.material + ", has " + name + " = " + to_text(E) + " " +
             units.stress + ", but plies and metals have more than " +
             to_text(soft * units.pascal) + " " + units.stress +
             " (foams and rubbers less). Units = " + units.length + ", " +
             units.force + " means stresses in " + units.stress +
             "; check that the moduli are in this unit";
    }



    std::string
    size_warning(const SectionMesh &section, const Units &units)
    {
      // Limits in micrometers.
      constexpr double thinnest = 1., thickest = 1e7;
      const auto   box = dealii::GridTools::compute_bounding_box(section.mesh);
      const double thickness =
        1e6 * std::min(box.side_length(0), box.side_length(1)) / meter(units);
      if (thickness >= thinnest && thickness <= thickest)
        return "";
      return "scene.section-size: the section is " +
             to_text(box.side_length(0)) + " by " +
             to_text(box.side_length(1)) + " " + units.length +
             (thickness < thinnest ? ", thinner than a micrometer" :
                                     ", thicker than 10 m") +
             check_units(units, "the lengths of the section are");
    }



    /// Returns the material name and thickness of each ply of @p shape.
    std::vector<std::pair<std::string, double>>
    thicknesses(const SectionShape &shape)
    {
      std::vector<std::pair<std::string, double>> all;
      const auto add = [&all](const WallLayup &layup) {
        for (const WallPly &ply : layup)
          all.emplace_back(ply.oriented_material.material, ply.thickness);
      };
      if (const auto *laminate = std::get_if<Laminate>(&shape))
        for (unsigned int k = 0; k < laminate->materials.size(); ++k)
          all.emplace_back(laminate->materials[k], laminate->thicknesses[k]);
      else if (const auto *tube = std::get_if<Tube>(&shape))
        add(tube->layup);
      else if (const auto *walls = std::get_if<ThinWalled>(&shape))
        for (const WallLayup &layup : walls->layups)
          add(layup);
      return all;
    }



    std::string
    ply_thickness_warning(const SectionShape &shape, const Scene &scene)
    {
      // Thickness of carbon fibers and upper limit for plies [micrometers];
      // lower limits for E1 of fiber plies [Pa] and for E1 / E3.
      constexpr double thinnest = 5., thickest = 1e5, stiff = 30e9,
                       of_fibers = 2.;
      const Units &units         = scene.units;
      for (const auto &[name, thickness] : thicknesses(shape))
        {
          const EngineeringConstants &c = scene.materials.at(name).elastic;
          const double in_micrometers   = 1e6 * thickness / meter(units);
          if (c.E1 > stiff * units.pascal && c.E1 > of_fibers * c.E3 &&
              (in_micrometers < thinnest || in_micrometers > thickest))
            return "scene.ply-thickness: the section has a ply of " + name +
                   " with the thickness " + to_text(thickness) + " " +
                   units.length +
                   (in_micrometers < thinnest ?
                      ", thinner than its fibers (5 micrometers)" :
                      ", thicker than 100 mm") +
                   check_units(units, "Ply thickness is");
        }
      return "";
    }



    std::vector<std::string>
    section_warnings(const Scene &scene, const SectionMeshes &meshes)
    {
      std::vector<std::string> plausibility_warnings;
      for (const auto &[name, mesh] : meshes)
        {
          std::vector<std::string> of_section{angle_warning(*mesh)};
          if (!scene.units.stress.empty())
            {
              of_section.push_back(soft_material_warning(*mesh, scene.units));
              const std::string size = size_warning(*mesh, scene.units);
              // One of the two warnings suffices.
              of_section.push_back(
                size.empty() ?
                  ply_thickness_warning(scene.sections.at(name), scene) :
                  size);
            }
          for (const std::string &warning : of_section)
            if (!warning.empty())
              {
                const Message message(warning);
                plausibility_warnings.push_back(message.identifier +
                                                ": section " + name + ": " +
                                                message.text);
              }
        }
      return plausibility_warnings;
    }
  } // namespace



  std::vector<std::string>
  magnitude_warnings(const Scene &scene, const SectionMeshes &meshes)
  {
    // Gravity of the Earth: 9.78 to 9.83 m/s^2.
    constexpr double         least = 9.7, most = 9.9, thousand = 1000.;
    std::vector<std::string> plausibility_warnings =
      section_warnings(scene, meshes);
    const double g     = scene.gravity.norm();
    const bool   is_mm = scene.units.length == "mm";
    const double there = is_mm ? g : g / thousand;
    if (!scene.units.length.empty() && there > least && there < most)
      plausibility_warnings.push_back(
        "scene.unusual-gravity: Gravity is " + to_text(g) + " " +
        scene.units.length + "/s^2, but on Earth the value is " +
        (is_mm ? "9810" : "9.81") + ". Check its unit");
    for (const Support &support : scene.supports)
      if (support.rotation && support.rotation->norm() > 2. * pi)
        plausibility_warnings.push_back(
          "scene.rotation-above-turn: support " + support.name +
          ": its Rotation, " + to_text(support.rotation->norm()) +
          " rad, is more than a revolution. A degree is 0.0174533 rad");
    return plausibility_warnings;
  }



  namespace
  {
    /// Returns the path of a load, support or obstacle that oscillates, or "".
    std::string
    first_oscillating(const Scene &scene)
    {
      const LoadFactor &factors = scene.solve.load_factors.back();
      for (const auto &obstacle : scene.obstacles)
        if (factors.oscillates(obstacle->history))
          Entry("Obstacle " + obstacle->name + "/Factors", "harmonic")
            .refuse("scene.oscillating-obstacle: obstacles cannot "
                    "oscillate",
                    "Let a support or a load oscillate.");
      for (const Load &load : scene.loads)
        if (factors.oscillates(load.history))
          return "Load " + load.name;
      for (const Support &support : scene.supports)
        if (factors.oscillates(support.history))
          return "Support " + support.name;
      return "";
    }
  } // namespace



  void
  check_response(const Scene &scene)
  {
    const std::string path = first_oscillating(scene);
    if (!scene.find.response && !path.empty())
      Entry(path + "/Factors", "harmonic")
        .refuse("scene.harmonic-without-response: only Find = response "
                "has oscillating loads and supports",
                "Write Find = response, or other Factors.");
    if (!scene.find.response)
      return;
    const Entry find("Find", "response");
    if (path.empty() && scene.find.response->base_acceleration.norm() == 0.)
      find.refuse("scene.response-without-oscillation: nothing oscillates",
                  "Write Factors = harmonic in a load or support, or Base "
                  "acceleration in subsection Harmonic response.");
    if (scene.probes.empty())
      find.refuse("scene.response-without-probes: the response is given at "
                  "probes, and the scene has none",
                  "Add a probe to Probes.");
    for (const Probe &probe : scene.probes)
      if (probe.stress == StressValues::equilibrium)
        Entry("Probe " + probe.name + "/Stress", "equilibrium")
          .refuse("scene.response-by-equilibrium: stresses by "
                  "equilibrium do not include inertial forces",
                  "Write Stress = recovered.");
  }
} // namespace lamella
