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
  /// A dead load, as numbers or functions of the undeformed x, y, z, times the
  /// load factor. Exactly one of force, pressure, couple, total and temperature
  /// applies. No factor multiplies a temperature (Body::heat()).
  struct Load
  {
    /// Name in `subsection Load NAME`.
    std::string name;
    /// Points, lines and surfaces (whole bodies for a temperature), each of
    /// which carries the full load: a force at two points acts twice.
    std::vector<Region> on;
    /// Force at a point [force], per length of a line or per area of a surface,
    /// scene components; empty for a pressure.
    std::array<Formula, 3> force;
    /// Pressure on a surface, positive into the body; empty for a force.
    Formula pressure;
    /// True if the pressure remains normal to the surface, per deformed area.
    bool is_follower = false;
    /// Moment on a surface [force x length], scene components, as tractions
    /// linear over it (Couple): on an end those of Navier, or of a round shaft.
    std::optional<dealii::Tensor<1, 3>> couple = {};
    /// Resultant [force] of all regions, spread evenly
    /// (distribute_total_forces()).
    std::optional<dealii::Tensor<1, 3>> total = {};
    /// Temperature above that of the stress-free state [K].
    Formula temperature = {};
    /// Number of its history of load factors (LoadFactor::of()).
    unsigned int history = 0;
  };

  /// Forces at points of a body equivalent to a load t on one of its regions:
  /// they do the same work on all its displacements. On a surface they are
  /// integral phi_k t dA at the trace nodes X_k of each facet, with trace
  /// functions phi_k; for constant t on a plane facet, at Gauss points.
  /// Constant expressions are exact except on curved facets.
  struct PointForces
  {
    /// Locations of the forces, in their order.
    std::vector<Location> locations;
    /// Forces in scene components [force].
    std::vector<dealii::Tensor<1, 3>> forces;

    /// Resultant [force], and its moment about the origin [force x length].
    dealii::Tensor<1, 3> force, moment;
    /// True if t varies, and the members below are set.
    bool checked = false;
    /// Integral of |t| [force]; zero if the load vanished at all points.
    double size = 0.;
    /// Resultant by a finer rule, its error, and the integrals' error [force].
    dealii::Tensor<1, 3> independent;
    double               independent_error = 0., error = 0.;
    /// Largest number of bisections along a parameter, and the point around it.
    unsigned int     bisections = 0;
    dealii::Point<3> place;
  };

  /// Integrates @p load at load factor 1 on @p region, one of its own, of @p
  /// body, adaptively on lines and surfaces (adaptive_moments()). Throws
  /// InputError as add_load() does, and for a pressure off a surface.
  PointForces
  point_forces(const Load &load, const Region &region, const Body &body);

  /// Adds the forces @p at on @p body to f: f . v = sum of force . v(x).
  void
  add_point_forces(const Body &body, const PointForces &at, Vector &f);

  /// Resultant of a load, which reactions must balance. For the summary.
  struct LoadResultant
  {
    std::string name;
    /// Force, and moment about the origin, of all regions at load factor 1.
    dealii::Tensor<1, 3> force, moment;
    /// True if the load is a temperature, without force and moment.
    bool is_temperature = false;
    /// Notes on the integration and on parts that the theory lacks.
    std::vector<std::string> notes;
  };

  /**
   * Adds the load vector of @p load at load factor 1 to f, with a block per
   * body, constrained DoFs included,
   *   f . v = sum or integral of force . v,
   * so delta L_ext = f . delta u (Eq. 10), with the work of the given traction
   * on every displacement. A torque on a theory without rotation about the axis
   * does no work; a note says so. Throws InputError for regions outside of
   * their body and for expressions that do not parse or are not finite.
   */
  LoadResultant
  add_load(const Load &load, const Bodies &bodies, BlockVector &f);

  /// Converts the totals of @p loads to forces total / M, with M the measure of
  /// all regions as loads are integrated. Must be called before other uses of
  /// the loads. Throws InputError for regions outside of their body.
  void
  distribute_total_forces(std::vector<Load> &loads, const Bodies &bodies);

  /// Heats the bodies of the temperatures among @p loads; may be repeated.
  /// Throws InputError as Body::heat() does, and for two loads on one body.
  void
  apply_temperatures(const std::vector<Load> &loads, const Bodies &bodies);

  /// Name of the weight of all bodies among the loads.
  constexpr const char *weight_load_name = "Gravity";

  /// Adds the weight of all bodies under @p acceleration [length / s^2] at load
  /// factor 1 to f. Throws InputError without a density. Collective.
  LoadResultant
  add_weight(const dealii::Tensor<1, 3> &acceleration,
             const Bodies               &bodies,
             BlockVector                &f);
} // namespace lamella

#endif
