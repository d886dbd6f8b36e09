// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_traction_h
#define lamella_conditions_traction_h

#include <lamella/conditions/load.h>

#include <memory>

namespace lamella
{
  /// Values of a load at load factor 1: the traction at points of a surface,
  /// the force per length of a line, or the force at a point.
  class Traction
  {
  public:
    /// Parses the expressions of @p load. Throws InputError if one is invalid.
    explicit Traction(const Load &load);
    ~Traction();
    Traction(Traction &&) noexcept; ///< Moves the parsed expressions.

    /// Returns the load at @p x, scene axes; for a pressure p it is -p n with
    /// the outward unit @p normal n. Throws InputError if it is not finite.
    dealii::Tensor<1, 3>
    operator()(const dealii::Point<3>     &x,
               const dealii::Tensor<1, 3> &normal) const;

    /// Returns true if the load is the same at all points of a plane surface.
    bool
    is_constant() const;

  private:
    struct Values;
    std::unique_ptr<Values> values;
  };
} // namespace lamella

#endif
