// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_forward_solved_rows_h
#define lamella_linear_forward_solved_rows_h

#include <lamella/linear/linear_solver.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace lamella
{
  /// View of the Cholesky factor L of A = P^T L L^T P, in CHOLMOD's layout of
  /// supernodes, sets of columns with the same rows. Supernode s has the
  /// columns from column[s] to before column[s+1] and the rows from
  /// row[first_row[s]] to before row[first_row[s+1]]; its first rows are its
  /// columns. Its entries begin at entry[first_entry[s]], column by column.
  /// Does not own the arrays.
  struct SupernodalFactor
  {
    /// Number of rows of L and number of supernodes. The arrays column,
    /// first_row and first_entry have n_supernodes + 1 entries.
    std::size_t         n = 0, n_supernodes = 0;
    const std::int64_t *column = nullptr, *first_row = nullptr,
                       *first_entry = nullptr, *row = nullptr;
    /// Dense blocks of all supernodes, by columns.
    const double *entry = nullptr;
    /// Row i of P A P^T is row permutation[i] of A.
    const std::int64_t *permutation = nullptr;
  };

  /// Computes the compliance B A^-1 B^T = Y^T Y of constraint rows b_k, the
  /// rows of B, from their forward solutions, the columns of Y = L^-1 P B^T:
  ///   A^-1 = P^T L^-T L^-1 P, so b_i A^-1 b_j = (L^-1 P b_i) . (L^-1 P b_j).
  ///
  /// A row b_k involves a few DoFs. Its column of Y is nonzero only in the
  /// supernodes of these DoFs and their ancestors in the elimination tree
  /// (Gilbert 1994). The parent of a supernode contains its first row below the
  /// diagonal block. Only these entries are computed and stored, 8 bytes each,
  /// in one dense block per supernode. Supernodes are eliminated from the
  /// leaves to the root for all new columns together, by LAPACK and BLAS.
  class ForwardSolvedRows
  {
  public:
    /// Keeps a view of @p factor, whose data must outlive this object.
    explicit ForwardSolvedRows(const SupernodalFactor &factor);

    /// Computes the columns of Y for all @p rows together. Weights of the same
    /// DoF are summed; constant parts are ignored.
    void
    append(const std::vector<LinearFunctional> &rows);

    /// Returns the number m of columns of Y.
    unsigned int
    size() const
    {
      return n_columns;
    }

    /// Returns the products y_i . y_j of the columns i >= @p first with all
    /// columns j of Y, at [j * (m - first) + i - first], m = size().
    std::vector<double>
    products(const unsigned int first) const;

    /// Returns Y @p lambda in the row order of L, with one entry of @p lambda
    /// per column of Y. P^T L^-T times the result is A^-1 B^T lambda.
    Vector
    combination(const std::vector<double> &lambda) const;

  private:
    /// Entries of Y in one supernode, computed by one call of append().
    struct Block
    {
      /// Numbers of the columns of Y that are nonzero here, ascending.
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
    parent(const std::size_t supernode) const;

    /// Stores P b_k of the @p rows b_k in new blocks, for columns from
    /// @p first.
    void
    scatter(const std::vector<LinearFunctional> &rows,
            const unsigned int                   first);

    /// Solves L_11 X = B for the last block B of @p supernode, with its
    /// diagonal block L_11 of L, and subtracts L_21 X from its ancestors.
    void
    eliminate(const std::size_t supernode);

    /// Subtracts @p change = L_21 X from the ancestors of @p supernode.
    void
    update_ancestors(const std::size_t          supernode,
                     const std::vector<double> &change);

    /// View of L; row of L for each row of A; supernode of each column of L.
    SupernodalFactor         factor;
    std::vector<std::size_t> position, supernode_of;
    /// Blocks of each supernode, one per call of append().
    std::vector<std::vector<Block>> blocks;
    /// Number of columns of Y so far.
    unsigned int n_columns = 0;
  };

  /// Returns an object that computes compliances B A^-1 B^T and displacements
  /// A^-1 B^T lambda for constraint rows B from the Cholesky factor L =
  /// @p factor, by ForwardSolvedRows. @p backward replaces x by P^T L^-T x. The
  /// data of both arguments must outlive the result.
  std::unique_ptr<SolvedRows>
  make_forward_solved(const SupernodalFactor       &factor,
                      std::function<void(Vector &)> backward);
} // namespace lamella

#endif
