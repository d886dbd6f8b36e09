// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_material_layup_h
#define lamella_material_layup_h

#include <string>
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
   * Throws InputError, beginning with @p what, where the code does not parse.
   */
  std::vector<double>
  parse_layup(const std::string &code, const std::string &what);
} // namespace lamella

#endif
