// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_kkt_residual_h
#define lamella_solve_kkt_residual_h

#include <lamella/body/body.h>
#include <lamella/solve/contact_problem.h>
#include <lamella/solve/linear_system.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/tensor.h>

#include <optional>
#include <utility>
#include <vector>

#include <cmath>

namespace lamella
{
  /// A force and its moment about the scene origin or another stated point.
  struct Wrench
  {
    dealii::Tensor<1, 3> force, ///< Force in scene components.
      moment;                   ///< Moment in scene components.
  };

  /// A force and its moment about a given point.
  struct Resultant
  {
    dealii::Tensor<1, 3> force, ///< Force in scene components.
      moment; ///< Moment about the point `about` in scene components.
    /// Reference point of the moment in the scene; not the point of action.
    dealii::Point<3> about;
    /// Point on the line of action nearest to `about`; empty without net force.
    std::optional<dealii::Point<3>> center_of_pressure = {};
  };

  /// Sum of all forces on one body and of their moments about its center, for
  /// the check of equilibrium. Each is computed as work on the rigid motions.
  class BodyForces
  {
  public:
    /// Creates an empty sum for the body @p of, displaced by @p u.
    BodyForces(const Body &of, const Vector &u);

    /// Returns the force of a load and its moment about the body center.
    /// @p work returns the work of the load on a displacement vector.
    template <typename Work>
    Wrench
    resultant_of_work(const Work &work) const
    {
      Wrench about_center;
      for (unsigned int c = 0; c < 3; ++c)
        {
          about_center.force[c]  = work(rigid[c]);
          about_center.moment[c] = work(rigid[3 + c]);
        }
      return about_center;
    }

    /// Adds a force and its moment about the body center to the sum; the
    /// largest force is at least @p least.
    void
    add(const Wrench &about_center, const double least = 0.);

    /// Makes unbalanced() divide by a force of at least @p force.
    void
    at_least(const double force);

    /// Returns |sum of forces| / F and |sum of moments| / (F times the body
    /// size), where F is the largest added force (or moment over body size).
    std::pair<double, double>
    unbalanced() const;

    const Body &body; ///< Body on which the forces act.

  private:
    std::vector<Vector> rigid;
    double              size;
    Wrench              sum;
    double              largest = 0.;
  };

  /// Residuals of the Karush-Kuhn-Tucker conditions (Eq. 18 of Nagaraj et al.
  /// 2020) and resultants of one contact at the end of a load step. The
  /// conditions of a constraint with gap g and contact force lambda, positive
  /// in compression, are
  ///   g >= 0,  lambda >= 0,  g lambda = 0.
  /// With a penalty stiffness eps, g + lambda / eps replaces g.
  struct KktResidual
  {
    unsigned int active = 0; ///< Number of constraints with a contact force.
    /// Resultant contact force on the second side, scene axes.
    dealii::Tensor<1, 3> force;
    dealii::Tensor<1, 3> moment; ///< Moment of `force` about the scene origin.
    /// Force, and moment about the scene origin, of each constraint.
    std::vector<Wrench> of_rows;
    /// Point on the line of action of `force` nearest to the mean of the active
    /// contact points, weighted by their forces.
    dealii::Point<3> center_of_pressure;
    /// Displacement of an obstacle under a given force [length], scene axes.
    std::optional<dealii::Tensor<1, 3>> obstacle_displacement;
    /// Norm of the sum of the contact forces on both bodies, over the sum of
    /// the normal forces; zero up to rounding.
    double imbalance       = 0.;
    double max_penetration = 0.; ///< Largest penetration [length].
    /// Smallest contact force of an active constraint; zero if none is active.
    double min_force = 0.;
    /// Largest product of contact force and positive gap [energy].
    double complementarity = 0.;
    /// Largest error of the contact law [length]: |g + lambda / eps| of active
    /// constraints, 1 / eps = 0 without penalty; -g of inactive ones.
    double law_error = 0.;
    /// Largest amount by which the initial gap of an active constraint, a
    /// weighted mean, exceeds that at its contact point [length]. It is large
    /// if the mesh is too coarse for the curvature of the surfaces.
    double unresolved_curvature = 0.;
    /// Resultant shear force on the second body of the contact, scene axes.
    dealii::Tensor<1, 3> shear;
    double               sticking = 0.; ///< Area of sticking points [length^2].
    double               slipping = 0.; ///< Area of slipping points [length^2].
    double               dissipated = 0.; ///< Energy dissipated by friction.
    /// Largest relative violation: law error over largest displacement, tensile
    /// force over largest force, or complementarity over the product of these.
    double violation = 0.;
  };

  /// Adds resultants, areas and dissipated energy of @p part to @p whole,
  /// unless the contact force of @p part is zero.
  void
  add_resultants(KktResidual &whole, const KktResidual &part);

  /// Views of the contact forces of one contact in a State, one entry per
  /// constraint. Friction views are empty without friction.
  struct ConstraintForces
  {
    /// Creates the views for contact @p contact of all constraints @p rows.
    ConstraintForces(const GapConstraints &rows,
                     const unsigned int    contact,
                     const State          &state);

    /// Returns the shear force of constraint @p k on the second side, or zero.
    dealii::Tensor<1, 3>
    shear_of(const unsigned int k) const
    {
      return shear.size() == 0 ? dealii::Tensor<1, 3>() : shear[k];
    }

    /// Returns the magnitude of the force of constraint @p k.
    double
    magnitude(const unsigned int k) const
    {
      return std::hypot(normal[k], shear_of(k).norm());
    }

    /// Returns the sum of magnitude() over all constraints.
    double
    sum_of_magnitudes() const
    {
      double sum = 0.;
      for (unsigned int k = 0; k < normal.size(); ++k)
        sum += magnitude(k);
      return sum;
    }

    /// Returns true if the constraint of index @p k is active and slips.
    bool
    slips(const unsigned int k) const
    {
      return direction.size() > 0 && direction[k].norm() > 0.;
    }

    /// Returns the friction history of @p row, a constraint of this contact.
    const FrictionHistory &
    history(const GapConstraint &row) const
    {
      return friction.history.at({contact, row.slave_node});
    }

    dealii::ArrayView<const double> normal; ///< Normal forces, compression > 0.
    /// Shear forces on the second side, in scene axes.
    dealii::ArrayView<const dealii::Tensor<1, 3>> shear;
    /// Unit vectors along the shear forces of slipping constraints, else zero.
    dealii::ArrayView<const dealii::Tensor<1, 3>> direction;
    /// Friction history of the material points of all contacts.
    const FrictionState &friction;
    unsigned int         contact; ///< Index of the contact.
  };

  /// Returns the resultants of @p contact and its residuals at the
  /// displacements @p u and load factor @p factor, with the contact @p forces.
  /// Adds the contact forces to @p on_body, one entry per body. Relative
  /// violations refer to the largest @p displacement of the scene.
  KktResidual
  check_contact(const ContactInterface  &contact,
                const ConstraintForces  &forces,
                const BlockVector       &u,
                const LoadFactor        &factor,
                const double             displacement,
                std::vector<BodyForces> &on_body);
} // namespace lamella

#endif
