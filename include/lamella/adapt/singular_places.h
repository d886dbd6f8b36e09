// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_singular_places_h
#define lamella_adapt_singular_places_h

#include <lamella/conditions/load.h>
#include <lamella/conditions/support.h>
#include <lamella/contact/contact_pair.h>

#include <string>
#include <vector>

namespace lamella
{
  /**
   * Why strains and stresses have no limit at the place @p position (scene
   * axes) of the body number @p body: a sentence without a full stop, empty
   * where nothing is known. However fine a model, the number that it has there
   * is its own and not the solution's. Known are
   *
   *   loads         on a point and along a line: stresses go as 1/r^2 and 1/r
   *   clamps        where an end that cannot move along the axis and along the
   *                 normal n of a free side meets it: r^-0.29 with a Poisson's
   *                 ratio of 0.3 (Williams, J. Appl. Mech. 19 (1952) 526-528).
   *                 Held in one of the two directions only, the body goes on as
   *                 its mirror image
   *   contacts      where a body ends on another that goes on, in the
   *                 undeformed scene: the edge of a punch
   *   corners       of the section, if they are re-entrant or plies that differ
   *                 end there (singular_corners()), of beams whose sections are
   *                 free to deform.
   *
   * That a certain load may leave such a place in peace, as bending does the
   * corner of an L, is not looked at; nor are points that supports hold, whose
   * reactions may be zero, and edges of obstacles.
   */
  std::string
  reason_for_no_limit(const dealii::Point<3>         &position,
                      const unsigned int              body,
                      const Bodies                   &bodies,
                      const std::vector<Support>     &supports,
                      const std::vector<Load>        &loads,
                      const std::vector<ContactPair> &contacts);
} // namespace lamella

#endif
