// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_checks_h
#define lamella_solve_checks_h

#include <lamella/solve/contact_solver.h>
#include <lamella/solve/kkt_residual.h>
#include <lamella/solve/nonlinearity_estimate.h>

#include <vector>

namespace lamella
{
  /// Checks of a load step: equilibrium, energy, the contact law and the range
  /// of linear kinematics. All are evaluated at the state with internal forces
  /// from strains, not from the matrix of the solution. The forces of a body
  /// are skipped if its strain energy is within the rounding of its
  /// displacements, such as when its supports move it as a whole.
  struct Checks
  {
    /// Reactions of the supports on the bodies, in the order of the scene.
    /// Moments are about the center of the bounding box of the points held by
    /// the support.
    std::vector<Resultant> reactions;
    /// Contact law of each contact, in the order of the scene.
    std::vector<KktResidual> contacts;
    /// Largest sum of all forces on one body (loads, the reaction of each
    /// support, contacts, springs), over the largest single one on it: a force,
    /// or a couple over the size of the body.
    double force_balance = 0.;
    /// Largest sum of all moments about the center of a body, over the size of
    /// the body and the largest single force of `force_balance`. Errors of
    /// lever arms, and rotations that a support or contact row does not follow,
    /// appear here.
    double moment_balance = 0.;
    /// |G^T (t f + B^T lambda - internal)| / |internal|, maximum norms;
    /// `internal` includes the spring forces.
    double residual = 0.;
    /// Strain energy 1/2 integral (e - e_0)^T C (e - e_0) dV with the thermal
    /// strain e_0, and half the sum of loads and reactions times their
    /// displacements (the external work if all forces grow in proportion).
    double energy = 0., external_work = 0.;
    /// Strain energy of each body, thermal strain included; zero where it is
    /// rounding, such as in a body that moves rigidly or expands freely.
    std::vector<double> energies;
    /// Energy in the stabilizing springs of all bodies, and its share of the
    /// total. Zero, but for rounding, once the springs are released.
    double stabilization_energy = 0., stabilization_share = 0.;
    /// |energy - external_work - half the contact forces times their
    /// displacements| over the larger of the first two, spring energy included:
    /// zero by Clapeyron's theorem. With heat, `energy` is here that of the
    /// total strains, and the thermal load f_0 also does work.
    double energy_balance = 0.;
    /// Largest rotation of all bodies [rad]. The linear strain (Eq. 5) neglects
    /// about half its square.
    double max_rotation = 0.;
    /// True if bodies have finite rotations. Reactions, moments and balances
    /// then refer to the current positions, work and energy balance are not
    /// evaluated, and the measures of Deformation are given.
    bool   is_large   = false;
    double max_strain = 0., max_mean_strain = 0., max_element_rotation = 0.,
           shape_change = 0.;
    /// Estimates of the effects of large deflections; not set by check_state(),
    /// which solves nothing.
    NonlinearityEstimate beyond;
    /// Largest component of all displacements, including those of obstacles.
    double max_displacement = 0.;
  };

  /// Returns the rounding error of the displacements @p u of a body [length];
  /// forces and energies that result from it have no meaning.
  double
  displacement_rounding(const Vector &u);

  /**
   * Returns the checks of @p state at load factor @p factor. The stiffness of
   * @p tangent bounds the rounding of an energy. @p contacts are those whose
   * constraints, one contact after the other, the forces of the state belong
   * to. Supports are numbered from 0 to @p n_supports - 1, as in
   * Structure::prescribed(). Costs two loops over all elements and no solution;
   * collective. Does not throw on a failed check: see check_solution().
   */
  Checks
  check_state(const TangentOperator               &tangent,
              const std::vector<ContactInterface> &contacts,
              const unsigned int                   n_supports,
              const State                         &state,
              const LoadFactor                    &factor);

} // namespace lamella

#endif
