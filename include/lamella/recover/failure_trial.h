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
  /// A load factor that was looked at for the first failure.
  struct FailureTrial
  {
    double load_factor = 0.;
    /// The smallest of all plies; none where no factor brings failure.
    std::optional<double> reserve;
    Checks                checks;
    /// As in StepResults.
    std::vector<std::vector<FieldRow>> probes;
  };

  /// What a search for the load at which the smallest reserve factor is 1 has
  /// found.
  struct FirstFailure
  {
    /// No ply fails at the first load factor, and one does at the second, if
    /// any was seen to fail.
    double safe = 0., failing = 0.;
    /// What fails, at `failing`; none if nothing was seen to fail.
    std::optional<PlyReserve> where;
    /// In the order in which they were looked at; neither load steps nor load
    /// factors without a state are among them.
    std::vector<FailureTrial> trials;
    /// Warnings about the state at `failing`, as for a load step.
    std::vector<std::string> warnings;
  };
} // namespace lamella

#endif
