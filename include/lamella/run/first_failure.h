// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_first_failure_h
#define lamella_run_first_failure_h

#include <lamella/contact/gap_constraints.h>
#include <lamella/recover/results.h>
#include <lamella/solve/structure.h>

#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// Throws InputError (path `Find`) if nothing increases with the load factor:
  /// no load but temperature, no weight, no motion of a support or obstacle.
  void
  check_load_growth(const Structure                     &structure,
                    const std::vector<ContactInterface> &contacts);

  /// Search for the load factor at which the smallest reserve factor is 1, by
  /// bisection between a safe load factor and an upper one, at which a ply
  /// fails or no solution exists (rotations beyond their limit, contact that
  /// does not converge). Load steps are evaluated first; if all are safe, the
  /// largest load factor is doubled up to ten times. The interval is then
  /// bisected to 0.1 %. The result is a failure, or the load factor above which
  /// no solution exists, whichever is lower.
  class FirstFailureSearch
  {
  public:
    /// Function that solves at the load factor of its first argument. The
    /// second argument is the number (from 0) of the load step that contains
    /// this factor, or the number of steps if it is beyond the last. Sets the
    /// third argument to the reserve factors. Throws NumericsError on failure.
    using TrySolve = std::function<FailureTrial(const double,
                                                const unsigned int,
                                                std::vector<PlyReserve> &)>;

    /// Keeps a reference to @p out and prints a line per trial to it.
    FirstFailureSearch(const TrySolve &try_load, std::ostream &out);

    /// Returns the first failure after the load @p steps with reserve factors.
    FirstFailure
    find(const std::vector<StepResults> &steps);

    /// Returns a note if no failure or no solution at failure is found.
    std::string
    note() const;

  private:
    /// Narrows the interval by the result at @p factor; true if a ply fails.
    bool
    judge(const double factor, const std::vector<PlyReserve> &plies);
    /// Solves at @p factor in load step @p load_step, updates the interval.
    void
    attempt(const double factor, const unsigned int load_step);
    /// Returns the lowest known load factor of failure or without solution.
    std::optional<double>
    upper() const;
    /// Returns true if the interval is small enough.
    bool
    is_interval_narrow() const;

    TrySolve      try_load;
    std::ostream &out;
    FirstFailure  result;
    /// Lowest load factor without a solution, and the reason.
    std::optional<double> without_state;
    std::string           reason;
  };
} // namespace lamella

#endif
