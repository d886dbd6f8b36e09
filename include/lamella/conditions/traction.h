// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_traction_h
#define lamella_conditions_traction_h

#include <lamella/conditions/load.h>

#include <memory>

namespace lamella
{
  /// Evaluates a load at load factor 1 at points: the traction on a surface,
  /// the force per length of a line, or the force at a point.
  class Traction
  {
  public:
    /// Parses the expressions. Throws InputError as add_load() does.
    explicit Traction(const Load &load);
    ~Traction();
    Traction(Traction &&) noexcept;

    /// Returns the load at @p x, scene axes; for a pressure p it is -p n with
    /// the outward unit @p normal n. Throws InputError if it is not finite.
    dealii::Tensor<1, 3>
    operator()(const dealii::Point<3>     &x,
               const dealii::Tensor<1, 3> &normal) const;

    /// Returns whether the load has the same value at all points of a plane.
    bool
    is_constant() const;

  private:
    struct Values;
    std::unique_ptr<Values> values;
  };
} // namespace lamella

#endif
