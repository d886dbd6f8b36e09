// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/contact/assumptions.h>

#include <algorithm>
#include <array>
#include <optional>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// One of the two surfaces of a contact.
    struct Side
    {
      /// Body of the surface; null for an obstacle.
      std::vector<SurfacePoint> points;
      /// Direction of the straight generators, or the normal of a plane.
      Tensor<1, 3> ruling;
      bool         is_plane = false;
    };



    Side
    side_of(const Body &body, const std::string &surface)
    {
      return {body.surface_points(surface),
              body.place().vector_to_scene(Point<3>(0., 1., 0.))};
    }



    Side
    side_of(const Obstacle &obstacle)
    {
      return {{}, obstacle.direction, obstacle.shape == Obstacle::Shape::plane};
    }



    /// Returns the normal of @p side near the points @p near if flat there.
    std::optional<Tensor<1, 3>>
    flat_normal(const Side &side, const std::vector<Point<3>> &near)
    {
      if (side.is_plane)
        return side.ruling;
      std::optional<Tensor<1, 3>> normal;
      for (const Point<3> &x : near)
        {
          const auto nearest =
            std::min_element(side.points.begin(),
                             side.points.end(),
                             [&x](const auto &a, const auto &b) {
                               return x.distance_square(a.position) <
                                      x.distance_square(b.position);
                             });
          if (nearest == side.points.end() ||
              (normal && cross_product_3d(*normal, nearest->normal).norm() >
                           arithmetic::parallel_sine))
            return {};
          if (!normal)
            normal = nearest->normal;
        }
      return normal;
    }



    /// Returns the normal, along @p n, that both sides share where they touch.
    Tensor<1, 3>
    common_normal(Tensor<1, 3>                                n,
                  const std::array<Side, 2>                  &sides,
                  const std::array<std::vector<Point<3>>, 2> &near)
    {
      const std::array<std::optional<Tensor<1, 3>>, 2> flat{
        {flat_normal(sides[0], near[0]), flat_normal(sides[1], near[1])}};
      if (flat[0] && flat[1] &&
          cross_product_3d(*flat[0], *flat[1]).norm() >
            arithmetic::parallel_sine)
        return n / n.norm();
      for (const auto &normal : flat)
        if (normal)
          return (*normal * n < 0. ? -1. : 1.) * *normal;
      std::vector<Tensor<1, 3>> generators;
      for (const Side &side : sides)
        {
          Tensor<1, 3> along = side.ruling;
          for (const Tensor<1, 3> &other : generators)
            along -= (along * other) * other;
          if (along.norm() > arithmetic::parallel_sine)
            generators.push_back(along / along.norm());
        }
      for (const Tensor<1, 3> &along : generators)
        n -= (n * along) * along;
      return n / n.norm();
    }



    /// Returns the rows of @p interface with gaps less than @p depth above the
    /// smallest one, in ascending order.
    std::vector<unsigned int>
    closest_rows(const ContactInterface &interface, const double depth)
    {
      std::vector<unsigned int> rows;
      for (unsigned int k = 0; k < interface.rows.size(); ++k)
        if (interface.points[k].normal.norm() > 0.)
          rows.push_back(k);
      const auto gap = [&interface](const unsigned int k) {
        return interface.rows[k].initial_gap;
      };
      std::stable_sort(rows.begin(),
                       rows.end(),
                       [&gap](const unsigned int a, const unsigned int b) {
                         return gap(a) < gap(b);
                       });
      rows.erase(std::find_if(rows.begin(),
                              rows.end(),
                              [&](const unsigned int k) {
                                return gap(k) > gap(rows.front()) + depth;
                              }),
                 rows.end());
      return rows;
    }
  } // namespace



  std::vector<MainNormal>
  main_normals(const ContactPair      &contact,
               const ContactInterface &interface,
               const Bodies           &bodies,
               const double            depth)
  {
    // The cosine of 60 degrees.
    constexpr double alike = 0.5;

    const std::array<Side, 2> sides{
      {side_of(*bodies[interface.first_body], contact.first.surface),
       interface.second_body ?
         side_of(*bodies[*interface.second_body], contact.second.surface) :
         side_of(*interface.obstacle)}};
    std::vector<unsigned int> rows = closest_rows(interface, depth);
    std::vector<MainNormal>   result;
    while (!rows.empty())
      {
        const Tensor<1, 3> n      = interface.points[rows.front()].normal;
        const auto         others = std::stable_partition(
          rows.begin(), rows.end(), [&](const unsigned int k) {
            const Tensor<1, 3> &m = interface.points[k].normal;
            return m * n > alike * m.norm() * n.norm();
          });
        std::array<std::vector<Point<3>>, 2> near;
        for (auto k = rows.begin(); k != others; ++k)
          {
            near[0].push_back(interface.points[*k].first);
            near[1].push_back(interface.points[*k].second);
          }
        const Tensor<1, 3> main = common_normal(n, sides, near);
        for (auto k = rows.begin(); k != others; ++k)
          result.push_back({*k, main});
        rows.erase(rows.begin(), others);
      }
    return result;
  }
} // namespace lamella
