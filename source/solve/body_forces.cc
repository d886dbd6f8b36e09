// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/solve/body_forces.h>

#include <algorithm>

namespace lamella
{
  using namespace dealii;

  BodyForces::BodyForces(const Body &of, const Vector &u)
    : body(of)
    , rigid(of.rigid_motions_at(u))
    , size(of.size())
  {}



  Wrench
  BodyForces::at_origin(const Wrench &about_centre) const
  {
    return {about_centre.force,
            about_centre.moment +
              cross_product_3d(body.centre(), about_centre.force)};
  }



  void
  BodyForces::add(const Wrench &about_centre)
  {
    sum.force += about_centre.force;
    sum.moment += about_centre.moment;
    at_least(
      std::max(about_centre.force.norm(), about_centre.moment.norm() / size));
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
