// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

namespace lamella
{
  namespace
  {
    // Fourth powers of numbers, and squares of their products, are still
    // doubles.
    constexpr double smallest = 1e-30, largest = 1e30;
  } // namespace



  std::string
  trimmed(const std::string &text)
  {
    const char *const white = " \t\r\n";
    const auto        begin = text.find_first_not_of(white);
    if (begin == std::string::npos)
      return "";
    return text.substr(begin, text.find_last_not_of(white) - begin + 1);
  }



  std::string
  abridged(const std::string &text)
  {
    constexpr std::size_t kept = 50;
    return text.substr(0, kept) + " ... (" + std::to_string(text.size()) +
           " characters) ... " + text.substr(text.size() - kept / 2);
  }



  std::vector<std::string>
  split(const std::string &text, const char separator)
  {
    std::vector<std::string> pieces;
    if (trimmed(text).empty())
      return pieces;
    std::string piece;
    int         depth = 0;
    for (const char c : text)
      {
        depth += (c == '(') - (c == ')');
        if (c == separator && depth == 0)
          {
            pieces.push_back(trimmed(piece));
            piece.clear();
          }
        else
          piece += c;
      }
    pieces.push_back(trimmed(piece));
    return pieces;
  }



  double
  to_number(const std::string &text, const std::string &what)
  {
    const std::string word  = trimmed(text);
    char             *end   = nullptr;
    const double      value = std::strtod(word.c_str(), &end);
    // strtod takes hexadecimal numbers, too; nobody means them.
    if (word.empty() || *end != '\0' || !std::isfinite(value) ||
        word.find_first_of("xX") != std::string::npos)
      throw InputError(what + ": '" + word +
                       "' is not a number. Write it plainly, without a unit, "
                       "as in 0.05 or 5e-2.");
    if (value != 0. &&
        (std::abs(value) < smallest || std::abs(value) > largest))
      throw InputError(what + ": '" + word +
                       "' is beyond what can be computed with: other than 0, "
                       "numbers lie between 1e-30 and 1e30. Take other units.");
    return value;
  }



  std::vector<double>
  to_numbers(const std::string &text, const std::string &what)
  {
    std::vector<double> values;
    for (const std::string &piece : split(text, ','))
      values.push_back(to_number(piece, what));
    return values;
  }



  bool
  to_bool(const std::string &text, const std::string &what)
  {
    if (text != "true" && text != "false")
      throw InputError(what + " = " + text + ": must be true or false.");
    return text == "true";
  }


  dealii::Point<3>
  to_point(const std::string &text, const std::string &what)
  {
    const std::vector<double> x = to_numbers(text, what);
    if (x.size() != 3)
      throw InputError(what + ": '" + trimmed(text) +
                       "' must be three numbers between commas, as in "
                       "0.05, 1, 0.106.");
    return {x[0], x[1], x[2]};
  }



  std::string
  joined(const std::vector<std::string> &names, const std::string &separator)
  {
    std::string text;
    for (const std::string &name : names)
      text += (text.empty() ? "" : separator) + name;
    return text;
  }



  std::string
  to_text(const double value, const int digits)
  {
    std::ostringstream out;
    out.precision(digits);
    out << value;
    return out.str();
  }



  std::string
  to_text(const dealii::Point<3> &point)
  {
    return "(" + to_text(point[0]) + ", " + to_text(point[1]) + ", " +
           to_text(point[2]) + ")";
  }



  std::string
  to_text(const dealii::Tensor<1, 3> &v)
  {
    dealii::Point<3> rounded;
    for (unsigned int c = 0; c < 3; ++c)
      rounded[c] = std::abs(v[c]) < 1e-9 * v.norm() ? 0. : v[c];
    return to_text(rounded);
  }
} // namespace lamella
