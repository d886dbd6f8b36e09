// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_kkt_residual_h
#define lamella_solve_kkt_residual_h

#include <lamella/solve/body_forces.h>
#include <lamella/solve/contact_problem.h>
#include <lamella/solve/contact_solver.h>

#include <deal.II/base/array_view.h>

#include <vector>

namespace lamella
{
  /// Residuals of the Kuhn-Tucker conditions (Eq. 18) and resultants of one
  /// contact at the end of a load step. The conditions of each constraint are
  ///   g >= 0,  lambda >= 0,  g lambda = 0   (for penalty with g + lambda / eps
  ///                                          in the place of g).
  /// lambda is positive in compression, where p_N of Eq. 18 is negative.
  struct KktResidual
  {
    /// Number of constraints with a force.
    unsigned int active = 0;
    /// Resultant contact force on the second side, and its moment about the
    /// scene origin, from the work on rigid motions: exact.
    dealii::Tensor<1, 3> force, moment;
    /// Force and moment of each constraint; their sum is the resultant.
    std::vector<Wrench> of_rows;
    /// Point on the line of action nearest to the mean of the active points.
    dealii::Point<3> center_of_pressure;
    /// Norm of the sum of the contact forces on both bodies over the sum of
    /// their norms; zero up to rounding.
    double imbalance = 0.;
    /// Largest penetration -g [length]; for penalty, force over penalty eps.
    double max_penetration = 0.;
    /// Smallest force of an active constraint; zero if none is active.
    double min_force = 0.;
    /// Largest lambda max(0, g) [energy], zero if the conditions are satisfied.
    double complementarity = 0.;
    /// Largest |g + a lambda| of active constraints and -g of inactive ones
    /// [length], with a = 1/eps for penalty, else zero.
    double law_error = 0.;
    /// Largest difference between the initial weighted gap of an active
    /// constraint and the gap at its point [length]. It is large if the mesh
    /// does not resolve the curvature of the surfaces.
    double unresolved_curvature = 0.;
    /// Friction: resultant shear force on the second side; areas of sticking
    /// and slipping constraints [length^2]; dissipated energy.
    dealii::Tensor<1, 3> shear;
    double               sticking = 0., slipping = 0., dissipated = 0.;
    /// Largest of law_error, tension and complementarity, each relative.
    double violation = 0.;
  };

  /// Adds the resultants, areas and energies of @p part to those of @p whole.
  void
  add_resultants(KktResidual &whole, const KktResidual &part);

  /// Views of the forces of one contact in a state, by its constraints.
  struct ConstraintForces
  {
    /// Views contact number @p contact of @p rows in @p state.
    ConstraintForces(const GapConstraints &rows,
                     const unsigned int    contact,
                     const State          &state);

    /// Returns the shear force of constraint @p k on the second side, or zero.
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
    /// Views of FrictionState::length and dissipated.
    dealii::ArrayView<const double> length, dissipated;
  };

  /// Returns the residuals of the contact law of @p contact with @p forces at
  /// the displacements @p u and load factor @p factor. Adds the contact forces
  /// to @p on_body, one entry per body. For `violation`, gaps are divided by
  /// the largest @p displacement.
  KktResidual
  check_contact(const ContactInterface  &contact,
                const ConstraintForces  &forces,
                const BlockVector       &u,
                const LoadFactor        &factor,
                const double             displacement,
                std::vector<BodyForces> &on_body);
} // namespace lamella

#endif
