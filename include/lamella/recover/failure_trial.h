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
  /// A load factor that was examined for first failure.
  struct FailureTrial
  {
    double load_factor = 0.;
    /// Smallest reserve factor of all plies; none if no factor brings failure.
    std::optional<double> reserve;
    Checks                checks;
    /// Rows of the probes, as in StepResults.
    std::vector<std::vector<FieldRow>> probes;
  };

  /// Result of the search for the load with the smallest reserve factor 1.
  struct FirstFailure
  {
    /// Bracket of load factors: no ply fails at `safe`, one at `failing`.
    double safe = 0., failing = 0.;
    /// The ply that fails at `failing`; none if no failure was found.
    std::optional<PlyReserve> where;
    /// Trials in order, without load steps and factors that have no state.
    std::vector<FailureTrial> trials;
    /// Warnings about the state at `failing`, as for a load step.
    std::vector<std::string> warnings;
  };
} // namespace lamella

#endif
