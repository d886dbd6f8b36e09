// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_full_strategy_h
#define lamella_solve_full_strategy_h

#include <lamella/solve/contact_strategy.h>
#include <lamella/solve/penalty_matrix.h>

namespace lamella
{
  /// Newton's method on the displacements u and contact forces lambda of the
  /// whole scene, a semi-smooth Newton method (solve_interface()) whose steps
  /// factorize the matrix of the whole scene (PenaltyMatrix). Without friction
  /// a constraint with the lengths v, the gap and all compliances included, is
  /// active if lambda - D v > 0, and the Newton step is
  ///   (K + K^p) du = r_u + B_A^T r_lambda / d,   K^p = B_A^T diag(1/d) B_A,
  ///   dlambda      = (r_lambda - B_A du) / d
  /// with the tangent stiffness K, gradients B_A of active gaps, numerical
  /// compliance d, unbalanced forces r_u, and r_lambda = -v.
  class FullStrategy : public ContactStrategy
  {
  public:
    /// Assembles the stiffness of @p tangent_operator, which needs no linear
    /// solvers, for the contact constraints @p rows.
    FullStrategy(const TangentOperator &tangent_operator,
                 const GapConstraints  &rows);

    ContactSolution
    solve(const ContactProblem &problem, const Monitor &monitor) override;

    /// Solves one linear Newton system with the active constraints @p closed,
    /// for unbalanced forces @p r_u and gap residuals @p r_lambda.
    void
    solve(const ActiveConstraints &closed,
          const BlockVector       &r_u,
          const Vector            &r_lambda,
          BlockVector             &du,
          Vector                  &dlambda) override;

    /// Returns the penalty factor, and the constraints in the matrix pattern.
    StrategyHistory
    memory() const override;
    void
    restore(const StrategyHistory &memory) override;

    bool
    forces_are_accurate() const override
    {
      return false;
    }

    std::string
    remedy() const override
    {
      return rows.has_friction() ? "the condensed strategy" :
                                   "a softer penalty, the condensed strategy";
    }

    /// Returns a warning if a large penalty causes rounding errors.
    std::vector<std::string>
    warnings() const override
    {
      return matrix.warnings();
    }

  private:
    PenaltyMatrix matrix;
  };
} // namespace lamella

#endif
