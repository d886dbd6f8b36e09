// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_embedding_h
#define lamella_section_embedding_h

#include <lamella/section/warping.h>

namespace lamella
{
  /// Returns true if the sections @p a and @p b have the same cells and elastic
  /// constants, up to relative differences of 1e-9. Their theories may differ,
  /// but only theories of the same degree have the same curved cells.
  bool
  have_same_cells(const Section &a, const Section &b);

  /// Projects the displacements @p fields from the section @p from onto the
  /// section functions Phi_alpha of the section @p to, which has the same cells
  /// (have_same_cells()). Each column of @p fields has the coefficients of a
  /// displacement w. The result has the coefficients of its best approximation
  /// v over the area,
  ///   int Phi_alpha . (v - w) dA = 0   for all alpha,
  /// with the integration points of @p to. If the functions of @p to contain
  /// those of @p from (LE-p contains LE-q for p > q), v = w. Throws
  /// NumericsError if the functions of @p to are linearly dependent.
  std::vector<Vector>
  embedded(const FieldColumns &fields, const Section &from, const Section &to);
} // namespace lamella

#endif
