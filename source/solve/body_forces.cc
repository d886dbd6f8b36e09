// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/solve/body_forces.h>

#include <algorithm>

namespace lamella
{
  using namespace dealii;

  BodyForces::BodyForces(const Body &of, const Vector &u)
    : body(of)
    , rigid(of.rigid_motions(u))
    , size(of.size())
  {}



  Wrench
  BodyForces::about_origin(const Wrench &about_center) const
  {
    return {about_center.force,
            about_center.moment +
              cross_product_3d(body.center(), about_center.force)};
  }



  void
  BodyForces::add(const Wrench &about_center)
  {
    sum.force += about_center.force;
    sum.moment += about_center.moment;
    at_least(
      std::max(about_center.force.norm(), about_center.moment.norm() / size));
  }



  void
  BodyForces::at_least(const double force)
  {
    largest = std::max(largest, force);
  }



  std::pair<double, double>
  BodyForces::unbalanced() const
  {
    const auto share = [this](const double left) {
      return left == 0. ? 0. : left / largest;
    };
    return {share(sum.force.norm()), share(sum.moment.norm() / size)};
  }
} // namespace lamella
