// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/linear/forward_solved_rows.h>

#include <deal.II/lac/lapack_templates.h>

#include <algorithm>
#include <map>
#include <set>

namespace lamella
{
  using dealii::types::blas_int;

  ForwardSolvedRows::ForwardSolvedRows(const SupernodalFactor &factor)
    : factor(factor)
    , position(factor.n)
    , supernode_of(factor.n)
    , blocks(factor.n_supernodes)
  {
    for (std::size_t i = 0; i < factor.n; ++i)
      position[factor.permutation[i]] = i;
    for (std::size_t s = 0; s < factor.n_supernodes; ++s)
      std::fill(supernode_of.begin() + factor.column[s],
                supernode_of.begin() + factor.column[s + 1],
                s);
  }



  std::size_t
  ForwardSolvedRows::parent(const std::size_t s) const
  {
    const std::int64_t below = factor.first_row[s] + width(s);
    return below < factor.first_row[s + 1] ? supernode_of[factor.row[below]] :
                                             factor.n_supernodes;
  }



  void
  ForwardSolvedRows::scatter(const std::vector<LinearFunctional> &rows,
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
        blocks[s].push_back({std::move(columns), std::vector<double>(size)});
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



  void
  ForwardSolvedRows::eliminate(const std::size_t s)
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



  void
  ForwardSolvedRows::update_ancestors(const std::size_t          s,
                                      const std::vector<double> &change)
  {
    const Block        &block = blocks[s].back();
    const std::int64_t *rows  = factor.row + factor.first_row[s] + width(s);
    const std::size_t   below =
      factor.first_row[s + 1] - factor.first_row[s] - width(s);
    // All columns that pass through a supernode pass through those of its rows.
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
              column[rows[i] - factor.column[above]] -= change[k * below + i];
          }
      }
  }



  void
  ForwardSolvedRows::append(const std::vector<LinearFunctional> &rows)
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



  std::vector<double>
  ForwardSolvedRows::products(const unsigned int first) const
  {
    const std::size_t   fresh = n_columns - first;
    std::vector<double> result(fresh * n_columns), product;
    const double        one = 1., zero = 0.;
    for (std::size_t s = 0; s < factor.n_supernodes; ++s)
      for (const Block &left : blocks[s])
        if (left.columns.front() >= first)
          for (const Block &right : blocks[s])
            {
              const blas_int m = left.columns.size(), n = right.columns.size(),
                             inside = width(s);
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
                  result[right.columns[j] * fresh + left.columns[i] - first] +=
                    product[std::size_t(j) * m + i];
            }
    return result;
  }



  Vector
  ForwardSolvedRows::combination(const std::vector<double> &lambda) const
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
    return y;
  }



  namespace
  {
    /// Half solved rows and the other half of a solution.
    class RowsOfFactor : public SolvedRows
    {
    public:
      RowsOfFactor(const SupernodalFactor       &factor,
                   std::function<void(Vector &)> backward)
        : rows(factor)
        , backward(std::move(backward))
      {}

      void
      append(const std::vector<LinearFunctional> &some) override
      {
        rows.append(some);
      }

      unsigned int
      size() const override
      {
        return rows.size();
      }

      std::vector<double>
      products(const unsigned int first) const override
      {
        return rows.products(first);
      }

      Vector
      displacement(const std::vector<double> &lambda) const override
      {
        Vector x = rows.combination(lambda);
        backward(x);
        return x;
      }

    private:
      ForwardSolvedRows             rows;
      std::function<void(Vector &)> backward;
    };
  } // namespace



  std::unique_ptr<SolvedRows>
  make_forward_solved(const SupernodalFactor       &factor,
                      std::function<void(Vector &)> backward)
  {
    return std::make_unique<RowsOfFactor>(factor, std::move(backward));
  }
} // namespace lamella
