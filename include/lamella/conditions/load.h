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
  /// A dead load, as numbers or functions of the scene's x, y, z: position and
  /// normal are those of the undeformed body, and the load factor of the step
  /// multiplies it. Exactly one of force, pressure, couple, total and
  /// temperature applies. A temperature is a state of bodies (Body::heat())
  /// that no load factor multiplies.
  struct Load
  {
    /// Name in `subsection Load NAME`.
    std::string name;
    /// Points, lines and surfaces, on one or several bodies; whole bodies for a
    /// temperature only. Each carries the full load: a force at two points acts
    /// twice.
    std::vector<Region> on;
    /// Force at a point [force], per length of a line [force/length], or per
    /// area of a surface [force/length^2], scene components. Empty for a
    /// pressure.
    std::array<Formula, 3> force;
    /// Pressure on a surface, positive into the body; empty for a force.
    Formula pressure;
    /// True if the pressure follows the surface, normal to it and per deformed
    /// area, on bodies with finite rotations.
    bool is_follower = false;
    /// Moment on a surface [force x length], scene components, as tractions
    /// linear over it (Couple). On an end a bending moment has Navier's axial
    /// traction, a torque that of a round shaft.
    std::optional<dealii::Tensor<1, 3>> couple = {};
    /// Resultant of all regions (surfaces or lines) [force], scene components,
    /// spread evenly over their area or length by distribute_total_forces().
    std::optional<dealii::Tensor<1, 3>> total = {};
    /// Temperature above that of the stress-free state [K].
    Formula temperature = {};
    /// Number of its history of load factors (LoadFactor::of()).
    unsigned int history = 0;
  };

  /// Forces at points of a body equivalent to a load t on one of its regions:
  /// they do the same work on all its displacements there. On a surface they
  /// are integral phi_k t dA at the trace nodes X_k of each facet, with trace
  /// functions phi_k; for constant t on a plane facet, at Gauss points.
  /// `checked`, `size` and `error` describe the integration of varying
  /// expressions. Constant ones are exact except on curved facets.
  struct PointForces
  {
    /// Locations of the forces, in their order.
    std::vector<Location> locations;
    /// Forces in scene components [force].
    std::vector<dealii::Tensor<1, 3>> forces;

    /// Resultant [force], and its moment about the scene's origin [force x
    /// length].
    dealii::Tensor<1, 3> force, moment;
    /// True if t varies, and the members below are set.
    bool checked = false;
    /// integral |t| [force], the reference of errors. Zero if the load vanished
    /// at all points.
    double size = 0.;
    /// Resultant by a finer rule with its error, and the error of the integrals
    /// [force].
    dealii::Tensor<1, 3> independent;
    double               independent_error = 0., error = 0.;
    /// Largest number of bisections of an element along a parameter, and the
    /// point around which it was bisected, in the scene.
    unsigned int     bisections = 0;
    dealii::Point<3> place;
  };

  /// Integrates @p load at load factor 1 on @p region, one of its own, of
  /// @p body, adaptively on lines and surfaces (adaptive_moments()). At points,
  /// forces are the values of the expressions. Throws InputError as add_load()
  /// does; pressure needs a surface. Not collective: every process computes
  /// all.
  PointForces
  point_forces(const Load &load, const Region &region, const Body &body);

  /// Adds the forces @p at on @p body to f: f . v = sum of force . v(x).
  void
  add_point_forces(const Body &body, const PointForces &at, Vector &f);

  /// Resultant of a load, which reactions must balance. For the summary.
  struct LoadResultant
  {
    std::string name;
    /// Force [force] and moment about the scene's origin [force x length], of
    /// all regions at load factor 1, scene axes.
    dealii::Tensor<1, 3> force, moment;
    /// True if the load is a temperature, without force and moment.
    bool is_temperature = false;
    /// Notes on the integration and on parts that the theory cannot represent,
    /// a sentence each.
    std::vector<std::string> notes;
  };

  /**
   * Adds the load vector of @p load at load factor 1 to f,
   *   f . v = sum or integral of force . v,
   * so delta L_ext = f . delta u (Eq. 10). The integration is consistent: the
   * work on every displacement of the body is that of the given traction. A
   * torque on a body whose theory has no rotation about its axis does no work;
   * a note says so. @p f has one block per body; constrained DoFs are included.
   * Throws InputError for regions outside of their body and for expressions
   * that do not parse or are not finite.
   */
  LoadResultant
  add_load(const Load &load, const Bodies &bodies, BlockVector &f);

  /// Converts the totals of @p loads to forces per area or length, total / M,
  /// with M the measure of all regions as loads are integrated, so that the
  /// resultant is exact to rounding. Throws InputError for regions outside of
  /// their body. Must be called before other uses of the loads.
  void
  distribute_total_forces(std::vector<Load> &loads, const Bodies &bodies);

  /// Heats the bodies of the temperatures among @p loads; may be repeated.
  /// Throws InputError as Body::heat() does, for expressions that do not parse,
  /// and for a body that two loads heat.
  void
  apply_temperatures(const std::vector<Load> &loads, const Bodies &bodies);

  /// Name of the weight of all bodies among the loads.
  constexpr const char *weight_load_name = "Gravity";

  /// Adds the weight of all bodies under @p acceleration (scene axes, length /
  /// s^2) at load factor 1 to f. Throws InputError for a material without
  /// density. Collective.
  LoadResultant
  add_weight(const dealii::Tensor<1, 3> &acceleration,
             const Bodies               &bodies,
             BlockVector                &f);
} // namespace lamella

#endif
