// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_checks_h
#define lamella_solve_checks_h

#include <lamella/solve/kkt_residual.h>
#include <lamella/solve/linear_system.h>
#include <lamella/solve/nonlinearity_estimate.h>

#include <vector>

namespace lamella
{
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

} // namespace lamella

#endif
