// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_traction_h
#define lamella_conditions_traction_h

#include <lamella/conditions/load.h>

#include <memory>

namespace lamella
{
  /**
   * What a load is at a point: of a surface the traction t there, per area, at
   * load factor 1. The expressions are parsed once.
   */
  class Traction
  {
  public:
    /// Throws InputError as add_load() does for expressions that do not parse.
    explicit Traction(const Load &load);
    ~Traction();
    Traction(Traction &&) noexcept;

    /// A force f per area (of lines and points: what they have), or a pressure
    /// p as t = -p n. @p x and the unit outward @p normal in scene axes;
    /// [force/length^2]. Throws InputError where an expression is not finite.
    dealii::Tensor<1, 3>
    operator()(const dealii::Point<3>     &x,
               const dealii::Tensor<1, 3> &normal) const;

    /// Whether it is the same at all places of a plane.
    bool
    is_constant() const;

  private:
    struct Values;
    std::unique_ptr<Values> values;
  };
} // namespace lamella

#endif
