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



  std::vector<dealii::Tensor<1, 3>>
  ContactProblem::forces() const
  {
    std::vector<dealii::Tensor<1, 3>> result(force.size());
    for (unsigned int r = 0; r < force.size(); ++r)
      {
        result[r][0] = force[r];
        for (unsigned int t = 0; t < 2 && !shear.empty(); ++t)
          result[r][1 + t] = shear[r][t];
      }
    return result;
  }
} // namespace lamella
