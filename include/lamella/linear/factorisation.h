// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_factorisation_h
#define lamella_linear_factorisation_h

#include <lamella/base/exceptions.h>
#include <lamella/linear/linear_solver.h>

namespace lamella
{
  /// A factorisation that broke down at the DoF @p dof (of the matrix, not in
  /// the order of elimination). Who knows what a DoF is says where in the body
  /// that is (Body::make_solver()). Its usual causes are a rigid motion that
  /// nothing holds, and a slenderness or a ratio of stiffnesses that double
  /// precision cannot hold.
  class NotPositiveDefinite : public NumericsError
  {
  public:
    /// @p message for the user, as of any NumericsError.
    NotPositiveDefinite(const std::string &message, const DofIndex dof)
      : NumericsError(message)
      , dof(dof)
    {}

    /// The first DoF, in the order of elimination, whose pivot is not positive.
    const DofIndex dof;
  };

  /**
   * Factorises @p matrix, of which only the upper triangle is read, with
   * CHOLMOD's supernodal Cholesky factorisation A = P^T L L^T P (AMD or METIS
   * ordering, serial). Its condition estimate is the square of the ratio of the
   * largest to the smallest diagonal entry of L: cheap and rough, it tells
   * decades. Its solved rows are half solved (HalfSolvedRows).
   *
   * Throws NumericsError if a pivot is not positive; @p what then names the
   * matrix in the message.
   *
   * The matrix is copied (exact zeros left out, which would only cause fill)
   * and may go afterwards. @p monitor is called between the symbolic analysis
   * and the factorisation; what it throws passes through, with all memory
   * freed. Also throws NumericsError if the factor does not fit in memory.
   * Serial: other processes need not take part.
   */
  std::unique_ptr<LinearSolver>
  factorise(const Matrix        &matrix,
            const std::string   &what,
            const FactorMonitor &monitor = {});

  /// Entries of a matrix, rows and columns counted from 1 as MUMPS does. Those
  /// of one place add up, those of all processes, too. 16 bytes an entry,
  /// MUMPS's coordinate format.
  struct MatrixEntries
  {
    /// Entry k is values[k] at (rows[k], columns[k]).
    std::vector<int>    rows, columns;
    std::vector<double> values;
  };

  /// Those of the upper triangle of a symmetric matrix, columns[k] >= rows[k].
  struct UpperTriangle : MatrixEntries
  {
    /// Adds an entry, rows and columns counted from 0; nothing if it is below
    /// the diagonal or zero.
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

  /**
   * A matrix of which only the values change: analysed once for its places,
   * factorised as often as one likes. Otherwise as factorise_shared(). For
   * Newton's method of the `full` strategy, whose K + K^p (Eq. 22) keeps its
   * places while contact opens and closes.
   */
  class RepeatedFactorisation
  {
  public:
    virtual ~RepeatedFactorisation() = default;

    /// Factorises the matrix with the values @p values in the places that it
    /// was made for, in their order. Throws NumericsError as factorise() does.
    /// As many as the pattern has entries on this process. Collective.
    virtual void
    factorise(std::vector<double> values) = 0;

    /// x = A^-1 x of the last factorisation. Whole vectors, the same on all
    /// processes. Collective.
    virtual void
    solve(Vector &x) const = 0;

    /// The sign of the determinant of the matrix that was factorised last: 1,
    /// or -1, which a definite one never has.
    virtual int
    sign_of_determinant() const = 0;
  };

  /// What MUMPS is told of a matrix.
  enum class Symmetry
  {
    definite, ///< symmetric and positive definite, of which there is the upper
              ///< triangle
    none      ///< all entries; pivots are chosen
  };

  /// For the matrix of @p n rows in the places of @p pattern, whose values are
  /// not looked at; @p what names it in messages. It must have as many of them
  /// as places, though. Collective; each process hands over its part. Throws
  /// NumericsError if the analysis fails.
  std::unique_ptr<RepeatedFactorisation>
  analyse_shared(const DofIndex     n,
                 MatrixEntries      pattern,
                 const Symmetry     symmetry,
                 const std::string &what);

  /**
   * Factorises the matrix of @p n rows whose entries the processes hold each a
   * part of, with MUMPS (multifrontal, L D L^T without pivoting), on all
   * processes together. All of them call this and what it returns.
   *
   * Deal.II's and Trilinos' ways to MUMPS (Amesos) treat every matrix as
   * unsymmetric, twice the work and memory, and solve for one right-hand side
   * at a time, which contact has many of; so MUMPS is called itself.
   *
   * Throws NumericsError as factorise() does.
   *
   * Each process hands over the entries it has and keeps none of them: they are
   * freed once the factor is there. The ordering is minimum degree, and nested
   * dissection where that would leave much fill (doc/running-in-parallel.md).
   * Entries that are no finite numbers throw NumericsError before MUMPS sees
   * them. There is no condition estimate. Its solved rows are RowProducts.
   */
  std::unique_ptr<LinearSolver>
  factorise_shared(const DofIndex       n,
                   UpperTriangle        matrix,
                   const std::string   &what,
                   const FactorMonitor &monitor = {});
} // namespace lamella

#endif
