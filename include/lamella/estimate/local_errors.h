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
  /// Returns @p errors divided equally among the elements of @p finer inside.
  LocalErrors
  distribute_to_finer(const LocalErrors &errors, const Simulation &finer);

  /// Error of a goal by elements, by dual-weighted residuals. u_H are the
  /// displacements of the coarser model on the nodes of the finer one. With K,
  /// the rows B and the forces lambda of the finer model, and the dual solution
  /// z, nu of the goal J,
  ///   K z - B^T nu = J'_u,   B z + a nu = -J'_lambda   (active constraints),
  /// the difference of the goal between both models is, to rounding,
  ///   J(u_h) - J(u_H) = r . z - nu . s,
  ///   r = t f + B^T l - f_int(u_H),   s = -(g(u_H) + a l),
  /// for any contact forces l; here lambda, scaled to the resultants of the
  /// coarser model. Except for contact, r is orthogonal to the interpolant I z
  /// in the coarser model. The error of an element is therefore the sum of r_k
  /// (z - I z)_k over its nodes k, one half of it for nodes of two elements.
  ///
  /// Both models have the same bodies: beams of the same section with different
  /// axes, and identical solids. (Becker and Rannacher, Acta Numerica 10
  /// (2001), sec. 3; deal.II's step-14.)
  class Localization
  {
  public:
    /// Returns true if the bodies of both models match.
    static bool
    is_possible(const Simulation &coarse, const Simulation &fine);

    /// Computes the residual on the finer model. Collective, as is errors().
    Localization(const Simulation &coarse, const Simulation &fine);

    /// Returns the errors of @p goal, whose values in both models differ by
    /// @p change. Empty if GoalDual::derivative() is. Costs one finer solution.
    std::optional<LocalErrors>
    errors(const NamedQuantity &goal, const double change) const;

  private:
    /// Returns the contributions of elements to the error, r . (z - I z).
    LocalErrors
    of_elements(const BlockVector &z) const;

    /// Returns coarser displacements on the nodes of the finer model.
    BlockVector
    interpolate_to_fine(const BlockVector &u) const;
    BlockVector
    interpolate_to_coarse(const BlockVector &u) const;

    /// Adds element errors of @p body from the products @p share by DoFs.
    void
    add_elements(const unsigned int body,
                 const Vector      &share,
                 LocalErrors       &result) const;

    const Simulation &coarse, &fine;
    LoadFactor        factor;
    GoalDual          dual;
    BlockVector       residual;
    /// Residual s of the active constraints.
    Vector mismatch;
  };

  /// Returns the local errors of @p goals of @p run by comparison with
  /// @p finer; empty if Localization is not possible.
  std::vector<std::optional<LocalErrors>>
  errors_of(const RunGoals   &goals,
            const Simulation &run,
            const Simulation &finer);
} // namespace lamella

#endif
