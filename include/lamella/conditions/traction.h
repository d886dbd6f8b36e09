// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_traction_h
#define lamella_conditions_traction_h

#include <lamella/conditions/load.h>

#include <memory>

namespace lamella
{
  /// The value of a load at a point: on a surface the traction t at load factor
  /// 1. Expressions are parsed once.
  class Traction
  {
  public:
    /// Parses the expressions. Throws InputError as add_load() does.
    explicit Traction(const Load &load);
    ~Traction();
    Traction(Traction &&) noexcept;

    /// Returns the force f per area (on lines and points, their force), or -p n
    /// of a pressure p [force/length^2]. @p x and the outward unit @p normal
    /// are in scene axes. Throws InputError if an expression is not finite.
    dealii::Tensor<1, 3>
    operator()(const dealii::Point<3>     &x,
               const dealii::Tensor<1, 3> &normal) const;

    /// Returns whether it is constant on any plane.
    bool
    is_constant() const;

  private:
    struct Values;
    std::unique_ptr<Values> values;
  };
} // namespace lamella

#endif
