// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_contact_solver_h
#define lamella_solve_contact_solver_h

#include <lamella/solve/contact_problem.h>

#include <functional>
#include <string>
#include <vector>

namespace lamella
{
  /// A state of the scene.
  struct State
  {
    BlockVector u;
    /// Of each gap row: the contact force, positive in compression.
    std::vector<double> force;
    /// Numbers of the active rows, ascending.
    std::vector<unsigned int> active;

    /// Where the stabilising springs are without force.
    SpringRest rest;

    unsigned int iterations = 0;
    /// Maximum norm of each correction over that of u: of the free linear
    /// solution, and of the solution with contact. The first of them measures
    /// the digits that the assembled matrix lost.
    std::vector<double> free_corrections, contact_corrections;
  };

  struct SolverParameters
  {
    unsigned int max_iterations = 50;
    /// Corrections below this, relative, end the refinement.
    double       refinement_tolerance = 1e-13;
    unsigned int max_refinements      = 6;
  };

  /**
   * The solution of one load step: the linear one first, then contact on top of
   * it, then without the forces of stabilising springs. How contact is solved
   * for is what its kinds differ in; what they share is the refinement against
   * the strain-first residual and the contact law itself.
   */
  class ContactSolver
  {
  public:
    using Progress = std::function<void(const std::string &)>;
    using Describe = std::function<std::string(const unsigned int)>;

    /// @p structure and the rows are referred to.
    ContactSolver(const Structure        &structure,
                  const GapRows          &rows,
                  const SolverParameters &parameters);
    virtual ~ContactSolver();

    /// Called with a line of text per iteration.
    Progress progress;
    /// What a gap row is to the user: contact, body, position.
    Describe describe;

    /// The linear solution at load factor @p factor, no row active, the springs
    /// without force at @p rest.
    State
    solve_free(const double factor, const SpringRest &rest = {});

    /**
     * Contact on top of @p free; @p previous, if any, is the state of the load
     * step before, from whose forces and active rows the search starts. Throws
     * NumericsError if the active set does not settle; the message names the
     * rows that keep changing.
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
     */
    State
    release_springs(State state, const double factor);

    /// g of each row at load factor @p factor.
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

    /// What was learnt so far, and back again.
    virtual StrategyMemory
    memory() const = 0;
    virtual void
    recall(const StrategyMemory &memory) = 0;

    /// The largest estimate of a condition number met so far, 0 if unknown.
    virtual double
    condition_estimate() const
    {
      return 0.;
    }

    /// What the user should know of penalties and arithmetic, a sentence each.
    virtual std::vector<std::string>
    warnings() const
    {
      return {};
    }

  protected:
    /// What to try where the search does not end, besides a finer mesh and more
    /// iterations.
    virtual std::string
    remedy() const = 0;

    /// Corrects u and the forces of active rows once, against
    /// r_u = t f + B^T lambda - integral B^T C (B u) and
    /// r_lambda = -(g + a lambda); returns the maximum norm of the correction
    /// over that of u. Throws NumericsError for what is no number.
    double
    correct(State &state, const double factor);

    /// Corrects until nothing is left to correct; returns what correct() did.
    std::vector<double>
    refine(State &state, const double factor, const unsigned int at_least);

    /// Whether another correction would be rounding, after @p corrections.
    bool
    is_refined(const std::vector<double> &corrections,
               const unsigned int         at_least) const;

    /// The length that gaps and displacements of @p state are accurate to
    /// rounding of.
    double
    size_of(const State &state, const double factor) const;

    /// Counts and reports a round; throws if there were too many.
    void
    watch(const Round &round, unsigned int &iterations) const;

    /// Throws NumericsError after too many @p iterations, and names the rows
    /// that are still @p changing.
    void
    check_iterations(const unsigned int               iterations,
                     const std::vector<unsigned int> &changing) const;

    const Structure       &structure;
    const GapRows          rows;
    const SolverParameters parameters;

  private:
    [[noreturn]] void
    fail_on_springs(const State &state, const double rate) const;
  };
} // namespace lamella

#endif
