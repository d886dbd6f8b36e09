// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/text.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

namespace lamella
{
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
    if (text.size() <= 2 * kept)
      return text;
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



  std::string
  replaced(std::string text, const std::string &what, const std::string &by)
  {
    for (auto at = text.find(what); at != std::string::npos;
         at      = text.find(what, at + by.size()))
      text.replace(at, what.size(), by);
    return text;
  }



  TextError
  number_error(const std::string &text)
  {
    const std::string word  = trimmed(text);
    char             *end   = nullptr;
    const double      value = std::strtod(word.c_str(), &end);
    // strtod also accepts hexadecimal numbers.
    if (word.empty() || *end != '\0' || !std::isfinite(value) ||
        word.find_first_of("xX") != std::string::npos)
      return {"entry.not-a-number: '" + word + "' is not a number",
              "Write the number alone, without a unit, as in 0.05 or 5e-2."};
    // strtod returns 0 for numbers below the range of doubles.
    const bool is_zero =
      word.substr(0, word.find_first_of("eE")).find_first_of("123456789") ==
      std::string::npos;
    if (!is_zero &&
        (std::abs(value) < smallest_number || std::abs(value) > largest_number))
      return {"entry.number-out-of-range: '" + word +
                "' is out of range: its size must be 0 or from 1e-30 to 1e30",
              "Correct the exponent, or choose other Units."};
    return {};
  }



  double
  to_number(const std::string &text)
  {
    return std::strtod(trimmed(text).c_str(), nullptr);
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
  to_text(const dealii::Point<2> &point)
  {
    return "(" + to_text(point[0]) + ", " + to_text(point[1]) + ")";
  }



  std::string
  to_text(const dealii::Tensor<1, 3> &v)
  {
    dealii::Point<3> rounded;
    for (unsigned int c = 0; c < 3; ++c)
      rounded[c] =
        std::abs(v[c]) < arithmetic::negligible * v.norm() ? 0. : v[c];
    return to_text(rounded);
  }
} // namespace lamella
