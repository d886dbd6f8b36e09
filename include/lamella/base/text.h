// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_text_h
#define lamella_base_text_h

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Returns @p text without blanks, tabs and line ends at its ends.
  std::string
  trimmed(const std::string &text);

  /// Returns the first 50 and last 25 characters of @p text and its length; all
  /// of a text of up to 100.
  std::string
  abridged(const std::string &text);

  /// Splits @p text at each @p separator outside of parentheses (muParser
  /// expressions stay whole) and trims the pieces. Empty pieces are kept, also
  /// at the end; a blank text has none.
  std::vector<std::string>
  split(const std::string &text, const char separator);

  /// Returns @p text with each @p what, not empty, replaced by @p by.
  std::string
  replaced(std::string text, const std::string &what, const std::string &by);

  /// Bounds of a scene's nonzero numbers: their fourth powers (moments of
  /// areas), and squares of stiffness times length^4, are still doubles.
  constexpr double smallest_number = 1e-30, largest_number = 1e30;

  /// An error in a text, in the form of Entry::refuse(): a rule without a full
  /// stop, a remedy in sentences.
  struct TextError
  {
    /// Rule and remedy; empty if there is no error.
    std::string rule, remedy;
  };

  /// Returns the error if @p text does not spell one finite number within the
  /// bounds. Point and exponent as in C; no unit.
  TextError
  number_error(const std::string &text);

  /// Returns the number that @p text spells; requires no number_error().
  double
  to_number(const std::string &text);

  /// Returns @p names as `a, b, c`; empty for no names.
  std::string
  joined(const std::vector<std::string> &names,
         const std::string              &separator = ", ");

  /// Returns @p value with @p digits significant digits, as `%g`.
  std::string
  to_text(const double value, const int digits = 6);

  /// Returns `(x, y, z)` with six digits a coordinate.
  std::string
  to_text(const dealii::Point<3> &point);
  /// Returns `(x, z)` of a point in a section, with six digits.
  std::string
  to_text(const dealii::Point<2> &point);

  /// Returns @p v as `(x, y, z)`; components below 1e-9 of its length read 0.
  std::string
  to_text(const dealii::Tensor<1, 3> &v);
} // namespace lamella

#endif
