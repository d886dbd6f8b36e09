// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/body/guided_obstacle.h>
#include <lamella/body/parameters.h>
#include <lamella/contact/guided_obstacles.h>

#include <algorithm>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // The load of the only DoF of the obstacle is |Force|.
    Load
    load_on(const Obstacle &obstacle)
    {
      Load load;
      load.name = "Obstacle " + obstacle.name;
      load.on.resize(1);
      load.on[0].body = *obstacle.body;
      load.on[0].kind = Region::Kind::point;
      load.on[0].at   = {obstacle.point};
      load.history    = obstacle.history;
      for (unsigned int c = 0; c < 3; ++c)
        load.force[c] = obstacle.force[c];
      return load;
    }
  } // namespace



  void
  add_guided_obstacles(const Obstacles                &obstacles,
                       const std::vector<ContactPair> &contacts,
                       Bodies                         &bodies,
                       std::vector<Load>              &loads,
                       std::vector<Stabilization>     &stabilizations)
  {
    for (const auto &obstacle : obstacles)
      {
        if (!obstacle->body)
          continue;
        const auto presses = std::find_if(contacts.begin(),
                                          contacts.end(),
                                          [&](const ContactPair &contact) {
                                            return contact.obstacle == obstacle;
                                          });
        if (presses == contacts.end())
          throw InputError("Obstacle " + obstacle->name + "/Force",
                           to_text(obstacle->force),
                           "contact.force-without-contact: no contact balances "
                           "this force",
                           "Name the obstacle in Second of a Contact.");
        AssertThrow(*obstacle->body == bodies.size(), ExcInternalError());
        const Body &pressed = *bodies[presses->first.body];
        loads.push_back(load_on(*obstacle));
        stabilizations.push_back({stabilization_of_contact, &pressed});
        bodies.push_back(std::make_unique<GuidedObstacle>(obstacle->name,
                                                          obstacle->guide(),
                                                          pressed));
      }
  }
} // namespace lamella
