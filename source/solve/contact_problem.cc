// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/solve/contact_problem.h>

#include <algorithm>

namespace lamella
{
  using namespace dealii;

  FrictionState
  FrictionState::unloaded(const GapConstraints &rows)
  {
    const std::vector<Tensor<1, 3>> none(rows.size());
    FrictionState                   state{none, none, none, {}, 0.};
    for (unsigned int r = 0; r < rows.size(); ++r)
      state.history[rows.material_point(r)].gap = rows[r].initial_gap;
    return state;
  }



  double
  FrictionState::all_dissipated() const
  {
    double sum = 0.;
    for (const auto &[point, of] : history)
      sum += of.dissipated;
    return sum;
  }



  Tensor<1, 2>
  along_tangents(const GapConstraint &row, const Tensor<1, 3> &vector)
  {
    Tensor<1, 2> components;
    for (unsigned int a = 0; a < row.slips.size(); ++a)
      components[a] = vector * row.slips[a].tangent;
    return components;
  }



  Tensor<1, 3>
  in_scene(const GapConstraint &row, const Tensor<1, 2> &components)
  {
    Tensor<1, 3> vector;
    for (unsigned int a = 0; a < row.slips.size(); ++a)
      vector += components[a] * row.slips[a].tangent;
    return vector;
  }



  Tensor<1, 2>
  slip_of(const GapConstraint &row,
          const BlockVector   &u,
          const LoadFactor    &factor)
  {
    Tensor<1, 2> slip;
    for (unsigned int a = 0; a < row.slips.size(); ++a)
      slip[a] = row.slips[a].slip(u, factor);
    return slip;
  }



  void
  add_force(const GapConstraint &row,
            const double         normal,
            const Tensor<1, 3>  &shear,
            BlockVector         &f)
  {
    row.add_to(f, normal);
    for (const SlipConstraint &slip : row.slips)
      slip.add_to(f, slip.tangent * shear);
  }



  double
  NumericalCompliance::proximal(const GapConstraint &row) const
  {
    return row.enforcement == Enforcement::penalty ?
             0. :
             1. / (stiffening * row.penalty);
  }



  double
  NumericalCompliance::operator()(const GapConstraints &rows,
                                  const unsigned int    number) const
  {
    return law_compliance(rows, number) + proximal(rows[rows.row_of(number)]);
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
                         const bool                  bilateral,
                         const PointState            state,
                         const dealii::Tensor<1, 3> &lambda)
  {
    const bool closed = state != PointState::open;
    force[r] = bilateral ? lambda[0] : closed ? std::max(0., lambda[0]) : 0.;
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
