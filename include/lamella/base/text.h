// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_text_h
#define lamella_base_text_h

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace lamella
{
  /**
   * @p text without white space at its ends.
   */
  std::string
  trimmed(const std::string &text);

  /**
   * The first 50 and the last 25 characters of the long @p text, and how many
   * there are.
   */
  std::string
  abridged(const std::string &text);

  /**
   * @p text cut at each @p separator outside of parentheses, each piece
   * trimmed; none for a text of white space. (Parentheses: a muParser
   * expression such as `if(y>1, 2, 0)` stays whole.)
   */
  std::vector<std::string>
  split(const std::string &text, const char separator);

  /**
   * The finite number that all of @p text spells. Throws InputError, beginning
   * with @p what (which names the entry), if it spells none, or one whose
   * products leave the range of doubles (zero apart, beyond 1e-30 to 1e30).
   */
  double
  to_number(const std::string &text, const std::string &what);

  /// to_number() of each piece between commas.
  std::vector<double>
  to_numbers(const std::string &text, const std::string &what);

  /// Of `true` and `false`. Throws InputError for anything else.
  bool
  to_bool(const std::string &text, const std::string &what);

  /// Three numbers between commas. Throws InputError if there are not three.
  dealii::Point<3>
  to_point(const std::string &text, const std::string &what);

  /// @p names as `a, b, c`.
  std::string
  joined(const std::vector<std::string> &names,
         const std::string              &separator = ", ");

  /// @p value with @p digits significant digits.
  std::string
  to_text(const double value, const int digits = 6);

  /// @p point as `(x, y, z)`.
  std::string
  to_text(const dealii::Point<3> &point);

  /// @p v as `(x, y, z)`; a component below 1e-9 of its length is rounding and
  /// reads 0.
  std::string
  to_text(const dealii::Tensor<1, 3> &v);
} // namespace lamella

#endif
