// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_half_solved_rows_h
#define lamella_linear_half_solved_rows_h

#include <lamella/base/row.h>

#include <cstdint>
#include <vector>

namespace lamella
{
  /**
   * The factor L of A = P^T L L^T P by supernodes, sets of columns with the
   * same rows: supernode s has the columns column[s] to column[s+1] and the
   * rows row[first_row[s]] to row[first_row[s+1]], of which the first are its
   * columns; its entries begin at entry[first_entry[s]], column by column. The
   * layout is CHOLMOD's; all is referred to.
   */
  struct SupernodalFactor
  {
    std::size_t         n = 0, n_supernodes = 0;
    const std::int64_t *column = nullptr, *first_row = nullptr,
                       *first_entry = nullptr, *row = nullptr;
    const double *entry = nullptr;
    /// Row i of P A P^T is row permutation[i] of A.
    const std::int64_t *permutation = nullptr;
  };

  /**
   * Rows b_k half solved, the columns of Y = L^-1 P B^T, with
   * B A^-1 B^T = Y^T Y.
   *
   * A row names a few DoFs, so its column vanishes outside of the supernodes
   * that these DoFs belong to and their ancestors in the elimination tree (the
   * parent of a supernode has its first row below the columns; Gilbert 1994).
   * Only those are computed and kept: per supernode a dense block of all
   * columns that pass through it.
   */
  class HalfSolvedRows
  {
  public:
    explicit HalfSolvedRows(const SupernodalFactor &factor);

    /// Half solves @p rows, all at once: the more, the faster a row.
    void
    append(const std::vector<Row> &rows);

    unsigned int
    size() const
    {
      return n_columns;
    }

    /// y_i . y_j of the columns i from @p first on with all j, at
    /// [j * (size() - first) + i - first].
    std::vector<double>
    products(const unsigned int first) const;

    /// Y @p lambda, all columns, in the order of L.
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

    SupernodalFactor                factor;
    std::vector<std::size_t>        position, supernode_of;
    std::vector<std::vector<Block>> blocks;
    unsigned int                    n_columns = 0;
  };
} // namespace lamella

#endif
