// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/linear_functional.h>
#include <lamella/conditions/stabilization.h>

namespace lamella
{
  using namespace dealii;

  Point<3>
  centroid_of(const std::vector<SurfacePoint> &points)
  {
    Tensor<1, 3> centroid;
    double       area = 0.;
    for (const SurfacePoint &point : points)
      {
        centroid += point.area * point.position;
        area += point.area;
      }
    return Point<3>(centroid / area);
  }



  namespace
  {
    /// Of @p points those furthest from @p x.
    std::vector<SurfacePoint>
    farthest_from(const Point<3> &x, const std::vector<SurfacePoint> &points)
    {
      double                    most = 0.;
      std::vector<SurfacePoint> found;
      for (const SurfacePoint &point : points)
        most = std::max(most, x.distance(point.position));
      for (const SurfacePoint &point : points)
        if (x.distance(point.position) > (1. - arithmetic::same_value) * most)
          found.push_back(point);
      return found;
    }



    /// E A / L.
    double
    axial_stiffness(const Body &body)
    {
      const auto start = body.surface_points("start"),
                 end   = body.surface_points("end");
      double stiffness = 0.;
      for (const SurfacePoint &point : start)
        stiffness += point.normal_modulus * point.area;
      return stiffness / centroid_of(end).distance(centroid_of(start));
    }



    /// What each of @p n points counts: four in all, however many there are.
    double
    weight(const std::size_t n)
    {
      return 4. / n;
    }



    /// Displacements at the points, one after the other.
    using PointMotion = std::vector<Tensor<1, 3>>;

    double
    product(const PointMotion &a, const PointMotion &b)
    {
      double sum = 0.;
      for (unsigned int p = 0; p < a.size(); ++p)
        sum += a[p] * b[p];
      return weight(a.size()) * sum;
    }



    std::vector<PointMotion>
    orthonormal(const std::vector<PointMotion> &motions)
    {
      std::vector<PointMotion> result;
      for (PointMotion motion : motions)
        {
          make_orthogonal(motion, result, product);
          const double norm = std::sqrt(product(motion, motion));
          for (Tensor<1, 3> &v : motion)
            v /= norm;
          result.push_back(std::move(motion));
        }
      return result;
    }



    /// What the points of @p body do in each of the motions @p free.
    std::vector<PointMotion>
    motions_of(const std::vector<FreeMotion> &free,
               const std::vector<Point<3>>   &points,
               const Body                    &body)
    {
      std::vector<PointMotion> motions;
      for (const FreeMotion &one : free)
        {
          motions.emplace_back();
          for (const Point<3> &x : points)
            motions.back().push_back(one.at(x, body));
        }
      return motions;
    }



    /// The spring on the only DoF of an obstacle under a given force.
    Spring
    guide_spring(const Stabilization &stabilization)
    {
      Spring spring{{},
                    stabilization.share *
                      axial_stiffness(*stabilization.pressed),
                    stabilization.share,
                    motion_along_force};
      spring.row.add(0, 1.);
      return spring;
    }
  } // namespace



  std::vector<SurfacePoint>
  farthest_points(const Body &body, const std::string &surface)
  {
    const std::vector<SurfacePoint> points = body.surface_points(surface);
    std::vector<SurfacePoint> far = farthest_from(centroid_of(points), points);
    if (far.size() == 1)
      for (const SurfacePoint &point : farthest_from(far[0].position, points))
        far.push_back(point);
    return far;
  }



  std::vector<Spring>
  stabilizing_springs(const Body                              &body,
                      const unsigned int                       index,
                      const std::vector<PrescribedFunctional> &rows,
                      const Stabilization                     &stabilization)
  {
    if (stabilization.share == 0.)
      return {};
    if (stabilization.pressed != nullptr)
      return {guide_spring(stabilization)};
    const std::vector<FreeMotion> free = free_rigid_motions(body, index, rows);
    if (free.empty())
      return {};

    std::vector<Point<3>> points;
    std::vector<Location> locations;
    for (const char *surface : {"start", "end"})
      for (const SurfacePoint &point : farthest_points(body, surface))
        {
          points.push_back(point.position);
          locations.push_back(point.location);
        }
    const std::vector<PointMotion> motions =
      orthonormal(motions_of(free, points, body));

    const double        stiffness = stabilization.share * axial_stiffness(body);
    const auto          u         = body.rows(locations, undisplaced);
    std::vector<Spring> springs;
    for (unsigned int k = 0; k < free.size(); ++k)
      {
        Spring spring{{}, stiffness, stabilization.share, free[k].words};
        for (unsigned int p = 0; p < points.size(); ++p)
          for (unsigned int c = 0; c < 3; ++c)
            spring.row.add(u[p][c], weight(points.size()) * motions[k][p][c]);
        spring.row.compress();
        springs.push_back(std::move(spring));
      }
    return springs;
  }
} // namespace lamella
