// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/scene/friction_rules.h>
#include <lamella/scene/histories.h>

namespace lamella
{
  namespace
  {
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
