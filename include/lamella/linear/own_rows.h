// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_linear_own_rows_h
#define lamella_linear_own_rows_h

#include <lamella/base/linear_algebra.h>

#include <deal.II/base/exceptions.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <Epetra_CrsMatrix.h>

#include <vector>

namespace lamella
{
  /// Calls @p use(row, columns, values) for each row of @p matrix that this
  /// process owns, with the row index, a vector of column indices and a pointer
  /// to the entries in these columns, valid during the call. Indices are
  /// global; columns are not sorted. The matrix must be compressed.
  template <typename Use>
  void
  for_each_own_row(const SharedMatrix &matrix, const Use &use)
  {
    const Epetra_CrsMatrix &entries = matrix.trilinos_matrix();
    std::vector<DofIndex>   columns;
    for (int local = 0; local < entries.NumMyRows(); ++local)
      {
        int       n      = 0;
        double   *values = nullptr;
        int      *places = nullptr;
        const int error  = entries.ExtractMyRowView(local, n, values, places);
        AssertThrow(error == 0, dealii::ExcInternalError());
        columns.resize(n);
        for (int k = 0; k < n; ++k)
          columns[k] = entries.GCID64(places[k]);
        use(DofIndex(entries.GRID64(local)), columns, values);
      }
  }
} // namespace lamella

#endif
