// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_trade_trade_h
#define lamella_trade_trade_h

// The room `trade`: variants of a scene (theories and meshes) for the
// comparison of accuracy and cost. It does not solve anything: scripts/trade.py
// runs the variants, each as a process of its own, creates a table, names the
// cheapest variants, and plots errors over cost.

#include <lamella/run/command_line.h>
#include <lamella/scene/scene.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Returns the changed entries PATH=VALUE (overrides) of the variant @p entry
  /// of @p scene, for h-refinement (factors) and p-refinement (theories). They
  /// are applied after those of the option --set.
  ///
  /// For each body of the trade, the overrides set the theory and the number of
  /// axis elements times the axis factor (rounded, at least 1). For sections of
  /// these bodies they set, with the section factor F,
  ///   laminates       Cells per ply and Cells across times F,
  ///   half discs      Finest cell over F, Sectors times F (multiples of 4, at
  ///                   least 8),
  ///   ellipses        Refinements + log2 F (rounded, 0 to 6),
  ///   thin walls      Cells per wall and Cells along wall times F,
  ///   tubes           Cells per ply and Cells around times F (multiples of 4),
  ///   mesh files      Cells divided + log2 F (rounded, not negative).
  /// TradeVariant::overrides are appended. A section is refined for all bodies
  /// that use it. Throws InputError if a mesh file would be coarsened.
  ///
  /// For a solution to a tolerance, the overrides set `Tolerance` of Goals, and
  /// `auto` for the theory of the scene and for theory and axis elements of the
  /// bodies of the trade; other bodies are refined, too. The compared
  /// quantities are the goals of these runs.
  std::vector<std::string>
  overrides_of(const TradeVariant &entry, const Scene &scene);

  /// Returns overrides that make the compared quantities of @p scene the goals
  /// of the variant @p entry, with error bars if `Trade/Error bars` is true,
  /// and without a run to a tolerance. None if @p entry is one.
  std::vector<std::string>
  goals_of(const TradeVariant &entry, const Scene &scene);

  /// Implements `lamella trade SCENE.prm`: checks the subsection Trade of @p
  /// scene, writes the variants with their overrides to variants/plan-PID.json
  /// in the folder CommandLine::output, and replaces this process by
  /// scripts/trade.py, which runs them (doc/guides/convergence-study.md). A
  /// variant whose overrides cannot be formed is stored with the reason. MPI
  /// must not be initialized. Throws InputError for invalid variants, a missing
  /// python3, and a folder that is not writable.
  [[noreturn]] void
  run_trade(const CommandLine &command, const Scene &scene);
} // namespace lamella

#endif
