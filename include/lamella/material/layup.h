// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_material_layup_h
#define lamella_material_layup_h

#include <lamella/base/entry.h>

#include <vector>

namespace lamella
{
  /**
   * The ply angles, bottom to top, in degrees, that a laminate code spells:
   * angles between slashes, `+-45` (or `-+45`) for a pair, brackets that may be
   * followed by a repetition and by `s` for symmetric, as in `0/90/0`,
   * `[0/90]s`, `[0/+-45/90]2s`. A repetition comes before the reflection:
   * [0/90]2s is 0/90/0/90/90/0/90/0.
   *
   * Throws InputError where the text of @p entry is no such code.
   *
   * Angles are as those of ply_axes(): 0 along the axis of the beam. They are
   * any numbers, not brought into a range, and a code holds at most 1000
   * characters and a repetition from 1 to 1000. `s` reflects the whole stack,
   * so that the two plies in the middle are equal neighbours; there is no sign
   * for a middle ply that is not doubled (`0/90/0` is written out). Only a code
   * in brackets takes a repetition or an `s`.
   */
  std::vector<double>
  parse_layup(const Entry &entry);
} // namespace lamella

#endif
