// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_traction_h
#define lamella_conditions_traction_h

#include <lamella/conditions/load.h>

#include <memory>

namespace lamella
{
  /// The value of a load at a point, a traction on a surface, at load factor 1.
  class Traction
  {
  public:
    /// Parses the expressions. Throws InputError as add_load() does.
    explicit Traction(const Load &load);
    ~Traction();
    Traction(Traction &&) noexcept;

    /// Returns the force f per area (or of a line or point), or -p n of a
    /// pressure, at @p x with outward unit @p normal, scene axes. Throws
    /// InputError if an expression is not finite.
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
