// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/linear/block_factor.h>
#include <lamella/linear/factorization.h>

#include <deal.II/lac/lapack_templates.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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



    /// A dense block of         p m rows and         p n columns of L, which
    /// are         p stride numbers apart.
    struct FactorBlock
    {
      const double *first;
      blas_int      stride, m, n;
    };



    /// Columns that are solved for,         p stride numbers apart.
    struct SolvedColumns
    {
      double  *first;
      blas_int stride, count;
    };



    /// y =         p factor op(L) x +         p keep y, column by column.
    void
    multiply(const char          *op,
             const double         factor,
             const FactorBlock   &L,
             const SolvedColumns &x,
             const double         keep,
             const SolvedColumns &y)
    {
      // One column is bound by reading L; gemm would copy it first.
      constexpr blas_int step  = 1;
      const bool         plain = *op == 'N';
      if (x.count == 1)
        dealii::gemv(op,
                     &L.m,
                     &L.n,
                     &factor,
                     L.first,
                     &L.stride,
                     x.first,
                     &step,
                     &keep,
                     y.first,
                     &step);
      else
        dealii::gemm(op,
                     "N",
                     plain ? &L.m : &L.n,
                     &x.count,
                     plain ? &L.n : &L.m,
                     &factor,
                     L.first,
                     &L.stride,
                     x.first,
                     &x.stride,
                     &keep,
                     y.first,
                     &y.stride);
    }



    /// x = op(L)^-1 x for the triangle L, of as many rows as columns.
    void
    divide(const char *op, const FactorBlock &L, const SolvedColumns &x)
    {
      constexpr blas_int step = 1;
      if (x.count == 1)
        trsv("L", op, "N", &L.n, L.first, &L.stride, x.first, &step);
      else
        trsm("L",
             "L",
             op,
             "N",
             &L.n,
             &x.count,
             &one,
             L.first,
             &L.stride,
             x.first,
             &x.stride);
    }



    /// Calls         p use for each row of the column         p s of L below
    /// its diagonal block and each of         p count columns of numbers: the
    /// place there, and the place among the rows below alone.
    template <typename Use>
    void
    for_each_row_below(const BlockPattern &pattern,
                       const unsigned int  s,
                       const std::size_t   count,
                       const Use          &use)
    {
      const std::int64_t *const below =
        pattern.row.data() + pattern.first_row[s] + pattern.width(s);
      const std::size_t m = pattern.height(s) - pattern.width(s);
      for (std::size_t c = 0; c < count; ++c)
        for (std::size_t k = 0; k < m; ++k)
          use(c * pattern.block_of.size() + below[k], c * m + k);
    }
  } // namespace



  BlockFactor::BlockFactor(BlockPattern pattern)
    : pattern(std::move(pattern))
  {}



  void
  BlockFactor::allocate()
  {
    entry.assign(pattern.n_entries(), 0.);
  }



  double *
  BlockFactor::column_begin(const DofIndex column, const unsigned int block)
  {
    const unsigned int s = pattern.block_of[column];
    double *const      begin =
      entries(s) +
      std::size_t(column - pattern.first_dof[s]) * pattern.height(s);
    if (block == s)
      return begin - pattern.first_dof[s];
    if (block < s)
      return nullptr;
    const auto part =
      std::lower_bound(pattern.parts[s].begin(),
                       pattern.parts[s].end(),
                       block,
                       [](const BlockPattern::Part &a, const unsigned b) {
                         return a.block < b;
                       });
    AssertThrow(part != pattern.parts[s].end() && part->block == block,
                dealii::ExcMessage("These blocks do not couple."));
    return begin + part->row - pattern.first_dof[block];
  }



  double &
  BlockFactor::diagonal(const DofIndex dof)
  {
    return column_begin(dof, pattern.block_of[dof])[dof];
  }



  void
  BlockFactor::throw_not_definite(const unsigned int s,
                                  const blas_int     pivot,
                                  const std::string &what) const
  {
    const std::size_t number = pattern.column[s] + pivot;
    throw NotPositiveDefinite(
      "linear.not-positive-definite: The stiffness matrix of " + what +
        " is not positive definite (pivot " + std::to_string(number) + " of " +
        std::to_string(pattern.block_of.size()) +
        "). Either a rigid-body motion is free (add a Support), or the body is "
        "too slender or too heterogeneous for double precision.",
      pattern.permutation[number - 1]);
  }



  std::pair<double, double>
  BlockFactor::pivots(const unsigned int s, const std::string &what) const
  {
    double least = std::numeric_limits<double>::max(), most = 0.;
    for (blas_int i = 0; i < pattern.width(s); ++i)
      {
        const double pivot = entries(s)[std::size_t(i) * pattern.height(s) + i];
        // Nor where the matrix holds what is no number.
        if (!(pivot > 0.) || !std::isfinite(pivot))
          throw_not_definite(s, i + 1, what);
        least = std::min(least, pivot);
        most  = std::max(most, pivot);
      }
    return {least, most};
  }



  void
  BlockFactor::factorize(const std::string &what)
  {
    double least = std::numeric_limits<double>::max(), most = 0.;
    for (unsigned int s = 0; s < pattern.n_blocks(); ++s)
      {
        double *const  L = entries(s);
        const blas_int w = pattern.width(s), h = pattern.height(s);
        const blas_int below = h - w;
        blas_int       info  = 0;
        dealii::potrf("L", &w, L, &h, &info);
        if (info != 0)
          throw_not_definite(s, info, what);
        const auto [smallest, largest] = pivots(s, what);
        least                          = std::min(least, smallest);
        most                           = std::max(most, largest);
        if (below > 0)
          {
            trsm("R", "L", "T", "N", &below, &w, &one, L, &h, L + w, &h);
            update(s);
          }
      }
    reciprocal = least * least / (most * most);
    if (!(reciprocal > 0.))
      throw_not_definite(pattern.n_blocks() - 1,
                         pattern.width(pattern.n_blocks() - 1),
                         what);
  }



  void
  BlockFactor::update(const unsigned int s)
  {
    const double *const L = entries(s);
    const blas_int      w = pattern.width(s), h = pattern.height(s);
    for (auto left = pattern.parts[s].begin(); left != pattern.parts[s].end();
         ++left)
      {
        const unsigned int t = left->block;
        const blas_int     n = pattern.width(t), h_t = pattern.height(t);
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
        for (auto right = left + 1; right != pattern.parts[s].end(); ++right)
          {
            const blas_int m = pattern.width(right->block);
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
                         column_begin(pattern.first_dof[t], right->block) +
                           pattern.first_dof[right->block],
                         &h_t);
          }
      }
  }



  void
  BlockFactor::forward(double *const x, const blas_int count) const
  {
    const blas_int      n = pattern.block_of.size();
    std::vector<double> change;
    for (unsigned int s = 0; s < pattern.n_blocks(); ++s)
      {
        const double *const L = entries(s);
        const blas_int      w = pattern.width(s), h = pattern.height(s);
        const blas_int      below = h - w;
        const SolvedColumns own{x + pattern.column[s], n, count};
        divide("N", {L, h, w, w}, own);
        if (below == 0)
          continue;
        change.resize(std::size_t(below) * count);
        multiply("N",
                 1.,
                 {L + w, h, below, w},
                 own,
                 0.,
                 {change.data(), below, count});
        for_each_row_below(pattern,
                           s,
                           count,
                           [&](const std::size_t i, const std::size_t k) {
                             x[i] -= change[k];
                           });
      }
  }



  void
  BlockFactor::backward(double *const x, const blas_int count) const
  {
    const blas_int      n = pattern.block_of.size();
    std::vector<double> known;
    for (unsigned int s = pattern.n_blocks(); s-- > 0;)
      {
        const double *const L = entries(s);
        const blas_int      w = pattern.width(s), h = pattern.height(s);
        const blas_int      below = h - w;
        const SolvedColumns own{x + pattern.column[s], n, count};
        if (below > 0)
          {
            known.resize(std::size_t(below) * count);
            for_each_row_below(pattern,
                               s,
                               count,
                               [&](const std::size_t i, const std::size_t k) {
                                 known[k] = x[i];
                               });
            multiply("T",
                     -1.,
                     {L + w, h, below, w},
                     {known.data(), below, count},
                     1.,
                     own);
          }
        divide("T", {L, h, w, w}, own);
      }
  }



  SupernodalFactor
  BlockFactor::view() const
  {
    SupernodalFactor view;
    view.n            = pattern.block_of.size();
    view.n_supernodes = pattern.n_blocks();
    view.column       = pattern.column.data();
    view.first_row    = pattern.first_row.data();
    view.first_entry  = pattern.first_entry.data();
    view.row          = pattern.row.data();
    view.entry        = entry.data();
    view.permutation  = pattern.permutation.data();
    return view;
  }
} // namespace lamella
