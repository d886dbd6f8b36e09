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

    unsigned int iterations = 0;
    /// Maximum norm of each correction over that of u: of the free linear
    /// solution, and of the solution with contact. The first of them measures
    /// the digits that the assembled matrix lost.
    std::vector<double> free_corrections, contact_corrections;
  };

  struct NewtonParameters
  {
    unsigned int max_iterations = 50;
    /// At most this many rows or as many as are active, whichever is more,
    /// become active in one iteration: the worst violators first.
    unsigned int rows_at_once = 8;
    /// Corrections below this, relative, end the refinement.
    double       refinement_tolerance = 1e-13;
    unsigned int max_refinements      = 6;
  };

  /**
   * The Newton loop of one load step. Bodies are linear, so only the active set
   * is not: each iteration solves the linear problem for the current active
   * rows exactly, drops those in tension and takes in the worst of those that
   * penetrate; it ends when nothing changes, also not after the result was
   * refined against the strain-first residual. A set that comes back makes it
   * change one row at a time from then on.
   */
  class Newton
  {
  public:
    using Progress = std::function<void(const std::string &)>;

    Newton(const Structure           &structure,
           const std::vector<GapRow> &rows,
           ContactStrategy           &strategy,
           const NewtonParameters    &parameters = NewtonParameters());

    /// Called with a line of text per iteration.
    Progress progress;

    /// The linear solution at load factor @p factor, no row active.
    State
    solve_free(const double factor) const;

    /**
     * Contact on top of @p free; @p start, if any, are the rows to start from.
     * Throws NumericsError if the active set does not settle; the message names
     * how many rows keep changing.
     */
    State
    solve_contact(const State                     &free,
                  const double                     factor,
                  const std::vector<unsigned int> &start) const;

    /// g of each row at load factor @p factor.
    std::vector<double>
    gaps(const BlockVector &u, const double factor) const;

  private:
    /// The active set that follows from @p state with gaps @p g: rows in
    /// tension open, at most @p at_once of those that penetrate close.
    std::vector<unsigned int>
    next_active_set(const State               &state,
                    const std::vector<double> &g,
                    const std::size_t          at_once) const;

    /// Displacements and forces of @p state for its active rows.
    void
    solve_active(const State               &free,
                 const std::vector<double> &free_gaps,
                 State                     &state) const;

    /// Corrects @p state against r_u = t f + B^T lambda - integral B^T C (B u)
    /// and r_lambda = -(g + lambda / eps) until nothing is left to correct.
    std::vector<double>
    refine(State             &state,
           const double       factor,
           const unsigned int at_least) const;

    const Structure           &structure;
    const std::vector<GapRow> &rows;
    ContactStrategy           &strategy;
    NewtonParameters           parameters;
  };
} // namespace lamella

#endif
