// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_expression_h
#define lamella_conditions_expression_h

#include <lamella/base/entry.h>

#include <deal.II/base/function_parser.h>

#include <string>
#include <type_traits>

namespace lamella
{
  /// A value of a load as text: a number, a function of x, y, z in the language
  /// of muParser (-1000*sin(pi*y/2)), or empty.
  class Formula
  {
  public:
    Formula() = default;

    /// Stores @p expression without parsing it. Conversions are implicit.
    Formula(const std::string &expression)
      : expression(expression)
    {}

    /// @copydoc Formula(const std::string &)
    Formula(const char *expression)
      : expression(expression)
    {}

    /// Converts @p value to text with 17 digits, without loss of precision.
    template <typename Number,
              typename = std::enable_if_t<std::is_arithmetic<Number>::value>>
    Formula(const Number value)
      : Formula(to_exact_text(value))
    {}

    /// Returns the text in the language of muParser.
    const std::string &
    text() const
    {
      return expression;
    }

    /// Returns true if no value is set, as for the pressure of a point force.
    bool
    empty() const
    {
      return expression.empty();
    }

  private:
    /// Returns @p value as text.
    static std::string
    to_exact_text(const double value);

    std::string expression;
  };

  /// A real function of the scene's x, y, z in the language of muParser
  /// (deal.II's FunctionParser), with pi. Error messages name its entry.
  class Expression
  {
  public:
    /// Parses @p expression, the value of @p entry or a component of that
    /// value. Throws InputError for syntax errors, commas outside of function
    /// calls, assignments (`x=1`) and random values (`rand()`).
    Expression(const std::string &expression, const Entry &entry);

    /// Returns the value at @p x. Throws InputError if it is not finite.
    double
    operator()(const dealii::Point<3> &x) const;

    /// Returns the expression, as given.
    const std::string &
    as_text() const
    {
      return text;
    }

    /// Returns true if the function is constant: x, y, z do not occur.
    bool
    is_constant() const
    {
      return constant;
    }

  private:
    dealii::FunctionParser<3> parser;
    std::string               text;
    Entry                     entry;
    bool                      constant = false;
  };
} // namespace lamella

#endif
