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
  /// An entry of a parameter file (scene): its path and its text. Accessors
  /// convert the text to the requested type or throw InputError with path,
  /// text, violated condition and remedy. Callers report violations of further
  /// conditions by refuse(). The entry does not refer to its ParameterHandler.
  class Entry
  {
  public:
    /// Stores @p path, e.g. `Body b/Kinematics/Theory`, and trimmed @p text.
    Entry(const std::string &path, const std::string &text);

    /// Returns the path: subsections and entry name, separated by slashes.
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

    /// Returns true if the text is empty: an optional entry without value.
    bool
    is_empty() const
    {
      return what.empty();
    }

    /// Throws InputError with the path and the text of this entry. @p rule is
    /// the violated condition, without a full stop. @p remedy tells in whole
    /// sentences how to correct the entry, or is empty.
    [[noreturn]] void
    refuse(const std::string &rule, const std::string &remedy = "") const;

    /// Throws InputError::missing() with @p remedy, since this entry is empty.
    [[noreturn]] void
    refuse_missing(const std::string &remedy) const;

    /// Returns the text as a number (see number_error()). Throws InputError
    /// unless it is zero or its magnitude is from 1e-30 to 1e30.
    double
    number() const;

    /// Returns the substring @p piece as a number; messages quote @p piece.
    double
    number(const std::string &piece) const;

    /// Returns the text as a positive number. Throws InputError if it is not a
    /// positive number, or if the text is empty.
    double
    positive() const;

    /// Returns the text as an integer, which may be written as 1e3 or 8.0.
    /// Throws InputError unless it is an integer from @p least to @p most.
    unsigned int
    whole(const unsigned int least, const unsigned int most) const;

    /// Returns the numbers of a comma-separated list (see split()); an empty
    /// list for an empty text. Throws InputError as number() does.
    std::vector<double>
    numbers() const;
    /// Returns the numbers of a comma-separated list: positions that divide a
    /// length @p end, called @p name in messages, into intervals. Throws
    /// InputError unless the numbers ascend strictly between 0 and @p end.
    std::vector<double>
    ascending(const double end, const std::string &name) const;
    /// Returns integers from @p least to @p most, separated by commas.
    std::vector<unsigned int>
    whole_numbers(const unsigned int least, const unsigned int most) const;

    /// Returns a position or direction, which must be three numbers.
    dealii::Point<3>
    point() const;
    /// Returns the substring @p piece of the text as a point, as point() does.
    dealii::Point<3>
    point(const std::string &piece) const;

    /// Returns true if the text is `true`, false if it is `false`. Throws
    /// InputError for any other text.
    bool
    boolean() const;

    /// Returns the value of the enumeration @p E whose name is the text. Throws
    /// InputError, which lists the valid names, if there is no such value.
    template <typename E>
    E
    choice() const
    {
      if (const auto value = named<E>(what))
        return *value;
      refuse_choice(
        selection<E>().description(dealii::Patterns::PatternBase::Machine));
    }

    /// Returns the trimmed substrings of the text between the characters @p
    /// separator, including empty ones; an empty list for an empty text.
    std::vector<std::string>
    items(const char separator = ',') const
    {
      return split(what, separator);
    }

    /// Returns the text if it is one of @p names. Otherwise throws InputError:
    /// `there is no KIND 'text'`, with the most similar name in LIST as the
    /// remedy, where @p kind and @p list are inserted for KIND and LIST.
    const std::string &
    among(const std::vector<std::string> &names,
          const std::string              &kind,
          const std::string              &list) const;

  private:
    [[noreturn]] void
    refuse_choice(const std::string &pattern) const;

    std::string where, what;
  };

  /// The entries of the current subsection of a ParameterHandler and its path.
  /// The handler must outlive this object and must not leave the subsection.
  class Entries
  {
  public:
    /// Stores the @p path of the current subsection, empty at the top level.
    Entries(const dealii::ParameterHandler &prm, const std::string &path)
      : prm(prm)
      , subsection(path)
    {}

    /// Returns the path, e.g. `Body upper/Kinematics`; empty at the top level.
    const std::string &
    path() const
    {
      return subsection;
    }

    /// Returns the entry @p name. deal.II throws if it is not declared.
    Entry
    operator[](const std::string &name) const;

    /// Throws InputError for the whole subsection, e.g. for a conflict between
    /// its entries. The arguments are those of Entry::refuse().
    [[noreturn]] void
    refuse(const std::string &rule, const std::string &remedy = "") const;

  private:
    const dealii::ParameterHandler &prm;
    std::string                     subsection;
  };
} // namespace lamella

#endif
