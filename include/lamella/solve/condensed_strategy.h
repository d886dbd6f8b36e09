// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_condensed_strategy_h
#define lamella_solve_condensed_strategy_h

#include <lamella/solve/contact_strategy.h>

#include <map>

namespace lamella
{
  /**
   * K is factorised once per body; contact lives on the compliance of the rows
   * that were ever active,
   *   C = B K^-1 B^T = Y^T Y,  Y = L^-1 P B^T,
   * of which only the forward half is computed, a few columns at a time. Each
   * solve is then one small dense system, (C + diag(1/eps)) dlambda =
   * r_lambda - B K^-1 r_u, and one backward half, du = K^-1 r_u + P^T L^-T Y
   * dlambda.
   */
  class CondensedStrategy : public ContactStrategy
  {
  public:
    /// Both are referred to; @p structure must be factorised.
    CondensedStrategy(const Structure           &structure,
                      const std::vector<GapRow> &rows);

    void
    solve(const std::vector<unsigned int> &active,
          const BlockVector               *r_u,
          const Vector                    &r_lambda,
          BlockVector                     &du,
          Vector                          &dlambda) override;

    double
    condition_estimate() const override;

  private:
    /// One body's columns Y of the rows that touch it.
    struct BodyColumns
    {
      std::vector<Vector> y;
      /// Number of a gap row -> column of y.
      std::map<unsigned int, unsigned int> column;
    };

    /// Computes the columns of those of @p active that have none yet, and their
    /// compliance with all others.
    void
    add_columns(const std::vector<unsigned int> &active);

    /// y_i . y_j over all bodies.
    double
    product(const unsigned int row_i, const unsigned int row_j) const;

    /// K^-1 r of the unconstrained DoFs, expanded.
    BlockVector
    apply_inverse(BlockVector r) const;

    const Structure           &structure;
    const std::vector<GapRow> &rows;
    std::vector<BodyColumns>   columns;

    /// The rows that were ever active, their place in the compliance, and its
    /// lower triangle by rows.
    std::vector<unsigned int>            known_rows;
    std::map<unsigned int, unsigned int> place;
    std::vector<std::vector<double>>     compliance;
  };
} // namespace lamella

#endif
