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
  /// The path and the text of one entry of a parameter file (scene). Accessors
  /// convert the text to the requested type or throw InputError with path,
  /// text, violated condition and remedy. Callers report failures of further
  /// checks by refuse(). The entry does not refer to its ParameterHandler. A
  /// substring may become a separate Entry with the same path.
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

    /// Returns whether the text is empty, as for an unset optional entry.
    bool
    is_empty() const
    {
      return what.empty();
    }

    /// Throws InputError with the path and the text of this entry. @p rule is
    /// the violated condition or the fault, without a full stop; @p remedy
    /// consists of whole sentences or is empty.
    [[noreturn]] void
    refuse(const std::string &rule, const std::string &remedy = "") const;

    /// Throws InputError::missing() with @p remedy for this empty entry.
    [[noreturn]] void
    refuse_missing(const std::string &remedy) const;

    /// Returns the text converted to a number (see number_error()). Throws
    /// InputError if its magnitude is not zero or from 1e-30 to 1e30.
    double
    number() const;

    /// Converts the substring @p piece to a number; messages quote @p piece.
    double
    number(const std::string &piece) const;

    /// Returns a positive number. Throws InputError also if the entry is empty.
    double
    positive() const;

    /// Returns an integer from @p least to @p most, which may be written as 1e3
    /// or 8.0. Throws InputError for any other text.
    unsigned int
    whole(const unsigned int least, const unsigned int most) const;

    /// Returns the numbers of a comma-separated list (see split()); an empty
    /// list for an empty text. Throws InputError as number() does.
    std::vector<double>
    numbers() const;
    /// Returns the positions that divide the length @p end into intervals:
    /// numbers that ascend strictly between 0 and @p end. Messages call the
    /// length @p name. Throws InputError for other numbers.
    std::vector<double>
    ascending(const double end, const std::string &name) const;
    /// Returns a list of integers, each from @p least to @p most.
    std::vector<unsigned int>
    whole_numbers(const unsigned int least, const unsigned int most) const;

    /// Returns a position or direction: three numbers separated by commas, in
    /// the coordinate system that the entry uses. Throws InputError if there
    /// are not three.
    dealii::Point<3>
    point() const;
    /// Returns the substring @p piece converted to a point.
    dealii::Point<3>
    point(const std::string &piece) const;

    /// Returns whether the text is `true`. Throws InputError unless the text is
    /// `true` or `false`.
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

    /// Splits the text at each @p separator and returns the trimmed substrings,
    /// including empty ones; an empty list for an empty text.
    std::vector<std::string>
    items(const char separator = ',') const
    {
      return split(what, separator);
    }

    /// Returns the text if it is one of @p names. Otherwise throws InputError:
    /// `there is no KIND 'text'. The nearest of LIST ...`, with @p kind and
    /// @p list inserted.
    const std::string &
    among(const std::vector<std::string> &names,
          const std::string              &kind,
          const std::string              &list) const;

  private:
    [[noreturn]] void
    refuse_choice(const std::string &pattern) const;

    std::string where, what;
  };

  /// The entries of the current subsection of a ParameterHandler and the path
  /// of that subsection. The handler must outlive this object and must not
  /// leave that subsection.
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
    /// its entries. Arguments as in Entry::refuse().
    [[noreturn]] void
    refuse(const std::string &rule, const std::string &remedy = "") const;

  private:
    const dealii::ParameterHandler &prm;
    std::string                     subsection;
  };
} // namespace lamella

#endif
