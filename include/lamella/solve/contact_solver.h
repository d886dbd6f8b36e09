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
  /// Tolerances and limits of ContactSolver. Lengths are relative to the
  /// largest displacement (ContactSolver::displacement_scale()).
  struct SolverParameters
  {
    /// Maximum number of active-set rounds in a load step; then it fails.
    unsigned int max_iterations = 50;

    /// Correction, relative to the solution, below which refinement ends.
    double refinement_tolerance = arithmetic::rounding_of_sums;
    /// Maximum number of corrections by refinement, besides the mandatory ones.
    /// Refinement also ends if a correction exceeds half the previous one.
    unsigned int max_refinements = 6;

    /// Penetrations below this length (relative) count as rounding.
    double rounding = arithmetic::rounding;
    /// Tolerance of the contact law in active constraints (relative length).
    double law_tolerance = arithmetic::rounding_of_results;
    /// Larger tolerance, used if the last round reduced the error slowly.
    double weak_law_tolerance = arithmetic::rounding_of_solutions;
    /// weak_law_tolerance applies if a round leaves more than this fraction of
    /// the error of the contact law.
    double slow = 0.1;
    /// Maximum number of rounds of ContactSolver::correct_active_set().
    unsigned int max_set_corrections = 20;

    /// Relative change of spring offsets below which release_springs() ends.
    double spring_offset_tolerance = arithmetic::rounding_of_results;
    /// Spring force over the largest force below which release_springs() ends.
    double       spring_force_tolerance = arithmetic::rounding_of_sums;
    unsigned int max_releases = 60; ///< Maximum rounds of release_springs().
  };

  /// Solver of one load step: first the linear solution, then contact, then the
  /// release of stabilizing springs. A ContactStrategy finds the active set.
  /// Equations at load factor t, with displacements u, internal forces f_int,
  /// loads f, gaps g with rows B, contact forces lambda and law_compliance() a:
  ///   f_int(u) + f_springs(u) = t f + B^T lambda   (in the free DoFs)
  ///   g(u) + a lambda >= 0,  lambda >= 0,  and in each constraint one is zero.
  /// f_int is linear in u; the active set is the only nonlinearity.
  ///
  /// Iterative refinement: the residuals of both equations are evaluated, f_int
  /// from strains (Structure::residual()), and the solution is corrected with
  /// the factorization of the strategy. Keeps references to the structure and
  /// the gap constraints. Collective, with equal arguments.
  class ContactSolver
  {
  public:
    /// Callback for a line of text on the progress of the solution.
    using Progress = std::function<void(const std::string &)>;
    /// Function that returns a description of the gap constraint with an index.
    using Describe = std::function<std::string(const unsigned int)>;

    /// Creates a solver for the stiffness @p tangent with the strategy
    /// @p which. The structure and @p rows must outlive this object.
    ContactSolver(std::shared_ptr<const TangentOperator> tangent,
                  const GapConstraints                  &rows,
                  const SolverParameters &parameters = SolverParameters(),
                  const Strategy          which      = Strategy::condensed);

    /// Callback for one line of text per round; no output by default.
    Progress progress;
    /// Description of a gap constraint in messages; its index by default.
    Describe describe;

    /// Returns the linear solution at load factor @p factor without contact,
    /// refined by at least two corrections. Stabilizing springs have no force
    /// at the offsets @p rest. Throws NumericsError if it is not finite.
    State
    solve_free(const LoadFactor &factor, const SpringOffsets &rest = {});

    /// Returns the solution with contact, starting from @p free, the result of
    /// solve_free() at the same @p factor, and from the forces and active set
    /// of the @p previous load step, if any. Without friction, the start
    /// affects the number of rounds only. Returns @p free if no constraint
    /// penetrates there. Throws NumericsError, naming the constraints that
    /// still change, if the active set does not converge.
    ///
    /// Each round determines the active set for the current estimates of the
    /// contact forces (method of multipliers), refines the state, and checks
    /// the contact law. The loop ends if no active constraint is tensile, no
    /// inactive one penetrates beyond rounding, and active ones satisfy the law
    /// to law_tolerance or weak_law_tolerance.
    State
    solve_contact(const State      &free,
                  const LoadFactor &factor,
                  const State      &previous = State());

    /// Returns @p state, a result of solve_contact(), without the influence of
    /// the stabilizing springs. Each round solves with springs that have no
    /// force in the previous state. Throws NumericsError after max_releases
    /// rounds if a body is unconstrained or the springs are too stiff.
    State
    release_springs(State state, const LoadFactor &factor);

    /// Returns the gap [length] of each constraint for the displacements @p u
    /// at load factor @p factor.
    std::vector<double>
    gaps(const BlockVector &u, const LoadFactor &factor) const;

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

    /// Returns the data of the contact strategy that a restarted run needs.
    StrategyHistory
    memory() const
    {
      return strategy->memory();
    }
    /// Restores data of the contact strategy, the result of memory().
    void
    restore(const StrategyHistory &memory)
    {
      strategy->restore(memory);
    }

    /// Returns the tangent stiffness with its factorizations.
    const TangentOperator &
    tangent() const
    {
      return *tangent_operator;
    }

    /// Returns the tangent stiffness for another solver with other constraints.
    std::shared_ptr<const TangentOperator>
    shared_tangent() const
    {
      return tangent_operator;
    }

    /// Returns warnings of the contact strategy, one sentence each.
    std::vector<std::string>
    warnings() const
    {
      return strategy->warnings();
    }

  private:
    /// Violations of the contact law in a refined state.
    struct ContactViolations
    {
      /// Active constraints that are tensile, and inactive ones that penetrate.
      std::vector<unsigned int> tensile, penetrating;
      /// Sticking constraints whose shear force exceeds the friction limit, and
      /// slipping ones whose slip is in the direction of their shear force.
      std::vector<unsigned int> friction_violations;
      /// Largest error of the remaining active constraints: |g + a lambda|, or
      /// the slip |v| of sticking constraints [length].
      double gap = 0.;

      bool
      is_active_set_correct() const
      {
        return tensile.empty() && penetrating.empty() &&
               friction_violations.empty();
      }
    };

    /// Returns the violations of the contact law; gaps above -@p closed count
    /// as zero.
    ContactViolations
    violations(const State      &state,
               const LoadFactor &factor,
               const double      closed) const;

    /// Adds the violation of Coulomb's law in constraint @p r to @p found.
    /// Forces below @p small and lengths below @p closed are rounding.
    void
    add_friction_violations(const State       &state,
                            const LoadFactor  &factor,
                            const unsigned int r,
                            const double       closed,
                            const double       small,
                            ContactViolations &found) const;

    /// Returns -(g + a lambda) of each gap g in @p closed, and minus each slip.
    Vector
    law_residual(const State             &state,
                 const LoadFactor        &factor,
                 const ActiveConstraints &closed) const;
    /// Returns the violations of the contact law beyond rounding.
    ContactViolations
    find_violations(const State &state, const LoadFactor &factor) const;

    /// Returns true if the @p error of the contact law [length] is below
    /// law_tolerance, or weak_law_tolerance if the last round @p was_slow.
    bool
    satisfies_contact_law(const State      &state,
                          const LoadFactor &factor,
                          const double      error,
                          const bool        was_slow) const;

    /// Returns the first contact problem, about the state @p free without
    /// contact forces. Force estimates are those of the @p previous load step
    /// for constraints that penetrate in @p free, else zero.
    ContactProblem
    first_problem(const State      &free,
                  const LoadFactor &factor,
                  const State      &previous) const;
    /// Returns the next contact problem, about @p state; the estimates are its
    /// forces.
    ContactProblem
    problem_at(const State &state, const LoadFactor &factor) const;

    /// Replaces the forces of @p state by those of @p settled, found by the
    /// strategy before refinement, and returns true if they satisfy the contact
    /// law. Otherwise returns false, without effect.
    bool
    multipliers_are_reliable(State            &state,
                             const State      &settled,
                             const LoadFactor &factor);

    /// Corrects the active set of the refined @p state if rounding of the
    /// compliance leads to the same wrong set again: deactivates tensile
    /// constraints, activates penetrating ones and refines, up to
    /// max_set_corrections times. Returns false, without effect, on failure.
    bool
    correct_active_set(State &state, const LoadFactor &factor);

    /// Corrects the displacements and the forces of the active constraints
    /// once, with a constant active set, from the residuals of equilibrium and
    /// of the contact law. Returns the maximum norm of the correction over that
    /// of the displacements. Throws NumericsError if it is not finite.
    double
    correct(State &state, const LoadFactor &factor);

    /// Returns the solution with springs that have no force at the offsets
    /// @p rest, from the solution @p state with other offsets.
    State
    with_springs_at(const SpringOffsets &rest,
                    State                state,
                    const LoadFactor    &factor);

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

    /// Returns the largest displacement component of bodies, or normal
    /// displacement of obstacles [length].
    double
    displacement_scale(const State &state, const LoadFactor &factor) const;

    /// Returns @p share times displacement_scale(), at least State::rounding().
    double
    length_of(const double      share,
              const State      &state,
              const LoadFactor &factor) const;

    /// Returns a sentence on the initial overlap of bodies, if any.
    std::string
    describe_overlap() const;

    /// Counts and reports @p round, and calls check_iterations() without the @p
    /// not_counted rounds.
    void
    watch(const Round       &round,
          const unsigned int not_counted,
          unsigned int      &iterations) const;

    /// Throws NumericsError if @p iterations exceeds max_iterations. The
    /// message names three of the constraints @p changing.
    void
    check_iterations(const unsigned int               iterations,
                     const std::vector<unsigned int> &changing) const;

    /// Throws the NumericsError of release_springs() for the rigid motion
    /// @p motion of @p body. If the ratio @p rate of successive spring forces
    /// is close to 1, nothing else constrains the motion. Otherwise the springs
    /// are too stiff, and the message gives a suitable Stabilization.
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
