// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_local_errors_h
#define lamella_estimate_local_errors_h

#include <lamella/estimate/goal_dual.h>
#include <lamella/estimate/run_goals.h>
#include <lamella/recover/named_quantity.h>
#include <lamella/run/simulation.h>

#include <optional>
#include <vector>

namespace lamella
{
  /// Returns @p errors with the error of each axis element divided equally
  /// among the elements of the model @p finer that it contains.
  LocalErrors
  distribute_to_finer(const LocalErrors &errors, const Simulation &finer);

  /// Error of a goal J per axis element, from dual-weighted residuals (Becker
  /// and Rannacher, Acta Numerica 10 (2001), sec. 3; deal.II's step-14). u_H
  /// are the displacements of the coarser model, interpolated to the nodes of
  /// the finer one. The finer model has displacements u_h, stiffness K,
  /// internal forces f_int, loads t f, contact forces lambda, and active
  /// constraints with matrix B, gaps g and compliances a. Its dual solution z,
  /// nu (GoalDual) satisfies
  ///   K z - B^T nu = J'_u,   B z + a nu = -J'_lambda.
  /// The difference of the goal between both models is, to rounding,
  ///   J(u_h) - J(u_H) = r . z - nu . s,
  ///   r = t f + B^T l - f_int(u_H),   s = -(g(u_H) + a l),
  /// for any contact forces l, here lambda scaled to the resultants of the
  /// coarser model. Except for contact, r . I z = 0 with the interpolant I z in
  /// the coarser model. The error of an element is therefore, over the DoFs k
  /// of its nodes, the sum of r_k (z - I z)_k, half of it at nodes of two
  /// elements.
  ///
  /// Both models must have the same bodies: beams with the same section
  /// functions and different axes, and identical solids.
  class Localization
  {
  public:
    /// Returns true if both models have the same numbers of section functions
    /// in each beam and of DoFs in each solid.
    static bool
    is_possible(const Simulation &coarse, const Simulation &fine);

    /// Computes the residual of the coarser solution on the finer model. Keeps
    /// references to both models. Collective, as is errors().
    Localization(const Simulation &coarse, const Simulation &fine);

    /// Returns the error of @p goal per element; @p change is the difference of
    /// its value between both models. Returns an empty optional if the goal has
    /// no derivative (GoalDual). Costs one solution with the finer stiffness.
    std::optional<LocalErrors>
    errors(const NamedQuantity &goal, const double change) const;

  private:
    /// Adds the errors of elements of @p body, sums of the products @p share.
    void
    add_elements(const unsigned int body,
                 const Vector      &share,
                 LocalErrors       &result) const;

    const Simulation &coarse, &fine;
    LoadFactor        factor;
    GoalDual          dual;
    BlockVector       residual;
    Vector mismatch; ///< Residual of each active constraint [length].
  };

  /// Returns the error per axis element of each goal of @p run by comparison
  /// with @p finer; empty if Localization is not possible.
  std::vector<std::optional<LocalErrors>>
  errors_of(const RunGoals   &goals,
            const Simulation &run,
            const Simulation &finer);
} // namespace lamella

#endif
