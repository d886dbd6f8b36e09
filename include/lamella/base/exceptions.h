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
   * A message for the user and its identifier, which tests and other programs
   * read. The source writes both in one text, `room.fault: TEXT`, the fault in
   * lower-case words with hyphens: `contact.no-pairs: no nodes face each other`
   * (doc/reference/messages.md lists them).
   */
  struct Message
  {
    /// Splits `ID: TEXT`; or TEXT ` [ID]`, the message of an earlier exception
    /// within @p source; the identifier is empty if there is neither.
    explicit Message(const std::string &source);

    /// Returns the text for the user, TEXT ` [ID]`.
    std::string
    shown() const;

    std::string identifier, text;
  };

  /**
   * An error in the input or the scene: exit status 1. The message is made of
   * fields, which handlers read instead of it:
   *   PATH = VALUE: RULE. REMEDY [ID]
   * e.g. `Contact c/Penalty = -1: must be positive. Leave it out for auto.
   * [entry.not-positive]`. The source writes ID before the rule (Message).
   *
   * Scenes are checked before computing wherever possible. main() ends the run
   * with this error. Handlers on the way may add the place in the file (at()).
   */
  class InputError : public std::runtime_error
  {
  public:
    /// Constructs an error of no entry, as of the command line, a file or a
    /// folder: @p message, whole sentences, is the rule; other fields are
    /// empty.
    explicit InputError(const std::string &message);

    /**
     * Constructs an error of an entry. The message abridges long values.
     *
     * @param path the entry or subsection, `Body upper/Kinematics/Theory`
     * @param value its text; empty for a whole subsection or an empty entry
     * @param rule what it must be, or what is wrong, without a full stop
     * @param remedy what to do about it, whole sentences; may be empty
     */
    InputError(const std::string &path,
               const std::string &value,
               const std::string &rule,
               const std::string &remedy);

    /// Returns the error of a missing required entry: `PATH is missing:
    /// REMEDY`. @p remedy continues that sentence, as `ID: give a length.`
    static InputError
    missing(const std::string &path, const std::string &remedy);

    /// Returns the identifier, as `entry.not-positive`.
    const std::string &
    identifier() const
    {
      return id;
    }

    /// Returns @p text with this identifier before it, the rule of another
    /// error with the same reason.
    std::string
    marked(const std::string &text) const
    {
      return id.empty() ? text : id + ": " + text;
    }

    /// Returns this error with @p place, `FILE:LINE: `, before its message and
    /// unchanged fields.
    InputError
    at(const std::string &place) const;

    /// Returns whether at() has already put a place before the message.
    bool
    has_place() const
    {
      return placed;
    }
    /// Returns the path of the entry or subsection; empty if there is none.
    const std::string &
    path() const
    {
      return entry_path;
    }
    /// Returns the entry's text, not abridged.
    const std::string &
    value() const
    {
      return entry_value;
    }
    /// Returns the rule that is broken; without an entry, the whole message.
    const std::string &
    rule() const
    {
      return rule_text;
    }
    /// Returns the remedy; may be empty.
    const std::string &
    remedy() const
    {
      return remedy_text;
    }

  private:
    InputError(const std::string &shown, const InputError &other);

    std::string id, entry_path, entry_value, rule_text, remedy_text;
    bool        placed = false;
  };

  /// A numerical failure (singular, indefinite, not converged, beyond linear
  /// theory): exit status 2. The message has a remedy. Processes that share the
  /// work all throw it, since their decisions use the same numbers.
  class NumericsError : public std::runtime_error
  {
  public:
    /// Shows @p message with its identifier at the end (Message).
    explicit NumericsError(const std::string &message)
      : std::runtime_error(Message(message).shown())
    {}
  };

  /// The end of a run that is complete, but does not meet the tolerance of a
  /// goal: exit status 3.
  class ToleranceNotMet : public NumericsError
  {
  public:
    using NumericsError::NumericsError;
  };

  /// Result of a program. The status is what the shell, a test or `lamella
  /// trade` receives.
  struct Outcome
  {
    /// Exit status: 0 done, 1 InputError, 2 NumericsError or anything else, 3
    /// done, but the tolerance of a goal is not met.
    int status = 0;
    /// Message for the user; empty if the status is 0. Values of an InputError
    /// longer than 400 characters are abridged.
    std::string message;
  };

  /// Runs @p program and returns its outcome. std::bad_alloc becomes status 2
  /// with a remedy, other unknown exceptions status 2 as an internal error.
  Outcome
  outcome_of(const std::function<void()> &program);

  /// Runs @p program as the `main` of a small program: prints a message to
  /// standard error if it throws, and returns the exit status. Not for MPI
  /// processes that must agree on the status.
  int
  run_and_report(const std::function<void()> &program);

  /// Returns the member of @p valid with the smallest Levenshtein distance to
  /// @p name, ignoring case; the first of several, or empty if @p valid is.
  /// Costs the product of both lengths for each.
  std::string
  nearest_name(const std::string &name, const std::vector<std::string> &valid);
} // namespace lamella

#endif
