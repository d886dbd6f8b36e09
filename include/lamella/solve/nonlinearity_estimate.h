// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_nonlinearity_estimate_h
#define lamella_solve_nonlinearity_estimate_h

#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  class ContactSolver;
  class Structure;
  struct State;

  /// Estimates of the nonlinear effects that a state of the linear model
  /// neglects, from that model alone. The stiffening vanishes with the square
  /// of the loads, the inverse buckling factor linearly.
  struct NonlinearityEstimate
  {
    /// r = 2 U(s_m) / U, the largest of all bodies with a share of the energy:
    /// U is the strain energy of a body and U(s_m) that of the membrane stress
    /// due to its own deflection (SecondOrder). Forces at given displacements
    /// are about 1 + r times those of the linear model. A clamped strip with
    /// the deflection W (1 - cos (2 pi y / L)) / 2 has r = 0.75 (W / h)^2 (von
    /// Karman).
    double stiffening = 0.;
    /// Index of the body with the largest r.
    unsigned int stiffened = 0;

    /// Smallest positive lambda of (K + lambda K_G) v = 0, with the geometric
    /// stiffness of s_0 + s_m (SecondOrder) and fixed active constraints. The
    /// state buckles at lambda times the loads if stresses grow in proportion.
    /// Error: 5 % above 10, much less below. Empty above 100, without
    /// compression, for a stiffening above 1, and above the limit of short
    /// waves in the material (SecondOrder::largest_short_wave_ratio()).
    std::optional<double> buckling_factor;
    /// Index of the body with most of the energy of the buckling mode.
    unsigned int buckled = 0;
    /// Relative growth of the displacements u by the buckling mode: |c| / |u| /
    /// (lambda - 1), where c is the part of u along the mode in the energy
    /// norm, which grows to c lambda / (lambda - 1). Zero for a straight
    /// column. Without a buckling factor: the first-order growth -u.K_G u / u.K
    /// u, between zero and the largest 1 / lambda for which no factor is given.
    double amplification = 0.;
  };

  /// Returns the estimates for @p state, whose bodies have the strain energies
  /// @p energies. @p solver has solved the state. It solves again with the
  /// active constraints: once for the membrane stress, and once for each
  /// Lanczos step with K^-1 K_G in the inner product of K, usually 5 to 8 and
  /// at most 30. Modes that only springs resist are excluded. Collective.
  NonlinearityEstimate
  beyond_linear(const Structure           &structure,
                ContactSolver             &solver,
                const State               &state,
                const std::vector<double> &energies);

  /// Returns warnings about @p found, none if stiffening and amplification are
  /// below 1 % and the loads below a tenth of the buckling loads.
  std::vector<std::string>
  warnings_of(const NonlinearityEstimate &found, const Structure &structure);

  /// Throws NumericsError: stiffening above 1 or buckling factor below 1.
  void
  check_linear_range(const NonlinearityEstimate &found,
                     const Structure            &structure);
} // namespace lamella

#endif
