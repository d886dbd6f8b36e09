// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/solve/condensed_strategy.h>
#include <lamella/solve/full_strategy.h>

namespace lamella
{
  ContactStrategy::~ContactStrategy() = default;



  std::unique_ptr<ContactStrategy>
  make_strategy(const Strategy         which,
                const TangentOperator &tangent_operator,
                const GapConstraints  &rows)
  {
    if (which == Strategy::full)
      return std::make_unique<FullStrategy>(tangent_operator, rows);
    return std::make_unique<CondensedStrategy>(tangent_operator, rows);
  }
} // namespace lamella
