// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_load_h
#define lamella_conditions_load_h

#include <lamella/conditions/expression.h>
#include <lamella/conditions/region.h>

#include <array>
#include <string>
#include <vector>

namespace lamella
{
  /**
   * A given force, as numbers or functions of the scene's x, y, z.
   */
  struct Load
  {
    std::string         name;
    std::vector<Region> on;
    /// Scene components: a force at a point, a force per length along a line, a
    /// force per area on a surface. Empty if the load is a pressure.
    std::array<Formula, 3> force;
    /// On a surface, force per area against its outward normal.
    Formula pressure;
  };

  /**
   * Forces at points of a body that stand for a load t on one of its regions:
   * they do the same work on all displacements that the body can have there.
   * On a surface the points are the trace nodes X_k of each facet and the
   * forces integral phi_k t dA, with phi_k the facet's trace functions; where t
   * is constant on a plane facet, Gauss points for these functions.
   */
  struct PointForces
  {
    std::vector<Location>             locations;
    std::vector<dealii::Tensor<1, 3>> forces;

    /// What the region carries in all, and its moment about the scene's origin.
    dealii::Tensor<1, 3> force, moment;
    /// Whether t varies and what follows was found.
    bool checked = false;
    /// integral |t|.
    double size = 0.;
    /// The sum of another, finer rule, and what the integrals may be off by.
    dealii::Tensor<1, 3> independent;
    double               error = 0.;
    /// How often an element had to be bisected, and around which point.
    unsigned int     bisections = 0;
    dealii::Point<3> place;
  };

  /// @p load at load factor 1 on @p region, one of its own, of @p body:
  /// integrated adaptively along a line and on a surface
  /// (adaptive_moments()). Throws InputError as add_load() does.
  PointForces
  point_forces(const Load &load, const Region &region, const Body &body);

  /// What a load is in all.
  struct LoadResultant
  {
    std::string name;
    /// On all of its regions, at load factor 1; the moment about the scene's
    /// origin.
    dealii::Tensor<1, 3> force, moment;
    /// What the user should know of how it was integrated and of what its
    /// bodies cannot feel, a sentence each.
    std::vector<std::string> notes;
  };

  /**
   * f += the load vector of @p load at load factor 1,
   *   f . v = sum or integral of force . v.
   * Throws InputError for regions outside of their body and for expressions
   * that do not parse or are not finite.
   */
  LoadResultant
  add_load(const Load &load, const Bodies &bodies, BlockVector &f);
} // namespace lamella

#endif
