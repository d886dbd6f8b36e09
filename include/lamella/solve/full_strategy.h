// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_full_strategy_h
#define lamella_solve_full_strategy_h

#include <lamella/solve/contact_strategy.h>

#include <deal.II/lac/trilinos_solver.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

namespace lamella
{
  /**
   * The paper's way: K + K^p of the whole scene, K^p = B_A^T diag(eps) B_A
   * (Eqs. 22 and 23), assembled through AffineConstraints into a Trilinos
   * matrix and factorised by MUMPS whenever the active set changes. What
   * nonlinear bodies will need, and an independent check of the condensed
   * strategy: neither the factorisation nor the compliance is shared.
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

    double
    condition_estimate() const override
    {
      return 0.;
    }

  private:
    /// The DoFs and weights of a gap row in the numbering of the whole scene.
    std::vector<Row::Entry>
    global_row(const GapRow &row) const;

    /// Assembles and factorises K + K^p of the rows @p active.
    void
    factorise(const std::vector<unsigned int> &active);

    const Structure           &structure;
    const std::vector<GapRow> &rows;

    Constraints                                             constraints;
    dealii::TrilinosWrappers::SparseMatrix                  matrix;
    dealii::SolverControl                                   control;
    std::unique_ptr<dealii::TrilinosWrappers::SolverDirect> solver;
    std::vector<unsigned int>                               factorised_for;
  };
} // namespace lamella

#endif
