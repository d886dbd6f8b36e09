// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_embedding_h
#define lamella_section_embedding_h

#include <lamella/section/warping.h>

namespace lamella
{
  /// Whether both have the same cells: as many, their middles within 1e-9 of
  /// the section's size, and the same elastic law there to 1e-9. Their theories
  /// may differ. Cells with curved sides have not, if the degrees differ: their
  /// middles move with it.
  bool
  have_same_cells(const Section &a, const Section &b);

  /**
   * The fields @p fields of the section @p from, a column each, as those of
   * @p to, which have_same_cells(): the displacement v of the one that is
   * nearest to the other's w over the area,
   *   int Phi_alpha . (v - w) dA = 0     for each field Phi_alpha of @p to,
   * at the integration points of @p to. LE-p holds LE-q of a lower degree, so
   * there v = w. A vector for each column, as long as @p to has fields. Throws
   * NumericsError where the fields of @p to depend on each other.
   */
  std::vector<Vector>
  embedded(const FieldColumns &fields, const Section &from, const Section &to);
} // namespace lamella

#endif
