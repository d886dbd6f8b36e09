// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `base`: utilities of all other modules. Types of vectors, matrices
// and constraints; affine functionals; exceptions and exit status; text, units,
// files, memory, MPI. It is independent of mechanics and solvers.

#ifndef lamella_base_exceptions_h
#define lamella_base_exceptions_h

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace lamella
{
  /// A message for the user and its identifier, by which tests and other
  /// programs recognize the message. The source code has both in one string,
  /// `module.fault: TEXT`, e.g. `contact.no-pairs: no nodes face each other`.
  /// doc/reference/messages.md lists all identifiers.
  struct Message
  {
    /// Splits @p source, of the form `ID: TEXT`, or `TEXT [ID]` if taken from
    /// the message of an earlier exception. The identifier is empty if
    /// @p source has neither form.
    explicit Message(const std::string &source);

    /// Returns the text for the user, `TEXT [ID]`.
    std::string
    shown() const;

    std::string identifier; ///< Identifier `module.fault`; may be empty.
    std::string text;       ///< Text for the user, without the identifier.
  };

  /// An error in the input, such as the parameter file (scene); the exit status
  /// is 1. The message consists of fields with accessors:
  ///   PATH = VALUE: RULE. REMEDY [ID]
  /// e.g. `Contact c/Penalty = -1: must be positive. Leave it out for auto.
  /// [entry.not-positive]`. For ID, see Message. main() catches this exception
  /// and ends the program. at() adds the line of the file.
  class InputError : public std::runtime_error
  {
  public:
    /// Constructs an error that concerns no entry, but e.g. a file. rule() is
    /// @p message, in whole sentences; the other fields are empty.
    explicit InputError(const std::string &message);

    /// Constructs an error of one entry. The message abridges long values.
    ///
    /// @param path the entry or subsection, `Body upper/Kinematics/Theory`
    /// @param value text of the entry; empty for a whole subsection
    /// @param rule violated condition or fault, without a full stop
    /// @param remedy how to correct the input, in whole sentences; may be empty
    InputError(const std::string &path,
               const std::string &value,
               const std::string &rule,
               const std::string &remedy);

    /// Returns the error of a missing required entry, with the message `PATH is
    /// missing: REMEDY`. @p remedy is e.g. `ID: give a length.`
    static InputError
    missing(const std::string &path, const std::string &remedy);

    /// Returns the identifier, e.g. `entry.not-positive`.
    const std::string &
    identifier() const
    {
      return id;
    }

    /// Returns `ID: TEXT` with the identifier of this error and @p text for
    /// TEXT, to construct another error with the same identifier.
    std::string
    marked(const std::string &text) const
    {
      return id.empty() ? text : id + ": " + text;
    }

    /// Returns a copy of this error whose message begins with @p place, a
    /// position in a file, `FILE:LINE: `. Only the message changes.
    InputError
    at(const std::string &place) const;

    /// Returns true if at() has already added file and line to the message.
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
    /// Returns the text of the entry, not abridged; empty if there is no entry.
    const std::string &
    value() const
    {
      return entry_value;
    }
    /// Returns the violated condition; the whole message if there is no entry.
    const std::string &
    rule() const
    {
      return rule_text;
    }
    /// Returns the advice for correcting the input; may be empty.
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

  /// A numerical failure: a singular or indefinite matrix, no convergence, or
  /// deformations beyond linear theory. The exit status is 2. The message has a
  /// remedy. In a parallel run, all processes throw this exception together.
  class NumericsError : public std::runtime_error
  {
  public:
    /// Constructs the error from @p message of the form `ID: TEXT`.
    explicit NumericsError(const std::string &message)
      : std::runtime_error(Message(message).shown())
    {}
  };

  /// Thrown at the end of a complete computation if the estimated error of a
  /// quantity of interest exceeds its tolerance; the exit status is 3.
  class ToleranceNotMet : public NumericsError
  {
  public:
    using NumericsError::NumericsError;
  };

  /// Exit status and error message of a program.
  struct Outcome
  {
    /// Exit status: 0 success, 1 InputError, 2 NumericsError or any other
    /// exception, 3 ToleranceNotMet.
    int status = 0;
    /// Message for the user; empty if the status is 0. Long words are abridged.
    std::string message;
  };

  /// Runs @p program and returns its outcome. For std::bad_alloc, the status is
  /// 2 and the message has a remedy. For other exceptions, the status is 2 and
  /// the message reports an internal error.
  Outcome
  outcome_of(const std::function<void()> &program);

  /// Runs @p program and returns the exit status, for the `main` of a small
  /// serial program. Prints the message of an exception to standard error.
  int
  run_and_report(const std::function<void()> &program);

  /// Returns the first member of @p valid with the smallest Levenshtein
  /// distance to @p name, ignoring case; empty if @p valid is empty.
  std::string
  nearest_name(const std::string &name, const std::vector<std::string> &valid);
} // namespace lamella

#endif
