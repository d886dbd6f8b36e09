// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_beyond_linear_h
#define lamella_solve_beyond_linear_h

#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  class ContactSolver;
  class Structure;
  struct State;

  /**
   * How far a state of the linear model is from what large deflections would
   * make of it, by its own numbers. Both are ratios, and both are zero effect
   * as loads go to zero: the stiffening grows with their square, the loads over
   * the buckling factor with themselves.
   */
  struct BeyondLinear
  {
    /// r = 2 U(s_m) / U: U the strain energy of a body and U(s_m) that of the
    /// stress that stays where it is stretched by its own deflection
    /// (SecondOrder). The largest of all bodies that hold a share of the
    /// energy. Forces at given displacements are about 1 + r times those of the
    /// linear model: in a strip clamped at both ends with the deflection
    /// W (1 - cos (2 pi y / L)) / 2 it is 0.75 (W / h)^2, von Karman's.
    double stiffening = 0.;
    /// The number of the body that it is of.
    unsigned int stiffened = 0;

    /// Smallest positive lambda of (K + lambda K_G) v = 0, with the geometric
    /// stiffness of s_0 + s_m (SecondOrder) and active contact constraints
    /// held. The state buckles at lambda times the loads, if stresses grow in
    /// proportion. Error: 5 % above 10, much less below. None above 100,
    /// without compression, for a stiffening above 1, and above the limit of
    /// short waves in the material (SecondOrder::short_waves()), which are no
    /// structural buckling.
    std::optional<double> buckling_factor;
    /// The number of the body that holds most of the energy of that mode.
    unsigned int buckled = 0;
    /// Relative growth of the displacements u by the buckling mode: |c| / |u| /
    /// (lambda - 1), c the part of u along the mode in the energy norm, which
    /// grows to c lambda / (lambda - 1). Zero if loads do not excite the mode,
    /// as for a straight column. Without a factor: the first-order growth
    /// -u.K_G u / u.K u, at least zero, at most the largest 1 / lambda that no
    /// factor is given for.
    double amplification = 0.;
  };

  /**
   * That of @p state, whose bodies have the strain energies @p energies, heat
   * included. @p solver has solved it and solves again, with the rows that are
   * active: once for the stretch, and once for each step of Lanczos' iteration
   * with K^-1 K_G in the inner product of K, 5 to 8 as a rule and at most 30.
   * Modes that stabilising springs hold rather than the bodies are none.
   * Collective.
   */
  BeyondLinear
  beyond_linear(const Structure           &structure,
                ContactSolver             &solver,
                const State               &state,
                const std::vector<double> &energies);

  /// What is to be said of @p found, a sentence each without a full stop:
  /// nothing where stiffening and amplification are below 1 % and the loads are
  /// below a tenth of those that buckle.
  std::vector<std::string>
  warnings_of(const BeyondLinear &found, const Structure &structure);

  /// Throws NumericsError where the stiffening is above 1 or the buckling
  /// factor below 1: the linear result is then no approximation.
  void
  require_linear_range(const BeyondLinear &found, const Structure &structure);
} // namespace lamella

#endif
