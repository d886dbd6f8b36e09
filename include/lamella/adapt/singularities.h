// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_singularities_h
#define lamella_adapt_singularities_h

#include <lamella/conditions/load.h>
#include <lamella/conditions/support.h>
#include <lamella/contact/contact_pair.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Returns the reason why strains and stresses diverge under refinement at @p
  /// position (scene axes) of body number @p body: a sentence without a full
  /// stop, empty if no reason is known. Known reasons are
  /// - loads on a point or a line: stresses grow as 1/r^2 or 1/r, distance r;
  /// - clamps: an end constrained along the axis and along the normal of an
  ///   adjacent unconstrained side. Stresses grow as r^-0.29 for a Poisson's
  ///   ratio of 0.3 (Williams, J. Appl. Mech. 19 (1952) 526-528). An end
  ///   constrained in one of these directions only is a symmetry plane;
  /// - contacts: an end of a body on another body that continues beyond it, in
  ///   the undeformed scene, as at the edge of a punch;
  /// - corners of the section, re-entrant or at ends of different plies
  ///   (singular_corners()), if the theory lets the section deform.
  ///
  /// Not considered: loads that do not excite a singularity, such as bending at
  /// the corner of an L; supported points; and edges of obstacles.
  std::string
  singularity_reason(const dealii::Point<3>         &position,
                     const unsigned int              body,
                     const Bodies                   &bodies,
                     const std::vector<Support>     &supports,
                     const std::vector<Load>        &loads,
                     const std::vector<ContactPair> &contacts);
} // namespace lamella

#endif
