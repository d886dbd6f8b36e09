// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/conditions/expression.h>

#include <deal.II/base/exceptions.h>

#include <cmath>
#include <iostream>
#include <regex>
#include <sstream>

namespace lamella
{
  std::string
  Formula::to_exact_text(const double value)
  {
    std::ostringstream text;
    text.precision(std::numeric_limits<double>::max_digits10);
    text << value;
    return text.str();
  }



  using namespace dealii;

  namespace
  {
    /// Returns an error of the text that muParser does not find, or nothing.
    std::string
    fault_of(const std::string &text)
    {
      // muParser evaluates the last of several expressions between commas.
      if (split(text, ',').size() != 1)
        return " (a decimal point is '.')";
      // muParser assigns by = and by += and its like.
      static const std::regex comparison("[=!<>]="),
        random("\\brand(_seed)?\\b");
      if (std::regex_replace(text, comparison, "").find('=') !=
          std::string::npos)
        return " ('=' assigns; to compare write '==')";
      if (std::regex_search(text, random))
        return " (random numbers are not reproducible)";
      return "";
    }



    bool
    depends_on_position(const std::string &text)
    {
      static const std::regex position("\\b[xyz]\\b");
      return std::regex_search(text, position);
    }
  } // namespace



  Expression::Expression(const std::string &expression, const Entry &entry)
    : text(expression)
    , entry(entry)
    , constant(!depends_on_position(expression))
  {
    const auto fail = [&](const std::string &why) {
      entry.refuse("conditions.invalid-expression: '" + expression +
                     "' is not an expression of x, y, z" + why,
                   "Write a formula (muParser), as in -1000*sin(pi*y/2).");
    };
    const std::string fault = fault_of(expression);
    if (!fault.empty())
      fail(fault);
    // deal.II prints muParser's message before it throws.
    std::ostringstream    discarded;
    std::streambuf *const standard_error = std::cerr.rdbuf(discarded.rdbuf());
    bool                  parses         = true;
    try
      {
        parser.initialize("x,y,z", expression, {{"pi", numbers::PI}}, false);
        // deal.II parses at the first evaluation.
        parser.value(Point<3>());
      }
    catch (const ExceptionBase &)
      {
        parses = false;
      }
    std::cerr.rdbuf(standard_error);
    if (!parses)
      fail("");
  }



  double
  Expression::operator()(const Point<3> &x) const
  {
    const double value = parser.value(x);
    if (!std::isfinite(value))
      entry.refuse("conditions.expression-not-finite: '" + text +
                     "' has no finite value at " + to_text(x) + " (x, y, z)",
                   "Change the expression, or On and At of the load.");
    if (std::abs(value) > largest_number)
      entry.refuse("conditions.expression-too-large: '" + text + "' is " +
                     to_text(value) + " at " + to_text(x) +
                     ", but its size must be less than " +
                     to_text(largest_number),
                   "Change the expression, or choose other Units.");
    return value;
  }
} // namespace lamella
