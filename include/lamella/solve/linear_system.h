// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_linear_system_h
#define lamella_solve_linear_system_h

#include <lamella/solve/contact_strategy.h>
#include <lamella/solve/nonlinear_parameters.h>
#include <lamella/solve/state.h>

#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// The linear equations of a structure with constant stiffness and a given
  /// active set. At load factor t, with displacements u, internal forces f_int,
  /// loads f, gaps g with gradients B, forces lambda and law_compliance() a:
  ///   f_int(u) + f_springs(u) = t f + B^T lambda   (in the free DoFs)
  ///   g(u) + a lambda = 0   in active constraints, lambda = 0 in all others,
  /// and likewise for the slips of sticking points.
  /// NonlinearSolver finds the active set with contact_strategy().
  ///
  /// Iterative refinement: the residuals of both equations are evaluated, f_int
  /// from strains (Structure::residual()), and the solution is corrected with
  /// the factorization of the strategy. Keeps references to the structure and
  /// the gap constraints. Collective, with equal arguments.
  class LinearSystem
  {
  public:
    /// Creates the equations for the stiffness @p tangent with the strategy
    /// @p which. The structure and @p rows must outlive this object.
    LinearSystem(std::shared_ptr<const TangentOperator> tangent,
                 const GapConstraints                  &rows,
                 const NonlinearParameters &parameters = NonlinearParameters(),
                 const Strategy             which      = Strategy::condensed);

    /// Returns the linear solution at load factor @p factor without contact,
    /// refined by at least one correction. Stabilizing springs have no force
    /// at zero displacements. Throws NumericsError if it is not finite.
    State
    solve_free(const LoadFactor &factor);

    /// Refines displacements and forces of @p state with its active set. If a
    /// force becomes tensile, as in dependent constraints, whose forces are not
    /// unique, the displacements alone are refined, for constant forces.
    void
    refine_contact(State &state, const LoadFactor &factor);

    /// Solves for corrections of displacements and forces with the active
    /// constraints @p closed (ContactStrategy::solve()).
    void
    solve_linear(const ActiveConstraints &closed,
                 const BlockVector       &r_u,
                 const Vector            &r_lambda,
                 BlockVector             &du,
                 Vector                  &dlambda)
    {
      strategy->solve(closed, r_u, r_lambda, du, dlambda);
    }

    /// Returns the active constraints of @p state with all their slips
    /// prescribed, as if no point slipped; the linear system is symmetric.
    ActiveConstraints
    sticking_equations(const State &state) const;

    /// Returns the largest displacement component of bodies, normal
    /// displacement of obstacles, or slip [length].
    double
    displacement_scale(const State &state, const LoadFactor &factor) const;

    /// Returns the contact strategy with its factorizations.
    ContactStrategy &
    contact_strategy()
    {
      return *strategy;
    }

    /// Returns the tangent stiffness with its factorizations.
    const TangentOperator &
    tangent() const
    {
      return *tangent_operator;
    }
    /// Returns the tangent stiffness for other constraints.
    std::shared_ptr<const TangentOperator>
    shared_tangent() const
    {
      return tangent_operator;
    }
    /// Returns the gap constraints.
    const GapConstraints &
    constraints() const
    {
      return rows;
    }

  private:
    /// Performs solve_free() by a solution of the linear equations.
    State
    refined_solution(const LoadFactor &factor);

    /// Returns -(g + a lambda) of each gap g in @p closed, and minus each slip.
    Vector
    law_residual(const State             &state,
                 const LoadFactor        &factor,
                 const ActiveConstraints &closed) const;

    /// Corrects the displacements and the forces of the active constraints
    /// once, with a constant active set, from the residuals of equilibrium and
    /// of the contact law. Returns the maximum norm of the correction over that
    /// of the displacements. Throws NumericsError if it is not finite.
    double
    correct(State &state, const LoadFactor &factor);

    /// Calls correct() @p at_least times and until is_refined(); returns the
    /// relative norm of each correction.
    std::vector<double>
    refine(State &state, const LoadFactor &factor, const unsigned int at_least);

    /// Returns true if refinement should end: the last of @p corrections is
    /// below refinement_tolerance or above half of the previous one, or
    /// max_refinements is reached (beyond @p at_least corrections).
    bool
    is_refined(const std::vector<double> &corrections,
               const unsigned int         at_least) const;

    const std::shared_ptr<const TangentOperator> tangent_operator;
    const Structure                             &structure;
    const GapConstraints                         rows;
    const NonlinearParameters                    parameters;
    const std::unique_ptr<ContactStrategy>       strategy;
    /// Solution without contact at load factor 1, if loads are proportional.
    State unit_solution;
  };
} // namespace lamella

#endif
