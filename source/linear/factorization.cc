// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/linear/factorization.h>

#include <cholmod.h>

#include <algorithm>
#include <cstring>
#include <new>

namespace lamella
{
  /// Ordering and symbolic factor of CHOLMOD, with the positions of the nonzero
  /// entries to which they belong.
  class SymbolicFactor
  {
  public:
    /// Analyzes the pattern of @p A.
    explicit SymbolicFactor(cholmod_sparse &A)
      : start(positions(A.p, A.ncol + 1))
      , rows(positions(A.i, start.back()))
    {
      start_cholmod(common);
      factor = cholmod_l_analyze(&A, &common);
      if (factor == nullptr)
        {
          cholmod_l_finish(&common);
          throw std::bad_alloc();
        }
      cholmod_l_free_work(&common);
    }
    SymbolicFactor(const SymbolicFactor &) = delete;
    ~SymbolicFactor()
    {
      cholmod_l_free_factor(&factor, &common);
      cholmod_l_finish(&common);
    }

    /// Starts CHOLMOD with the settings of all factorizations.
    static void
    start_cholmod(cholmod_common &common)
    {
      cholmod_l_start(&common);
      common.supernodal = CHOLMOD_SUPERNODAL;
      common.final_ll   = true;
      common.print      = 0;
    }

    /// Returns true if @p A has entries at the same positions.
    bool
    has_pattern_of(const cholmod_sparse &A) const
    {
      return start.size() == A.ncol + 1 &&
             std::equal(start.begin(), start.end(), integers(A.p)) &&
             std::equal(rows.begin(), rows.end(), integers(A.i));
    }

    /// Returns a copy that owns its memory in @p other.
    cholmod_factor *
    copy(cholmod_common &other) const
    {
      return cholmod_l_copy_factor(factor, &other);
    }

  private:
    static const SuiteSparse_long *
    integers(const void *const array)
    {
      return static_cast<const SuiteSparse_long *>(array);
    }
    static std::vector<DofIndex>
    positions(const void *const array, const std::size_t n)
    {
      return {integers(array), integers(array) + n};
    }

    const std::vector<DofIndex> start, rows;
    cholmod_common              common;
    cholmod_factor             *factor = nullptr;
  };



  namespace
  {
    /// The lower triangle by columns, which is the upper one by rows. Exact
    /// zeros (extension and shear of a cross-ply) are left out against fill.
    cholmod_sparse *
    lower_triangle(const Matrix &matrix, cholmod_common &common)
    {
      const std::size_t n     = matrix.m();
      std::size_t       count = 0;
      // An entry of a whole matrix looks for its row, one of a row knows it.
      for (std::size_t row = 0; row < n; ++row)
        for (auto entry = matrix.begin(row); entry != matrix.end(row); ++entry)
          count += entry->column() >= row && entry->value() != 0.;

      cholmod_sparse *A = cholmod_l_allocate_sparse(
        n, n, count, true, true, -1, CHOLMOD_REAL, &common);
      if (A == nullptr)
        throw std::bad_alloc();
      auto *const start = static_cast<SuiteSparse_long *>(A->p);
      auto *const rows  = static_cast<SuiteSparse_long *>(A->i);
      auto *const x     = static_cast<double *>(A->x);
      std::size_t next  = 0;
      for (std::size_t row = 0; row < n; ++row)
        {
          start[row] = next;
          // deal.II stores the diagonal first, then columns in this order.
          for (auto entry = matrix.begin(row); entry != matrix.end(row);
               ++entry)
            if (entry->column() >= row && entry->value() != 0.)
              {
                rows[next] = entry->column();
                x[next++]  = entry->value();
              }
        }
      start[n] = next;
      return A;
    }



    /// Returns the symbolic factor of @p A; a copy of that in @p symbolic if
    /// that has the same pattern.
    cholmod_factor *
    analyzed(cholmod_sparse                        &A,
             std::shared_ptr<const SymbolicFactor> *symbolic,
             cholmod_common                        &common)
    {
      if (symbolic == nullptr)
        return cholmod_l_analyze(&A, &common);
      if (*symbolic == nullptr || !(*symbolic)->has_pattern_of(A))
        *symbolic = std::make_shared<const SymbolicFactor>(A);
      return (*symbolic)->copy(common);
    }



    /// The workspace of CHOLMOD and the factor L, both freed with the object.
    class CholmodFactorization : public LinearSolver
    {
    public:
      CholmodFactorization(const Matrix                          &matrix,
                           const std::string                     &what,
                           const FactorMonitor                   &monitor,
                           std::shared_ptr<const SymbolicFactor> *symbolic)
      {
        // The monitor may free the matrix: nobody asks it afterwards.
        const DofIndex n = matrix.m();
        for (DofIndex i = 0; i < n; ++i)
          greatest = std::max(greatest, std::abs(matrix.diag_element(i)));
        SymbolicFactor::start_cholmod(common);

        cholmod_sparse *A = lower_triangle(matrix, common);
        try
          {
            factor = analyzed(*A, symbolic, common);
            if (factor == nullptr)
              throw std::bad_alloc();
            if (monitor)
              monitor({double(factor->xsize),
                       8. * (factor->xsize + factor->maxcsize)});
            cholmod_l_factorize(A, factor, &common);
            reciprocal_condition = cholmod_l_rcond(factor, &common);
            cholmod_l_free_sparse(&A, &common);
            check(what, n);
          }
        catch (...)
          {
            // Nothing, if it is freed.
            cholmod_l_free_sparse(&A, &common);
            release();
            throw;
          }
      }

      CholmodFactorization(const CholmodFactorization &) = delete;
      ~CholmodFactorization() override
      {
        release();
      }

      void
      solve(Vector &x) const override
      {
        apply(CHOLMOD_A, x.begin(), 1);
        ++n_solutions;
      }

      void
      solve_all(std::vector<Vector> &x) const override
      {
        // As many at a time as fit beside the factor.
        constexpr std::size_t most = 64;
        std::vector<double>   block;
        for (std::size_t first = 0; first < x.size(); first += most)
          {
            const std::size_t count = std::min(most, x.size() - first);
            block.clear();
            for (std::size_t k = first; k < first + count; ++k)
              block.insert(block.end(), x[k].begin(), x[k].end());
            apply(CHOLMOD_A, block.data(), count);
            for (std::size_t k = first; k < first + count; ++k)
              std::copy_n(block.begin() + (k - first) * factor->n,
                          factor->n,
                          x[k].begin());
          }
        n_solutions += x.size();
      }

      std::unique_ptr<SolvedRows>
      solved_rows() const override
      {
        return make_forward_solved(supernodes(),
                                   [this](Vector &x) { backward(x); });
      }

      /// The factor as half solved rows see it.
      SupernodalFactor
      supernodes() const
      {
        const auto index = [](const void *const array) {
          return static_cast<const std::int64_t *>(array);
        };
        static_assert(sizeof(SuiteSparse_long) == sizeof(std::int64_t));
        SupernodalFactor view;
        view.n            = factor->n;
        view.n_supernodes = factor->nsuper;
        view.column       = index(factor->super);
        view.first_row    = index(factor->pi);
        view.first_entry  = index(factor->px);
        view.row          = index(factor->s);
        view.entry        = static_cast<const double *>(factor->x);
        view.permutation  = index(factor->Perm);
        return view;
      }

      /// x = P^T L^-T x: A^-1 b, if x is b half solved.
      void
      backward(Vector &x) const
      {
        apply(CHOLMOD_Lt, x.begin(), 1);
        apply(CHOLMOD_Pt, x.begin(), 1);
      }

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
        return {SolverKind::cholmod, double(factor->xsize), n_solutions};
      }

    private:
      /// Applies one CHOLMOD system to @p count vectors from @p x on.
      void
      apply(const int system, double *const x, const std::size_t count) const
      {
        cholmod_dense b{};
        b.nrow  = factor->n;
        b.ncol  = count;
        b.d     = factor->n;
        b.nzmax = b.nrow * count;
        b.x     = x;
        b.xtype = CHOLMOD_REAL;
        b.dtype = CHOLMOD_DOUBLE;

        cholmod_dense *y = cholmod_l_solve(system, factor, &b, &common);
        if (y == nullptr)
          throw NumericsError(
            "linear.out-of-memory: CHOLMOD ran out of memory in the solution. "
            "Use a coarser mesh or a theory of lower order.");
        std::memcpy(x, y->x, sizeof(double) * b.nzmax);
        cholmod_l_free_dense(&y, &common);
      }

      /// Throws NumericsError if the factorization of the matrix of @p n rows
      /// has failed; who calls it releases what there is.
      void
      check(const std::string &what, const DofIndex n) const
      {
        const std::size_t minor  = factor->minor;
        const int         status = common.status;
        // The condition is no number where the matrix holds one that is none.
        if (status == CHOLMOD_OK && minor == n && reciprocal_condition > 0.)
          return;
        if (status == CHOLMOD_OUT_OF_MEMORY)
          throw NumericsError(
            "linear.out-of-memory: The factorization of " + what +
            " does not fit in memory. Use a coarser mesh or lower order.");
        const auto *order = static_cast<const SuiteSparse_long *>(factor->Perm);
        throw NotPositiveDefinite(
          "linear.not-positive-definite: The stiffness matrix of " + what +
            " is not positive definite (pivot " +
            std::to_string(std::min<std::size_t>(minor + 1, n)) + " of " +
            std::to_string(n) +
            "). Either a rigid-body motion is free (add a Support), or the body "
            "is too slender or too heterogeneous for double precision.",
          order[std::min<std::size_t>(minor, n - 1)]);
      }

      void
      release()
      {
        cholmod_l_free_factor(&factor, &common);
        cholmod_l_finish(&common);
      }

      // CHOLMOD writes into its workspace while solving.
      mutable cholmod_common common;
      cholmod_factor        *factor               = nullptr;
      double                 reciprocal_condition = 0.;
      double                 greatest             = 0.;
      mutable unsigned int   n_solutions          = 0;
    };
  } // namespace



  std::unique_ptr<LinearSolver>
  factorize(const Matrix                          &matrix,
            const std::string                     &what,
            const FactorMonitor                   &monitor,
            std::shared_ptr<const SymbolicFactor> *symbolic)
  {
    return std::make_unique<CholmodFactorization>(matrix,
                                                  what,
                                                  monitor,
                                                  symbolic);
  }
} // namespace lamella
