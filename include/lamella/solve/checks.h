// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_checks_h
#define lamella_solve_checks_h

#include <lamella/solve/contact_solver.h>
#include <lamella/solve/kkt_residual.h>
#include <lamella/solve/nonlinearity_estimate.h>

#include <vector>

namespace lamella
{
  /// Results of the checks of a load step: equilibrium, energy, the contact law
  /// and the range of linear kinematics. The balance of a body is skipped if
  /// its strain energy is within the rounding of its displacements.
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
    /// Strain energy of each body; zero if it is within rounding.
    std::vector<double> energies;
    /// Energy of the stabilizing springs; rounding once they are released.
    double stabilization_energy = 0.;
    double stabilization_share  = 0.; ///< Spring over total energy.
    /// |energy - external_work - half the contact forces times displacements|
    /// over the larger of the first two, springs included: zero by Clapeyron's
    /// theorem. For heated bodies, `energy` is here that of the total strains,
    /// and the work of the thermal load is included.
    double energy_balance = 0.;
    /// Largest rotation [rad]; linear kinematics neglects half its square.
    double max_rotation = 0.;
    /// True for finite rotations: forces and moments refer to the current
    /// configuration, and energies are not balanced. False if linear.
    bool   is_large   = false;
    double max_strain = 0., ///< Largest principal Green strain.
      max_rms_strain  = 0., ///< Largest rms of the axial strain over a section.
      max_element_rotation = 0., ///< Largest rotation within an element [rad].
      shape_change = 0.; ///< Relative error of moments by rigid section shapes.
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
