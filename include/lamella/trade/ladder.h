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
    /// As the scene says it: `LE-2, axis 2`.
    std::string name;
    /// `LE-2`; `tolerance 1` of a run to one.
    std::string theory;
    /// As of --set, to stand behind those of the command line: the last of
    /// equal ones counts.
    std::vector<std::string> overrides;
  };

  /**
   * Refinement of a discretisation by overrides of its entries: h in the
   * factors, p in the theory. A rung is no other kind of scene, so whatever a
   * user can write by hand a ladder can do, and the other way round.
   *
   * The overrides that make @p entry out of @p scene: for each body of the
   * trade its theory, its numbers of axis elements times the factor (rounded,
   * at least 1), and for their sections
   *   laminates       Cells per ply, Cells across times the factor,
   *   half discs      Finest cell over it, Sectors times it (multiples of 4, at
   *                   least 8),
   *   ellipses        Refinements + log2 of it (rounded, 0 to 6),
   *   thin walls      Cells per wall, Cells along wall times it;
   * then the entry's own. A section that two bodies share becomes finer for
   * both, also for one that the trade leaves alone. Throws InputError for a
   * factor on a mesh file.
   *
   * Of a run to a tolerance, the Tolerance of subsection Goals, `auto` for the
   * Theory of the scene, and for Theory and Axis elements of the trade's
   * bodies; others begin as the scene says, but the run enriches them, too,
   * where their errors matter. There, and where the trade makes error bars, the
   * quantities of the trade are the goals: none is named where the trade takes
   * whole probes, and those are the goals' default, too.
   */
  Rung
  make_rung(const LadderEntry &entry, const Scene &scene);
} // namespace lamella

#endif
