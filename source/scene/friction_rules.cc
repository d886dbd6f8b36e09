// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/scene/friction_rules.h>
#include <lamella/scene/histories.h>

#include <algorithm>

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
                .refuse("contact " + contact.name + " has no friction",
                        "Give it some (Friction), or leave this out.");
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
          in["Substeps"].refuse(
            "no contact has friction, so the way to a load step changes "
            "nothing",
            "Leave it out.");
        return;
      }
    const std::string rule = "contact " + contact->name + " has friction";
    if (!scene.goals.tolerances.empty())
      throw InputError(
        "Goals/Tolerance",
        "",
        rule + ", and a run to a tolerance makes no load steps shorter",
        "Leave Tolerance out; Error bars = true says how "
        "sure the numbers are.");
  }
} // namespace lamella
