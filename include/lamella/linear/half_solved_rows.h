// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_half_solved_rows_h
#define lamella_linear_half_solved_rows_h

#include <lamella/linear/linear_solver.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace lamella
{
  /**
   * The factor L of A = P^T L L^T P by supernodes, sets of columns with the
   * same rows: supernode s has the columns column[s] to column[s+1] and the
   * rows row[first_row[s]] to row[first_row[s+1]], of which the first are its
   * columns; its entries begin at entry[first_entry[s]], column by column. The
   * layout is CHOLMOD's; all is referred to. A view without ownership: the
   * factor must outlive it and not change.
   */
  struct SupernodalFactor
  {
    /// Rows of L, and the number of supernodes; see above for the arrays, which
    /// have n_supernodes + 1 entries (column, first_row, first_entry).
    std::size_t         n = 0, n_supernodes = 0;
    const std::int64_t *column = nullptr, *first_row = nullptr,
                       *first_entry = nullptr, *row = nullptr;
    /// The dense blocks of all supernodes, each with as many rows as the
    /// supernode and stored by columns, so that LAPACK and the BLAS take them
    /// as they are.
    const double *entry = nullptr;
    /// Row i of P A P^T is row permutation[i] of A.
    const std::int64_t *permutation = nullptr;
  };

  /**
   * Rows b_k half solved, the columns of Y = L^-1 P B^T, with B A^-1 B^T = Y^T
   * Y.
   *
   * A row names a few DoFs, so its column vanishes outside of the supernodes
   * that these DoFs belong to and their ancestors in the elimination tree (the
   * parent of a supernode has its first row below the columns; Gilbert 1994).
   * Only those are computed and kept: per supernode a dense block of all
   * columns that pass through it.
   *
   *   A^-1 = P^T L^-T L^-1 P, so b_i A^-1 b_j = (L^-1 P b_i) . (L^-1 P b_j):
   *
   * one half of the solution is enough for all products, and it is the half in
   * which a sparse row stays sparse. Supernodes are eliminated from the leaves
   * up for all new columns together, by LAPACK's trtrs and the BLAS's gemm.
   * Memory is 8 bytes for each row of a supernode and column that passes
   * through it; the root block is common to all columns, the leaves to next to
   * none.
   */
  class HalfSolvedRows
  {
  public:
    /// What @p factor points to must outlive this object.
    explicit HalfSolvedRows(const SupernodalFactor &factor);

    /// Half solves @p rows, all at once: the more, the faster a row. Weights of
    /// one DoF that come several times add up; constants are ignored.
    void
    append(const std::vector<Row> &rows);

    /// The number m of columns of Y.
    unsigned int
    size() const
    {
      return n_columns;
    }

    /// y_i . y_j of the columns i from @p first on with all j, at [j * (size()
    /// - first) + i - first]. (m - first) x m numbers, column by column: m (m -
    /// first) times the mean length of the columns that meet, done as dense
    /// products per supernode.
    std::vector<double>
    products(const unsigned int first) const;

    /// Y @p lambda, all columns, in the order of L. P^T L^-T of it is A^-1 B^T
    /// lambda: the backward half that the caller does once for all rows.
    /// @p lambda has one number per column; zeros are skipped.
    Vector
    combination(const std::vector<double> &lambda) const;

  private:
    /// What one call of append() left in a supernode.
    struct Block
    {
      /// Ascending numbers of columns of Y.
      std::vector<unsigned int> columns;
      /// As many rows as the supernode has columns, column by column.
      std::vector<double> values;
    };

    /// The number of columns of @p supernode.
    std::size_t
    width(const std::size_t supernode) const
    {
      return factor.column[supernode + 1] - factor.column[supernode];
    }

    /// The supernode above, or none for a root: their number.
    std::size_t
    parent(const std::size_t supernode) const;

    /// Makes room for @p rows, the first of them column @p first of Y, and
    /// writes down P B^T.
    void
    scatter(const std::vector<Row> &rows, const unsigned int first);

    /// L_11 X = B for the last block of @p supernode, and B - L_21 X above.
    void
    eliminate(const std::size_t supernode);

    /// Takes @p change, L_21 X of @p supernode, column by column, off what is
    /// above.
    void
    pass_on(const std::size_t supernode, const std::vector<double> &change);

    /// Then the place of each row of A in L, and the supernode of each column
    /// of L.
    SupernodalFactor         factor;
    std::vector<std::size_t> position, supernode_of;
    /// Of each supernode, one per call of append() that passed through it.
    std::vector<std::vector<Block>> blocks;
    /// Columns of Y so far.
    unsigned int n_columns = 0;
  };

  /// Rows half solved by @p factor as a solver hands them out. @p backward does
  /// the other half to what combination() returns, x = P^T L^-T x. Refers to
  /// what both refer to.
  std::unique_ptr<SolvedRows>
  half_solved(const SupernodalFactor       &factor,
              std::function<void(Vector &)> backward);
} // namespace lamella

#endif
