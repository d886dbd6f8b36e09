// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_contact_solver_h
#define lamella_solve_contact_solver_h

#include <lamella/base/arithmetic.h>
#include <lamella/solve/contact_strategy.h>
#include <lamella/solve/state.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// Tolerances and limits of ContactSolver. Values without a unit are relative
  /// to ContactSolver::displacement_scale().
  struct SolverParameters
  {
    /// Limit of the contact iterations; more are a failure.
    unsigned int max_iterations = 50;

    /// Relative correction that ends the refinement.
    double refinement_tolerance = arithmetic::rounding_of_sums;
    /// Limit of corrections beyond the mandatory ones; one above half the
    /// previous one ends the refinement, too.
    unsigned int max_refinements = 6;

    /// Gaps above minus this share, or the last correction, are rounding.
    double rounding = arithmetic::rounding;
    /// Tolerance of the law in active constraints, and a weaker one that is
    /// accepted if a further round hardly improves it.
    double law_tolerance      = arithmetic::rounding_of_results,
           weak_law_tolerance = arithmetic::rounding_of_solutions;
    /// A round is slow if it leaves more than this share of the violation.
    double slow = 0.1;
    /// Limit of the rounds of ContactSolver::correct_active_set().
    unsigned int max_set_corrections = 20;

    /// Relative change of the spring offsets that ends their release, or
    /// remaining spring force over the largest load or contact force.
    double spring_offset_tolerance = arithmetic::rounding_of_results,
           spring_force_tolerance  = arithmetic::rounding_of_sums;
    unsigned int max_releases      = 60;
  };

  /**
   * Solver of one load step: first the linear solution, then contact, then the
   * release of stabilizing springs. A ContactStrategy finds the active set; the
   * result is refined against the residual evaluated from strains and the
   * contact law. Equations at load factor t, with the gap rows B:
   *   f_int(u) + f_springs(u) = t f + B^T lambda   (in the free DoFs)
   *   g(u) + a lambda >= 0,  lambda >= 0,  one of them zero in each row.
   * f_int is linear in u; the active set is the only nonlinearity.
   *
   * Iterative refinement: both residuals are evaluated at the state, f_int from
   * strains (Structure::residual()), and corrected with the inverse of the
   * strategy. The residuals determine the accuracy, the matrix only the rate of
   * convergence. Refers to the structure and views the gap rows. Collective,
   * with the same arguments and states on all processes.
   */
  class ContactSolver
  {
  public:
    /// Callback for a line of text.
    using Progress = std::function<void(const std::string &)>;
    /// Function that describes the gap row of a given number.
    using Describe = std::function<std::string(const unsigned int)>;

    /// Creates a solver about the state of @p tangent_operator with the
    /// strategy @p which (make_strategy()). Refers to structure and rows;
    /// solves nothing.
    ContactSolver(std::shared_ptr<const TangentOperator> tangent_operator,
                  const GapConstraints                  &rows,
                  const SolverParameters &parameters = SolverParameters(),
                  const Strategy          which      = Strategy::condensed);

    /// Callback for a line of text per iteration; no output by default.
    Progress progress;
    /// Description of a gap row; by default its number.
    Describe describe;

    /// Returns the linear solution at load factor @p factor without active
    /// constraints, with the springs free of force at @p rest: u = t u_p, then
    /// at least two corrections. Throws NumericsError if it is not finite.
    State
    solve_free(const LoadFactor &factor, const SpringOffsets &rest = {});

    /**
     * Returns the solution with contact, starting from @p free, the state of
     * solve_free() at the same @p factor, and from the forces and active set of
     * the @p previous load step, if any. The problem is convex: the start
     * affects the number of rounds only, and displacements and gaps are unique
     * (forces if the constraints are independent). Returns @p free if no
     * constraint penetrates there. Throws NumericsError, naming the constraints
     * that still change, if the active set does not converge.
     *
     * Each round determines the active set about the current state for
     * estimates of the forces, refines the state, and checks the contact law.
     * `exact` and `augmented lagrangian` use the same loop: each refinement and
     * round takes the current forces as estimates (proximal point iteration,
     * method of multipliers). The loop ends if no active constraint is tensile,
     * no other penetrates beyond rounding, and active constraints satisfy the
     * law to law_tolerance, or to weak_law_tolerance after a slow round. Each
     * round counts as at least one of the max_iterations. Convergence: the
     * forces solve a strictly convex problem, refinement changes only the
     * estimates, and each proximal step reduces the distance to the solution.
     */
    State
    solve_contact(const State      &free,
                  const LoadFactor &factor,
                  const State      &previous = State());

    /**
     * Returns @p state, a result of solve_contact(), without the influence of
     * the stabilizing springs. Each round calls solve_free() and
     * solve_contact() with the spring offsets at the previous state (proximal
     * point method), and leaves the share s / (s + k) of the spring forces,
     * with the stiffness s of the springs and k of the contact that constrains
     * the body. Ends if the offsets change by less than 1e-12 of the
     * displacements, or the springs carry less than 1e-13 of the largest load
     * or contact force. Throws NumericsError after 60 rounds: nothing
     * constrains the body, or the springs are too stiff, in which case the
     * message gives the Stabilization to use.
     */
    State
    release_springs(State state, const LoadFactor &factor);

    /// Returns g = B u + g_init + t g_rate of each constraint at t = @p factor
    /// (Eq. 16) [length].
    std::vector<double>
    gaps(const BlockVector &u, const LoadFactor &factor) const;

    /// Solves the linear system of one correction (ContactStrategy::solve()).
    void
    solve_linear(const ActiveConstraints &closed,
                 const BlockVector       &r_u,
                 const Vector            &r_lambda,
                 BlockVector             &du,
                 Vector                  &dlambda)
    {
      strategy->solve(closed, r_u, r_lambda, du, dlambda);
    }

    /// Returns the closed gaps of @p state with all slips, for a symmetric
    /// matrix: a sliding point resists small disturbances until it reverses.
    ActiveConstraints
    sticking_equations(const State &state) const;

    /// Returns the data of the strategy that a resumed run needs.
    StrategyHistory
    memory() const
    {
      return strategy->memory();
    }
    /// Restores @p memory in a new solver of the same scene.
    void
    restore(const StrategyHistory &memory)
    {
      strategy->restore(memory);
    }

    /// Returns the linearization.
    const TangentOperator &
    tangent() const
    {
      return *tangent_operator;
    }

    /// Returns the tangent operator for another solver with other rows.
    std::shared_ptr<const TangentOperator>
    shared_tangent() const
    {
      return tangent_operator;
    }

    /// Returns warnings about penalties and rounding, one sentence each.
    std::vector<std::string>
    warnings() const
    {
      return strategy->warnings();
    }

  private:
    /// Violations of the contact law in a refined state.
    struct ContactViolations
    {
      /// Active constraints that are tensile, and others that penetrate.
      std::vector<unsigned int> tensile, penetrating;
      /// Sticking constraints beyond mu lambda_n, and slipping ones whose slip
      /// is along their shear force.
      std::vector<unsigned int> friction_violations;
      /// Largest |g + a lambda| of the others, |v| of sticking ones.
      double gap = 0.;

      bool
      is_active_set_correct() const
      {
        return tensile.empty() && penetrating.empty() &&
               friction_violations.empty();
      }
    };

    /// Returns the violations of @p state; gaps above -@p closed are closed.
    ContactViolations
    violations(const State      &state,
               const LoadFactor &factor,
               const double      closed) const;

    /// Adds to @p found the violation of Coulomb's law in row @p r, with forces
    /// below @p small and lengths below @p closed as rounding.
    void
    add_friction_violations(const State       &state,
                            const LoadFactor  &factor,
                            const unsigned int r,
                            const double       closed,
                            const double       small,
                            ContactViolations &found) const;

    /// Returns the residual of the contact law for each number of @p closed.
    Vector
    law_residual(const State             &state,
                 const LoadFactor        &factor,
                 const ActiveConstraints &closed) const;
    /// Returns violations() beyond the rounding of the last correction.
    ContactViolations
    find_violations(const State &state, const LoadFactor &factor) const;

    /// Returns true if the @p error of the law [length] is small enough, which
    /// is more if the round @p was_slow.
    bool
    satisfies_contact_law(const State      &state,
                          const LoadFactor &factor,
                          const double      error,
                          const bool        was_slow) const;

    /// Returns the first problem, about the state without contact forces, with
    /// @p previous forces that penetrate in @p free as estimates.
    ContactProblem
    first_problem(const State      &free,
                  const LoadFactor &factor,
                  const State      &previous) const;
    /// Returns the next problem, about @p state with its forces as estimates.
    ContactProblem
    problem_at(const State &state, const LoadFactor &factor) const;

    /// Replaces @p state by the state of the forces of @p settled, and returns
    /// true if that satisfies the contact law: for dependent constraints, where
    /// refinement shifts forces by rounding. Returns false, without effect, if
    /// the strategy is not as accurate.
    bool
    multipliers_are_reliable(State            &state,
                             const State      &settled,
                             const LoadFactor &factor);

    /// Corrects the active set of the refined @p state where rounding of the
    /// compliance repeats a wrong set: tensile constraints leave, penetrating
    /// ones join, and the state is refined, in at most max_set_corrections
    /// rounds. Returns false, without effect, on failure.
    bool
    correct_active_set(State &state, const LoadFactor &factor);

    /// Corrects u and the forces of the active constraints once, against r_u =
    /// t f + B^T lambda - integral B^T C (B u) and r_lambda = -(g + a lambda),
    /// or -v if sticking, with the active set kept. Returns the maximum norm of
    /// the correction over that of u. Throws NumericsError if it is not finite.
    double
    correct(State &state, const LoadFactor &factor);

    /// Corrects @p at_least times until is_refined(); returns all correct().
    std::vector<double>
    refine(State &state, const LoadFactor &factor, const unsigned int at_least);

    /// Returns true if another correction would be rounding: the last of @p
    /// corrections is small or above half of the previous one, or at the limit.
    bool
    is_refined(const std::vector<double> &corrections,
               const unsigned int         at_least) const;

    /// Returns the largest displacement, obstacles along normals included.
    double
    displacement_scale(const State &state, const LoadFactor &factor) const;

    /// Returns @p share of displacement_scale(), at least State::rounding().
    double
    length_of(const double      share,
              const State      &state,
              const LoadFactor &factor) const;

    /// Returns a sentence on the initial overlap of bodies, or nothing.
    std::string
    describe_overlap() const;

    /// Counts @p round in @p iterations and reports it, with
    /// check_iterations().
    void
    watch(const Round &round, unsigned int &iterations) const;

    /// Throws NumericsError once @p iterations reaches max_iterations, naming
    /// three constraints that are @p changing.
    void
    check_iterations(const unsigned int               iterations,
                     const std::vector<unsigned int> &changing) const;

    /// Throws the NumericsError of release_springs() for the spring under the
    /// largest force. The motion is unconstrained if the ratio @p rate of
    /// successive changes is close to 1. Otherwise its springs are too stiff,
    /// and the message gives the share for a rate of 0.1.
    [[noreturn]] void
    throw_unconstrained_motion(const std::string &body,
                               const std::string &motion,
                               const double       rate) const;
    [[noreturn]] void
    throw_spring_failure(const State &state, const double rate) const;

    const std::shared_ptr<const TangentOperator> tangent_operator;
    const Structure                             &structure;
    const GapConstraints                         rows;
    const SolverParameters                       parameters;
    const std::unique_ptr<ContactStrategy>       strategy;
  };
} // namespace lamella

#endif
