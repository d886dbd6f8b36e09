// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_checks_h
#define lamella_solve_checks_h

#include <lamella/solve/kkt_residual.h>
#include <lamella/solve/linear_system.h>
#include <lamella/solve/tangent_operator.h>

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

  /// Results of the checks of a load step: equilibrium, energy, the contact law
  /// and the range of linear kinematics. The force and moment balances of a
  /// body are skipped if its strain energy is below that of rounding errors.
  struct Checks
  {
    /// Reaction forces of the supports on the bodies; moments are about the
    /// center of the bounding box of the supported points.
    std::vector<Resultant> reactions;
    /// Residual of the contact law of each contact, in the order of the scene.
    std::vector<KktResidual> contacts;
    /// Largest sum of all forces on one body (loads, reactions, contacts,
    /// springs), over the largest single force (or moment over body size).
    double force_balance = 0.;
    /// Largest sum of all moments about the center of one body, over the body
    /// size times the largest single force (or moment over body size) on it.
    double moment_balance = 0.;
    /// Equilibrium residual |G^T (t f + B^T lambda - p)| / |p| in the maximum
    /// norm: external loads t f, contact forces B^T lambda, internal and spring
    /// forces p computed from strains, and condensation G of the supports.
    double residual = 0.;
    /// Strain energy 1/2 int (e - e_0)^T C (e - e_0) dV, thermal strain e_0.
    double energy        = 0.;
    double external_work = 0.; ///< Half the work of loads and reactions.
    /// Strain energy of each body; zero if below that of rounding errors.
    std::vector<double> energies;
    /// Energy of the stabilizing springs; about zero once they are released.
    double stabilization_energy = 0.;
    double stabilization_share  = 0.; ///< Spring over total energy.
    /// Relative error of the energy balance (Clapeyron's theorem): strain and
    /// spring energy minus external_work and half the contact forces times
    /// displacements, over the largest energy or work. For heated bodies, the
    /// energy of the total strains and the work of the thermal load are used.
    double energy_balance = 0.;
    /// Largest rotation [rad]; linear kinematics neglects half its square.
    double max_rotation = 0.;
    /// True for finite rotations: forces and moments refer to the current
    /// configuration, and there is no energy balance. False if linear.
    bool   is_large   = false;
    double max_strain = 0., ///< Largest principal Green strain.
      max_rms_strain  = 0., ///< Largest rms of the axial strain over a section.
      max_element_rotation = 0., ///< Largest rotation within an element [rad].
      shape_change = 0.; ///< Relative moment error due to rigid section shape.
    /// Estimated effects of large deflections; not set by check_state().
    NonlinearityEstimate beyond;
    /// Largest displacement component of all bodies and obstacles.
    double max_displacement = 0.;
  };

  /// Returns the rounding error of the displacements @p u of one body [length].
  double
  displacement_rounding(const Vector &u);

  /// Returns the checks of @p state at load factor @p factor. @p contacts have
  /// the constraints of the forces of @p state. Supports have the indices 0 to
  /// @p n_supports - 1. Collective. A failed check does not throw.
  Checks
  check_state(const TangentOperator               &tangent,
              const std::vector<ContactInterface> &contacts,
              const unsigned int                   n_supports,
              const State                         &state,
              const LoadFactor                    &factor);


  /// Throws NumericsError if @p state is not reliable, i.e. if
  /// - stabilizing springs store more than a tenth of the energy,
  /// - the last correction of a refinement exceeds 1e-6 of the displacements,
  /// - the residual, or a force, moment or energy balance, exceeds 1e-3,
  /// - a contact force is tensile,
  /// - an error of the contact law exceeds 1e-6 of the displacements,
  /// - values are not finite, or a rotation exceeds @p rotation_limit [rad], or
  /// - the rms axial strain of a section exceeds 5 % (finite rotations).
  void
  check_solution(const State  &state,
                 const Checks &checks,
                 const double  rotation_limit);

  /// Throws NumericsError if supports of the same points contradict each other
  /// at finite rotations: if points in the state of @p here are not at their
  /// prescribed positions at load factor @p at. The tolerance is ten times the
  /// displacement error that rotation of warped sections causes.
  void
  check_followed(const TangentOperator &here, const LoadFactor &at);

  /// Returns warnings about a reliable @p state, one sentence each, if
  /// - bodies overlap initially, or penetrate by 1e-3 of the displacements,
  /// - mean and pointwise gaps of a contact differ by 1e-2 of these,
  /// - rotations exceed 0.1 rad, or springs store more than 1e-3 of the energy,
  /// - errors of balances, or the first refinement correction, exceed 1e-7, or
  /// - strains or rotations within elements are large (finite rotations).
  std::vector<std::string>
  warnings_of(const State                         &state,
              const Checks                        &checks,
              const std::vector<ContactInterface> &contacts);
} // namespace lamella

#endif
