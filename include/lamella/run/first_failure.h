// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_first_failure_h
#define lamella_run_first_failure_h

#include <lamella/contact/gap_constraints.h>
#include <lamella/recover/results.h>
#include <lamella/run/built_scene.h>
#include <lamella/solve/structure.h>

#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// Throws InputError for the entry `Find` if nothing grows with the load
  /// factor: no load except temperatures, no weight, no prescribed motion.
  /// Loads with factors of their own do not count; @p factor has these.
  void
  check_load_growth(const Structure                     &structure,
                    const std::vector<ContactInterface> &contacts,
                    const LoadFactor                    &factor);

  /// Searches the load factor at which the smallest reserve factor of all plies
  /// is 1. The lower end of the search interval is a load factor without
  /// failure. At the upper end a ply fails, or no solution exists (rotations
  /// beyond their limit, contact that does not converge). The first interval is
  /// that of the load steps. If no ply fails in them, the largest load factor
  /// is doubled up to ten times. Bisection reduces the interval to 0.1 %. Its
  /// upper end is the result.
  class FirstFailureSearch
  {
  public:
    /// Function that solves the scene at the load factor of its first argument.
    /// The second argument is the index, from 0, of the load step that contains
    /// this factor; it is the number of load steps if the factor exceeds all of
    /// them. The third argument receives the reserve factors of plies. Throws
    /// NumericsError if there is no solution.
    using TrySolve = std::function<FailureTrial(const double,
                                                const unsigned int,
                                                std::vector<PlyReserve> &)>;

    /// Constructs a search by @p try_load, which prints its trials to @p out.
    FirstFailureSearch(const TrySolve &try_load, std::ostream &out);

    /// Returns the first failure, searched after the solved load @p steps.
    FirstFailure
    find(const std::vector<StepResults> &steps);

    /// Returns a warning if no ply fails, or if no solution exists at failure.
    std::string
    note() const;

  private:
    /// Updates the interval by reserve factors at @p factor; true for failure.
    bool
    judge(const double factor, const std::vector<PlyReserve> &plies);
    /// Solves at @p factor in load step @p load_step and updates the interval.
    void
    attempt(const double factor, const unsigned int load_step);
    /// Returns the lowest known load factor with failure or without a solution.
    std::optional<double>
    upper() const;

    TrySolve      try_load;
    std::ostream &out;
    FirstFailure  result;
    /// Lowest load factor without a solution, and the reason.
    std::optional<double> without_state;
    std::string           reason;
  };
} // namespace lamella

#endif
