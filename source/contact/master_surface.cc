// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/contact/master_surface.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// (n_1 - n_2) / |n_1 - n_2|, unless the normals look the same way.
    std::optional<Tensor<1, 3>>
    averaged_normal(const Tensor<1, 3> &n1, const Tensor<1, 3> &n2)
    {
      constexpr double   parallel = 0.2;
      const Tensor<1, 3> sum      = n1 - n2;
      if (sum.norm() < parallel)
        return {};
      return sum / sum.norm();
    }
  } // namespace



  std::optional<MasterPoint>
  find_master_point(const MasterSurface &other,
                    const Point<3>      &x,
                    const Tensor<1, 3>  &n1,
                    const double         search_radius,
                    const double         opposed)
  {
    // The error of an iterate is at most a few times its last change.
    constexpr unsigned int max_iterations = 50;
    constexpr double       small = arithmetic::rounding, accepted = 1e-11;

    Tensor<1, 3> n   = n1;
    auto         hit = other.meet(x, n, search_radius);
    if (!hit)
      {
        const Tensor<1, 3> near = other.normal_near(x);
        if (n1 * near > -opposed)
          return {};
        n   = *averaged_normal(n1, near);
        hit = other.meet(x, n, search_radius);
      }
    double change = 1.;
    for (unsigned int k = 0; hit && k < max_iterations; ++k)
      {
        const auto next = averaged_normal(n1, hit->normal);
        if (!next)
          return {};
        change = (*next - n).norm();
        if (change < small)
          break;
        n   = *next;
        hit = other.meet(x, n, search_radius);
      }
    if (!hit || change > accepted || n1 * hit->normal > -opposed)
      return {};
    // |n_1 - n_2| = 2 cos(angle / 2), |n_1 + n_2| = 2 sin(angle / 2).
    return MasterPoint{
      *hit, n, 2. * std::asin(std::min(1., 0.5 * (n1 + hit->normal).norm()))};
  }



  ObstacleSurface::ObstacleSurface(std::shared_ptr<const Obstacle> obstacle)
    : obstacle(std::move(obstacle))
  {}



  std::optional<SurfaceHit>
  ObstacleSurface::meet(const Point<3>     &x,
                        const Tensor<1, 3> &d,
                        const double        search_radius) const
  {
    const std::optional<Hit> hit = lamella::meet(*obstacle, x, d);
    if (!hit || std::abs(hit->distance) > search_radius)
      return {};
    SurfaceHit result;
    static_cast<Hit &>(result) = *hit;
    return result;
  }



  Tensor<1, 3>
  ObstacleSurface::normal_near(const Point<3> &x) const
  {
    const Tensor<1, 3> &axis = obstacle->direction;
    if (obstacle->shape == Obstacle::Shape::plane)
      return axis;
    const Tensor<1, 3> r =
      x - obstacle->point - ((x - obstacle->point) * axis) * axis;
    return r.norm() > 0. ? r / r.norm() : r;
  }
} // namespace lamella
