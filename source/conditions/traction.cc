// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/conditions/expression.h>
#include <lamella/conditions/traction.h>

#include <algorithm>
#include <deque>

namespace lamella
{
  using namespace dealii;

  struct Traction::Values
  {
    bool is_pressure = false;
    /// One of a pressure, three of a force; a deque, for they do not move.
    std::deque<Expression> expressions;
  };



  Traction::Traction(const Load &load)
    : values(std::make_unique<Values>())
  {
    const std::string path = "Load " + load.name;
    values->is_pressure    = !load.pressure.empty();
    if (values->is_pressure)
      {
        const Entry entry(path + "/Pressure", load.pressure.text());
        values->expressions.emplace_back(entry.text(), entry);
        return;
      }
    const auto &[fx, fy, fz] = load.force;
    const Entry entry(path + "/Force",
                      joined({fx.text(), fy.text(), fz.text()}));
    for (const Formula &component : load.force)
      values->expressions.emplace_back(component.text(), entry);
  }



  Traction::~Traction() = default;



  Traction::Traction(Traction &&) noexcept = default;



  Tensor<1, 3>
  Traction::operator()(const Point<3> &x, const Tensor<1, 3> &normal) const
  {
    const auto &value = values->expressions;
    if (values->is_pressure)
      return -value[0](x) * normal;
    return Point<3>(value[0](x), value[1](x), value[2](x));
  }



  bool
  Traction::is_constant() const
  {
    return std::all_of(values->expressions.begin(),
                       values->expressions.end(),
                       [](const Expression &e) { return e.is_constant(); });
  }
} // namespace lamella
