// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_factor_row_h
#define lamella_linear_factor_row_h

#include <lamella/base/linear_algebra.h>

#include <array>
#include <map>
#include <vector>

#include <deal.II/lac/lapack_full_matrix.h>

namespace lamella
{
  /// A row of the five axis matrices, or of the five section matrices, whose
  /// Kronecker products are the stiffness of a beam. Each column has five
  /// entries, one per matrix: for derivatives of orders (p, q) = (0, 0), (0,
  /// 1), (1, 0), (1, 1) of test and trial function, and for transverse shear.
  struct FactorRow
  {
    std::vector<unsigned int>          columns; ///< Nonzero columns, ascending.
    std::vector<std::array<double, 5>> entries; ///< Five entries per column.
  };

  /// Returns row @p r of five matrices of the same pattern. @p matrix_number(m)
  /// returns matrix m. Columns j are omitted if @p wanted(j) is false.
  template <typename Factor, typename Wanted>
  FactorRow
  factor_row(const Factor      &matrix_number,
             const unsigned int r,
             const Wanted      &wanted)
  {
    // deal.II stores the diagonal first; here columns ascend.
    std::map<unsigned int, std::array<double, 5>> sorted;
    for (unsigned int m = 0; m < 5; ++m)
      for (auto entry = matrix_number(m).begin(r);
           entry != matrix_number(m).end(r);
           ++entry)
        if (wanted(entry->column()))
          sorted[entry->column()][m] = entry->value();
    FactorRow row;
    for (const auto &[column, entries] : sorted)
      {
        row.columns.push_back(column);
        row.entries.push_back(entries);
      }
    return row;
  }

  /// Returns the product of the sparse matrix @p A and the dense matrix @p X.
  /// Several columns of X are processed together, to read each entry of A once.
  /// Each column of the result is bitwise equal to a matrix-vector product.
  dealii::LAPACKFullMatrix<double>
  times_columns(const Matrix &A, const dealii::LAPACKFullMatrix<double> &X);
} // namespace lamella

#endif
