// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_kuhn_tucker_h
#define lamella_solve_kuhn_tucker_h

#include <lamella/solve/body_forces.h>
#include <lamella/solve/contact_problem.h>
#include <lamella/solve/contact_solver.h>

#include <deal.II/base/array_view.h>

#include <vector>

namespace lamella
{
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
    /// With friction: its resultant on the second side, scene components; the
    /// areas of the rows that stick and that slip [length^2]; what it has
    /// dissipated so far [energy].
    dealii::Tensor<1, 3> shear;
    double               sticking = 0., slipping = 0., dissipated = 0.;
    /// The largest of law error over displacement, tension over force and
    /// complementarity over both: a number. Zero if no row is active.
    double violation = 0.;
  };

  /// Adds the resultants of @p part, at ends of a body, to those of the contact
  /// @p whole: forces, moments, areas and work.
  void
  add_resultants(KuhnTucker &whole, const KuhnTucker &part);

  /// The forces of the rows of one contact in a state: views of it.
  struct RowForces
  {
    /// Of the contact number @p contact of @p rows; @p state lives longer.
    RowForces(const GapRows     &rows,
              const unsigned int contact,
              const State       &state);

    /// lambda_t of row @p k on the second side; zero without friction.
    dealii::Tensor<1, 3>
    shear_of(const unsigned int k) const
    {
      return shear.size() == 0 ? dealii::Tensor<1, 3>() : shear[k];
    }

    bool
    slips(const unsigned int k) const
    {
      return direction.size() > 0 && direction[k].norm() > 0.;
    }

    dealii::ArrayView<const double>               normal;
    dealii::ArrayView<const dealii::Tensor<1, 3>> shear, direction;
    /// FrictionState::length and dissipated.
    dealii::ArrayView<const double> length, dissipated;
  };

  /**
   * What the rows of @p contact say of gaps and of @p forces at the
   * displacements @p u and load factor @p factor, and what the forces do as a
   * whole; adds them to the forces @p on_body of every body. Gaps are compared
   * with @p displacement, the largest there is.
   */
  KuhnTucker
  check_contact(const ContactInterface  &contact,
                const RowForces         &forces,
                const BlockVector       &u,
                const LoadFactor        &factor,
                const double             displacement,
                std::vector<BodyForces> &on_body);
} // namespace lamella

#endif
