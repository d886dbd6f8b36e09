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

    /// Returns the pattern of a comma-separated list of numbers, of any length.
    dealii::Patterns::List
    numbers();
    /// Returns the pattern of exactly @p n comma-separated numbers.
    dealii::Patterns::List
    numbers(const unsigned int n);

    /// The pattern of an integer within bounds; 1e3 and 8.0 are integers.
    class Whole : public dealii::Patterns::PatternBase
    {
    public:
      /// Constructs the pattern of integers from @p least to @p most.
      Whole(const unsigned int least, const unsigned int most);

      /// Returns true if @p text is an integer within the bounds.
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
      /// Constructs the pattern that matches @p word and what @p other matches.
      WordOrPattern(const std::string                   &word,
                    const dealii::Patterns::PatternBase &other);

      /// Returns true if @p text is the word or matches the other pattern.
      bool
      match(const std::string &text) const override;
      /// Returns `[WORD or OTHER]`, with the other pattern's description.
      std::string
      description(const OutputStyle style = Machine) const override;
      /// Returns a copy of this pattern.
      std::unique_ptr<dealii::Patterns::PatternBase>
      clone() const override;

    private:
      std::string                                          word;
      std::shared_ptr<const dealii::Patterns::PatternBase> other;
    };

    /// Returns the pattern of an entry that is empty or matches @p other.
    WordOrPattern
    optional(const dealii::Patterns::PatternBase &other);

    /// Throws InputError for @p entry, whose text does not match a pattern with
    /// the machine-readable description @p pattern. The message lists valid
    /// values: bounds, names of a selection, or the word of a WordOrPattern.
    [[noreturn]] void
    refuse(const Entry &entry, const std::string &pattern);

    /// Throws InputError for @p entry, whose text does not match its pattern
    /// declared in @p prm. Slow, since it writes all of @p prm as JSON.
    [[noreturn]] void
    refuse(const Entry &entry, const dealii::ParameterHandler &prm);
  } // namespace patterns
} // namespace lamella

#endif
