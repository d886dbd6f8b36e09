// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/linear/block_factor.h>
#include <lamella/linear/block_factorization.h>
#include <lamella/linear/factorization.h>
#include <lamella/linear/forward_solved_rows.h>

#include <algorithm>
#include <cmath>
#include <new>

namespace lamella
{
  namespace
  {
    /// The DoF @p dof in unconstrained DoFs.
    void
    resolve(const DofIndex                            dof,
            const Constraints                        &constraints,
            std::vector<std::pair<DofIndex, double>> &result)
    {
      result.clear();
      if (!constraints.is_constrained(dof))
        result.emplace_back(dof, 1.);
      else
        result = *constraints.get_constraint_entries(dof);
    }



    class BlockFactorization : public LinearSolver
    {
    public:
      BlockFactorization(const StiffnessTerms &terms,
                         const DenseBlocks    &blocks,
                         const Constraints    &constraints,
                         const std::string    &what,
                         const SolverMonitor  &monitor)
        : factor(BlockPattern(terms, blocks, constraints))
      {
        if (monitor.factor_sized)
          monitor.factor_sized({non_zeros(), 8. * non_zeros()});
        try
          {
            factor.allocate();
          }
        catch (const std::bad_alloc &)
          {
            throw NumericsError(
              "linear.out-of-memory: The factorization of " + what +
              " does not fit in memory. Use a coarser mesh or lower order.");
          }
        assemble(terms, constraints);
        fill_diagonal(constraints);
        if (monitor.assembled)
          monitor.assembled();
        factor.factorize(what);
      }

      void
      solve(Vector &x) const override
      {
        std::vector<Vector> both(1);
        both[0].swap(x);
        solve_all(both);
        both[0].swap(x);
      }

      void
      solve_all(std::vector<Vector> &x) const override
      {
        // As many at a time as fit beside the factor.
        constexpr std::size_t most        = 64;
        const std::size_t     n           = factor.where().block_of.size();
        const auto           &permutation = factor.where().permutation;
        std::vector<double>   y;
        for (std::size_t begin = 0; begin < x.size(); begin += most)
          {
            const std::size_t count = std::min(most, x.size() - begin);
            y.resize(count * n);
            for (std::size_t k = 0; k < count; ++k)
              for (std::size_t i = 0; i < n; ++i)
                y[k * n + i] = x[begin + k][permutation[i]];
            factor.forward(y.data(), count);
            factor.backward(y.data(), count);
            for (std::size_t k = 0; k < count; ++k)
              for (std::size_t i = 0; i < n; ++i)
                x[begin + k][permutation[i]] = y[k * n + i];
          }
        n_solutions += x.size();
      }

      std::unique_ptr<SolvedRows>
      solved_rows() const override
      {
        return make_forward_solved(factor.view(), [this](Vector &x) {
          factor.backward(x.begin(), 1);
          const auto &permutation = factor.where().permutation;
          Vector      y(x.size());
          for (std::size_t i = 0; i < x.size(); ++i)
            y[permutation[i]] = x[i];
          x = y;
        });
      }

      double
      condition_estimate() const override
      {
        return 1. / factor.reciprocal_condition();
      }

      double
      largest_diagonal() const override
      {
        return greatest;
      }

      SolverStatistics
      statistics() const override
      {
        return {SolverKind::blocks, non_zeros(), n_solutions};
      }

    private:
      double
      non_zeros() const
      {
        return factor.where().n_entries();
      }

      /// Adds @p value times the symmetrized product of @p u and @p v to A.
      void
      add(const std::vector<std::pair<DofIndex, double>> &u,
          const std::vector<std::pair<DofIndex, double>> &v,
          const double                                    value)
      {
        const std::vector<unsigned int> &block_of = factor.where().block_of;
        for (const auto &[i, of_u] : u)
          for (const auto &[j, of_v] : v)
            if (block_of[j] >= block_of[i])
              factor.column_begin(i, block_of[j])[j] += value * of_u * of_v;
      }

      /// Adds row @p row of a block times @p weight.
      void
      add_row(const DofIndex        row,
              const double          weight,
              const StiffnessBlock &block,
              const unsigned int    row_in_block,
              const Constraints    &constraints)
      {
        const std::vector<unsigned int> &block_of = factor.where().block_of;
        // By symmetry, row `row` of A is that column, with contiguous entries.
        const double *const values =
          block.values.data() +
          std::size_t(row_in_block) * block.columns.size();
        std::vector<std::pair<DofIndex, double>> resolved;
        double                                  *to = nullptr;
        unsigned int current                        = factor.where().n_blocks();
        for (std::size_t k = 0; k < block.columns.size(); ++k)
          {
            const DofIndex j = block.columns[k];
            if (constraints.is_constrained(j))
              {
                resolve(j, constraints, resolved);
                add({{row, weight}}, resolved, values[k]);
                continue;
              }
            if (block_of[j] != current)
              {
                current = block_of[j];
                to      = factor.column_begin(row, current);
              }
            if (to != nullptr)
              to[j] += weight * values[k];
          }
      }

      void
      assemble(const StiffnessTerms &terms, const Constraints &constraints)
      {
        std::vector<std::pair<DofIndex, double>> resolved;
        terms.for_each_block(true, [&](const StiffnessBlock &block) {
          for (unsigned int i = 0; i < block.rows.size(); ++i)
            {
              resolve(block.rows[i], constraints, resolved);
              for (const auto &[row, weight] : resolved)
                add_row(row, weight, block, i, constraints);
            }
        });
        for (const auto &[spring, stiffness] : terms.springs)
          {
            const LinearFunctional free = spring.reduced(constraints);
            add(free.entries(), free.entries(), stiffness);
          }
      }

      /// Constrained DoFs get the mean diagonal of the others.
      void
      fill_diagonal(const Constraints &constraints)
      {
        const DofIndex n_dofs = factor.where().block_of.size();
        double         sum    = 0.;
        for (DofIndex dof = 0; dof < n_dofs; ++dof)
          if (!constraints.is_constrained(dof))
            {
              greatest = std::max(greatest, std::abs(factor.diagonal(dof)));
              sum += std::abs(factor.diagonal(dof));
            }
        const double mean =
          sum > 0. ? sum / (n_dofs - constraints.n_constraints()) : 1.;
        for (const auto &line : constraints.get_lines())
          factor.diagonal(line.index) = mean;
      }

      BlockFactor          factor;
      double               greatest    = 0.;
      mutable unsigned int n_solutions = 0;
    };
  } // namespace



  std::unique_ptr<LinearSolver>
  factorize_blocks(const StiffnessTerms &terms,
                   const DenseBlocks    &blocks,
                   const Constraints    &constraints,
                   const std::string    &what,
                   const SolverMonitor  &monitor)
  {
    return std::make_unique<BlockFactorization>(
      terms, blocks, constraints, what, monitor);
  }
} // namespace lamella
