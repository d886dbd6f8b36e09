// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_expression_h
#define lamella_conditions_expression_h

#include <deal.II/base/function_parser.h>

#include <string>

namespace lamella
{
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
