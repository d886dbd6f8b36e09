// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_newton_h
#define lamella_solve_newton_h

#include <lamella/solve/contact_strategy.h>

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

  struct NewtonParameters
  {
    unsigned int max_iterations = 50;
    /// Corrections below this, relative, end the refinement.
    double       refinement_tolerance = 1e-13;
    unsigned int max_refinements      = 6;
  };

  /**
   * The solution of one load step: the linear one first, then contact on top of
   * it. Bodies are linear, so only the active set is not; the strategy finds
   * it. What it found is refined against the strain-first residual and the
   * contact law itself, and looked at again: rows that pull or penetrate after
   * that send it back to the strategy with better estimates of state and
   * forces. Rows without penetration (`exact`, `augmented lagrangian`) come out
   * of the same loop: each refinement and each return takes the forces so far
   * as the estimate.
   */
  class Newton
  {
  public:
    using Progress = std::function<void(const std::string &)>;
    using Describe = std::function<std::string(const unsigned int)>;

    Newton(const Structure           &structure,
           const std::vector<GapRow> &rows,
           ContactStrategy           &strategy,
           const NewtonParameters    &parameters = NewtonParameters());

    /// Called with a line of text per iteration.
    Progress progress;
    /// What a gap row is to the user: contact, body, position.
    Describe describe;

    /// The linear solution at load factor @p factor, no row active, the springs
    /// without force at @p rest.
    State
    solve_free(const double factor, const SpringRest &rest = {}) const;

    /**
     * Contact on top of @p free; @p previous, if any, is the state of the load
     * step before, from whose forces and active rows the search starts. Throws
     * NumericsError if the active set does not settle; the message names the
     * rows that keep changing.
     */
    State
    solve_contact(const State &free,
                  const double factor,
                  const State &previous = State()) const;

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
    release_springs(State state, const double factor) const;

    /// g of each row at load factor @p factor.
    std::vector<double>
    gaps(const BlockVector &u, const double factor) const;

  private:
    [[noreturn]] void
    fail_on_springs(const State &state, const double rate) const;

    /// The length that gaps and displacements of @p state are accurate to
    /// rounding of.
    double
    size_of(const State &state, const double factor) const;

    /// What is wrong with a refined state.
    struct Misses
    {
      /// Active rows that pull, and others that penetrate.
      std::vector<unsigned int> opening, closing;
      /// The largest |g + a lambda| of the others that are active.
      double gap = 0.;
    };

    Misses
    misses(const State               &state,
           const std::vector<double> &g,
           const double               closed) const;

    /// The problem that the strategy is to solve first.
    ContactProblem
    first_problem(const std::vector<double> &free_gaps,
                  const State               &previous) const;

    /// Corrects @p state against r_u = t f + B^T lambda - integral B^T C (B u)
    /// and r_lambda = -(g + a lambda) until nothing is left to correct.
    std::vector<double>
    refine(State             &state,
           const double       factor,
           const unsigned int at_least) const;

    /**
     * Takes rows of the refined @p state that pull out of the active set and
     * rows that penetrate into it, refines, and looks again; whether that ended
     * well. It is for strategies whose own rounding decides on rows that hardly
     * touch, and then gives the same wrong set again and again.
     */
    bool
    correct_set(State &state, const double factor) const;

    /// Counts and reports a round; throws if there were too many.
    void
    watch(const Round &round, unsigned int &iterations) const;

    /// Throws NumericsError after too many @p iterations, and names the rows
    /// that are still @p changing.
    void
    check_iterations(const unsigned int               iterations,
                     const std::vector<unsigned int> &changing) const;

    const Structure           &structure;
    const std::vector<GapRow> &rows;
    ContactStrategy           &strategy;
    NewtonParameters           parameters;
  };
} // namespace lamella

#endif
