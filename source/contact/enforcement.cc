// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/contact/enforcement.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace lamella
{
  double
  row_penalty(const Penalty        &penalty,
              const LocalStiffness &first,
              const LocalStiffness &second)
  {
    const auto stiffness = [](const LocalStiffness &side) {
      return side.normal_modulus * side.area / side.depth;
    };
    switch (penalty.kind)
      {
        case PenaltyKind::automatic:
          return penalty.value * std::min(stiffness(first), stiffness(second));
        case PenaltyKind::per_node:
          return penalty.value;
        case PenaltyKind::per_area:
          return penalty.value * first.area;
        default:
          Assert(false, dealii::ExcMessage("The penalty was never set."));
          return 0.;
      }
  }
} // namespace lamella
