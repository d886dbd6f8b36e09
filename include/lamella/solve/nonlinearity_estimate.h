// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_nonlinearity_estimate_h
#define lamella_solve_nonlinearity_estimate_h

#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  class LinearSystem;
  class Structure;
  struct State;

  /// Effects of large deflections that a linear solution neglects, estimated.
  struct NonlinearityEstimate
  {
    /// Relative stiffening r = 2 U(s_m) / U, the largest of all bodies with a
    /// considerable part of the energy: U is the strain energy of the body, and
    /// U(s_m) that of the membrane stress due to its deflection (SecondOrder).
    /// Forces at prescribed displacements are about 1 + r times linear ones.
    double stiffening = 0.;
    /// Index of the body with the largest relative stiffening.
    unsigned int stiffened = 0;

    /// Smallest positive lambda of (K + lambda K_G) v = 0 for fixed active
    /// constraints, with the stiffness K and geometric stiffness K_G of linear
    /// and membrane stresses (SecondOrder). The state buckles at lambda times
    /// the loads if stresses grow in proportion. Its error is 5 % if lambda is
    /// above 10, much less below. Empty if lambda is above 100, if short-wave
    /// buckling is possible below lambda, if there is no compression, or if
    /// `stiffening` is above 1.
    std::optional<double> buckling_factor;
    /// Index of the body with the largest energy in the buckling mode.
    unsigned int buckled = 0;
    /// Relative growth of the displacements u by the buckling mode, |c| / |u| /
    /// (lambda - 1), with the buckling factor lambda. c is the component of u
    /// along the mode in the energy norm. Zero for a straight column. Without
    /// buckling factor: the first-order growth -u.K_G u / u.K u (see
    /// `buckling_factor`), from 0 to 1 / (largest lambda considered).
    double amplification = 0.;

    /// Returns false beyond the range of linear kinematics.
    bool
    is_in_range() const
    {
      return stiffening <= 1. && buckling_factor.value_or(1.) >= 1.;
    }
  };

  /// Returns the estimates for @p state, whose bodies have the strain energies
  /// @p energies. @p solver, which has computed the state, solves a linear
  /// system for the membrane stress and at most 30 for the Lanczos method, with
  /// fixed active constraints. Modes that only springs restrain are excluded.
  NonlinearityEstimate
  beyond_linear(const Structure           &structure,
                LinearSystem              &solver,
                const State               &state,
                const std::vector<double> &energies);

  /// Returns warnings about the estimates @p found; none if stiffening and
  /// amplification are below 1 % and loads below a tenth of the buckling load.
  std::vector<std::string>
  warnings_of(const NonlinearityEstimate &found, const Structure &structure);

  /// Throws NumericsError if stiffening is above or buckling factor below 1.
  void
  check_linear_range(const NonlinearityEstimate &found,
                     const Structure            &structure);
} // namespace lamella

#endif
