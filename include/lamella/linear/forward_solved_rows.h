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

  /// Computes the compliance B A^-1 B^T = Y^T Y of constraints with matrix B,
  /// from the forward solutions Y = L^-1 P B^T with the Cholesky factor L:
  ///   A^-1 = P^T L^-T L^-1 P, so b_i A^-1 b_j = (L^-1 P b_i) . (L^-1 P b_j).
  ///
  /// A row b_k of B involves a few DoFs. Its column of Y is nonzero only in the
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

    /// Appends the constraint @p rows and computes their forward solutions.
    /// Weights of the same DoF are summed; constant parts are ignored.
    void
    append(const std::vector<LinearFunctional> &rows);

    /// Returns the number of constraints appended so far.
    unsigned int
    size() const
    {
      return n_columns;
    }

    /// Returns the compliances of all constraints i >= @p first with all j, at
    /// [j * (m - first) + i - first] with m = size().
    std::vector<double>
    products(const unsigned int first) const;

    /// Returns the combination L^-1 P B^T @p lambda of forward solutions in the
    /// row order of L, with one force @p lambda per constraint. P^T L^-T times
    /// the result is A^-1 B^T lambda.
    Vector
    combination(const std::vector<double> &lambda) const;

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
    parent(const std::size_t supernode) const;

    /// Stores the permuted @p rows in new blocks, for columns from @p first.
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
    unsigned int n_columns = 0; ///< Number of constraints so far.
  };

  /// Returns an object that computes compliances B A^-1 B^T and displacements
  /// A^-1 B^T lambda for constraints with the matrix B, from the Cholesky
  /// factor @p factor of A (ForwardSolvedRows). @p backward replaces x by P^T
  /// L^-T x. The data of both arguments must outlive the result.
  std::unique_ptr<SolvedRows>
  make_forward_solved(const SupernodalFactor       &factor,
                      std::function<void(Vector &)> backward);
} // namespace lamella

#endif
