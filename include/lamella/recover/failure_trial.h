// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_failure_trial_h
#define lamella_recover_failure_trial_h

#include <lamella/recover/field_rows.h>
#include <lamella/recover/ply_reserve.h>
#include <lamella/solve/checks.h>

#include <optional>
#include <vector>

namespace lamella
{
  /// Results at one load factor that the search for first ply failure tried.
  struct FailureTrial
  {
    double load_factor = 0.; ///< Multiplier of all loads of the scene.
    /// Smallest reserve factor of all plies; empty if no ply can fail.
    std::optional<double> reserve;
    Checks                checks; ///< Reactions, contact forces and residuals.
    /// Fields at each probe, one entry per ply, as in StepResults::probes.
    std::vector<std::vector<FieldRow>> probes;
  };

  /// Result of the search for the load factor of first ply failure, at which
  /// the smallest reserve factor is 1.
  struct FirstFailure
  {
    double safe    = 0.; ///< Largest load factor found at which no ply fails.
    double failing = 0.; ///< Smallest load factor found at which a ply fails.
    /// The ply that fails at `failing`; empty if no failure was found.
    std::optional<PlyReserve> where;
    /// Load factors tried in the search, except those without a solution.
    std::vector<FailureTrial> trials;
    /// Warnings about the solution at `failing`, one sentence each.
    std::vector<std::string> warnings;
  };
} // namespace lamella

#endif
