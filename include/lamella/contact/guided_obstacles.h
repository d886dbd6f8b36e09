// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_guided_obstacles_h
#define lamella_contact_guided_obstacles_h

#include <lamella/conditions/load.h>
#include <lamella/conditions/stabilization.h>
#include <lamella/contact/contact_pair.h>
#include <lamella/contact/parameters.h>

#include <vector>

namespace lamella
{
  /// Appends those of @p obstacles that a force presses to @p bodies
  /// (GuidedObstacle), their forces to @p loads, and their springs to
  /// @p stabilizations. Throws InputError if one is in none of @p contacts.
  void
  add_guided_obstacles(const Obstacles                &obstacles,
                       const std::vector<ContactPair> &contacts,
                       Bodies                         &bodies,
                       std::vector<Load>              &loads,
                       std::vector<Stabilization>     &stabilizations);
} // namespace lamella

#endif
