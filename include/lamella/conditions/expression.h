// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_expression_h
#define lamella_conditions_expression_h

#include <lamella/base/entry.h>

#include <deal.II/base/function_parser.h>

#include <string>
#include <type_traits>

namespace lamella
{
  /**
   * A value of a load: a number, or a function of the scene's x, y, z in the
   * language of muParser; or nothing. Only text, and cheap to copy: Expression
   * parses it. Tests and programs that use the library write `load.force[2] =
   * -1000.`, scenes `-1000*sin(pi*y/2)`.
   */
  class Formula
  {
  public:
    Formula() = default;

    /// Implicit, as from literals and numbers; nothing is checked.
    Formula(const std::string &expression)
      : expression(expression)
    {}

    Formula(const char *expression)
      : expression(expression)
    {}

    /// With all digits of @p value. 17 of them, so that the parser reads the
    /// same double again.
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

    /// Whether there is no value, as of a pressure where a force is given.
    bool
    empty() const
    {
      return expression.empty();
    }

  private:
    /// @p value as text.
    static std::string
    with_all_digits(const double value);

    std::string expression;
  };

  /**
   * A real function of the scene's x, y, z that a scene spells in the language
   * of muParser (deal.II's FunctionParser), with the constant pi. It keeps its
   * own copy of the entry, for messages.
   */
  class Expression
  {
  public:
    /**
     * Of @p expression, a part of @p entry or all of it. Throws InputError of
     * the entry if the expression does not parse, holds a comma outside of
     * functions, assigns (`x=1` is an assignment to muParser and worth 1), or
     * has no value of its own (`rand()`). It is evaluated once, at the origin,
     * since deal.II parses no earlier; the value there may be infinite.
     */
    Expression(const std::string &expression, const Entry &entry);

    /// The value at @p x; InputError of the entry if it is not a finite number.
    /// @p x in scene axes [length]; the unit of the value is that of what it is
    /// for.
    double
    operator()(const dealii::Point<3> &x) const;

    /// Whether the text speaks of none of x, y, z. Then one value stands for
    /// all places and integrals need no adaptivity.
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
