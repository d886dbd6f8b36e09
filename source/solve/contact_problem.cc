// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/solve/contact_problem.h>

namespace lamella
{
  double
  law_compliance(const GapConstraint &row)
  {
    return row.enforcement == Enforcement::penalty ? 1. / row.penalty : 0.;
  }



  double
  NumericalCompliance::operator()(const GapConstraint &row) const
  {
    return row.enforcement == Enforcement::penalty ?
             1. / row.penalty :
             1. / (stiffening * row.penalty);
  }



  bool
  NumericalCompliance::increase_penalty()
  {
    constexpr double factor = 10., bound = 1000.;
    if (stiffening >= bound)
      return false;
    stiffening *= factor;
    return true;
  }
} // namespace lamella
