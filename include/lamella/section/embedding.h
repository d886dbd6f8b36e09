// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_embedding_h
#define lamella_section_embedding_h

#include <lamella/section/warping.h>

namespace lamella
{
  /// Returns true if both have the same cells and elastic laws there, to 1e-9
  /// of the section's size and of the laws. Theories may differ, but for curved
  /// sides not in degree.
  bool
  have_same_cells(const Section &a, const Section &b);

  /// Returns @p fields of the section @p from, one per column, as those of
  /// @p to, with have_same_cells(): the displacement v nearest to w over the
  /// area,
  ///   int Phi_alpha . (v - w) dA = 0     for each field Phi_alpha of @p to,
  /// at the integration points of @p to. LE-p contains LE-q of a lower degree:
  /// v = w. Throws NumericsError if the fields of @p to depend on each other.
  std::vector<Vector>
  embedded(const FieldColumns &fields, const Section &from, const Section &to);
} // namespace lamella

#endif
