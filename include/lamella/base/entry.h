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
  /**
   * An entry of a scene: its path and the text that stands there. Whoever reads
   * it asks for what it must be and gets that or an InputError with the path,
   * the text, the rule and the remedy; what only the reader can judge it says
   * with refuse().
   *
   * An entry is a value: it copies path and text, and outlives the parameter
   * handler that it was read from. Numbers of a scene all pass the same checks
   * here (fault_of_number()), and every message names its entry in the same
   * form. A piece of an entry becomes an Entry of its own, with the path of the
   * whole one, where a function takes no less.
   */
  class Entry
  {
  public:
    /// @p path as in `Body upper/Kinematics/Theory`; @p text is trimmed.
    /// Nothing is checked here: an entry that nobody asks for is never refused.
    Entry(const std::string &path, const std::string &text);

    /// For messages, subsections first, with slashes between.
    const std::string &
    path() const
    {
      return where;
    }

    /// As it was written, without white space at its ends.
    const std::string &
    text() const
    {
      return what;
    }

    /// Whether nothing stands there: of an optional entry, its default.
    bool
    is_empty() const
    {
      return what.empty();
    }

    /// Throws InputError: this text breaks the @p rule. @p rule says what the
    /// text must be, or what is wrong with it, without a full stop; @p remedy
    /// is whole sentences, empty where the rule says it all. The message is
    /// that of InputError(path, value, rule, remedy).
    [[noreturn]] void
    refuse(const std::string &rule, const std::string &remedy = "") const;

    /// Throws InputError: an entry that has to be given is not. @p remedy says
    /// what to give. The message is that of InputError::missing().
    [[noreturn]] void
    is_missing(const std::string &remedy) const;

    /// The finite number that the whole text spells (fault_of_number() has the
    /// rules). Throws InputError unless the text is one finite number, zero or
    /// of a size between 1e-30 and 1e30. No unit is attached: the caller knows
    /// it.
    double
    number() const;

    /// The same of a @p piece of the text. The message names the whole entry
    /// and quotes the piece.
    double
    number(const std::string &piece) const;

    /// A number above zero. Throws InputError as well if the entry is empty.
    double
    positive() const;

    /// A whole number from @p least to @p most. Any spelling of a whole number
    /// does, as 1e3 or 8.0; throws InputError for other numbers, for none and
    /// for several.
    unsigned int
    whole(const unsigned int least, const unsigned int most) const;

    /// One of each piece between commas; none where the text is empty. Commas
    /// within parentheses do not separate (split()). Throws InputError for a
    /// piece that number() would refuse.
    std::vector<double>
    numbers() const;
    /// numbers() that ascend between 0 and @p end, which @p name calls; throws
    /// InputError for others: positions along something that end one piece of
    /// it and begin the next.
    std::vector<double>
    ascending(const double end, const std::string &name) const;
    /// numbers() that are whole, each from @p least to @p most.
    std::vector<unsigned int>
    wholes(const unsigned int least, const unsigned int most) const;

    /// Three numbers between commas. A position or a direction in whatever axes
    /// the entry means; throws InputError for other than three.
    dealii::Point<3>
    point() const;
    /// Of a @p piece of the text, as entries with several points have between
    /// semicolons.
    dealii::Point<3>
    point(const std::string &piece) const;

    /// `true` or `false`. Throws InputError for any other word, `yes` and `1`
    /// included.
    bool
    truth() const;

    /// The value of the enumeration @p E with this name. Throws InputError that
    /// lists the names (Names<E>) if it is none of them.
    template <typename E>
    E
    choice() const
    {
      if (const auto value = named<E>(what))
        return *value;
      refuse_choice(
        selection<E>().description(dealii::Patterns::PatternBase::Machine));
    }

    /// Pieces between @p separator, trimmed. None for an empty text; an empty
    /// piece between two separators is kept.
    std::vector<std::string>
    items(const char separator = ',') const
    {
      return split(what, separator);
    }

    /// The text, or a piece of it, which must be a name of the scene's @p list:
    /// `there is no KIND 'text'. The nearest of LIST is ...`. Returns the text.
    /// Throws InputError with the name that is nearest to it by Levenshtein's
    /// distance (nearest_name()).
    const std::string &
    among(const std::vector<std::string> &names,
          const std::string              &kind,
          const std::string              &list) const;

  private:
    [[noreturn]] void
    refuse_choice(const std::string &pattern) const;

    std::string where, what;
  };

  /**
   * The entries of the subsection that a ParameterHandler is in, with the path
   * that leads there (which ParameterHandler does not tell). Refers to it. The
   * handler must outlive it, and must stay in that subsection while entries are
   * read.
   */
  class Entries
  {
  public:
    /// @p path is empty at the top level. Nothing is entered: the caller has
    /// entered the subsection already.
    Entries(const dealii::ParameterHandler &prm, const std::string &path)
      : prm(prm)
      , subsection(path)
    {}

    /// As `Body upper/Kinematics`, empty at the top level.
    const std::string &
    path() const
    {
      return subsection;
    }

    /// The entry @p name, which must be declared. deal.II throws its own
    /// exception for a name that is not declared, which is a fault of the
    /// program and not of the scene.
    Entry
    operator[](const std::string &name) const;

    /// Throws InputError: what is wrong with the subsection as a whole. For
    /// faults between entries (two that exclude each other, none of several):
    /// the message has no value.
    [[noreturn]] void
    refuse(const std::string &rule, const std::string &remedy = "") const;

  private:
    const dealii::ParameterHandler &prm;
    std::string                     subsection;
  };
} // namespace lamella

#endif
