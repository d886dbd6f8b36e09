// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_assumptions_h
#define lamella_contact_assumptions_h

#include <lamella/contact/gap_constraints.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Throws InputError of `Contact NAME` if two of the contacts @p interfaces
  /// constrain the same points of the same two bodies, so that their forces
  /// would be counted twice. Two contacts with weighted gaps may share a line
  /// of nodes, since their areas lie on either side of it. Two points coincide
  /// if they are within 1e-9 of the body size, the opposite points within the
  /// root of the tributary area, and the normals within 60 degrees of each
  /// other. Call it before the solution.
  void
  check_conflicts(const std::vector<ContactInterface> &interfaces,
                  const Bodies                        &bodies);

  /// Throws InputError of `Contact NAME/Discretization` if fewer than half of
  /// the facing nodes of either surface have a partner node for node-to-node
  /// contact: the bodies would pass through each other.
  void
  check_node_matching(const std::vector<ContactInterface> &interfaces);

  /// Largest relative sliding of a pair of contact points, the tangential part
  /// of u_2 - u_1. Node pairs of the undeformed bodies assume that it is small.
  struct Sliding
  {
    /// Sliding distance [length].
    double distance = 0.;
    /// Spacing of the contact points [length]; 0 if nothing slides.
    double spacing = 0.;
    /// Position on the first surface, undeformed, scene axes.
    dealii::Point<3> position;
  };

  /// Returns the largest sliding, relative to the point spacing, of the active
  /// constraints @p active (numbers within @p interface) at the displacements
  /// @p u and load factor @p factor, which also moves an obstacle. Throws
  /// InputError if a contact point is not in its body (locate_all()).
  Sliding
  largest_sliding(const ContactInterface          &interface,
                  const Bodies                    &bodies,
                  const BlockVector               &u,
                  const LoadFactor                &factor,
                  const std::vector<unsigned int> &active);

  /// Returns warnings, one sentence each, if the state violates the assumptions
  /// of small-sliding contact, where constraints pair the initially facing
  /// points along the initial normals. The normals of an active pair should be
  /// nearly collinear (at 5 degrees the gap along their average is off by
  /// 1e-3), and sliding at most a tenth of the point spacing. Arguments as in
  /// largest_sliding().
  std::vector<std::string>
  assumption_warnings(const ContactInterface          &interface,
                      const Bodies                    &bodies,
                      const BlockVector               &u,
                      const LoadFactor                &factor,
                      const std::vector<unsigned int> &active);
} // namespace lamella

#endif
