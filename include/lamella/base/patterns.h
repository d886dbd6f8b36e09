// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_patterns_h
#define lamella_base_patterns_h

#include <lamella/base/entry.h>

#include <deal.II/base/patterns.h>

#include <memory>
#include <string>

namespace lamella
{
  /// Patterns for deal.II's ParameterHandler, which check the text of entries.
  namespace patterns
  {
    /// Returns the pattern of any number from -1e30 to 1e30.
    dealii::Patterns::Double
    number();

    /// Returns the pattern of numbers from 1e-30 to 1e30.
    dealii::Patterns::Double
    positive();

    /// Returns the pattern of a comma-separated list of numbers of any length.
    dealii::Patterns::List
    numbers();
    /// Returns the pattern of exactly @p n comma-separated numbers.
    dealii::Patterns::List
    numbers(const unsigned int n);

    /// The pattern of an integer within bounds; 1e3 and 8.0 are integers.
    class Whole : public dealii::Patterns::PatternBase
    {
    public:
      /// Stores the smallest and the largest permitted integer.
      Whole(const unsigned int least, const unsigned int most);

      /// Returns whether @p text is an integer within the bounds.
      bool
      match(const std::string &text) const override;
      /// Returns the description of deal.II's Integer with the same bounds.
      std::string
      description(const OutputStyle style = Machine) const override;
      /// Returns a copy of this pattern.
      std::unique_ptr<dealii::Patterns::PatternBase>
      clone() const override;

    private:
      unsigned int least, most;
    };

    /// The pattern of an entry that is a given word (`auto`, `none` or empty)
    /// or matches another pattern.
    class WordOrPattern : public dealii::Patterns::PatternBase
    {
    public:
      /// Stores @p word (case-sensitive) and clones @p other.
      WordOrPattern(const std::string                   &word,
                    const dealii::Patterns::PatternBase &other);

      /// Returns whether @p text is the word or matches the other pattern.
      bool
      match(const std::string &text) const override;
      /// Returns `[WORD or OTHER]`.
      std::string
      description(const OutputStyle style = Machine) const override;
      std::unique_ptr<dealii::Patterns::PatternBase>
      clone() const override;

    private:
      std::string                                          word;
      std::shared_ptr<const dealii::Patterns::PatternBase> other;
    };

    /// Returns the pattern of an optional entry, which may be empty.
    WordOrPattern
    optional(const dealii::Patterns::PatternBase &other);

    /// Throws InputError for @p entry, which does not match a pattern.
    /// @p pattern is the machine-readable description of that pattern. The
    /// message lists the valid values: bounds of numbers and lists, names of a
    /// selection, or the word of a WordOrPattern.
    [[noreturn]] void
    refuse(const Entry &entry, const std::string &pattern);

    /// Throws InputError for @p entry, which does not match the pattern
    /// declared in @p prm. Slow: writes @p prm as JSON.
    [[noreturn]] void
    refuse(const Entry &entry, const dealii::ParameterHandler &prm);
  } // namespace patterns
} // namespace lamella

#endif
