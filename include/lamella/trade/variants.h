// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_trade_variants_h
#define lamella_trade_variants_h

#include <lamella/scene/scene.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Variant of a trade: the scene with these overrides, PATH=VALUE each.
  struct Variant
  {
    /// Name in the scene: `LE-2, axis 2`.
    std::string name;
    /// Theory, as `LE-2`; `tolerance 1` for a run to a tolerance.
    std::string theory;
    /// Overrides, to be appended to those of the command line (--set).
    std::vector<std::string> overrides;
  };

  /**
   * Returns the overrides that change @p scene into the variant @p entry:
   * refinement in h by factors and in p by theories.
   *
   * The overrides are, for each body of the trade, its theory and its numbers
   * of axis elements times the factor (rounded, at least 1). Sections of these
   * bodies have, with the section's factor,
   *   laminates       Cells per ply, Cells across times the factor,
   *   half discs      Finest cell over it, Sectors times it (multiples of 4, at
   *                   least 8),
   *   ellipses        Refinements + log2 of it (rounded, 0 to 6),
   *   thin walls      Cells per wall, Cells along wall times it.
   * The overrides of the entry follow. A section is refined for all bodies that
   * share it. Throws InputError for a factor on a mesh file.
   *
   * A run to a tolerance has the overrides Tolerance of Goals, and `auto` for
   * the Theory of the scene and for Theory and Axis elements of the trade's
   * bodies. Other bodies begin as in the scene but are refined, too. Here, and
   * if the trade makes error bars, the quantities of the trade are the goals;
   * none is named if the trade takes whole probes, which are the goals'
   * default.
   */
  Variant
  make_variant(const TradeVariant &entry, const Scene &scene);
} // namespace lamella

#endif
