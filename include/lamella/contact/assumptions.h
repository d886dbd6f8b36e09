// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_assumptions_h
#define lamella_contact_assumptions_h

#include <lamella/contact/gap_rows.h>

#include <string>
#include <vector>

namespace lamella
{
  /**
   * Throws InputError of `Contact NAME` if two of @p interfaces hold the same
   * places of the same two bodies apart: their forces would be counted twice.
   * The message names the places. Contacts by weighted gaps may share a line of
   * nodes, since the areas on either side of it are different ones.
   *
   * Two places are the same if they are within 1e-9 of the body's size of each
   * other, their partners within the root of the tributary area, and their
   * normals within 60 degrees; contacts with the same obstacle are compared,
   * too. Each pair of contacts between the same two bodies costs a search among
   * their points. To be called once, before anything is solved.
   */
  void
  check_conflicts(const std::vector<ContactInterface> &interfaces,
                  const Bodies                        &bodies);

  /**
   * Throws InputError of `Contact NAME/Discretisation` where pairs of nodes
   * leave most of a contact open: where of the nodes of either side that face
   * the other surface fewer than half have a partner. The bodies would pass
   * through each other there. Of bodies as they are solved, not of those that
   * axes are graded with.
   */
  void
  check_partners(const std::vector<ContactInterface> &interfaces);

  /// How far places that are held apart slide along each other: the tangential
  /// part of the relative displacement, d - (d . n) n with d = u_2 - u_1, which
  /// node pairs of the undeformed bodies take for small.
  struct Sliding
  {
    /// [length]
    double distance = 0.;
    /// Of the points there, see ContactInterface::Point. [length]; 0 if there
    /// was no row to look at.
    double spacing = 0.;
    /// On First, undeformed, scene axes.
    dealii::Point<3> position;
  };

  /**
   * The worst of the rows @p active of @p interface, by distance over spacing,
   * for the displacements @p u at load factor @p factor. @p active are numbers
   * of the interface's own rows. An obstacle has moved by @p factor times its
   * displacement. Throws InputError if a point of the interface is not in its
   * body, as locate_all() finds it.
   */
  Sliding
  largest_sliding(const ContactInterface          &interface,
                  const Bodies                    &bodies,
                  const BlockVector               &u,
                  const LoadFactor                &factor,
                  const std::vector<unsigned int> &active);

  /**
   * What the solution says against the pairing, a sentence each: rows hold
   * places apart that faced each other at the start, along the normals of the
   * start. So the normals of active pairs should be nearly collinear (5 degrees
   * apart, the gap along their average is off by 1e-3) and what slides should
   * slide by little against the spacing of points (a tenth).
   *
   * Of the rows @p active (the interface's own numbers), those that carry force
   * in the state @p u at load factor @p factor. At most one sentence on sliding
   * and one on normals, each with the worst place; none without active rows.
   */
  std::vector<std::string>
  broken_assumptions(const ContactInterface          &interface,
                     const Bodies                    &bodies,
                     const BlockVector               &u,
                     const LoadFactor                &factor,
                     const std::vector<unsigned int> &active);
} // namespace lamella

#endif
