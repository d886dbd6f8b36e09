// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_factorization_h
#define lamella_linear_factorization_h

#include <lamella/base/exceptions.h>
#include <lamella/linear/linear_solver.h>

#include <cstdint>
#include <functional>
#include <memory>

namespace lamella
{
  /// Exception thrown if a Cholesky factorization has a pivot that is not
  /// positive. Usual causes are an unconstrained rigid-body motion, and a
  /// slenderness or stiffness ratio beyond double precision.
  class NotPositiveDefinite : public NumericsError
  {
  public:
    /// Stores the @p message for the user and the DoF @p dof of the pivot.
    NotPositiveDefinite(const std::string &message, const DofIndex dof)
      : NumericsError(message)
      , dof(dof)
    {}

    /// First DoF in elimination order whose pivot is not positive; invalid if
    /// unknown (MUMPS).
    const DofIndex dof;
  };

  class SymbolicFactor;

  /// Factorizes @p matrix, of which only the upper triangle is read, with
  /// CHOLMOD's supernodal Cholesky factorization A = P^T L L^T P (AMD or METIS
  /// ordering, serial). The condition estimate is the squared ratio of the
  /// largest to the smallest diagonal entry of L.
  ///
  /// The nonzero entries are copied. @p monitor is called between symbolic
  /// analysis and factorization. If @p symbolic is not null, the symbolic
  /// factor that it points to is used if it belongs to the same nonzero
  /// entries, and replaced otherwise. Throws NotPositiveDefinite, with @p what
  /// as name of the matrix, if a pivot is not positive, NumericsError if memory
  /// is insufficient.
  std::unique_ptr<LinearSolver>
  factorize(const Matrix                          &matrix,
            const std::string                     &what,
            const FactorMonitor                   &monitor  = {},
            std::shared_ptr<const SymbolicFactor> *symbolic = nullptr);

  /// Matrix entries in MUMPS's coordinate format, with rows and columns
  /// numbered from 1. Entries of the same row and column are summed.
  struct MatrixEntries
  {
    std::vector<int> rows,      ///< Row of each entry, from 1.
      columns;                  ///< Column of each entry, from 1.
    std::vector<double> values; ///< Value of each entry.
  };

  /// Entries of the upper triangle of a symmetric matrix.
  struct UpperTriangle : MatrixEntries
  {
    /// Adds @p value at @p row and @p column, numbered from 0. Zeros and
    /// entries below the diagonal are ignored.
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

  /// Direct solver for a sequence of matrices with the same sparsity pattern,
  /// which is analyzed only once: the tangent matrices of Newton's method in
  /// the solution strategy `full`, which assembles one matrix of all bodies.
  class RepeatedFactorization
  {
  public:
    virtual ~RepeatedFactorization() = default;

    /// Factorizes the matrix with the entries @p values, in the order of the
    /// pattern that this process passed to analyze_shared(). Throws
    /// NumericsError if the matrix is singular or memory insufficient.
    /// Collective.
    virtual void
    factorize(std::vector<double> values) = 0;

    /// Computes x = A^-1 x with the last factorization. @p x is the whole
    /// vector and equal on all processes. Collective.
    virtual void
    solve(Vector &x) const = 0;

    /// Returns the sign of the last factorized matrix's determinant: 1 or -1.
    virtual int
    sign_of_determinant() const = 0;
  };

  /// Kind of matrix that MUMPS factorizes.
  enum class Symmetry
  {
    definite, ///< symmetric positive definite, upper triangle given
    none      ///< all entries; pivots are chosen
  };

  /// Analyzes a matrix of @p n rows with MUMPS and returns the object that
  /// factorizes it. Each process passes a subset of the sparsity @p pattern. @p
  /// what is the name of the matrix in messages. Throws NumericsError if the
  /// analysis fails. Collective.
  std::unique_ptr<RepeatedFactorization>
  analyze_shared(const DofIndex     n,
                 MatrixEntries      pattern,
                 const Symmetry     symmetry,
                 const std::string &what);

  /// Factorizes a matrix of @p n rows with MUMPS (multifrontal L D L^T without
  /// pivoting). Each process passes a subset of the entries. Collective, as are
  /// all functions of the result.
  ///
  /// MUMPS is called directly, since the interfaces of deal.II and Trilinos
  /// treat every matrix as unsymmetric and solve for one right-hand side at a
  /// time. The entries are freed after the factorization. The ordering is
  /// minimum degree, or nested dissection if that has less fill-in
  /// (doc/guides/running-in-parallel.md). Throws NotPositiveDefinite, and
  /// NumericsError if memory is insufficient or entries are not finite.
  /// No condition estimate. LinearSolver::solved_rows() returns RowProducts.
  std::unique_ptr<LinearSolver>
  factorize_shared(const DofIndex       n,
                   UpperTriangle        matrix,
                   const std::string   &what,
                   const FactorMonitor &monitor = {});

  /// View of the Cholesky factor L of A = P^T L L^T P (permutation P), in
  /// CHOLMOD's layout of supernodes, sets of columns with the same rows.
  /// Supernode s has the columns column[s] to column[s+1] - 1 and the row
  /// indices row[first_row[s]] to row[first_row[s+1] - 1], which begin with its
  /// columns. Its entries begin at entry[first_entry[s]], by columns. The
  /// arrays are not owned.
  struct SupernodalFactor
  {
    std::size_t n              = 0,       ///< Number of rows of L.
      n_supernodes             = 0;       ///< Number of supernodes.
    const std::int64_t *column = nullptr, ///< First column of each supernode.
      *first_row        = nullptr, ///< Offset in `row` of each supernode.
        *first_entry    = nullptr, ///< Offset in `entry` of each supernode.
          *row          = nullptr; ///< Row indices of all supernodes.
    const double *entry = nullptr; ///< Dense blocks of supernodes, by columns.
    /// Permutation P: row i of P A P^T is row permutation[i] of A.
    const std::int64_t *permutation = nullptr;
  };

  /// Returns an object that computes compliances B A^-1 B^T and displacements
  /// A^-1 B^T lambda for constraints with the matrix B, from the Cholesky
  /// factor @p factor of A. @p backward replaces x by P^T
  /// L^-T x. The data of both arguments must outlive the result.
  std::unique_ptr<SolvedRows>
  make_forward_solved(const SupernodalFactor       &factor,
                      std::function<void(Vector &)> backward);
} // namespace lamella

#endif
