// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_trade_ladder_h
#define lamella_trade_ladder_h

#include <lamella/scene/scene.h>

#include <string>
#include <vector>

namespace lamella
{
  /// A rung of a trade: the scene with these overrides, PATH=VALUE each.
  struct Rung
  {
    std::string              name;
    std::string              theory;
    std::vector<std::string> overrides;
  };

  /**
   * The overrides that make @p entry out of @p scene: for each body of the
   * trade its theory, its numbers of axis elements times the factor (rounded,
   * at least 1), and for their sections
   *   laminates       Cells per ply, Cells across times the factor,
   *   half discs      Finest cell over it, Sectors times it (multiples of 4),
   *   ellipses        Refinements + log2 of it,
   *   thin walls      Cells per wall, Cells along wall times it;
   * then the entry's own. Throws InputError for a factor on a mesh file.
   */
  Rung
  make_rung(const LadderEntry &entry, const Scene &scene);
} // namespace lamella

#endif
