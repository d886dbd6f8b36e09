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
  /// A load factor that was tried in the search for first failure.
  struct FailureTrial
  {
    double load_factor = 0.;
    /// Smallest reserve factor of all plies; empty if no ply can fail.
    std::optional<double> reserve;
    Checks                checks;
    /// Rows of the probe table, as in StepResults.
    std::vector<std::vector<FieldRow>> probes;
  };

  /// Load factor at which the smallest reserve factor is 1.
  struct FirstFailure
  {
    /// No ply fails at the load factor `safe`; a ply fails at `failing`.
    double safe = 0., failing = 0.;
    /// The ply that fails at `failing`; empty if no failure was found.
    std::optional<PlyReserve> where;
    /// Load factors tried in the search, except those without a solution.
    std::vector<FailureTrial> trials;
    /// Warnings about the state at `failing`, as for a load step.
    std::vector<std::string> warnings;
  };
} // namespace lamella

#endif
