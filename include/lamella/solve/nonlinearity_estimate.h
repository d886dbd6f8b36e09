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

  /// Estimates of the nonlinear effects that a solution of the linear model
  /// neglects, from that model alone.
  struct NonlinearityEstimate
  {
    /// Relative stiffening r = 2 U(s_m) / U, the largest of all bodies with a
    /// considerable part of the energy. U is the strain energy of a body and
    /// U(s_m) that of the membrane stress due to its own deflection
    /// (SecondOrder). At prescribed displacements, forces are about 1 + r times
    /// those of the linear model.
    double stiffening = 0.;
    /// Index of the body with the largest r.
    unsigned int stiffened = 0;

    /// Smallest positive lambda of (K + lambda K_G) v = 0, with the geometric
    /// stiffness K_G of the stresses s_0 (linear) and s_m (SecondOrder) and
    /// fixed active constraints. The state buckles at lambda times the loads if
    /// stresses grow in proportion. Error: 5 % above 10, much less below. Empty
    /// if it is above 100 or above SecondOrder::largest_short_wave_ratio(), if
    /// there is no compression, or if `stiffening` is above 1.
    std::optional<double> buckling_factor;
    /// Index of the body with the largest energy in the buckling mode.
    unsigned int buckled = 0;
    /// Relative growth of the displacements u by the buckling mode, |c| / |u| /
    /// (lambda - 1). c is the component of u along the mode in the energy norm,
    /// which grows to c lambda / (lambda - 1). Zero for a straight column. If
    /// there is no buckling factor: the first-order growth -u.K_G u / u.K u, at
    /// least zero and at most 1 / lambda for the largest lambda considered.
    double amplification = 0.;
  };

  /// Returns the estimates for @p state, whose bodies have the strain energies
  /// @p energies. @p solver, which has solved the state, solves linear systems
  /// with the active constraints: one for the membrane stress, and one for each
  /// of at most 30 Lanczos steps. Modes restrained by springs are excluded.
  NonlinearityEstimate
  beyond_linear(const Structure           &structure,
                ContactSolver             &solver,
                const State               &state,
                const std::vector<double> &energies);

  /// Returns warnings about the estimates @p found; none if stiffening and
  /// amplification are below 1 % and loads below a tenth of buckling.
  std::vector<std::string>
  warnings_of(const NonlinearityEstimate &found, const Structure &structure);

  /// Throws NumericsError if stiffening is above or buckling factor below 1.
  void
  check_linear_range(const NonlinearityEstimate &found,
                     const Structure            &structure);
} // namespace lamella

#endif
