// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_first_failure_h
#define lamella_run_first_failure_h

#include <lamella/contact/gap_rows.h>
#include <lamella/recover/results.h>
#include <lamella/solve/structure.h>

#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// Throws InputError of `Find` if no load factor changes anything: without a
  /// load that is not zero (temperatures do not grow), weight, or a
  /// displacement of a support or an obstacle.
  void
  require_growth(const Structure                     &structure,
                 const std::vector<ContactInterface> &contacts);

  /**
   * Seeks the load factor at which the smallest reserve factor is 1, between a
   * load factor that is safe and an upper end: one at which a ply fails, or at
   * which no state is to be had (rotations beyond their limit, a contact that
   * does not settle). Load steps come first; where all of them are safe, the
   * largest is doubled up to ten times. Then the interval is halved until its
   * ends are within 0.1 %.
   *
   * So a failure below the load at which states end is found, and where states
   * end first that load is.
   */
  class FirstFailureSearch
  {
  public:
    /// Solves at a load factor on the way of a load step, beyond the last one
    /// where there is none of that number, and puts the reserve factors there
    /// into the third argument. Throws NumericsError where there is no state.
    using Try = std::function<FailureTrial(const double,
                                           const unsigned int,
                                           std::vector<PlyReserve> &)>;

    /// @p out is told of each trial, a line each, and referred to.
    FirstFailureSearch(const Try &try_load, std::ostream &out);

    /// @p steps are those of the run, with the reserve factors of their plies.
    FirstFailure
    find(const std::vector<StepResults> &steps);

    /// What the user should know of it, a sentence without a full stop: that no
    /// ply fails, or where states end. Empty if neither.
    std::string
    note() const;

  private:
    /// Whether a ply fails at @p factor, where the plies have @p plies.
    bool
    judge(const double factor, const std::vector<PlyReserve> &plies);
    /// Solves at @p factor on the way of load step @p leg and judges; without a
    /// state that is an upper end.
    void
    attempt(const double factor, const unsigned int leg);
    /// The nearer one of the two upper ends; none where there is no such end.
    std::optional<double>
    upper() const;
    /// Whether the interval is as narrow as is asked for.
    bool
    is_narrow() const;

    Try           try_load;
    std::ostream &out;
    FirstFailure  result;
    /// Where there is no state, and why.
    std::optional<double> without_state;
    std::string           reason;
  };
} // namespace lamella

#endif
