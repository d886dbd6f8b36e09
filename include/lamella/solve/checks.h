// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_checks_h
#define lamella_solve_checks_h

#include <lamella/solve/beyond_linear.h>
#include <lamella/solve/contact_solver.h>

#include <deal.II/base/tensor.h>

#include <optional>
#include <vector>

namespace lamella
{
  /// A force and its moment about the scene's origin, scene components.
  struct Wrench
  {
    dealii::Tensor<1, 3> force, moment;
  };

  /**
   * The Kuhn-Tucker state (Eq. 18) of one contact at the end of a load step,
   *   g >= 0,  lambda >= 0,  g lambda = 0   (for penalty with g + lambda / eps
   *                                          in the place of g),
   * row by row, and what it transmits. lambda is the force of a row, positive
   * in compression, where p_N of Eq. 18 is negative. Forces and lengths are in
   * the scene's units and axes.
   */
  struct KuhnTucker
  {
    /// Rows with a force.
    unsigned int active = 0;
    /// The resultant on the second body or obstacle, scene components, and the
    /// moment about the scene's origin: the work of the rows on rigid motions
    /// of a body, so exact for every kind of rows.
    dealii::Tensor<1, 3> force, moment;
    /// What each row has of these: they sum to them but for rounding.
    std::vector<Wrench> of_rows;
    /// Where the force acts: of its line of action the point nearest to the
    /// mean of the active points, weighted with their forces. The origin where
    /// there is no force.
    dealii::Point<3> centre_of_pressure;
    /// |sum of the forces on both bodies| over the sum of the rows' forces:
    /// zero but for rounding. Not looked at against an obstacle.
    double imbalance = 0.;
    /// The largest -g, zero without penetration; by design F / eps for penalty.
    double max_penetration = 0.;
    /// The smallest force of an active row: not negative. Zero if none is
    /// active.
    double min_force = 0.;
    /// The largest lambda max(0, g), an energy: zero.
    double complementarity = 0.;
    /// The largest |g + a lambda| of an active row and -g of any other, with
    /// a = 1/eps for penalty and zero without: how far gaps and forces are from
    /// the law, a length.
    double law_error = 0.;
    /// How much wider the initial gaps of active rows, means over elements
    /// perhaps, are than those between their points: what the mesh does not
    /// resolve of how the surfaces curve.
    double averaged_away = 0.;
    /// The largest of law error over displacement, tension over force and
    /// complementarity over both: a number. Zero if no row is active.
    double violation = 0.;
  };

  /// A wrench: a force and its moment about a point, scene components.
  struct Resultant
  {
    dealii::Tensor<1, 3> force, moment;
    /// The point, in the scene; not where the force acts.
    dealii::Point<3> about;
    /// Where it acts: of its line of action the point nearest to `about`. None
    /// without a force, or with one that is rounding beside the moment.
    std::optional<dealii::Point<3>> centre_of_pressure = {};
  };

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
    /// What large deflections would change; not looked at by check_state(),
    /// which solves nothing.
    BeyondLinear beyond;
    /// The largest component of displacements, those of obstacles among them:
    /// what gaps are differences of.
    double max_displacement = 0.;
  };

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
              const double                         factor);

  /**
   * Throws NumericsError if the state is not to be trusted, looked at in this
   * order: stabilising springs that hold more than a tenth of the energy, last
   * corrections above 1e-6 of the displacements, balance of forces or moments,
   * residual or balance of energy above 1e-3, a contact force below zero or
   * gaps off the contact law by more than 1e-6 of the displacements, numbers
   * that are none, or a rotation above @p rotation_limit (rad). A check that is
   * not a number counts as failed.
   */
  void
  require_sound(const State  &state,
                const Checks &checks,
                const double  rotation_limit);

  /**
   * What the user should know of a state that is sound, a sentence each without
   * a full stop: penetrations above 1e-3 of the displacements, gaps whose
   * averages miss more than 1e-2 of them, bodies that overlap from the start;
   * rotations beyond 0.1 rad, stabilising springs with more than 1e-3 of the
   * energy, balances that hold to worse than 1e-7, and digits that the
   * assembled matrix lost (a first correction above 1e-7). @p contacts are
   * those of check_state().
   */
  std::vector<std::string>
  warnings_of(const State                         &state,
              const Checks                        &checks,
              const std::vector<ContactInterface> &contacts);
} // namespace lamella

#endif
