// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_full_strategy_h
#define lamella_solve_full_strategy_h

#include <lamella/solve/contact_strategy.h>

namespace lamella
{
  /**
   * The paper's way: K + K^p of the whole scene, K^p = B_A^T diag(eps) B_A
   * (Eqs. 22 and 23), factorised by MUMPS, on all processes, whenever the
   * active set changes. What nonlinear bodies will need, and an independent
   * check of the condensed strategy: on one process neither the factorisation
   * nor the compliance is shared.
   *
   * The active set is found by Newton's method on the energy
   *   E(u) = 1/2 u^T K u - f^T u
   *          + sum 1/2 max(0, (d - a) lambda_bar - g)^2 / d,
   * convex and piecewise quadratic: each step is followed to the lowest point
   * on its line, so E falls and no set of rows comes back.
   */
  class FullStrategy : public ContactStrategy
  {
  public:
    /// Both are referred to; @p structure must be assembled.
    FullStrategy(const Structure &structure, const std::vector<GapRow> &rows);

    void
    solve(const std::vector<unsigned int> &active,
          const BlockVector               *r_u,
          const Vector                    &r_lambda,
          BlockVector                     &du,
          Vector                          &dlambda) override;

    ContactSolution
    settle(const ContactProblem &problem, const Monitor &monitor) override;

    double
    condition_estimate() const override
    {
      return 0.;
    }

    std::string
    remedy() const override
    {
      return "a softer penalty, the condensed strategy";
    }

    std::vector<std::string>
    warnings() const override;

  private:
    /// Keeps the hardest of the penalties of @p active over what the DoFs of
    /// the row offer, k = 1 / sum(b_i^2 / K_ii).
    void
    measure_hardness(const std::vector<unsigned int> &active);

    /// Where Newton's method stands: displacements since the state of the
    /// problem, the contact forces that they balance, and the gaps.
    struct Iterate
    {
      BlockVector         du;
      std::vector<double> force, gap;
    };

    /// The state that is in balance with all of @p active and no other row in
    /// contact.
    Iterate
    newton_point(const ContactProblem            &problem,
                 const std::vector<unsigned int> &active);

    /// (d - a) lambda_bar - g of row @p r: its law's force times d where it is
    /// positive.
    double
    overlap(const ContactProblem &problem,
            const unsigned int    r,
            const double          gap) const;

    /// The rows whose law says otherwise at @p gap than @p active.
    Round
    compare(const ContactProblem            &problem,
            const std::vector<unsigned int> &active,
            const std::vector<double>       &gap) const;

    /// What follows from @p active and its gaps: those in tension open, the
    /// worst of those that penetrate close.
    std::vector<unsigned int>
    next_set(const ContactProblem            &problem,
             const std::vector<unsigned int> &active,
             const std::vector<double>       &gap) const;

    /// dE/dt at @p t on the line from @p from to @p to.
    double
    slope(const ContactProblem &problem,
          const Iterate        &from,
          const Iterate        &to,
          const double          t) const;

    /// The t at which E is lowest on that line.
    double
    lowest_point(const ContactProblem &problem,
                 const Iterate        &from,
                 const Iterate        &to) const;

    /// The unconstrained DoFs and weights of a gap row in the numbering of the
    /// whole scene.
    Row
    global_row(const GapRow &row) const;

    /// Assembles and factorises K + K^p of the rows @p active.
    void
    factorise(const std::vector<unsigned int> &active);

    std::unique_ptr<LinearSolver> solver;
    std::vector<unsigned int>     factorised_for;
    std::vector<double>           factorised_with;
    double                        hardest = 0., hardest_penalty = 0.;
  };
} // namespace lamella

#endif
