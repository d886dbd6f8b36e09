// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_text_h
#define lamella_base_text_h

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace lamella
{
  /**
   * @p text without white space at its ends. White space is blanks, tabs and
   * ends of lines (\r, \n).
   */
  std::string
  trimmed(const std::string &text);

  /**
   * The first 50 and the last 25 characters of the long @p text, and how many
   * there are; all of a text of up to 100. For messages.
   */
  std::string
  abridged(const std::string &text);

  /**
   * @p text cut at each @p separator outside of parentheses, each piece
   * trimmed; none for a text of white space. (Parentheses: a muParser
   * expression such as `if(y>1, 2, 0)` stays whole.) Empty pieces between
   * separators are kept, as is the one after a separator at the end.
   */
  std::vector<std::string>
  split(const std::string &text, const char separator);

  /// @p text with each @p what replaced @p by something else. From left to
  /// right; what @p by brings in is not looked at again. @p what must not be
  /// empty.
  std::string
  replaced(std::string text, const std::string &what, const std::string &by);

  /// Numbers of a scene, other than zero, lie between these: fourth powers of
  /// numbers, and squares of their products, are still doubles. Moments of
  /// areas are such fourth powers, products of stiffness and length^4 such
  /// squares.
  constexpr double smallest_number = 1e-30, largest_number = 1e30;

  /// What is wrong with a text, and what to do about it. In the form that
  /// Entry::refuse() takes: a rule without a full stop, a remedy in sentences.
  struct TextFault
  {
    /// Empty: nothing is.
    std::string rule, remedy;
  };

  /// Whether all of @p text spells one finite number within those bounds. Point
  /// and exponent as in C; no unit, no hexadecimal digits, no inf, no nan.
  /// White space at the ends is no fault.
  TextFault
  fault_of_number(const std::string &text);

  /// The number that all of @p text spells, which must have no fault. Ask
  /// fault_of_number() first: of a text with a fault it is anything.
  double
  to_number(const std::string &text);

  /// @p names as `a, b, c`. Empty for no names.
  std::string
  joined(const std::vector<std::string> &names,
         const std::string              &separator = ", ");

  /// @p value with @p digits significant digits. As C's %g writes it, without
  /// trailing zeros. For people; numbers that are read again need 17 digits.
  std::string
  to_text(const double value, const int digits = 6);

  /// @p point as `(x, y, z)`. Six digits a coordinate, in the scene's unit of
  /// length.
  std::string
  to_text(const dealii::Point<3> &point);
  /// `(x, z)` of a place in a section likewise.
  std::string
  to_text(const dealii::Point<2> &point);

  /// @p v as `(x, y, z)`; a component below 1e-9 of its length is rounding and
  /// reads 0. A zero vector reads (0, 0, 0).
  std::string
  to_text(const dealii::Tensor<1, 3> &v);
} // namespace lamella

#endif
