// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_entry_h
#define lamella_base_entry_h

#include <lamella/base/exceptions.h>
#include <lamella/base/names.h>
#include <lamella/base/text.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace lamella
{
  /// An entry of a scene: its path and its text. Accessors return the value in
  /// the requested form or throw InputError with path, text, rule and remedy;
  /// refuse() is for checks by the caller. An entry is independent of its
  /// parameter handler. A piece of an entry may become an Entry with the path
  /// of the whole.
  class Entry
  {
  public:
    /// Stores @p path, as `Body upper/Kinematics/Theory`, and @p text, trimmed.
    Entry(const std::string &path, const std::string &text);

    /// Returns the path for messages, subsections first, separated by slashes.
    const std::string &
    path() const
    {
      return where;
    }

    /// Returns the text as written, without white space at its ends.
    const std::string &
    text() const
    {
      return what;
    }

    /// Returns whether the text is empty, the default of an optional entry.
    bool
    is_empty() const
    {
      return what.empty();
    }

    /// Throws InputError(path, value, rule, remedy). @p rule is the condition
    /// or the fault, without a full stop; @p remedy is whole sentences, or
    /// empty.
    [[noreturn]] void
    refuse(const std::string &rule, const std::string &remedy = "") const;

    /// Throws InputError::missing() for a required entry, with @p remedy.
    [[noreturn]] void
    refuse_missing(const std::string &remedy) const;

    /// Returns the number that the whole text spells (see number_error()).
    /// Throws InputError unless it is zero or of a size between 1e-30 and 1e30.
    double
    number() const;

    /// Returns the number in a @p piece of the text. Messages quote the piece.
    double
    number(const std::string &piece) const;

    /// Returns a positive number. Throws InputError also if the entry is empty.
    double
    positive() const;

    /// Returns a whole number from @p least to @p most, in any spelling (1e3,
    /// 8.0). Throws InputError for anything else.
    unsigned int
    whole(const unsigned int least, const unsigned int most) const;

    /// Returns the numbers between commas (outside of parentheses, see
    /// split()); none for an empty text. Throws InputError as number() does.
    std::vector<double>
    numbers() const;
    /// Returns numbers() that ascend between 0 and @p end, called @p name in
    /// messages: positions that divide a length. Throws InputError for others.
    std::vector<double>
    ascending(const double end, const std::string &name) const;
    /// Returns numbers() that are whole, each from @p least to @p most.
    std::vector<unsigned int>
    whole_numbers(const unsigned int least, const unsigned int most) const;

    /// Returns three numbers between commas, a position or direction in the
    /// axes of the entry. Throws InputError for another count.
    dealii::Point<3>
    point() const;
    /// Returns the point in a @p piece of the text.
    dealii::Point<3>
    point(const std::string &piece) const;

    /// Returns `true` or `false`. Throws InputError for any other word.
    bool
    boolean() const;

    /// Returns the value of the enumeration @p E with this name. Throws
    /// InputError that lists the names if there is none.
    template <typename E>
    E
    choice() const
    {
      if (const auto value = named<E>(what))
        return *value;
      refuse_choice(
        selection<E>().description(dealii::Patterns::PatternBase::Machine));
    }

    /// Returns the trimmed pieces between @p separator; none for an empty text.
    /// Keeps empty pieces between two separators.
    std::vector<std::string>
    items(const char separator = ',') const
    {
      return split(what, separator);
    }

    /// Returns the text, which must be among @p names of the scene's @p list.
    /// Throws InputError otherwise: `there is no KIND 'text'. The nearest of
    /// LIST ...`
    const std::string &
    among(const std::vector<std::string> &names,
          const std::string              &kind,
          const std::string              &list) const;

  private:
    [[noreturn]] void
    refuse_choice(const std::string &pattern) const;

    std::string where, what;
  };

  /// The entries of the current subsection of a ParameterHandler, with its
  /// path. The handler must outlive the object and stay in that subsection.
  class Entries
  {
  public:
    /// Stores the @p path of the current subsection, empty at the top level.
    Entries(const dealii::ParameterHandler &prm, const std::string &path)
      : prm(prm)
      , subsection(path)
    {}

    /// Returns the path, as `Body upper/Kinematics`; empty at the top level.
    const std::string &
    path() const
    {
      return subsection;
    }

    /// Returns the entry @p name, which must be declared (otherwise deal.II
    /// throws).
    Entry
    operator[](const std::string &name) const;

    /// Throws InputError for the subsection as a whole, without a value, such
    /// as conflicts between entries.
    [[noreturn]] void
    refuse(const std::string &rule, const std::string &remedy = "") const;

  private:
    const dealii::ParameterHandler &prm;
    std::string                     subsection;
  };
} // namespace lamella

#endif
