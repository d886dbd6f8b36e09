// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_assumptions_h
#define lamella_contact_assumptions_h

#include <lamella/contact/gap_rows.h>

#include <string>
#include <vector>

namespace lamella
{
  /**
   * Throws InputError if two of @p interfaces hold the same places of the same
   * two bodies apart: their forces would be counted twice. The message names
   * the places. Contacts by weighted gaps may share a line of nodes, since the
   * areas on either side of it are different ones.
   */
  void
  check_conflicts(const std::vector<ContactInterface> &interfaces,
                  const Bodies                        &bodies);

  /// How far places that are held apart slide along each other.
  struct Sliding
  {
    double distance = 0.;
    /// Of the points there, see ContactInterface::Point.
    double           spacing = 0.;
    dealii::Point<3> position;
  };

  /// The worst of the rows @p active of @p interface, by distance over
  /// spacing, for the displacements @p u at load factor @p factor.
  Sliding
  largest_sliding(const ContactInterface          &interface,
                  const Bodies                    &bodies,
                  const BlockVector               &u,
                  const double                     factor,
                  const std::vector<unsigned int> &active);

  /**
   * What the solution says against the pairing, a sentence each: rows hold
   * places apart that faced each other at the start, along the normals of the
   * start. So the normals of active pairs should be nearly collinear (5 degrees
   * apart, the gap along their average is off by 1e-3) and what slides should
   * slide by little against the spacing of points (a tenth).
   */
  std::vector<std::string>
  broken_assumptions(const ContactInterface          &interface,
                     const Bodies                    &bodies,
                     const BlockVector               &u,
                     const double                     factor,
                     const std::vector<unsigned int> &active);
} // namespace lamella

#endif
