// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_load_h
#define lamella_conditions_load_h

#include <lamella/conditions/expression.h>
#include <lamella/conditions/load_factor.h>
#include <lamella/conditions/region.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// A load on a piece of a line (interval [0, 1] of s) or on a surface facet
  /// (unit square of s, t).
  struct LoadCell
  {
    /// Force f per unit interval or square, finite inside the cell: on a facet,
    /// the traction times the area element dA / (ds dt).
    std::function<dealii::Tensor<1, 3>(const dealii::Point<2> &)> f;
    /// Degrees of the polynomials along s and t; 0 along t for a line.
    std::array<unsigned int, 2> degree;
    /// Lengths of the cell along s and t; only their ratio is used.
    std::array<double, 2> extent;
  };

  /// Integrals of a load f over cells. phi_k are products of Lagrange
  /// polynomials through Gauss-Lobatto points:
  ///   moment_k = integral f phi_k
  /// These are consistent nodal forces if f is a traction.
  struct LoadMoments
  {
    /// Moments of_cells[c][k] of cell c and polynomial k, the first parameter s
    /// running fastest: k = k_t (degree_s + 1) + k_s.
    std::vector<std::vector<dealii::Tensor<1, 3>>> of_cells;
    double size  = 0., ///< Integral of |f| over all cells [force].
      error      = 0., ///< Estimated error of all moments together [force].
      unresolved = 0.; ///< Largest error of one Gauss rule per cell [force].
    unsigned int cell = 0; ///< Index of the cell with the error `unresolved`.
  };

  /// Returns the moments of the loads on @p cells by composite Gauss rules. A
  /// cell is divided into boxes with degree + 3 points along each parameter; at
  /// first, all cells together have about 2e4 points. The error of a box is the
  /// difference from the Gauss-Lobatto rules of degree + 4 points. The box with
  /// the largest error is bisected, along the parameter with the larger error,
  /// until the sum of errors is below 1e-9 of LoadMoments::size, or until f has
  /// been evaluated another 2e6 times. Peaks of f that no point hits are
  /// missed.
  LoadMoments
  load_moments(const std::vector<LoadCell> &cells);

  /// A load as numbers or functions of the undeformed x, y, z, multiplied by
  /// the load factor. Exactly one of force, pressure, couple, total and
  /// temperature is set. A temperature is not multiplied (Body::heat()).
  struct Load
  {
    /// Name in `subsection Load NAME`.
    std::string name;
    /// Points, lines and surfaces (whole bodies for a temperature). The full
    /// load acts on each of them: a force at two points acts twice.
    std::vector<Region> on;
    /// Force at a point [force], per length of a line or per area of a surface,
    /// scene components; empty for a pressure.
    std::array<Formula, 3> force;
    /// Pressure on a surface, positive into the body; empty for a force.
    Formula pressure;
    /// True if the pressure remains normal to the deformed surface, per
    /// deformed area; false if it keeps its initial direction and area.
    bool is_follower = false;
    /// Moment on a surface [force x length], scene components, applied as
    /// tractions linear over the surface (Couple).
    std::optional<dealii::Tensor<1, 3>> couple = {};
    /// Resultant [force] of all regions together, evenly distributed over their
    /// length or area (distribute_total_forces()).
    std::optional<dealii::Tensor<1, 3>> total = {};
    /// Temperature above that of the stress-free state [K].
    Formula temperature = {};
    /// Index of the load's factor (LoadFactor::of()); 0: that of the scene.
    unsigned int history = 0;
  };

  /// Point forces that do the same work on all discrete displacements of a body
  /// as a load t on one of its regions. On a surface they are integral phi_k t
  /// dA at the nodes of each facet, with the shape functions phi_k of the
  /// displacement on the facet; for constant t on a plane facet they are at
  /// Gauss points. Constant t is integrated exactly except on curved facets.
  struct PointForces
  {
    /// Location of each force.
    std::vector<Location> locations;
    /// Force vectors at the locations, components along the scene axes.
    std::vector<dealii::Tensor<1, 3>> forces;

    dealii::Tensor<1, 3> force, ///< Resultant force [force].
      moment; ///< Moment of the forces about the scene's origin [force length].
    /// Integral of the load on its cells; empty if the load is constant or acts
    /// at points.
    LoadMoments integral;
    /// Center of the cell LoadMoments::cell of the integral, in the scene.
    dealii::Point<3> place;
  };

  /// Returns the point forces of @p load at load factor 1 on @p region of @p
  /// body, by composite Gauss rules on lines and surfaces (load_moments()).
  /// Throws InputError as add_load() does, and for a pressure on a point or
  /// line.
  PointForces
  point_forces(const Load &load, const Region &region, const Body &body);

  /// Adds the point forces @p at on @p body to the load vector f.
  void
  add_point_forces(const Body &body, const PointForces &at, Vector &f);

  /// Resultant of a load, which reactions must balance, for the summary.
  struct LoadResultant
  {
    std::string          name;  ///< Name of the load.
    dealii::Tensor<1, 3> force, ///< Force on all regions at load factor 1.
      moment; ///< Moment about the scene's origin, of all regions.
    /// True if the load is a temperature, without force and moment.
    bool is_temperature = false;
    /// Notes for the user on the integration, and on load components that do no
    /// work, since the theory has no displacement along them.
    std::vector<std::string> notes;
  };

  /// Adds the load vector of @p load at load factor 1 to f, which has a block
  /// per body. Forces on constrained DoFs are included. With a displacement v,
  ///   f . v = sum or integral of force . v,
  /// so the external virtual work is delta L_ext = f . delta u (Eq. 10). A
  /// torque does no work in a theory without rotation about the axis; the
  /// result then has a note. Throws InputError for regions outside of their
  /// body and for expressions that are invalid or not finite.
  LoadResultant
  add_load(const Load &load, const Bodies &bodies, BlockVector &f);

  /// Converts the resultant `total` of each of @p loads to a force per length
  /// or area of its regions. Must be called before other uses of the loads.
  /// Throws InputError for regions outside of their body.
  void
  distribute_total_forces(std::vector<Load> &loads, const Bodies &bodies);

  /// Applies the temperatures among @p loads to their bodies. Throws InputError
  /// as Body::heat() does, and for two temperatures on one body.
  void
  apply_temperatures(const std::vector<Load> &loads, const Bodies &bodies);

  /// Name of the load that is the weight of all bodies.
  constexpr const char *weight_load_name = "Gravity";

  /// Adds the weight of all bodies under @p acceleration [length / s^2] at load
  /// factor 1 to f. Throws InputError if a ply has no density. Collective.
  LoadResultant
  add_weight(const dealii::Tensor<1, 3> &acceleration,
             const Bodies               &bodies,
             BlockVector                &f);

  /// Values of a load at load factor 1: the traction at points of a surface,
  /// the force per length of a line, or the force at a point.
  class Traction
  {
  public:
    /// Parses the expressions of @p load. Throws InputError if one is invalid.
    explicit Traction(const Load &load);
    ~Traction();
    Traction(Traction &&) noexcept; ///< Moves the parsed expressions.

    /// Returns the load at @p x, scene axes; for a pressure p it is -p n with
    /// the outward unit @p normal n. Throws InputError if it is not finite.
    dealii::Tensor<1, 3>
    operator()(const dealii::Point<3>     &x,
               const dealii::Tensor<1, 3> &normal) const;

    /// Returns true if the load is the same at all points of a plane surface.
    bool
    is_constant() const;

  private:
    struct Values;
    std::unique_ptr<Values> values;
  };
} // namespace lamella

#endif
