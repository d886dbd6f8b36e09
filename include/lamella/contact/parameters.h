// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_parameters_h
#define lamella_contact_parameters_h

#include <lamella/base/entry.h>
#include <lamella/conditions/load.h>
#include <lamella/conditions/stabilization.h>
#include <lamella/contact/contact_pair.h>
#include <lamella/contact/gap_constraints.h>

#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// Rigid obstacles in the order of the input file; contacts share ownership.
  using Obstacles = std::vector<std::shared_ptr<const Obstacle>>;

  /// Parameters of a contact, `subsection Contact NAME`: surfaces,
  /// discretization, search distance, overclosure, enforcement, tolerance, and
  /// friction.
  struct ContactParameters
  {
    /// Declares the entries with their defaults, patterns and documentation.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Reads the contact @p name between two of @p bodies, or between a body
    /// and one of @p obstacles. make_interface() checks later that the surfaces
    /// exist. `Penalty = auto` becomes 1e6 times the local stiffness. Throws
    /// InputError for an unknown body or obstacle, an obstacle as First, two
    /// surfaces of one body, an obstacle with `node to node` or as the slave, a
    /// Tolerance of 0.5 or more, and a Friction below 0 or above 10.
    static ContactPair
    parse(const Entries                  &in,
          const std::string              &name,
          const std::vector<std::string> &bodies,
          const Obstacles                &obstacles);
  };

  /// Parameters of a rigid obstacle, `subsection Obstacle NAME`: Shape,
  /// Through, Normal, Axis, Radius and the displacement u [length] or Force.
  struct ObstacleParameters
  {
    /// Declares the entries with their defaults, patterns and documentation.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Reads the obstacle @p name and normalizes its direction. Never returns
    /// null. Under a Force, its displacement is the DoF of the body with index
    /// @p body. Throws InputError for a missing shape, a zero direction, a
    /// cylinder without a positive radius, a plane with a radius, and a Force
    /// that is zero, beside u, or away from the bodies.
    static std::shared_ptr<Obstacle>
    parse(const Entries &in, const std::string &name, const unsigned int body);
  };

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
