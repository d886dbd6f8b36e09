// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/linear/block_factorisation.h>
#include <lamella/linear/factorisation.h>
#include <lamella/linear/half_solved_rows.h>

#include <deal.II/lac/lapack_templates.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <new>
#include <set>

extern "C"
{
  // These are not among deal.II's.
  void DEAL_II_FORTRAN_MANGLE(dtrsm, DTRSM)(const char *side,
                                            const char *uplo,
                                            const char *trans,
                                            const char *diag,
                                            const dealii::types::blas_int *m,
                                            const dealii::types::blas_int *n,
                                            const double *alpha,
                                            const double *A,
                                            const dealii::types::blas_int *lda,
                                            double                        *B,
                                            const dealii::types::blas_int *ldb);
  void DEAL_II_FORTRAN_MANGLE(dtrsv,
                              DTRSV)(const char                    *uplo,
                                     const char                    *trans,
                                     const char                    *diag,
                                     const dealii::types::blas_int *n,
                                     const double                  *A,
                                     const dealii::types::blas_int *lda,
                                     double                        *x,
                                     const dealii::types::blas_int *incx);
}

namespace lamella
{
  using dealii::types::blas_int;

  namespace
  {
    constexpr double one = 1., minus_one = -1.;

    const auto trsm = &DEAL_II_FORTRAN_MANGLE(dtrsm, DTRSM);
    const auto trsv = &DEAL_II_FORTRAN_MANGLE(dtrsv, DTRSV);



    /// The blocks @p some from @p begin to @p end, the middle one after those
    /// on both sides.
    void
    dissect(const std::vector<unsigned int> &some,
            const std::size_t                begin,
            const std::size_t                end,
            std::vector<unsigned int>       &order)
    {
      if (begin >= end)
        return;
      const std::size_t middle = (begin + end) / 2;
      dissect(some, begin, middle, order);
      dissect(some, middle + 1, end, order);
      order.push_back(some[middle]);
    }



    /// The blocks of @p n in the order in which they are eliminated.
    std::vector<unsigned int>
    elimination_order(const unsigned int                            n,
                      const std::vector<std::vector<unsigned int>> &cliques)
    {
      std::vector<unsigned int> count(n, 0), order, between;
      for (const auto &clique : cliques)
        for (const unsigned int g : clique)
          ++count[g];
      for (unsigned int g = 0; g < n; ++g)
        (count[g] <= 1 ? order : between).push_back(g);
      if (between.empty())
        return order;
      dissect(between, 1, between.size() - 1, order);
      order.push_back(between.front());
      if (between.size() > 1)
        order.push_back(between.back());
      return order;
    }



    /// Of each block, by its place in the order of elimination, the later ones
    /// that its column of L has.
    std::vector<std::set<unsigned int>>
    eliminate(const std::vector<unsigned int>              &place,
              const std::vector<std::vector<unsigned int>> &cliques)
    {
      std::vector<std::set<unsigned int>> below(place.size());
      for (const auto &clique : cliques)
        for (const unsigned int g : clique)
          for (const unsigned int h : clique)
            if (place[h] > place[g])
              below[place[g]].insert(place[h]);
      for (std::set<unsigned int> &column : below)
        if (!column.empty())
          below[*column.begin()].insert(std::next(column.begin()),
                                        column.end());
      return below;
    }



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



    class BlockFactorisation : public LinearSolver
    {
    public:
      BlockFactorisation(const StiffnessTerms &terms,
                         const DenseBlocks    &blocks,
                         const Constraints    &constraints,
                         const std::string    &what,
                         const SolverMonitor  &monitor);

      void
      solve(Vector &x) const override;
      void
      solve_all(std::vector<Vector> &x) const override;
      std::unique_ptr<SolvedRows>
      solved_rows() const override;

      double
      condition_estimate() const override
      {
        return 1. / reciprocal_condition;
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
      /// A block below the diagonal of a column of L: its place in the order,
      /// and its first row in the column.
      struct Part
      {
        unsigned int block;
        blas_int     row;
      };

      unsigned int
      n_blocks() const
      {
        return parts.size();
      }
      blas_int
      width(const unsigned int s) const
      {
        return column[s + 1] - column[s];
      }
      blas_int
      height(const unsigned int s) const
      {
        return first_row[s + 1] - first_row[s];
      }
      double *
      entries(const unsigned int s)
      {
        return entry.data() + first_entry[s];
      }
      const double *
      entries(const unsigned int s) const
      {
        return entry.data() + first_entry[s];
      }
      double
      non_zeros() const;

      /// Groups of blocks that constraints and springs couple, too.
      std::vector<std::vector<unsigned int>>
      cliques_of(const StiffnessTerms &terms,
                 const DenseBlocks    &blocks,
                 const Constraints    &constraints) const;
      void
      analyse(const DenseBlocks                            &blocks,
              const std::vector<std::vector<unsigned int>> &cliques);
      /// Adds @p value times the product of the functionals @p u and @p v to A;
      /// the transposed product comes by itself.
      void
      add(const std::vector<std::pair<DofIndex, double>> &u,
          const std::vector<std::pair<DofIndex, double>> &v,
          const double                                    value);
      /// Adds row @p row of a block times @p factor.
      void
      add_row(const DofIndex        row,
              const double          factor,
              const StiffnessBlock &block,
              const unsigned int    row_in_block,
              const Constraints    &constraints);
      void
      assemble(const StiffnessTerms &terms, const Constraints &constraints);
      /// Constrained DoFs get the mean diagonal of the others.
      void
      fill_diagonal(const Constraints &constraints);
      double &
      diagonal(const DofIndex dof);
      /// Where the entry of the DoF @p column in the rows of the block number
      /// @p block would begin if that began with DoF 0; nullptr where it is
      /// above the diagonal.
      double *
      begin_of(const DofIndex column, const unsigned int block);
      void
      factorise(const std::string &what);
      /// Takes what the column @p s of L does to later ones out of them.
      void
      update(const unsigned int s);
      [[noreturn]] void
      break_down(const unsigned int s,
                 const blas_int     pivot,
                 const std::string &what) const;

      /// Calls @p use for each row of the column @p s of L below its diagonal
      /// block and each of @p count columns of numbers: the place there, and
      /// the place among the rows below alone.
      template <typename Use>
      void
      for_each_row_below(const unsigned int s,
                         const std::size_t  count,
                         const Use         &use) const
      {
        const std::int64_t *const below = row.data() + first_row[s] + width(s);
        const std::size_t         m     = height(s) - width(s);
        for (std::size_t c = 0; c < count; ++c)
          for (std::size_t k = 0; k < m; ++k)
            use(c * block_of.size() + below[k], c * m + k);
      }

      /// The @p count columns from @p x on, in the order of L.
      void
      forward(double *const x, const blas_int count) const;
      void
      backward(double *const x, const blas_int count) const;

      /// Of each DoF its block and of each block its first DoF; both by place
      /// in the order of elimination.
      std::vector<unsigned int>      block_of;
      std::vector<DofIndex>          first_dof;
      std::vector<std::vector<Part>> parts;
      /// L; see SupernodalFactor.
      std::vector<std::int64_t> column, first_row, first_entry, row,
        permutation;
      std::vector<double>  entry;
      double               reciprocal_condition = 0.;
      double               greatest             = 0.;
      mutable unsigned int n_solutions          = 0;
    };



    BlockFactorisation::BlockFactorisation(const StiffnessTerms &terms,
                                           const DenseBlocks    &blocks,
                                           const Constraints    &constraints,
                                           const std::string    &what,
                                           const SolverMonitor  &monitor)
      : block_of(terms.n_dofs)
    {
      for (unsigned int g = 0; g + 1 < blocks.first.size(); ++g)
        std::fill(block_of.begin() + blocks.first[g],
                  block_of.begin() + blocks.first[g + 1],
                  g);
      analyse(blocks, cliques_of(terms, blocks, constraints));
      if (monitor.sized)
        monitor.sized({non_zeros(), 8. * non_zeros()});
      try
        {
          entry.assign(first_entry.back(), 0.);
        }
      catch (const std::bad_alloc &)
        {
          throw NumericsError("The factorisation of " + what +
                              " does not fit in memory. Use a coarser mesh or "
                              "a lower order.");
        }
      assemble(terms, constraints);
      fill_diagonal(constraints);
      if (monitor.assembled)
        monitor.assembled();
      factorise(what);
    }



    double
    BlockFactorisation::non_zeros() const
    {
      return first_entry.back();
    }



    std::vector<std::vector<unsigned int>>
    BlockFactorisation::cliques_of(const StiffnessTerms &terms,
                                   const DenseBlocks    &blocks,
                                   const Constraints    &constraints) const
    {
      // A constrained DoF stands for those that it is a combination of.
      std::vector<std::set<unsigned int>> stands_for(blocks.first.size() - 1);
      for (const auto &line : constraints.get_lines())
        for (const auto &[dof, weight] : line.entries)
          stands_for[block_of[line.index]].insert(block_of[dof]);
      std::vector<std::vector<unsigned int>> cliques;
      const auto add = [&](const std::set<unsigned int> &members) {
        std::set<unsigned int> all = members;
        for (const unsigned int g : members)
          all.insert(stands_for[g].begin(), stands_for[g].end());
        cliques.emplace_back(all.begin(), all.end());
      };
      for (const auto &clique : blocks.cliques)
        add({clique.begin(), clique.end()});
      for (const auto &[spring, stiffness] : terms.springs)
        {
          std::set<unsigned int> touched;
          for (const auto &[dof, weight] : spring.entries())
            touched.insert(block_of[dof]);
          add(touched);
        }
      return cliques;
    }



    void
    BlockFactorisation::analyse(
      const DenseBlocks                            &blocks,
      const std::vector<std::vector<unsigned int>> &cliques)
    {
      const unsigned int        n     = blocks.first.size() - 1;
      const auto                order = elimination_order(n, cliques);
      std::vector<unsigned int> place(n);
      for (unsigned int s = 0; s < n; ++s)
        place[order[s]] = s;
      for (unsigned int &g : block_of)
        g = place[g];

      column = {0};
      for (const unsigned int g : order)
        {
          first_dof.push_back(blocks.first[g]);
          column.push_back(column.back() + blocks.first[g + 1] -
                           blocks.first[g]);
          for (DofIndex dof = blocks.first[g]; dof < blocks.first[g + 1]; ++dof)
            permutation.push_back(dof);
        }
      first_row   = {0};
      first_entry = {0};
      for (const auto &below : eliminate(place, cliques))
        {
          const unsigned int s = parts.size();
          parts.emplace_back();
          const auto add_rows = [&](const unsigned int t) {
            for (std::int64_t i = column[t]; i < column[t + 1]; ++i)
              row.push_back(i);
          };
          add_rows(s);
          for (const unsigned int t : below)
            {
              parts[s].push_back({t, blas_int(row.size() - first_row[s])});
              add_rows(t);
            }
          first_row.push_back(row.size());
          first_entry.push_back(first_entry[s] +
                                std::int64_t(height(s)) * width(s));
        }
    }



    double *
    BlockFactorisation::begin_of(const DofIndex dof, const unsigned int block)
    {
      const unsigned int s = block_of[dof];
      double *const      begin =
        entries(s) + std::size_t(dof - first_dof[s]) * height(s);
      if (block == s)
        return begin - first_dof[s];
      const auto part = std::lower_bound(parts[s].begin(),
                                         parts[s].end(),
                                         block,
                                         [](const Part &a, const unsigned b) {
                                           return a.block < b;
                                         });
      Assert(block < s || (part != parts[s].end() && part->block == block),
             dealii::ExcMessage("These blocks do not couple."));
      return block < s ? nullptr : begin + part->row - first_dof[block];
    }



    double &
    BlockFactorisation::diagonal(const DofIndex dof)
    {
      return begin_of(dof, block_of[dof])[dof];
    }



    void
    BlockFactorisation::add(const std::vector<std::pair<DofIndex, double>> &u,
                            const std::vector<std::pair<DofIndex, double>> &v,
                            const double value)
    {
      for (const auto &[i, of_u] : u)
        for (const auto &[j, of_v] : v)
          if (block_of[j] >= block_of[i])
            begin_of(i, block_of[j])[j] += value * of_u * of_v;
    }



    void
    BlockFactorisation::add_row(const DofIndex        row,
                                const double          factor,
                                const StiffnessBlock &block,
                                const unsigned int    row_in_block,
                                const Constraints    &constraints)
    {
      // Symmetric: row `row` of A is that column of it, whose places follow one
      // another.
      const double *const values =
        block.values.data() + std::size_t(row_in_block) * block.columns.size();
      std::vector<std::pair<DofIndex, double>> resolved;
      double                                  *to      = nullptr;
      unsigned int                             current = n_blocks();
      for (std::size_t k = 0; k < block.columns.size(); ++k)
        {
          const DofIndex j = block.columns[k];
          if (constraints.is_constrained(j))
            {
              resolve(j, constraints, resolved);
              add({{row, factor}}, resolved, values[k]);
              continue;
            }
          if (block_of[j] != current)
            {
              current = block_of[j];
              to      = begin_of(row, current);
            }
          if (to != nullptr)
            to[j] += factor * values[k];
        }
    }



    void
    BlockFactorisation::assemble(const StiffnessTerms &terms,
                                 const Constraints    &constraints)
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
          const Row free = spring.reduced(constraints);
          add(free.entries(), free.entries(), stiffness);
        }
    }



    void
    BlockFactorisation::fill_diagonal(const Constraints &constraints)
    {
      double sum = 0.;
      for (DofIndex dof = 0; dof < block_of.size(); ++dof)
        if (!constraints.is_constrained(dof))
          {
            greatest = std::max(greatest, std::abs(diagonal(dof)));
            sum += std::abs(diagonal(dof));
          }
      const double mean =
        sum > 0. ? sum / (block_of.size() - constraints.n_constraints()) : 1.;
      for (const auto &line : constraints.get_lines())
        diagonal(line.index) = mean;
    }



    void
    BlockFactorisation::break_down(const unsigned int s,
                                   const blas_int     pivot,
                                   const std::string &what) const
    {
      const std::size_t number = column[s] + pivot;
      throw NotPositiveDefinite(
        "The stiffness matrix of " + what +
          " is not positive definite (pivot " + std::to_string(number) +
          " of " + std::to_string(block_of.size()) +
          "). Either the body can still move, or its slenderness or its ratio "
          "of stiffnesses is beyond what double precision holds.",
        permutation[number - 1]);
    }



    void
    BlockFactorisation::factorise(const std::string &what)
    {
      double least = std::numeric_limits<double>::max(), most = 0.;
      for (unsigned int s = 0; s < n_blocks(); ++s)
        {
          double *const  L = entries(s);
          const blas_int w = width(s), h = height(s), below = h - w;
          blas_int       info = 0;
          dealii::potrf("L", &w, L, &h, &info);
          if (info != 0)
            break_down(s, info, what);
          for (blas_int i = 0; i < w; ++i)
            {
              const double pivot = L[std::size_t(i) * h + i];
              // Nor where the matrix holds what is no number.
              if (!(pivot > 0.) || !std::isfinite(pivot))
                break_down(s, i + 1, what);
              least = std::min(least, pivot);
              most  = std::max(most, pivot);
            }
          if (below == 0)
            continue;
          trsm("R", "L", "T", "N", &below, &w, &one, L, &h, L + w, &h);
          update(s);
        }
      reciprocal_condition = least * least / (most * most);
      if (!(reciprocal_condition > 0.))
        break_down(n_blocks() - 1, width(n_blocks() - 1), what);
    }



    void
    BlockFactorisation::update(const unsigned int s)
    {
      const double *const L = entries(s);
      const blas_int      w = width(s), h = height(s);
      for (auto left = parts[s].begin(); left != parts[s].end(); ++left)
        {
          const unsigned int t = left->block;
          const blas_int     n = width(t), h_t = height(t);
          dealii::syrk("L",
                       "N",
                       &n,
                       &w,
                       &minus_one,
                       L + left->row,
                       &h,
                       &one,
                       entries(t),
                       &h_t);
          for (auto right = left + 1; right != parts[s].end(); ++right)
            {
              const blas_int m = width(right->block);
              dealii::gemm("N",
                           "T",
                           &m,
                           &n,
                           &w,
                           &minus_one,
                           L + right->row,
                           &h,
                           L + left->row,
                           &h,
                           &one,
                           begin_of(first_dof[t], right->block) +
                             first_dof[right->block],
                           &h_t);
            }
        }
    }



    /// y = @p factor op(L) x + @p keep y with @p count columns each.
    void
    multiply(const char    *op,
             const blas_int m,
             const blas_int n,
             const blas_int count,
             const double   factor,
             const double  *L,
             const blas_int ld_L,
             const double  *x,
             const blas_int ld_x,
             const double   keep,
             double        *y,
             const blas_int ld_y)
    {
      // One column is bound by reading L; gemm would copy it first.
      constexpr blas_int stride = 1;
      const bool         plain  = *op == 'N';
      if (count == 1)
        dealii::gemv(op,
                     plain ? &m : &n,
                     plain ? &n : &m,
                     &factor,
                     L,
                     &ld_L,
                     x,
                     &stride,
                     &keep,
                     y,
                     &stride);
      else
        dealii::gemm(op,
                     "N",
                     &m,
                     &count,
                     &n,
                     &factor,
                     L,
                     &ld_L,
                     x,
                     &ld_x,
                     &keep,
                     y,
                     &ld_y);
    }



    /// x = op(L)^-1 x for the triangle @p L of @p w columns.
    void
    divide(const char    *op,
           const blas_int w,
           const blas_int count,
           const double  *L,
           const blas_int ld_L,
           double        *x,
           const blas_int ld_x)
    {
      constexpr blas_int stride = 1;
      if (count == 1)
        trsv("L", op, "N", &w, L, &ld_L, x, &stride);
      else
        trsm("L", "L", op, "N", &w, &count, &one, L, &ld_L, x, &ld_x);
    }



    void
    BlockFactorisation::forward(double *const x, const blas_int count) const
    {
      const blas_int      n = block_of.size();
      std::vector<double> change;
      for (unsigned int s = 0; s < n_blocks(); ++s)
        {
          const double *const L = entries(s);
          const blas_int      w = width(s), h = height(s), below = h - w;
          divide("N", w, count, L, h, x + column[s], n);
          if (below == 0)
            continue;
          change.resize(std::size_t(below) * count);
          multiply("N",
                   below,
                   w,
                   count,
                   1.,
                   L + w,
                   h,
                   x + column[s],
                   n,
                   0.,
                   change.data(),
                   below);
          for_each_row_below(s,
                             count,
                             [&](const std::size_t i, const std::size_t k) {
                               x[i] -= change[k];
                             });
        }
    }



    void
    BlockFactorisation::backward(double *const x, const blas_int count) const
    {
      const blas_int      n = block_of.size();
      std::vector<double> known;
      for (unsigned int s = n_blocks(); s-- > 0;)
        {
          const double *const L = entries(s);
          const blas_int      w = width(s), h = height(s), below = h - w;
          if (below > 0)
            {
              known.resize(std::size_t(below) * count);
              for_each_row_below(s,
                                 count,
                                 [&](const std::size_t i, const std::size_t k) {
                                   known[k] = x[i];
                                 });
              multiply("T",
                       w,
                       below,
                       count,
                       -1.,
                       L + w,
                       h,
                       known.data(),
                       below,
                       1.,
                       x + column[s],
                       n);
            }
          divide("T", w, count, L, h, x + column[s], n);
        }
    }



    void
    BlockFactorisation::solve(Vector &x) const
    {
      std::vector<Vector> both(1);
      both[0].swap(x);
      solve_all(both);
      both[0].swap(x);
    }



    void
    BlockFactorisation::solve_all(std::vector<Vector> &x) const
    {
      // As many at a time as fit beside the factor.
      constexpr std::size_t most = 64;
      const std::size_t     n    = block_of.size();
      std::vector<double>   y;
      for (std::size_t begin = 0; begin < x.size(); begin += most)
        {
          const std::size_t count = std::min(most, x.size() - begin);
          y.resize(count * n);
          for (std::size_t k = 0; k < count; ++k)
            for (std::size_t i = 0; i < n; ++i)
              y[k * n + i] = x[begin + k][permutation[i]];
          forward(y.data(), count);
          backward(y.data(), count);
          for (std::size_t k = 0; k < count; ++k)
            for (std::size_t i = 0; i < n; ++i)
              x[begin + k][permutation[i]] = y[k * n + i];
        }
      n_solutions += x.size();
    }



    std::unique_ptr<SolvedRows>
    BlockFactorisation::solved_rows() const
    {
      SupernodalFactor view;
      view.n            = block_of.size();
      view.n_supernodes = n_blocks();
      view.column       = column.data();
      view.first_row    = first_row.data();
      view.first_entry  = first_entry.data();
      view.row          = row.data();
      view.entry        = entry.data();
      view.permutation  = permutation.data();
      return half_solved(view, [this](Vector &x) {
        backward(x.begin(), 1);
        Vector y(x.size());
        for (std::size_t i = 0; i < x.size(); ++i)
          y[permutation[i]] = x[i];
        x = y;
      });
    }
  } // namespace



  std::unique_ptr<LinearSolver>
  factorise_blocks(const StiffnessTerms &terms,
                   const DenseBlocks    &blocks,
                   const Constraints    &constraints,
                   const std::string    &what,
                   const SolverMonitor  &monitor)
  {
    return std::make_unique<BlockFactorisation>(
      terms, blocks, constraints, what, monitor);
  }
} // namespace lamella
