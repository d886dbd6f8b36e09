// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_expression_h
#define lamella_conditions_expression_h

#include <deal.II/base/function_parser.h>

#include <string>
#include <type_traits>

namespace lamella
{
  /**
   * A value of a load: a number, or a function of the scene's x, y, z in the
   * language of muParser; or nothing.
   */
  class Formula
  {
  public:
    Formula() = default;

    Formula(const std::string &expression)
      : expression(expression)
    {}

    Formula(const char *expression)
      : expression(expression)
    {}

    /// With all digits of @p value.
    template <typename Number,
              typename = std::enable_if_t<std::is_arithmetic<Number>::value>>
    Formula(const Number value)
      : Formula(with_all_digits(value))
    {}

    /// In the language of muParser.
    const std::string &
    text() const
    {
      return expression;
    }

    bool
    empty() const
    {
      return expression.empty();
    }

  private:
    static std::string
    with_all_digits(const double value);

    std::string expression;
  };

  /**
   * A real function of the scene's x, y, z that a scene spells in the language
   * of muParser (deal.II's FunctionParser), with the constant pi.
   */
  class Expression
  {
  public:
    /**
     * Throws InputError, beginning with @p what (which names the entry), if
     * @p expression does not parse, holds a comma outside of functions, assigns
     * (`x=1` is an assignment to muParser and worth 1), or has no value of its
     * own (`rand()`).
     */
    Expression(const std::string &expression, const std::string &what);

    /// The value at @p x; InputError if it is not a finite number.
    double
    operator()(const dealii::Point<3> &x) const;

    /// Whether the text speaks of none of x, y, z.
    bool
    is_constant() const
    {
      return constant;
    }

  private:
    dealii::FunctionParser<3> parser;
    std::string               text, what;
    bool                      constant = false;
  };
} // namespace lamella

#endif
