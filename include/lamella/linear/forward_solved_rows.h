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
  /// The factor L of A = P^T L L^T P by supernodes, sets of columns with the
  /// same rows. Supernode s has the columns column[s] to column[s+1] and the
  /// rows row[first_row[s]] to row[first_row[s+1]], beginning with its columns;
  /// its entries begin at entry[first_entry[s]], column by column. The layout
  /// is CHOLMOD's. Refers to the factor.
  struct SupernodalFactor
  {
    /// Number of rows of L and of supernodes (column, first_row and first_entry
    /// have n_supernodes + 1 entries).
    std::size_t         n = 0, n_supernodes = 0;
    const std::int64_t *column = nullptr, *first_row = nullptr,
                       *first_entry = nullptr, *row = nullptr;
    /// Dense blocks of all supernodes, by columns.
    const double *entry = nullptr;
    /// Row i of P A P^T is row permutation[i] of A.
    const std::int64_t *permutation = nullptr;
  };

  /**
   * Half-solved rows b_k, the columns of Y = L^-1 P B^T, with B A^-1 B^T = Y^T
   * Y:
   *   A^-1 = P^T L^-T L^-1 P, so b_i A^-1 b_j = (L^-1 P b_i) . (L^-1 P b_j).
   *
   * A row involves a few DoFs. Its column vanishes outside the supernodes of
   * these DoFs and their ancestors in the elimination tree (the parent of a
   * supernode has its first row below the columns; Gilbert 1994). Only these
   * entries are computed and stored, per supernode in a dense block of all
   * columns that pass through it. Supernodes are eliminated from the leaves up
   * for all new columns together, by LAPACK's trtrs and the BLAS's gemm. Memory
   * is 8 bytes for each row of a supernode and column that passes through it.
   */
  class ForwardSolvedRows
  {
  public:
    /// Refers to the data of @p factor, which must outlive this object.
    explicit ForwardSolvedRows(const SupernodalFactor &factor);

    /// Half-solves @p rows together. Weights of one DoF are summed; constants
    /// are ignored.
    void
    append(const std::vector<LinearFunctional> &rows);

    /// Returns the number m of columns of Y.
    unsigned int
    size() const
    {
      return n_columns;
    }

    /// Returns y_i . y_j of the columns i from @p first on with all j, at [j *
    /// (size() - first) + i - first]: (m - first) x m numbers.
    std::vector<double>
    products(const unsigned int first) const;

    /// Returns Y @p lambda in the order of L, with one number of @p lambda per
    /// column; P^T L^-T times the result is A^-1 B^T lambda.
    Vector
    combination(const std::vector<double> &lambda) const;

  private:
    /// Part of one call of append() in a supernode.
    struct Block
    {
      /// Ascending numbers of columns of Y.
      std::vector<unsigned int> columns;
      /// Values, as many rows as the supernode has columns, column by column.
      std::vector<double> values;
    };

    /// Returns the number of columns of @p supernode.
    std::size_t
    width(const std::size_t supernode) const
    {
      return factor.column[supernode + 1] - factor.column[supernode];
    }

    /// Returns the parent supernode; the number of supernodes for a root.
    std::size_t
    parent(const std::size_t supernode) const;

    /// Fills P B^T of @p rows into new blocks, from column @p first of Y.
    void
    scatter(const std::vector<LinearFunctional> &rows,
            const unsigned int                   first);

    /// Solves L_11 X = B for the last block of @p supernode; subtracts L_21 X.
    void
    eliminate(const std::size_t supernode);

    /// Subtracts @p change, L_21 X of @p supernode, from its ancestors.
    void
    update_ancestors(const std::size_t          supernode,
                     const std::vector<double> &change);

    /// Factor, position of each row of A in L, supernode of each column of L.
    SupernodalFactor         factor;
    std::vector<std::size_t> position, supernode_of;
    /// Blocks of each supernode, one per call of append().
    std::vector<std::vector<Block>> blocks;
    /// Number of columns of Y so far.
    unsigned int n_columns = 0;
  };

  /// Returns rows half-solved by @p factor as SolvedRows. @p backward computes
  /// x = P^T L^-T x of a combination(). Refers to the data of both.
  std::unique_ptr<SolvedRows>
  make_forward_solved(const SupernodalFactor       &factor,
                      std::function<void(Vector &)> backward);
} // namespace lamella

#endif
