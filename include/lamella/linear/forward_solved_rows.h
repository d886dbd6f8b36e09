// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_forward_solved_rows_h
#define lamella_linear_forward_solved_rows_h

#include <lamella/linear/linear_solver.h>

#include <cstdint>
#include <functional>
#include <memory>

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

  /// Returns an object that computes compliances B A^-1 B^T and displacements
  /// A^-1 B^T lambda for constraints with the matrix B, from the Cholesky
  /// factor @p factor of A. @p backward replaces x by P^T
  /// L^-T x. The data of both arguments must outlive the result.
  std::unique_ptr<SolvedRows>
  make_forward_solved(const SupernodalFactor       &factor,
                      std::function<void(Vector &)> backward);
} // namespace lamella

#endif
