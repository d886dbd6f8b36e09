// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_parameters_h
#define lamella_contact_parameters_h

#include <lamella/base/entry.h>
#include <lamella/contact/gap_rows.h>

#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// Obstacles in the order of the scene's list. None of them is null; contacts
  /// share them.
  using Obstacles = std::vector<std::shared_ptr<const Obstacle>>;

  /// The entries of a `subsection Contact NAME`: the two surfaces, the
  /// discretisation and the side of its points, the search distance,
  /// overclosure, enforcement and penalty, the tolerance of facing nodes, and
  /// friction.
  struct ContactParameters
  {
    /// Declares them with their defaults, patterns and what they mean.
    static void
    declare(dealii::ParameterHandler &prm);

    /**
     * The contact @p name of bodies with the names @p bodies, or of one and an
     * obstacle, which must be among @p obstacles. Throws InputError, also for
     * what an obstacle does not have; surfaces are not known yet and are
     * checked by make_interface().
     *
     * `Penalty = auto` becomes 1e6 times the local stiffness. Refused are an
     * obstacle in First, two surfaces of one body, an obstacle with `node to
     * node` or with the points on its side, a Tolerance of 0.5 or more, and a
     * Friction below 0 or above 10.
     */
    static ContactPair
    parse(const Entries                  &in,
          const std::string              &name,
          const std::vector<std::string> &bodies,
          const Obstacles                &obstacles);
  };

  /// The entries of a `subsection Obstacle NAME`: Shape, Through, Normal, Axis,
  /// Radius [length] and the displacement u [length].
  struct ObstacleParameters
  {
    /// As that of a contact.
    static void
    declare(dealii::ParameterHandler &prm);

    /// The obstacle @p name, its direction a unit vector. Throws InputError.
    /// Refused are no shape, a direction of no length, a cylinder without a
    /// positive radius and a plane with one. Normal of a cylinder and Axis of a
    /// plane are not read. Never null.
    static std::shared_ptr<Obstacle>
    parse(const Entries &in, const std::string &name);
  };
} // namespace lamella

#endif
