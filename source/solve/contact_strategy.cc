// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/solve/condensed_strategy.h>
#include <lamella/solve/full_strategy.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  ContactStrategy::~ContactStrategy() = default;



  Strategy
  choose_strategy(const Strategy   which,
                  const Structure &structure,
                  const double     n)
  {
    if (which != Strategy::automatic)
      return which;
    // Up to here a factor of the compliance takes less than a second.
    constexpr double few_operations = 1e9;

    double of_bodies = 0.;
    for (const auto &body : structure.bodies())
      of_bodies +=
        std::pow(body->stiffness_entries(), 2) / double(body->n_dofs());
    return std::pow(n, 3) / 3. > std::max(of_bodies, few_operations) ?
             Strategy::full :
             Strategy::condensed;
  }



  Strategy
  choose_strategy(const Strategy        which,
                  const Structure      &structure,
                  const GapConstraints &rows)
  {
    double n = 0.;
    for (const GapConstraint &row : rows)
      if (!row.slips.empty() && row.initial_gap <= 0.)
        n += 1. + row.slips.size();
    return choose_strategy(which, structure, n);
  }



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
