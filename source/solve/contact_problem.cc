// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/solve/contact_problem.h>

#include <algorithm>

namespace lamella
{
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



  void
  ContactSolution::store(const unsigned int          r,
                         const PointState            state,
                         const dealii::Tensor<1, 3> &lambda)
  {
    const bool closed = state != PointState::open;
    force[r]          = closed ? std::max(0., lambda[0]) : 0.;
    if (closed)
      active.push_back(r);
    if (shear.empty())
      return;
    shear[r]     = {};
    direction[r] = {};
    if (closed)
      shear[r] = dealii::Tensor<1, 2>({lambda[1], lambda[2]});
    if (state == PointState::slip && shear[r].norm() > 0.)
      direction[r] = shear[r] / shear[r].norm();
  }
} // namespace lamella
