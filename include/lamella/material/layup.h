// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_material_layup_h
#define lamella_material_layup_h

#include <lamella/base/entry.h>

#include <vector>

namespace lamella
{
  /**
   * Returns the ply angles in degrees (as of ply_axes()), bottom to top, of a
   * laminate code: angles between slashes, `+-45` (or `-+45`) for a pair,
   * brackets optionally followed by a repetition and by `s` for symmetric, as
   * in `0/90/0`, `[0/90]s`, `[0/+-45/90]2s`. Repetition precedes reflection:
   * [0/90]2s is 0/90/0/90/90/0/90/0. `s` reflects the whole stack.
   *
   * A code has at most 1000 characters and a repetition from 1 to 1000. Throws
   * InputError if the text of @p entry is no such code.
   */
  std::vector<double>
  parse_layup(const Entry &entry);
} // namespace lamella

#endif
