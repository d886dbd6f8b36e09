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
   * A fault of the input or of the scene: exit status 1. What it is about is
   * kept in fields, and the message is made of them:
   *   PATH = VALUE: RULE. REMEDY
   * e.g. `Contact c/Penalty = -1: must be positive. Leave it out for auto.`
   * Catchers ask the fields; nobody reads the message but the user.
   *
   * A scene is refused before anything is computed wherever that can be known:
   * whoever meets the fault throws this, and main() ends the run with it. Those
   * who catch it on the way know more: the place of the entry in its file
   * (at()), or that the entry is one of a ladder.
   */
  class InputError : public std::runtime_error
  {
  public:
    /// Of no entry: of the command line, a file, a folder. The message is the
    /// rule; path, value and remedy are empty. @p message is whole sentences.
    explicit InputError(const std::string &message);

    /**
     * @param path   the entry or subsection, `Body upper/Kinematics/Theory`
     * @param value  what stands there; empty where the fault is of the whole
     *               subsection, or where nothing stands there
     * @param rule   what it must be, or what is wrong, without a full stop
     * @param remedy what to do about it, whole sentences; empty where the rule
     *               says that already
     * Values that are longer than anybody reads are abridged in the message.
     */
    InputError(const std::string &path,
               const std::string &value,
               const std::string &rule,
               const std::string &remedy);

    /// An entry that must be given and is not: `PATH is missing: REMEDY`.
    /// @p remedy begins in the middle of that sentence, as `give a length.`
    static InputError
    missing(const std::string &path, const std::string &remedy);

    /// The same fault with @p place, `FILE:LINE: `, before its message. The
    /// fields stay as they are, so that it can still be asked what it is about.
    InputError
    at(const std::string &place) const;

    /// Whether at() has put a place before the message: it is done once only.
    bool
    has_place() const
    {
      return placed;
    }
    /// The entry or subsection; empty if the fault is of no entry.
    const std::string &
    path() const
    {
      return entry_path;
    }
    /// The text that stands there, not abridged.
    const std::string &
    value() const
    {
      return entry_value;
    }
    /// What it must be, or what is wrong; of a fault of no entry the whole
    /// message.
    const std::string &
    rule() const
    {
      return broken_rule;
    }
    /// What to do about it; may be empty.
    const std::string &
    remedy() const
    {
      return way_out;
    }

  private:
    std::string entry_path, entry_value, broken_rule, way_out;
    bool        placed = false;
  };

  /**
   * A failure of the numerics (singular, indefinite, not converged, beyond the
   * range of the linear theory): exit status 2. The message says what to try.
   * Where several processes share the work it is thrown on all of them, since
   * they take the same decisions from the same numbers.
   */
  class NumericsError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /// How a program came to its end. The status is what the shell, a test or the
  /// ladder of `lamella trade` sees.
  struct Outcome
  {
    /// 0 done, 1 InputError, 2 NumericsError or anything else.
    int status = 0;
    /// For the user; empty where the status is 0. Words of an InputError that
    /// are longer than 400 characters are abridged.
    std::string message;
  };

  /// Runs @p program and turns whatever it throws into its outcome. Memory that
  /// the system refuses (std::bad_alloc) becomes status 2 with a remedy; any
  /// other exception becomes status 2 as an internal error.
  Outcome
  outcome_of(const std::function<void()> &program);

  /**
   * Runs @p program and returns its exit status; what it throws becomes one
   * message on the standard error stream. The `main` of a small program. Not
   * for processes of MPI that must agree on the status: each tells its own.
   */
  int
  run_and_tell(const std::function<void()> &program);

  /**
   * The member of @p valid with the smallest edit distance (Levenshtein) to
   * @p name, letters compared without case; empty if @p valid is empty. The
   * first of several that are equally near. The cost is the product of the
   * lengths of both names, for each of @p valid.
   */
  std::string
  nearest_name(const std::string &name, const std::vector<std::string> &valid);
} // namespace lamella

#endif
