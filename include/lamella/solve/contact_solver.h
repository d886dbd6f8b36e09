// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_contact_solver_h
#define lamella_solve_contact_solver_h

#include <lamella/solve/contact_problem.h>
#include <lamella/solve/linearisation.h>

#include <functional>
#include <string>
#include <vector>

namespace lamella
{
  /// The primal and dual unknowns of a scene at one load factor: displacements
  /// and contact forces, and how they were come by. Empty: no state at all, as
  /// before the first load step.
  struct State
  {
    /// Displacements of all bodies, a block each: expanded, so prescribed DoFs
    /// have their values.
    BlockVector u;
    /// Of each gap row: the contact force lambda, positive in compression; zero
    /// in rows that are not active. It loads the bodies with B^T lambda.
    std::vector<double> force;
    /// Numbers of the active rows, ascending.
    std::vector<unsigned int> active;

    /// Where the stabilising springs are without force; empty: at u = 0.
    SpringRest rest;

    /// Rounds of the search for the active rows, those of all releases of the
    /// springs added up.
    unsigned int iterations = 0;
    /// Maximum norm of each correction over that of u: of the free linear
    /// solution, and of the solution with contact on its last active set. The
    /// first of `free_corrections` (the solution itself is left out) measures
    /// the digits that the assembled matrix lost.
    std::vector<double> free_corrections, contact_corrections;
  };

  /// When iterations end.
  struct SolverParameters
  {
    /// Of a solution with contact; one that needs more fails.
    unsigned int max_iterations = 50;
    /// Corrections below this, relative to the displacements, end the
    /// refinement.
    double refinement_tolerance = 1e-13;
    /// Corrections beyond those that are made in any case. A correction that is
    /// more than half of the one before ends them sooner.
    unsigned int max_refinements = 6;
  };

  /**
   * The solution of one load step: the linear one first, then contact on top of
   * it, then without the forces of stabilising springs. How contact is solved
   * for is what its kinds differ in; what they share is the refinement against
   * the strain-first residual and the contact law itself.
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

    /// About the state of @p linearisation; its structure and the rows are
    /// referred to. Nothing is solved yet.
    ContactSolver(std::shared_ptr<const Linearisation> linearisation,
                  const GapRows                       &rows,
                  const SolverParameters              &parameters);
    virtual ~ContactSolver();

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
    solve_free(const double factor, const SpringRest &rest = {});

    /**
     * Contact on top of @p free, the state of solve_free() at the same
     * @p factor; @p previous, if any, is the state of the load step before,
     * from whose forces and active rows the search starts. The problem is
     * convex, so the start decides on rounds and not on the result:
     * displacements and gaps are unique (forces where rows are independent).
     * Returns @p free itself if no row penetrates there. Throws NumericsError
     * if the active set does not settle; the message names the rows that keep
     * changing.
     */
    virtual State
    solve_contact(const State &free,
                  const double factor,
                  const State &previous = State()) = 0;

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
    release_springs(State state, const double factor);

    /// g = B u + g_init + t g_rate of each row at load factor t = @p factor
    /// (Eq. 16), a length, negative where the bodies penetrate.
    std::vector<double>
    gaps(const BlockVector &u, const double factor) const;

    /**
     * Solves the linear system of one iteration: with B_A the rows @p active
     * and d the numerical softness of a row, at least a,
     *   K du - B_A^T dlambda = r_u,
     *   B_A du + d dlambda   = r_lambda,
     * which is the paper's Eq. 22 when dlambda is eliminated. @p r_lambda and
     * @p dlambda have an entry for each active row. @p r_u need not be
     * condensed. du vanishes in what supports prescribe.
     */
    virtual void
    solve_linear(const std::vector<unsigned int> &active,
                 const BlockVector               &r_u,
                 const Vector                    &r_lambda,
                 BlockVector                     &du,
                 Vector                          &dlambda) = 0;

    /// What was learnt so far, as it is kept for a resumed run.
    virtual StrategyMemory
    memory() const = 0;
    /// Back again, into a solver of the same scene that has solved nothing yet.
    virtual void
    recall(const StrategyMemory &memory) = 0;

    /// What it solves with.
    const Linearisation &
    tangent() const
    {
      return *linearisation;
    }

    /// What the user should know of penalties and arithmetic, a sentence each.
    virtual std::vector<std::string>
    warnings() const
    {
      return {};
    }

  protected:
    /// What to try where the search does not end, besides a finer mesh and more
    /// iterations: the middle of a sentence.
    virtual std::string
    remedy() const = 0;

    /// Corrects u and the forces of active rows once, against
    /// r_u = t f + B^T lambda - integral B^T C (B u) and
    /// r_lambda = -(g + a lambda); returns the maximum norm of the correction
    /// over that of u, 0 if there was nothing to correct. The active set stays
    /// as it is. Throws NumericsError for what is no number.
    double
    correct(State &state, const double factor);

    /// Corrects @p at_least times and then until nothing is left to correct
    /// (is_refined()); returns what each correct() did.
    std::vector<double>
    refine(State &state, const double factor, const unsigned int at_least);

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
    size_of(const State &state, const double factor) const;

    /// Counts @p round in @p iterations and reports it; throws NumericsError if
    /// rows are still changing after too many.
    void
    watch(const Round &round, unsigned int &iterations) const;

    /// Throws NumericsError once @p iterations has reached max_iterations, and
    /// names the first three rows that are still @p changing.
    void
    check_iterations(const unsigned int               iterations,
                     const std::vector<unsigned int> &changing) const;

    const std::shared_ptr<const Linearisation> linearisation;
    const Structure                           &structure;
    const GapRows                              rows;
    const SolverParameters                     parameters;

  private:
    /// Throws the NumericsError of release_springs() for the spring under the
    /// largest force: the body runs away if the change of a round over that of
    /// the one before, @p rate, is close to 1; else its springs are too stiff,
    /// and the message gives the share with which the rate would be 0.1.
    [[noreturn]] void
    fail_on_springs(const State &state, const double rate) const;
  };
} // namespace lamella

#endif
