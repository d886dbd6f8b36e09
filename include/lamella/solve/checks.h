// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_checks_h
#define lamella_solve_checks_h

#include <lamella/solve/beyond_linear.h>
#include <lamella/solve/contact_solver.h>
#include <lamella/solve/kuhn_tucker.h>

#include <vector>

namespace lamella
{
  /**
   * What every load step is checked for: equilibrium, energy, the contact law
   * and the range of linear kinematics. All of them are evaluated at the state
   * with internal forces from strains, not from the matrix that was solved
   * with. Where a body's strain energy is no more than the last digits of its
   * displacements make (its supports move it as a whole), its forces are
   * rounding and are not looked at.
   */
  struct Checks
  {
    /// Of each support, in the order of the scene, what it does to the bodies;
    /// the moment about the middle of the box around the points that it holds.
    std::vector<Resultant> reactions;
    /// Of each contact, in the order of the scene.
    std::vector<KuhnTucker> contacts;
    /// The largest sum of all forces on one body (loads, each support's
    /// reaction, contacts, springs) over the largest single one of them there:
    /// a force, or a couple over the size of the body.
    double force_balance = 0.;
    /// The largest sum of all their moments about the body's centre, over the
    /// size of the body and that same single force: what arms, and turns that
    /// the rows of a support or a contact do not follow, spoil.
    double moment_balance = 0.;
    /// |G^T (t f + B^T lambda - internal)| / |internal|, maximum norms, with
    /// the springs' forces in `internal`.
    double residual = 0.;
    /// Strain energy, 1/2 integral (strain - that of heat)^T C (strain - that
    /// of heat) dV, and half the sum of loads and reactions times their
    /// displacements (the work done on the scene if all forces grow in
    /// proportion).
    double energy = 0., external_work = 0.;
    /// What each body has of the strain energy, heat included; zero where that
    /// is rounding, as in a body that is moved as a whole or expands freely.
    std::vector<double> energies;
    /// In stabilising springs, over all bodies, and its share of all energy.
    /// Zero, but for rounding, once the state is released from them.
    double stabilisation_energy = 0., stabilisation_share = 0.;
    /// |energy - external_work - half the contact forces times their
    /// displacements| over the larger of the first two, with what the springs
    /// hold: zero by Clapeyron's theorem. With heat, energy is that of the
    /// whole strains here, and its load f_0 does work, too.
    double energy_balance = 0.;
    /// The largest rotation, in rad, over all bodies. The linear strain (Eq. 5)
    /// misses about half its square.
    double max_rotation = 0.;
    /// Whether bodies turn by any angle. Then reactions, moments and balances
    /// are those at the places where the bodies are now, the work and the
    /// balance of energy are not looked at, and there are the numbers of
    /// Deformation.
    bool   is_large   = false;
    double max_strain = 0., max_mean_strain = 0., max_element_turn = 0.,
           shape_change = 0.;
    /// What large deflections would change; not looked at by check_state(),
    /// which solves nothing.
    BeyondLinear beyond;
    /// The largest component of displacements, those of obstacles among them:
    /// what gaps are differences of.
    double max_displacement = 0.;
  };

  /// The last digits of the displacements @p u of a body, some of them
  /// [length]: what makes forces and energies of no meaning.
  double
  rounding_of_places(const Vector &u);

  /**
   * The checks of @p state at load factor @p factor. What is rounding in an
   * energy is told by the stiffness of @p tangent. @p contacts are those
   * whose rows, one contact after the other, the forces of the state belong
   * to; supports are numbered from 0 to @p n_supports - 1, as in
   * Structure::prescribed(). Costs two loops over all elements, no solution;
   * collective. Throws nothing of what it finds: see require_sound().
   */
  Checks
  check_state(const Linearisation                 &tangent,
              const std::vector<ContactInterface> &contacts,
              const unsigned int                   n_supports,
              const State                         &state,
              const LoadFactor                    &factor);

} // namespace lamella

#endif
