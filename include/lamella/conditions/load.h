// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_load_h
#define lamella_conditions_load_h

#include <lamella/conditions/expression.h>
#include <lamella/conditions/load_factor.h>
#include <lamella/conditions/region.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /**
   * A given force, as numbers or functions of the scene's x, y, z. Dead loads
   * of linear theory: position and normal are those of the undeformed body, and
   * all of it is multiplied by the load factor of the step. One of force,
   * pressure, couple, total and temperature counts. A temperature is no force
   * but what its bodies are (Body::heat()); no load factor multiplies it.
   */
  struct Load
  {
    /// As in `subsection Load NAME`.
    std::string name;
    /// Points, lines and surfaces, on one body or several; of a temperature,
    /// and of nothing else, whole bodies. Each carries the load anew: a force
    /// at two points is there twice.
    std::vector<Region> on;
    /// Scene components: a force at a point, a force per length along a line, a
    /// force per area on a surface. In [force], [force/length],
    /// [force/length^2]. Empty if the load is a pressure.
    std::array<Formula, 3> force;
    /// On a surface, force per area against its outward normal. So a positive
    /// one pushes into the body. Empty if the load is a force.
    Formula pressure;
    /// Whether the pressure stays normal to the surface as that turns, and is
    /// per area of the deformed one: of bodies that turn by any angle.
    bool follows = false;
    /**
     * On a surface, a moment [force x length], scene components, as tractions
     * that are linear over it (Couple). On an end a bending moment gives the
     * axial traction of Navier, a torque that of a round shaft.
     */
    std::optional<dealii::Tensor<1, 3>> couple = {};
    /// On surfaces or lines, what all regions together carry [force], scene
    /// components, spread evenly over their area or length: the force per
    /// length or area follows from it when the bodies are there
    /// (spread_totals()).
    std::optional<dealii::Tensor<1, 3>> total = {};
    /// By how much bodies are warmer than without stress [K].
    Formula temperature = {};
    /// Of its load factors (LoadFactor::of()).
    unsigned int history = 0;
  };

  /**
   * Forces at points of a body that stand for a load t on one of its regions:
   * they do the same work on all displacements that the body can have there. On
   * a surface the points are the trace nodes X_k of each facet and the forces
   * integral phi_k t dA, with phi_k the facet's trace functions; where t is
   * constant on a plane facet, Gauss points for these functions. What follows
   * the two lists tells how well the integration went; `checked`, `size` and
   * `error` concern expressions that vary, since constant ones are integrated
   * exactly but for curved facets.
   */
  struct PointForces
  {
    /// As many as forces, one for each.
    std::vector<Location> locations;
    /// Scene components [force].
    std::vector<dealii::Tensor<1, 3>> forces;

    /// What the region carries in all, and its moment about the scene's origin.
    /// [force] and [force x length].
    dealii::Tensor<1, 3> force, moment;
    /// Whether t varies and what follows was found.
    bool checked = false;
    /// integral |t| [force]: what errors are compared with. Zero where the load
    /// was zero wherever it was looked at.
    double size = 0.;
    /// The sum of another, finer rule and what that may be off by, and what the
    /// integrals may be. All [force].
    dealii::Tensor<1, 3> independent;
    double               independent_error = 0., error = 0.;
    /// How often an element had to be bisected along one of its parameters, and
    /// (place, in the scene) around which point.
    unsigned int     bisections = 0;
    dealii::Point<3> place;
  };

  /// @p load at load factor 1 on @p region, one of its own, of @p body:
  /// integrated adaptively along a line and on a surface (adaptive_moments()).
  /// Throws InputError as add_load() does. Nothing is communicated: every
  /// process computes all of it. At points the forces are the values of the
  /// expressions there; pressure needs a surface.
  PointForces
  point_forces(const Load &load, const Region &region, const Body &body);

  /// f += what @p at does on @p body: f . v = sum of force . v(x).
  void
  add_point_forces(const Body &body, const PointForces &at, Vector &f);

  /// What a load is in all. For the summary: the sums that reactions must
  /// balance.
  struct LoadResultant
  {
    std::string name;
    /// On all of its regions, at load factor 1; the moment about the scene's
    /// origin. [force] and [force x length], scene axes.
    dealii::Tensor<1, 3> force, moment;
    /// Whether it is a temperature, which has neither.
    bool is_heat = false;
    /// What the user should know of how it was integrated and of what its
    /// bodies cannot feel, a sentence each.
    std::vector<std::string> notes;
  };

  /**
   * f += the load vector of @p load at load factor 1,
   *   f . v = sum or integral of force . v.
   * Throws InputError for regions outside of their body and for expressions
   * that do not parse or are not finite.
   *
   * So delta L_ext = f . delta u (Eq. 10), integrated consistently: the load
   * does the same work on every displacement that the body has there as the
   * given traction does. A torque about the axis of a body whose theory cannot
   * turn about it does no work and is left out, which a note says. @p f has one
   * block per body of @p bodies; constrained DoFs get their share, too.
   */
  LoadResultant
  add_load(const Load &load, const Bodies &bodies, BlockVector &f);

  /// Gives those of @p loads that have a total the force per area or length
  /// that makes it: total / M, M the measure of all their regions as loads are
  /// integrated, so that the resultant is the total to rounding. Throws
  /// InputError for regions outside of their body. To be called before loads
  /// are used otherwise.
  void
  spread_totals(std::vector<Load> &loads, const Bodies &bodies);

  /// Heats the bodies of @p bodies that a temperature among @p loads is on, as
  /// often as it is called. Throws InputError as Body::heat() does, for an
  /// expression that does not parse, and for a body that two loads heat.
  void
  apply_heat(const std::vector<Load> &loads, const Bodies &bodies);

  /// What the weight of all bodies is called among the loads.
  constexpr const char *name_of_weight = "Gravity";

  /// f += the weight of all bodies under @p acceleration (scene axes, length /
  /// s^2) at load factor 1. Throws InputError for a material without density.
  /// Collective.
  LoadResultant
  add_weight(const dealii::Tensor<1, 3> &acceleration,
             const Bodies               &bodies,
             BlockVector                &f);
} // namespace lamella

#endif
