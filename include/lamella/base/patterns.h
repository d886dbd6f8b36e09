// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_patterns_h
#define lamella_base_patterns_h

#include <lamella/base/entry.h>

#include <deal.II/base/patterns.h>

#include <memory>
#include <string>

namespace lamella
{
  /// Patterns of entries: deal.II's with the ranges of a scene's numbers (zero,
  /// or a size between 1e-30 and 1e30), and two more.
  namespace patterns
  {
    /// Returns the pattern of any number from -1e30 to 1e30.
    dealii::Patterns::Double
    number();

    /// Returns the pattern of numbers from 1e-30 to 1e30.
    dealii::Patterns::Double
    positive();

    /// Returns the pattern of any number of numbers between commas.
    dealii::Patterns::List
    numbers();
    /// Returns the pattern of exactly @p n numbers, as 3 of a point.
    dealii::Patterns::List
    numbers(const unsigned int n);

    /// A whole number from @p least to @p most in any spelling, such as 1e3 or
    /// 8.0.
    class Whole : public dealii::Patterns::PatternBase
    {
    public:
      /// Stores the bounds, both included.
      Whole(const unsigned int least, const unsigned int most);

      /// Returns whether @p text is a valid whole number within the bounds.
      bool
      match(const std::string &text) const override;
      /// Returns the description of deal.II's Integer with the same bounds.
      std::string
      description(const OutputStyle style = Machine) const override;
      /// Returns a copy, as deal.II's ParameterHandler keeps one.
      std::unique_ptr<dealii::Patterns::PatternBase>
      clone() const override;

    private:
      unsigned int least, most;
    };

    /// A word in place of another pattern: `auto`, `none`, or empty.
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

    /// Throws InputError for @p entry, which does not match the pattern with
    /// the machine description @p pattern. The rule is made from the
    /// description: bounds of numbers and lists, names of a selection, `, or
    /// WORD` for WordOrPattern.
    [[noreturn]] void
    refuse(const Entry &entry, const std::string &pattern);

    /// Throws InputError for @p entry, with the pattern that @p prm declares at
    /// its path. Slow: writes the declaration as JSON to find the pattern.
    [[noreturn]] void
    refuse(const Entry &entry, const dealii::ParameterHandler &prm);
  } // namespace patterns
} // namespace lamella

#endif
