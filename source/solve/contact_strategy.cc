// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/solve/contact_strategy.h>

namespace lamella
{
  double
  law_softness(const GapRow &row)
  {
    return row.enforcement == Enforcement::penalty ? 1. / row.penalty : 0.;
  }



  ContactStrategy::ContactStrategy(const Structure           &structure,
                                   const std::vector<GapRow> &rows)
    : structure(structure)
    , rows(rows)
  {}



  bool
  ContactStrategy::stiffen()
  {
    constexpr double factor = 10., bound = 1000.;
    if (stiffening >= bound)
      return false;
    stiffening *= factor;
    return true;
  }



  double
  ContactStrategy::numerical_softness(const GapRow &row) const
  {
    return row.enforcement == Enforcement::penalty ?
             1. / row.penalty :
             1. / (stiffening * row.penalty);
  }
} // namespace lamella
