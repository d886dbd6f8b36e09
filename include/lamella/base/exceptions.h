// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `base`: what every other room speaks in. It owns the names of
// vectors, matrices and constraints, rows (a linear part and a constant), the
// two kinds of errors and how a program ends, text, units, files that are
// written whole or not at all, memory and processes. It knows no mechanics and
// never solves anything.

#ifndef lamella_base_exceptions_h
#define lamella_base_exceptions_h

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace lamella
{
  /**
   * A fault of the input or of the scene: exit status 1. The message names the
   * entry, the value, the rule and the remedy, for the user and not for us.
   */
  class InputError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /**
   * A failure of the numerics (singular, indefinite, not converged, beyond the
   * range of the linear theory): exit status 2. The message says what to try.
   */
  class NumericsError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /// How a program came to its end.
  struct Outcome
  {
    /// 0 done, 1 InputError, 2 NumericsError or anything else.
    int status = 0;
    /// For the user; empty where the status is 0.
    std::string message;
  };

  /// Runs @p program and turns whatever it throws into its outcome.
  Outcome
  outcome_of(const std::function<void()> &program);

  /**
   * Runs @p program and returns its exit status; what it throws becomes one
   * message on the standard error stream. The `main` of a small program.
   */
  int
  run_and_tell(const std::function<void()> &program);

  /**
   * The member of @p valid with the smallest edit distance (Levenshtein) to
   * @p name, letters compared without case; empty if @p valid is empty.
   */
  std::string
  nearest_name(const std::string &name, const std::vector<std::string> &valid);
} // namespace lamella

#endif
