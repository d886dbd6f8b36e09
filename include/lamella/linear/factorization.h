// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_factorization_h
#define lamella_linear_factorization_h

#include <lamella/base/exceptions.h>
#include <lamella/linear/linear_solver.h>

namespace lamella
{
  /// Exception: a factorization failed at the DoF @p dof of the matrix. Usual
  /// causes are an unconstrained rigid motion, and a slenderness or stiffness
  /// ratio beyond double precision.
  class NotPositiveDefinite : public NumericsError
  {
  public:
    /// Sets the @p message for the user, as of any NumericsError.
    NotPositiveDefinite(const std::string &message, const DofIndex dof)
      : NumericsError(message)
      , dof(dof)
    {}

    /// First DoF, in elimination order, with a pivot that is not positive.
    const DofIndex dof;
  };

  /**
   * Factorizes @p matrix, of which only the upper triangle is read, with
   * CHOLMOD's supernodal Cholesky factorization A = P^T L L^T P (AMD or METIS
   * ordering, serial). The condition estimate is the squared ratio of the
   * largest to the smallest diagonal entry of L.
   *
   * The matrix is copied without exact zeros. @p monitor is called between
   * symbolic analysis and factorization. Throws NotPositiveDefinite, naming the
   * matrix @p what, if a pivot is not positive, and NumericsError if the factor
   * does not fit in memory.
   */
  std::unique_ptr<LinearSolver>
  factorize(const Matrix        &matrix,
            const std::string   &what,
            const FactorMonitor &monitor = {});

  /// Matrix entries in MUMPS's coordinate format, with 1-based rows and
  /// columns. Entries at the same place are summed, across processes, too.
  struct MatrixEntries
  {
    /// Entry k is values[k] at (rows[k], columns[k]).
    std::vector<int>    rows, columns;
    std::vector<double> values;
  };

  /// Entries of the upper triangle of a symmetric matrix.
  struct UpperTriangle : MatrixEntries
  {
    /// Adds an entryunless zero or below the diagonal; @p row and @p column
    /// count from 0.
    void
    add(const DofIndex row, const DofIndex column, const double value)
    {
      if (column < row || value == 0.)
        return;
      rows.push_back(row + 1);
      columns.push_back(column + 1);
      values.push_back(value);
    }
  };

  /// A matrix of constant pattern, analyzed once and factorized repeatedly, for
  /// the Newton method of the `full` strategy (K + K^p, Eq. 22).
  class RepeatedFactorization
  {
  public:
    virtual ~RepeatedFactorization() = default;

    /// Factorizes the matrix with @p values in the order of this process's
    /// pattern. Throws NumericsError as factorize() does. Collective.
    virtual void
    factorize(std::vector<double> values) = 0;

    /// Computes x = A^-1 x with the last factorization. Whole vectors, the same
    /// on all processes. Collective.
    virtual void
    solve(Vector &x) const = 0;

    /// Returns the sign of the determinant of the last factorized matrix.
    virtual int
    sign_of_determinant() const = 0;
  };

  /// Symmetry of a matrix for MUMPS.
  enum class Symmetry
  {
    definite, ///< symmetric positive definite, upper triangle given
    none      ///< all entries; pivots are chosen
  };

  /// Returns a factorization for the matrix of @p n rows with the given
  /// @p pattern, of which each process passes its part. @p what names the
  /// matrix in messages. Throws NumericsError if the analysis fails.
  /// Collective.
  std::unique_ptr<RepeatedFactorization>
  analyze_shared(const DofIndex     n,
                 MatrixEntries      pattern,
                 const Symmetry     symmetry,
                 const std::string &what);

  /**
   * Factorizes the matrix of @p n rows, of which each process has a part of the
   * entries, with MUMPS (multifrontal, L D L^T without pivoting). Collective,
   * as are all functions of the result.
   *
   * The interfaces of deal.II and Trilinos treat every matrix as unsymmetric
   * and solve for one right-hand side at a time, so MUMPS is called directly.
   * The entries are freed after the factorization. The ordering is minimum
   * degree, or nested dissection if that gives less fill
   * (doc/guides/running-in-parallel.md). Throws NumericsError as factorize()
   * does, and if entries are not finite. No condition estimate. The solved rows
   * are RowProducts.
   */
  std::unique_ptr<LinearSolver>
  factorize_shared(const DofIndex       n,
                   UpperTriangle        matrix,
                   const std::string   &what,
                   const FactorMonitor &monitor = {});
} // namespace lamella

#endif
