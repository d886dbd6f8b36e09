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



    /// Returns Aitken's relaxation factor after the residuals @p before and @p
    /// now of a fixed-point iteration with the factor @p relaxation (Irons and
    /// Tuck, Int. J. Numer. Methods Eng. 1 (1969) 275-277); 1 if it is not in
    /// (0, 1), as the iteration converges without relaxation then.
    double
    aitken_relaxation(const double        relaxation,
                      const Tensor<1, 3> &before,
                      const Tensor<1, 3> &now)
    {
      const Tensor<1, 3> change = now - before;
      const double       factor = -relaxation * (before * change);
      const double       most   = change.norm_square();
      return factor > 0. && factor < most ? factor / most : 1.;
    }



    /// Returns where the line from @p x along the normal @p n meets @p other.
    /// If it misses, and the normal of @p other near @p x is @p opposed, @p n
    /// becomes their average, as often as reduces an angle of 60 degrees to 2.
    std::optional<SurfaceHit>
    first_hit(const MasterSurface &other,
              const Point<3>      &x,
              const double         search_radius,
              const double         opposed,
              Tensor<1, 3>        &n)
    {
      auto hit = other.meet(x, n, search_radius);
      if (hit)
        return hit;
      const Tensor<1, 3> near = other.normal_near(x);
      if (n * near > -opposed)
        return {};
      for (unsigned int k = 0; k < 5 && !hit; ++k)
        {
          n   = *averaged_normal(n, near);
          hit = other.meet(x, n, search_radius);
        }
      return hit;
    }



    /// Moves @p n by @p relaxation times @p step and returns where the line
    /// through @p x along it meets @p other. A step that misses is halved, in
    /// all as often as suffices for a gap of 2^5 radii; @p misses counts.
    std::optional<SurfaceHit>
    relaxed_step(const MasterSurface &other,
                 const Point<3>      &x,
                 const double         search_radius,
                 const Tensor<1, 3>  &step,
                 Tensor<1, 3>        &n,
                 double              &relaxation,
                 unsigned int        &misses)
    {
      constexpr unsigned int max_misses = 5;
      const Tensor<1, 3>     previous   = n;
      for (;; relaxation *= 0.5)
        {
          n = previous + relaxation * step;
          n /= n.norm();
          const auto hit = other.meet(x, n, search_radius);
          if (hit || ++misses > max_misses)
            return hit;
        }
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
    auto         hit = first_hit(other, x, search_radius, opposed, n);
    // The rate of the fixed-point iteration on a surface of radius R is
    // -gap / (2 R), positive if the surface is concave.
    Tensor<1, 3> before;
    double       change = 1., relaxation = 1.;
    unsigned int misses = 0;
    for (unsigned int k = 0; hit && k < max_iterations; ++k)
      {
        const auto next = averaged_normal(n1, hit->normal);
        if (!next)
          return {};
        const Tensor<1, 3> residual = *next - n;
        change                      = residual.norm();
        if (change < small)
          break;
        if (k > 0)
          relaxation = aitken_relaxation(relaxation, before, residual);
        before = residual;
        hit    = relaxed_step(
          other, x, search_radius, residual, n, relaxation, misses);
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
