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
  /// When iterations end. All tolerances of the loop are here; those without
  /// a unit are relative to the displacements (ContactSolver::size_of()).
  struct SolverParameters
  {
    /// Of a solution with contact; one that needs more fails.
    unsigned int max_iterations = 50;

    /// Corrections below this end the refinement.
    double refinement_tolerance = arithmetic::rounding_of_sums;
    /// Corrections beyond those that are made in any case. A correction that is
    /// more than half of the one before ends them sooner.
    unsigned int max_refinements = 6;

    /// Gaps less negative than this are rounding; than the last correction, if
    /// digits are lost.
    double rounding = arithmetic::rounding;
    /// What active rows keep the contact law to, and what is good enough where
    /// another round hardly betters them, as rounding allows no more.
    double law_tolerance = arithmetic::rounding_of_results,
           good_enough   = arithmetic::rounding_of_solutions;
    /// A round that leaves more than this share of the law's error of the one
    /// before is slow.
    double slow = 0.1;
    /// Of ContactSolver::correct_set().
    unsigned int max_set_corrections = 20;

    /// What the springs' rest moves by in a round that ends their release; or
    /// what springs still carry then, of the largest load or contact force. (A
    /// motion that nothing loads nor holds drifts by rounding, without a force
    /// to speak of.)
    double springs_at_rest       = arithmetic::rounding_of_results,
           springs_without_force = arithmetic::rounding_of_sums;
    unsigned int max_releases    = 60;
  };

  /**
   * The solution of one load step: the linear one first, then contact on top of
   * it, then without the forces of stabilising springs. Which rows are active
   * is settled by a ContactStrategy; what it found is refined here against the
   * strain-first residual and the contact law itself.
   *
   * What is solved, at load factor t, with the gap rows B:
   *   f_int(u) + f_springs(u) = t f + B^T lambda   (in the free DoFs)
   *   g(u) + a lambda >= 0,  lambda >= 0,  one of the two zero in each row.
   * f_int is linear in u, so the one nonlinearity is which rows are active.
   *
   * Iterative refinement: both lines are evaluated at the state itself, f_int
   * from strains (Structure::residual()), and corrected with the inverse that
   * the strategy has. The result is as accurate as these residuals; the
   * matrix decides only how fast it is reached.
   *
   * Refers to the structure and, through a view, to the gap rows: both must
   * outlive it. Where processes share the work, all of them call all functions
   * with the same arguments and hold the same states.
   */
  class ContactSolver
  {
  public:
    /// Takes a line of text.
    using Progress = std::function<void(const std::string &)>;
    /// Turns the number of a gap row into words.
    using Describe = std::function<std::string(const unsigned int)>;

    /// About the state of @p linearisation, with the strategy @p which
    /// (make_strategy()); its structure and the rows are referred to. Nothing
    /// is solved yet.
    ContactSolver(std::shared_ptr<const Linearisation> linearisation,
                  const GapRows                       &rows,
                  const SolverParameters &parameters = SolverParameters(),
                  const Strategy          which      = Strategy::condensed);

    /// Called with a line of text per iteration; does nothing by default.
    Progress progress;
    /// What a gap row is to the user: contact, body, position. By default its
    /// number.
    Describe describe;

    /**
     * The linear solution at load factor @p factor, no row active, the springs
     * without force at @p rest: u = t u_p, then corrected at least twice (the
     * first correction is the solution itself). Throws NumericsError if the
     * result is no number.
     */
    State
    solve_free(const LoadFactor &factor, const SpringRest &rest = {});

    /**
     * Contact on top of @p free, the state of solve_free() at the same
     * @p factor; @p previous, if any, is the state of the load step before,
     * from whose forces and active rows the search starts. The problem is
     * convex, so the start decides on rounds and not on the result:
     * displacements and gaps are unique (forces where rows are independent).
     * Returns @p free itself if no row penetrates there. Throws NumericsError
     * if the active set does not settle; the message names the rows that keep
     * changing.
     *
     * One loop: the strategy settles the active set about the state, for
     * estimates of the forces; the outcome is refined; it is judged by the
     * contact law itself. Rows that pull or penetrate then send it back, about
     * the refined state. Rows without penetration (`exact`, `augmented
     * lagrangian`) come out of the same loop: each refinement and each return
     * takes the forces so far as the estimates (a proximal point iteration,
     * the method of multipliers). It ends when no active row pulls, no other
     * penetrates by more than rounding, and active rows keep the law to
     * law_tolerance; to good_enough where a round was slow.
     *
     * That it ends: every return to the strategy is counted as at least one
     * iteration, as some row is active or has a force then, so after
     * max_iterations at most it ends or throws. That it ends well where
     * arithmetic is exact: settled forces are those of a strictly convex
     * problem, refining them changes nothing but estimates, and each proximal
     * step lowers the distance to the solution.
     */
    State
    solve_contact(const State      &free,
                  const LoadFactor &factor,
                  const State      &previous = State());

    /**
     * @p state of solve_contact() without what stabilising springs falsify:
     * solved again and again with the springs' rest at the state before, it
     * converges to one in which they are without force (the proximal point
     * method; each round leaves the share s / (s + k) of the spring forces, s
     * the springs' stiffness and k that of the contact that holds the body).
     * Throws NumericsError if the rounds do not end: nothing holds the body, or
     * the springs are too stiff, and the message then gives the Stabilisation
     * to take.
     *
     * It ends when the rest moves by less than 1e-12 of the displacements, or
     * the springs carry less than 1e-13 of the largest load or contact force;
     * 60 rounds at most. Returns @p state at once if no body has springs. Each
     * round is a solve_free() and a solve_contact().
     */
    State
    release_springs(State state, const LoadFactor &factor);

    /// g = B u + g_init + t g_rate of each row at load factor t = @p factor
    /// (Eq. 16), a length, negative where the bodies penetrate.
    std::vector<double>
    gaps(const BlockVector &u, const LoadFactor &factor) const;

    /// Solves the linear system of one correction (ContactStrategy::solve()).
    void
    solve_linear(const ClosedRows  &closed,
                 const BlockVector &r_u,
                 const Vector      &r_lambda,
                 BlockVector       &du,
                 Vector            &dlambda)
    {
      strategy->solve(closed, r_u, r_lambda, du, dlambda);
    }

    /// The gaps that are closed in @p state and all slips there, with a
    /// symmetric matrix: what holds the bodies in a small disturbance, which
    /// has to turn a slip that goes on before it can use it.
    ClosedRows
    held_rows(const State &state) const;

    /// What was learnt so far, as it is kept for a resumed run.
    StrategyMemory
    memory() const
    {
      return strategy->memory();
    }
    /// Back again, into a solver of the same scene that has solved nothing yet.
    void
    recall(const StrategyMemory &memory)
    {
      strategy->recall(memory);
    }

    /// What it solves with.
    const Linearisation &
    tangent() const
    {
      return *linearisation;
    }

    /// The same for another solver, of other rows on the same stiffness.
    std::shared_ptr<const Linearisation>
    shared_tangent() const
    {
      return linearisation;
    }

    /// What the user should know of penalties and arithmetic, a sentence each.
    std::vector<std::string>
    warnings() const
    {
      return strategy->warnings();
    }

  private:
    /// How a refined state breaks the contact law.
    struct Misses
    {
      /// Active rows that pull, and others that penetrate.
      std::vector<unsigned int> opening, closing;
      /// Rows that stick with more than mu lambda_n, or slip where their shear
      /// drives them.
      std::vector<unsigned int> rubbing;
      /// The largest |g + a lambda| of the others that are active, and of |v|
      /// of those that stick; a length.
      double gap = 0.;

      bool
      is_right_set() const
      {
        return opening.empty() && closing.empty() && rubbing.empty();
      }
    };

    /// Of @p state; a gap above -@p closed is none that penetrates.
    Misses
    misses(const State      &state,
           const LoadFactor &factor,
           const double      closed) const;

    /// Adds to @p found how row @p r of @p state breaks the law of friction.
    /// Forces below @p small are rounding, as lengths below @p closed.
    void
    add_misses_of_friction(const State       &state,
                           const LoadFactor  &factor,
                           const unsigned int r,
                           const double       closed,
                           const double       small,
                           Misses            &found) const;

    /// What the law asks for of each number of @p closed, r_lambda.
    Vector
    law_residual(const State      &state,
                 const LoadFactor &factor,
                 const ClosedRows &closed) const;
    /// misses() of a refined state, where digits may be lost to its last
    /// correction.
    Misses
    judge(const State &state, const LoadFactor &factor) const;

    /// Whether an @p error of the law, a length, is small enough to end; less
    /// is asked for where the round @p was_slow.
    bool
    keeps_law(const State      &state,
              const LoadFactor &factor,
              const double      error,
              const bool        was_slow) const;

    /// What is to be settled first: about the state without contact forces,
    /// with the forces of @p previous as the estimates in those of its active
    /// rows that penetrate in @p free.
    ContactProblem
    first_problem(const State      &free,
                  const LoadFactor &factor,
                  const State      &previous) const;
    /// What is to be settled next, about the refined @p state, whose forces are
    /// the estimates.
    ContactProblem
    problem_about(const State &state, const LoadFactor &factor) const;

    /// For rows that depend on each other, where refining a state moves forces
    /// among them, also below zero, by rounding: replaces @p state by that of
    /// the forces alone that the strategy is sure of, those of @p settled, and
    /// says whether that is good enough. Nothing is done where the strategy
    /// does not know forces that well.
    bool
    stands_by_forces(State            &state,
                     const State      &settled,
                     const LoadFactor &factor);

    /**
     * For rows that hardly touch, where the rounding of the compliance decides
     * and gives the same wrong set again and again: takes rows of the refined
     * @p state that pull out of the active set and rows that penetrate into it,
     * refines, and looks again, in max_set_corrections rounds at most. Leaves
     * @p state as it is and returns false if that does not end well.
     */
    bool
    correct_set(State &state, const LoadFactor &factor);

    /// Corrects u and the forces of active rows once, against
    /// r_u = t f + B^T lambda - integral B^T C (B u) and
    /// r_lambda = -(g + a lambda), of rows that stick -v; returns the maximum
    /// norm of the correction over that of u, 0 if there was nothing to
    /// correct. The active set stays as it is. Throws NumericsError for what is
    /// no number.
    double
    correct(State &state, const LoadFactor &factor);

    /// Corrects @p at_least times and then until nothing is left to correct
    /// (is_refined()); returns what each correct() did.
    std::vector<double>
    refine(State &state, const LoadFactor &factor, const unsigned int at_least);

    /// Whether another correction would be rounding, after @p corrections: the
    /// last is below the tolerance, or more than half of the one before, or
    /// there were enough of them.
    bool
    is_refined(const std::vector<double> &corrections,
               const unsigned int         at_least) const;

    /// The length that gaps and displacements of @p state are accurate to
    /// rounding of: the largest displacement, that of moving obstacles along
    /// the rows' normals among them.
    double
    size_of(const State &state, const LoadFactor &factor) const;

    /// @p share of size_of(), a tolerance, or State::rounding() if that is
    /// more.
    double
    length_of(const double      share,
              const State      &state,
              const LoadFactor &factor) const;

    /// Returns a sentence on the initial overlap of bodies, its place, and the
    /// remedy; empty without overlap.
    std::string
    describe_overlap() const;

    /// Counts @p round in @p iterations and reports it; throws NumericsError if
    /// rows are still changing after too many.
    void
    watch(const Round &round, unsigned int &iterations) const;

    /// Throws NumericsError once @p iterations has reached max_iterations, and
    /// names the first three rows that are still @p changing.
    void
    check_iterations(const unsigned int               iterations,
                     const std::vector<unsigned int> &changing) const;

    /// Throws the NumericsError of release_springs() for the spring under the
    /// largest force: the body runs away if the change of a round over that of
    /// the one before, @p rate, is close to 1; else its springs are too stiff,
    /// and the message gives the share with which the rate would be 0.1.
    [[noreturn]] void
    fail_running_away(const std::string &body,
                      const std::string &motion,
                      const double       rate) const;
    [[noreturn]] void
    fail_on_springs(const State &state, const double rate) const;

    const std::shared_ptr<const Linearisation> linearisation;
    const Structure                           &structure;
    const GapRows                              rows;
    const SolverParameters                     parameters;
    const std::unique_ptr<ContactStrategy>     strategy;
  };
} // namespace lamella

#endif
