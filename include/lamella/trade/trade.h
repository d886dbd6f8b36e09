// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `trade`: variants of a scene (theories and meshes) for the
// comparison of accuracy and cost. It does not solve anything: scripts/trade.py
// runs the variants, each as a process of its own, creates a table, names the
// cheapest variants, and plots errors over cost.

#ifndef lamella_trade_trade_h
#define lamella_trade_trade_h

#include <lamella/run/command_line.h>
#include <lamella/scene/scene.h>

namespace lamella
{
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
