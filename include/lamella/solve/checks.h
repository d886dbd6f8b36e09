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
  /// and the range of linear kinematics. Internal forces are computed from
  /// strains, not from the matrix. The balance of a body is skipped if its
  /// strain energy is within the rounding of its displacements.
  struct Checks
  {
    /// Reaction forces of the supports on the bodies; moments are about the
    /// center of the bounding box of the supported points.
    std::vector<Resultant> reactions;
    /// Residual of the contact law of each contact, in the order of the scene.
    std::vector<KktResidual> contacts;
    /// Largest sum of all forces on one body (loads, reactions, contacts,
    /// springs), over the largest single force, or couple over body size.
    double force_balance = 0.;
    /// Largest sum of all moments about the center of a body, relative to its
    /// size times the reference force of `force_balance`.
    double moment_balance = 0.;
    /// Equilibrium residual |G^T (t f + B^T lambda - internal)| / |internal| in
    /// the maximum norm, with external loads t f, contact forces B^T lambda,
    /// the condensation G of the supports, and spring forces in `internal`.
    double residual = 0.;
    /// Strain energy 1/2 integral (e - e_0)^T C (e - e_0) dV with the thermal
    /// strain e_0, and external work, half the work of loads and reactions.
    double energy = 0., external_work = 0.;
    /// Strain energy of each body; zero if it is within rounding.
    std::vector<double> energies;
    /// Energy of the stabilizing springs, and its ratio to the total energy;
    /// both are rounding once the springs are released.
    double stabilization_energy = 0., stabilization_share = 0.;
    /// |energy - external_work - half the contact forces times displacements|
    /// over the larger of the first two, springs included: zero by Clapeyron's
    /// theorem. For heated bodies, `energy` is that of the total strains, and
    /// the work of the thermal load is included.
    double energy_balance = 0.;
    /// Largest rotation [rad]; Eq. 5 neglects about half its square.
    double max_rotation = 0.;
    /// True for finite rotations: forces and moments refer to the current
    /// configuration, without energy balance. Below: largest strains, rotations
    /// and shape change (Deformation).
    bool   is_large   = false;
    double max_strain = 0., max_rms_strain = 0., max_element_rotation = 0.,
           shape_change = 0.;
    /// Estimated effects of large deflections; not set by check_state().
    NonlinearityEstimate beyond;
    /// Largest displacement component of all bodies and obstacles.
    double max_displacement = 0.;
  };

  /// Returns the rounding error of the displacements @p u of a body [length].
  double
  displacement_rounding(const Vector &u);

  /// Returns the checks of @p state at load factor @p factor. The stiffness of
  /// @p tangent bounds the rounding of an energy. @p contacts have the
  /// constraints of the forces of the state, contact by contact. Supports are
  /// numbered from 0 to @p n_supports - 1. Costs two loops over all elements;
  /// collective. A failed check does not throw: see check_solution().
  Checks
  check_state(const TangentOperator               &tangent,
              const std::vector<ContactInterface> &contacts,
              const unsigned int                   n_supports,
              const State                         &state,
              const LoadFactor                    &factor);

} // namespace lamella

#endif
