// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_text_h
#define lamella_base_text_h

#include <lamella/base/exceptions.h>

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Returns @p text without blanks, tabs and newlines at its start and end.
  std::string
  trimmed(const std::string &text);

  /// Returns @p text if it has at most 100 characters. Otherwise returns its
  /// first 50 and last 25 characters and its length.
  std::string
  abridged(const std::string &text);

  /// Splits @p text at each @p separator outside of parentheses, as in muParser
  /// expressions, and returns the trimmed substrings, including empty ones.
  /// Returns an empty list for a blank text.
  std::vector<std::string>
  split(const std::string &text, const char separator);

  /// Returns @p text with each occurrence of @p what replaced by @p by. @p what
  /// must not be empty.
  std::string
  replaced(std::string text, const std::string &what, const std::string &by);

  /// Smallest magnitude of nonzero numbers in the input.
  constexpr double smallest_number = 1e-30;
  /// Largest magnitude of numbers in the input. Fourth powers do not overflow.
  constexpr double largest_number = 1e30;

  /// An error in a text of the input, with the arguments of Entry::refuse().
  struct TextError
  {
    std::string rule;   ///< Violated condition; empty if there is no error.
    std::string remedy; ///< Advice for correcting the text; may be empty.
  };

  /// Checks that @p text is a number without a unit, in the notation of C, that
  /// is zero or from smallest_number to largest_number in magnitude. Returns
  /// the error, which is empty if @p text is valid.
  TextError
  number_error(const std::string &text);

  /// Converts @p text, which must be valid for number_error(), to a number.
  double
  to_number(const std::string &text);

  /// Returns @p names joined by @p separator, e.g. `a, b, c`.
  std::string
  joined(const std::vector<std::string> &names,
         const std::string              &separator = ", ");

  /// Returns @p value with @p digits significant digits, in the format `%g`.
  std::string
  to_text(const double value, const int digits = 6);

  /// Returns the coordinates of @p point as `(x, y, z)`, with six digits each.
  std::string
  to_text(const dealii::Point<3> &point);
  /// Returns a @p point of a section as `(x, z)`, with six digits each.
  std::string
  to_text(const dealii::Point<2> &point);

  /// Returns the components of @p v as `(x, y, z)`. Components below 1e-9 times
  /// the length of @p v are printed as 0.
  std::string
  to_text(const dealii::Tensor<1, 3> &v);

  /// Returns the text of @p message without its identifier, and without white
  /// space and full stops at its end, to be inserted into a longer sentence.
  inline std::string
  strip_period(const std::string &message)
  {
    std::string text = trimmed(Message(message).text);
    while (!text.empty() && text.back() == '.')
      text.pop_back();
    return text;
  }

  /// Returns the console line `Note: TEXT. [ID]` for a @p note `ID: TEXT`.
  inline std::string
  note_line(const std::string &note)
  {
    Message message(note);
    message.text = "Note: " + message.text + ".";
    return message.shown();
  }
} // namespace lamella

#endif
