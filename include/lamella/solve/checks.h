// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_checks_h
#define lamella_solve_checks_h

#include <lamella/solve/contact_solver.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace lamella
{
  /// The Kuhn-Tucker state (Eq. 18) of one contact at the end of a load step,
  /// and what it transmits.
  struct KuhnTucker
  {
    unsigned int active = 0;
    /// On the second body or obstacle, scene components, and the moment about
    /// the scene's origin: the work of the rows on rigid motions of a body, so
    /// exact for every kind of rows.
    dealii::Tensor<1, 3> force, moment;
    /// Where the force acts: of its line of action the point nearest to the
    /// mean of the active points, weighted with their forces.
    dealii::Point<3> centre_of_pressure;
    /// |sum of the forces on both bodies| / |force|: zero.
    double imbalance = 0.;
    /// The largest -g, zero without penetration; by design F / eps for penalty.
    double max_penetration = 0.;
    /// The smallest force of an active row: not negative.
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
    /// complementarity over both: a number.
    double violation = 0.;
  };

  /// A force and its moment about a point, scene components.
  struct Resultant
  {
    dealii::Tensor<1, 3> force, moment;
    dealii::Point<3>     about;
  };

  /// What every load step is checked for.
  struct Checks
  {
    /// Of each support, what it does to the bodies; the moment about the middle
    /// of the box around the points that it holds.
    std::vector<Resultant>  reactions;
    std::vector<KuhnTucker> contacts;
    /// The largest sum of all forces on one body over the largest single force.
    double force_balance = 0.;
    /// |G^T (t f + B^T lambda - internal)| / |internal|, maximum norms.
    double residual = 0.;
    /// Strain energy, and half the sum of loads and reactions times their
    /// displacements.
    double energy = 0., external_work = 0.;
    /// In stabilising springs, over all bodies, and its share of all energy.
    double stabilisation_energy = 0., stabilisation_share = 0.;
    /// |energy - external_work - half the contact forces times their
    /// displacements| over the larger of the first two, with what the springs
    /// hold: zero by Clapeyron's theorem.
    double energy_balance = 0.;
    /// In rad, over all bodies.
    double max_rotation = 0.;
    /// The largest component of displacements, those of obstacles among them:
    /// what gaps are differences of.
    double max_displacement = 0.;
  };

  Checks
  check_state(const Structure                     &structure,
              const std::vector<ContactInterface> &contacts,
              const unsigned int                   n_supports,
              const State                         &state,
              const double                         factor);

  /**
   * Throws NumericsError if the state is not to be trusted: corrections that do
   * not become small, forces, residual or energy out of balance, gaps and
   * forces off the contact law, numbers that are none, or a rotation above
   * @p rotation_limit.
   */
  void
  require_sound(const State  &state,
                const Checks &checks,
                const double  rotation_limit);

  /// What the user should know of a state that is sound: lost digits, rotations
  /// beyond the linear theory, penetrations of the size of the displacements,
  /// points that face nothing, bodies that overlap from the start. A sentence
  /// each.
  std::vector<std::string>
  warnings_of(const State                         &state,
              const Checks                        &checks,
              const std::vector<ContactInterface> &contacts);
} // namespace lamella

#endif
