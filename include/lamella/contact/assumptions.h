// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_assumptions_h
#define lamella_contact_assumptions_h

#include <lamella/contact/gap_constraints.h>

#include <string>
#include <vector>

namespace lamella
{
  /**
   * Throws InputError of `Contact NAME` if two of @p interfaces constrain the
   * same points of the same two bodies, which would count their forces twice.
   * The message names the places. Contacts with weighted gaps may share a line
   * of nodes, since the areas on either side differ. Two points coincide if
   * they are within 1e-9 of the body size, their partners within the root of
   * the tributary area, and their normals within 60 degrees. Call once, before
   * the solution.
   */
  void
  check_conflicts(const std::vector<ContactInterface> &interfaces,
                  const Bodies                        &bodies);

  /// Throws InputError of `Contact NAME/Discretization` if fewer than half of
  /// the nodes of either side that face the other surface have a partner: the
  /// bodies would pass through each other.
  void
  check_node_matching(const std::vector<ContactInterface> &interfaces);

  /// Relative sliding of paired points, the tangential part of d = u_2 - u_1,
  /// which pairs of undeformed nodes assume to be small.
  struct Sliding
  {
    /// Sliding distance [length].
    double distance = 0.;
    /// Spacing of the points, see ContactInterface::Point [length]; else 0.
    double spacing = 0.;
    /// Position on First, undeformed, scene axes.
    dealii::Point<3> position;
  };

  /// Returns the largest sliding relative to the spacing of the rows @p active
  /// of @p interface (its own row numbers) for the displacements @p u at load
  /// factor @p factor, which also moves an obstacle. Throws InputError if a
  /// point of the interface is not in its body (locate_all()).
  Sliding
  largest_sliding(const ContactInterface          &interface,
                  const Bodies                    &bodies,
                  const BlockVector               &u,
                  const LoadFactor                &factor,
                  const std::vector<unsigned int> &active);

  /**
   * Returns warnings on violated assumptions of the pairing, one sentence each:
   * constraints pair the points that face each other initially, along the
   * initial normals. The normals of active pairs should be nearly collinear (at
   * 5 degrees the gap along their average is off by 1e-3), and sliding small
   * against the spacing of points (a tenth). Considers the rows @p active with
   * a force in the state @p u at load factor @p factor; at most one sentence
   * each on sliding and on normals, with the worst place.
   */
  std::vector<std::string>
  assumption_warnings(const ContactInterface          &interface,
                      const Bodies                    &bodies,
                      const BlockVector               &u,
                      const LoadFactor                &factor,
                      const std::vector<unsigned int> &active);
} // namespace lamella

#endif
