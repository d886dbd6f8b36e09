// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_embedding_h
#define lamella_section_embedding_h

#include <lamella/section/warping.h>

namespace lamella
{
  /// Returns true if both sections have the same cells and elastic laws, up to
  /// relative differences of 1e-9. Their theories may differ; if sides are
  /// curved, both must have the same degree.
  bool
  have_same_cells(const Section &a, const Section &b);

  /// Projects @p fields of the section @p from, one per column, onto the
  /// section functions Phi_alpha of @p to, which must satisfy
  /// have_same_cells(). The projection v of the displacement w is the best
  /// approximation over the area,
  ///   int Phi_alpha . (v - w) dA = 0     for each field Phi_alpha of @p to,
  /// with the integration points of @p to. If @p to contains the functions of
  /// @p from (LE-p and LE-q, p > q), v = w. Throws NumericsError if the
  /// functions of @p to are linearly dependent.
  std::vector<Vector>
  embedded(const FieldColumns &fields, const Section &from, const Section &to);
} // namespace lamella

#endif
