// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_patterns_h
#define lamella_base_patterns_h

#include <lamella/base/entry.h>

#include <deal.II/base/patterns.h>

#include <memory>
#include <string>

namespace lamella
{
  /**
   * What an entry may be, declared once, with the entry: deal.II's patterns in
   * the ranges that numbers of a scene have (text.h: other than zero, between
   * 1e-30 and 1e30), and two of ours. A value that does not match is refused
   * with the pattern's rule in words before anything reads it.
   */
  namespace patterns
  {
    /// Any number. From -1e30 to 1e30; what is smaller than 1e-30 and not zero
    /// is refused by whoever reads the number (Entry::number()).
    dealii::Patterns::Double
    number();

    /// Numbers above zero: from 1e-30 to 1e30.
    dealii::Patterns::Double
    positive();

    /// Numbers between commas: @p n of them, or any number of them. An empty
    /// entry matches: it is a list of none.
    dealii::Patterns::List
    numbers();
    /// Exactly @p n, as 3 of a point.
    dealii::Patterns::List
    numbers(const unsigned int n);

    /// A whole number from @p least to @p most however numbers are spelled, 1e3
    /// or 8.0 (which deal.II's Integer does not read).
    class Whole : public dealii::Patterns::PatternBase
    {
    public:
      /// Both bounds are included.
      Whole(const unsigned int least, const unsigned int most);

      /// Whether @p text is a number without fault, whole and within the
      /// bounds.
      bool
      match(const std::string &text) const override;
      /// That of deal.II's Integer with the same bounds, which users and
      /// refuse() know.
      std::string
      description(const OutputStyle style = Machine) const override;
      /// A copy, as deal.II's ParameterHandler keeps one.
      std::unique_ptr<dealii::Patterns::PatternBase>
      clone() const override;

    private:
      unsigned int least, most;
    };

    /// A word in place of what another pattern takes: `auto`, `none`, or
    /// nothing for an entry that may be left empty. The other pattern is copied
    /// and shared between copies of this one.
    class WordOr : public dealii::Patterns::PatternBase
    {
    public:
      /// @p word is compared as it stands; @p other is cloned.
      WordOr(const std::string                   &word,
             const dealii::Patterns::PatternBase &other);

      /// Whether @p text is the word or matches the other pattern.
      bool
      match(const std::string &text) const override;
      /// `[WORD or OTHER]`.
      std::string
      description(const OutputStyle style = Machine) const override;
      std::unique_ptr<dealii::Patterns::PatternBase>
      clone() const override;

    private:
      std::string                                          word;
      std::shared_ptr<const dealii::Patterns::PatternBase> other;
    };

    /// An entry that may be left empty. WordOr with the empty word;
    /// Entry::is_empty() then tells the default.
    WordOr
    optional(const dealii::Patterns::PatternBase &other);

    /// Throws InputError for @p entry, which does not match the pattern whose
    /// description for machines is @p pattern. The rule is made from the
    /// description: bounds of numbers and lists, names of a selection, `, or
    /// WORD` for WordOr. Where any real number may stand its own faults come
    /// first, so that `abc` is called no number rather than one out of bounds.
    [[noreturn]] void
    refuse(const Entry &entry, const std::string &pattern);

    /// The same, the pattern being what @p prm declares at the entry's path.
    /// Writes the whole declaration as JSON to look the pattern up: for the one
    /// message of a run, not for loops.
    [[noreturn]] void
    refuse(const Entry &entry, const dealii::ParameterHandler &prm);
  } // namespace patterns
} // namespace lamella

#endif
