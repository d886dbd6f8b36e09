// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/contact/contact_pair.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    std::optional<Hit>
    intersect_plane(const Obstacle     &plane,
                    const Point<3>     &x,
                    const Tensor<1, 3> &d)
    {
      const double approach = d * plane.direction;
      if (approach >= 0.)
        return {};
      const double t = (plane.point - x) * plane.direction / approach;
      return Hit{x + t * d, plane.direction, t};
    }



    std::optional<Hit>
    intersect_cylinder(const Obstacle     &cylinder,
                       const Point<3>     &x,
                       const Tensor<1, 3> &d)
    {
      const Tensor<1, 3> r = cylinder.across_axis(x - cylinder.point),
                         e = cylinder.across_axis(d);
      // |r + t e| = R; of its two roots the smaller one enters the cylinder.
      const double a = e * e, b = r * e,
                   c = r * r - cylinder.radius * cylinder.radius;
      if (a == 0. || b * b < a * c)
        return {};
      const double       t = (-b - std::sqrt(b * b - a * c)) / a;
      const Tensor<1, 3> n = (r + t * e) / cylinder.radius;
      return Hit{x + t * d, n, t};
    }
  } // namespace



  std::optional<Hit>
  meet(const Obstacle &obstacle, const Point<3> &x, const Tensor<1, 3> &d)
  {
    Assert(obstacle.shape != Obstacle::Shape::undefined,
           ExcMessage("The shape was never set."));
    return obstacle.shape == Obstacle::Shape::plane ?
             intersect_plane(obstacle, x, d) :
             intersect_cylinder(obstacle, x, d);
  }



  bool
  contains(const Obstacle &obstacle, const Point<3> &x)
  {
    const Tensor<1, 3> r = x - obstacle.point;
    return obstacle.shape == Obstacle::Shape::plane ?
             r * obstacle.direction < 0. :
             obstacle.across_axis(r).norm() < obstacle.radius;
  }



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
