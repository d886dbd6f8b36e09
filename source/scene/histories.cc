// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/scene/histories.h>

namespace lamella
{
  std::string
  first_with_factors(const Scene &scene)
  {
    for (const Support &support : scene.supports)
      if (support.history > 0)
        return "Support " + support.name;
    for (const Load &load : scene.loads)
      if (load.history > 0)
        return "Load " + load.name;
    for (const auto &obstacle : scene.obstacles)
      if (obstacle->history > 0)
        return "Obstacle " + obstacle->name;
    return "";
  }



  const ContactPair *
  first_with_friction(const Scene &scene)
  {
    for (const ContactPair &contact : scene.contacts)
      if (contact.friction > 0.)
        return &contact;
    return nullptr;
  }
} // namespace lamella
