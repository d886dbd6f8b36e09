// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/linear/factorization.h>

#include <deal.II/lac/lapack_templates.h>

#include <algorithm>
#include <map>
#include <set>

namespace lamella
{
  using dealii::types::blas_int;

  namespace
  {
    /// Computes the compliance B A^-1 B^T = Y^T Y of constraints with matrix B,
    /// from the forward solutions Y = L^-1 P B^T with the Cholesky factor L:
    ///   A^-1 = P^T L^-T L^-1 P, so b_i A^-1 b_j = (L^-1 P b_i) . (L^-1 P b_j).
    ///
    /// A row b_k of B involves a few DoFs. Its column of Y is nonzero only in
    /// the supernodes of these DoFs and their ancestors in the elimination tree
    /// (Gilbert 1994). The parent of a supernode contains its first row below
    /// the diagonal block. Only these entries are computed and stored, 8 bytes
    /// each, in one dense block per supernode. Supernodes are eliminated from
    /// the leaves to the root for all new columns together, by LAPACK and BLAS.
    class ForwardSolvedRows : public SolvedRows
    {
    public:
      /// Keeps a view of @p factor, whose data must outlive this object.
      ForwardSolvedRows(const SupernodalFactor       &factor,
                        std::function<void(Vector &)> backward)
        : factor(factor)
        , position(factor.n)
        , supernode_of(factor.n)
        , blocks(factor.n_supernodes)
        , backward(std::move(backward))
      {
        for (std::size_t i = 0; i < factor.n; ++i)
          position[factor.permutation[i]] = i;
        for (std::size_t s = 0; s < factor.n_supernodes; ++s)
          std::fill(supernode_of.begin() + factor.column[s],
                    supernode_of.begin() + factor.column[s + 1],
                    s);
      }

      /// Appends the constraint @p rows and computes their forward solutions.
      /// Weights of the same DoF are summed; constant parts are ignored.
      void
      append(const std::vector<LinearFunctional> &rows) override
      {
        if (rows.empty())
          return;
        const unsigned int first = n_columns;
        scatter(rows, first);
        n_columns += rows.size();
        // Supernodes are numbered from the leaves up.
        for (std::size_t s = 0; s < factor.n_supernodes; ++s)
          if (!blocks[s].empty() && blocks[s].back().columns.back() >= first)
            eliminate(s);
      }

      /// Returns the number of constraints appended so far.
      unsigned int
      size() const override
      {
        return n_columns;
      }

      /// Returns the compliances of all constraints i >= @p first with all j,
      /// at [j * (m - first) + i - first] with m = size().
      std::vector<double>
      products(const unsigned int first) const override
      {
        const std::size_t   fresh = n_columns - first;
        std::vector<double> result(fresh * n_columns), product;
        const double        one = 1., zero = 0.;
        for (std::size_t s = 0; s < factor.n_supernodes; ++s)
          for (const Block &left : blocks[s])
            if (left.columns.front() >= first)
              for (const Block &right : blocks[s])
                {
                  const blas_int m = left.columns.size(),
                                 n = right.columns.size(), inside = width(s);
                  product.resize(std::size_t(m) * n);
                  dealii::gemm("T",
                               "N",
                               &m,
                               &n,
                               &inside,
                               &one,
                               left.values.data(),
                               &inside,
                               right.values.data(),
                               &inside,
                               &zero,
                               product.data(),
                               &m);
                  for (blas_int j = 0; j < n; ++j)
                    for (blas_int i = 0; i < m; ++i)
                      result[right.columns[j] * fresh + left.columns[i] -
                             first] += product[std::size_t(j) * m + i];
                }
        return result;
      }

      Vector
      displacement(const std::vector<double> &lambda) const override
      {
        Vector y(factor.n);
        for (std::size_t s = 0; s < factor.n_supernodes; ++s)
          for (const Block &block : blocks[s])
            for (std::size_t k = 0; k < block.columns.size(); ++k)
              {
                const double        force  = lambda[block.columns[k]];
                const double *const column = block.values.data() + k * width(s);
                if (force != 0.)
                  for (std::size_t i = 0; i < width(s); ++i)
                    y[factor.column[s] + i] += force * column[i];
              }
        backward(y);
        return y;
      }

    private:
      /// Forward solutions in one supernode, computed by one call of append().
      struct Block
      {
        /// Constraints with nonzero entries in this supernode, ascending.
        std::vector<unsigned int> columns;
        /// Entries, stored by columns; one row per column of the supernode.
        std::vector<double> values;
      };

      /// Returns the number of columns of @p supernode.
      std::size_t
      width(const std::size_t supernode) const
      {
        return factor.column[supernode + 1] - factor.column[supernode];
      }

      /// Returns the parent in the elimination tree; n_supernodes for a root.
      std::size_t
      parent(const std::size_t s) const
      {
        const std::int64_t below = factor.first_row[s] + width(s);
        return below < factor.first_row[s + 1] ?
                 supernode_of[factor.row[below]] :
                 factor.n_supernodes;
      }

      /// Stores the permuted @p rows in new blocks, for columns from @p first.
      void
      scatter(const std::vector<LinearFunctional> &rows,
              const unsigned int                   first)
      {
        // Which columns pass through a supernode.
        std::map<std::size_t, std::vector<unsigned int>> through;
        for (unsigned int k = 0; k < rows.size(); ++k)
          {
            std::set<std::size_t> path;
            for (const auto &[dof, weight] : rows[k].entries())
              for (std::size_t s = supernode_of[position[dof]];
                   s < factor.n_supernodes && path.insert(s).second;
                   s = parent(s))
                ;
            for (const std::size_t s : path)
              through[s].push_back(first + k);
          }
        for (auto &[s, columns] : through)
          {
            const std::size_t size = width(s) * columns.size();
            blocks[s].push_back(
              {std::move(columns), std::vector<double>(size)});
          }

        for (unsigned int k = 0; k < rows.size(); ++k)
          for (const auto &[dof, weight] : rows[k].entries())
            {
              const std::size_t i = position[dof], s = supernode_of[i];
              Block            &block = blocks[s].back();
              const std::size_t at    = std::lower_bound(block.columns.begin(),
                                                      block.columns.end(),
                                                      first + k) -
                                     block.columns.begin();
              block.values[at * width(s) + i - factor.column[s]] += weight;
            }
      }

      /// Solves L_11 X = B for the last block B of @p supernode, with its
      /// diagonal block L_11 of L, and subtracts L_21 X from its ancestors.
      void
      eliminate(const std::size_t s)
      {
        Block         &block  = blocks[s].back();
        const double  *L      = factor.entry + factor.first_entry[s];
        const blas_int inside = width(s), count = block.columns.size(),
                       height = factor.first_row[s + 1] - factor.first_row[s],
                       below  = height - inside;
        blas_int info         = 0;
        dealii::trtrs("L",
                      "N",
                      "N",
                      &inside,
                      &count,
                      L,
                      &height,
                      block.values.data(),
                      &inside,
                      &info);
        if (below == 0)
          return;

        std::vector<double> change(std::size_t(below) * count);
        const double        one = 1., zero = 0.;
        dealii::gemm("N",
                     "N",
                     &below,
                     &count,
                     &inside,
                     &one,
                     L + inside,
                     &height,
                     block.values.data(),
                     &inside,
                     &zero,
                     change.data(),
                     &below);
        update_ancestors(s, change);
      }

      /// Subtracts @p change = L_21 X from the ancestors of @p supernode.
      void
      update_ancestors(const std::size_t s, const std::vector<double> &change)
      {
        const Block        &block = blocks[s].back();
        const std::int64_t *rows  = factor.row + factor.first_row[s] + width(s);
        const std::size_t   below =
          factor.first_row[s + 1] - factor.first_row[s] - width(s);
        // All columns that pass through a supernode pass through those of its
        // rows.
        for (std::size_t begin = 0, end = 0; begin < below; begin = end)
          {
            const std::size_t above = supernode_of[rows[begin]];
            while (end < below && supernode_of[rows[end]] == above)
              ++end;
            Block      &target = blocks[above].back();
            std::size_t at     = 0;
            for (std::size_t k = 0; k < block.columns.size(); ++k)
              {
                while (target.columns[at] != block.columns[k])
                  ++at;
                double *const column = target.values.data() + at * width(above);
                for (std::size_t i = begin; i < end; ++i)
                  column[rows[i] - factor.column[above]] -=
                    change[k * below + i];
              }
          }
      }

      /// View of L; row of L for each row of A; supernode of each column of L.
      SupernodalFactor         factor;
      std::vector<std::size_t> position, supernode_of;
      /// Blocks of each supernode, one per call of append().
      std::vector<std::vector<Block>> blocks;
      /// Replaces x by P^T L^-T x.
      std::function<void(Vector &)> backward;
      unsigned int n_columns = 0; ///< Number of constraints so far.
    };
  } // namespace



  std::unique_ptr<SolvedRows>
  make_forward_solved(const SupernodalFactor       &factor,
                      std::function<void(Vector &)> backward)
  {
    return std::make_unique<ForwardSolvedRows>(factor, std::move(backward));
  }
} // namespace lamella
