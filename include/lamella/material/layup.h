// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_material_layup_h
#define lamella_material_layup_h

#include <lamella/base/entry.h>

#include <vector>

namespace lamella
{
  /// Parses a laminate code such as `0/90/0`, `[0/90]s` or `[0/+-45/90]2s` and
  /// returns the ply angles in degrees (see ply_axes()), bottom to top. Angles
  /// are separated by slashes; `+-45` or `-+45` is a pair of plies. Brackets
  /// may be followed by a repetition factor and by `s` for a symmetric
  /// laminate. Repetition precedes reflection: [0/90]2s is 0/90/0/90/90/0/90/0.
  ///
  /// A code has at most 1000 characters and a repetition factor from 1 to 1000.
  /// Throws InputError if the text of @p entry is not a laminate code.
  std::vector<double>
  parse_layup(const Entry &entry);
} // namespace lamella

#endif
