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
  /// Throws InputError of `Find` if nothing grows with the load factor: no load
  /// but temperatures, weight, or displacement of a support or an obstacle.
  void
  check_load_growth(const Structure                     &structure,
                    const std::vector<ContactInterface> &contacts);

  /**
   * Search for the load factor at which the smallest reserve factor is 1. The
   * interval is between a safe load factor and an upper end, at which a ply
   * fails or no solution exists (rotations beyond their limit, contact without
   * convergence). Load steps come first; if all are safe, the largest is
   * doubled up to ten times. The interval is then bisected to 0.1 %. The result
   * is a failure or the load at which solutions are lost, whichever comes
   * first.
   */
  class FirstFailureSearch
  {
  public:
    /// Function that solves at a load factor within a load step of a number (or
    /// beyond the last one) and sets the reserve factors in the third argument.
    /// Throws NumericsError without a solution.
    using TrySolve = std::function<FailureTrial(const double,
                                                const unsigned int,
                                                std::vector<PlyReserve> &)>;

    /// Prints a line per trial to @p out, which is referred to.
    FirstFailureSearch(const TrySolve &try_load, std::ostream &out);

    /// Returns the first failure after the run's @p steps with reserve factors.
    FirstFailure
    find(const std::vector<StepResults> &steps);

    /// Returns a sentence if no ply fails or solutions are lost; else empty.
    std::string
    note() const;

  private:
    /// Returns whether a ply fails at @p factor with reserve factors @p plies.
    bool
    judge(const double factor, const std::vector<PlyReserve> &plies);
    /// Solves at @p factor within step @p load_step and narrows the interval.
    void
    attempt(const double factor, const unsigned int load_step);
    /// Returns the smaller one of the two upper ends, if any.
    std::optional<double>
    upper() const;
    /// Returns whether the interval is narrow enough.
    bool
    is_interval_narrow() const;

    TrySolve      try_load;
    std::ostream &out;
    FirstFailure  result;
    /// Load factor without a solution, and the reason.
    std::optional<double> without_state;
    std::string           reason;
  };
} // namespace lamella

#endif
