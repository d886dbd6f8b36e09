// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/memory.h>
#include <lamella/base/text.h>
#include <lamella/scene/scene.h>
#include <lamella/scene/scene_checks.h>

#include <numeric>

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



    /// Throws InputError for dissipation of a contact without friction.
    void
    check_dissipated(const Scene &scene)
    {
      for (const auto *quantities :
           {&scene.goals.quantities, &scene.trade.quantities})
        for (const NamedQuantity &quantity : *quantities)
          for (const ContactPair &contact : scene.contacts)
            if (quantity.of == NamedQuantity::ObjectKind::contact &&
                quantity.column == "dissipated" &&
                contact.name == quantity.name && contact.friction == 0.)
              Entry(quantity.path, quantity.label())
                .refuse("scene.no-friction: contact " + contact.name +
                          " has no friction",
                        "Write Friction there, or remove this quantity.");
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
    check_dissipated(scene);
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
} // namespace lamella
