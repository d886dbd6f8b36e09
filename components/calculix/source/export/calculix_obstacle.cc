// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/export/calculix_element.h>
#include <lamella/export/calculix_obstacle.h>

#include <deal.II/base/numbers.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    constexpr double largest_angle = 2. * numbers::PI / 180.;
    constexpr double margin        = 0.05;
    /// Elements each way along a plane.
    constexpr unsigned int n_along_plane = 8;



    struct Range
    {
      double begin = std::numeric_limits<double>::max(),
             end   = -std::numeric_limits<double>::max();

      void
      add(const double value)
      {
        begin = std::min(begin, value);
        end   = std::max(end, value);
      }

      double
      length() const
      {
        return end - begin;
      }

      void
      widen(const double by)
      {
        begin -= by;
        end += by;
      }

      double
      at(const double share) const
      {
        return begin + share * length();
      }
    };



    /// n_s x n_t hexahedra, their nodes where @p place puts the (s, t, depth)
    /// of the unit cube; depth 1 is the surface.
    ObstacleLayer
    grid(const unsigned int                                     n_s,
         const unsigned int                                     n_t,
         const std::function<Point<3>(double, double, double)> &place)
    {
      const CalculixElement                               element("C3D20R");
      std::map<std::array<unsigned int, 3>, unsigned int> numbers;
      ObstacleLayer                                       layer;
      for (unsigned int i = 0; i < n_s; ++i)
        for (unsigned int j = 0; j < n_t; ++j)
          {
            layer.elements.emplace_back();
            for (unsigned int k = 0; k < element.n_nodes(); ++k)
              {
                const Point<3>                   &unit = element.unit_node(k);
                const std::array<unsigned int, 3> halves{
                  {2 * i + static_cast<unsigned int>(2. * unit[0]),
                   2 * j + static_cast<unsigned int>(2. * unit[1]),
                   static_cast<unsigned int>(2. * unit[2])}};
                const auto [at, is_new] =
                  numbers.insert({halves, layer.nodes.size()});
                if (is_new)
                  layer.nodes.push_back(place(0.5 * halves[0] / n_s,
                                              0.5 * halves[1] / n_t,
                                              unit[2]));
                layer.elements.back().push_back(at->second);
              }
          }
      return layer;
    }



    /// Any unit vector across @p n.
    Tensor<1, 3>
    across(const Tensor<1, 3> &n)
    {
      unsigned int least = 0;
      for (unsigned int d = 1; d < 3; ++d)
        if (std::abs(n[d]) < std::abs(n[least]))
          least = d;
      Tensor<1, 3> e;
      e[least] = 1.;
      e -= (e * n) * n;
      return e / e.norm();
    }



    ObstacleLayer
    plane_layer(const Obstacle &plane, const std::vector<Point<3>> &facing)
    {
      const Tensor<1, 3> n = plane.direction, e = across(n),
                         f = cross_product_3d(n, e);
      Range s, t;
      for (const Point<3> &x : facing)
        {
          s.add((x - plane.point) * e);
          t.add((x - plane.point) * f);
        }
      const double larger = std::max(s.length(), t.length());
      s.widen(margin * larger + std::abs(plane.displacement * e));
      t.widen(margin * larger + std::abs(plane.displacement * f));
      return grid(n_along_plane,
                  n_along_plane,
                  [&](const double a, const double b, const double depth) {
                    return plane.point + s.at(a) * e + t.at(b) * f +
                           0.1 * larger * (depth - 1.) * n;
                  });
    }



    ObstacleLayer
    cylinder_layer(const Obstacle              &cylinder,
                   const std::vector<Point<3>> &facing)
    {
      const Tensor<1, 3> axis = cylinder.direction;
      // Angles are counted from the middle of what faces.
      Tensor<1, 3> middle;
      Range        along, angle;
      for (const Point<3> &x : facing)
        {
          const Tensor<1, 3> r = x - cylinder.point;
          middle += r - (r * axis) * axis;
          along.add(r * axis);
        }
      const Tensor<1, 3> up   = middle / middle.norm(),
                         side = cross_product_3d(axis, up);
      for (const Point<3> &x : facing)
        {
          const Tensor<1, 3> r = x - cylinder.point;
          angle.add(std::atan2(r * side, r * up));
        }
      const Tensor<1, 3> &u = cylinder.displacement;
      along.widen(margin * along.length() + std::abs(u * axis));
      angle.widen(margin * angle.length() +
                  std::abs(u * side) / cylinder.radius);
      const unsigned int n_s =
        static_cast<unsigned int>(std::ceil(angle.length() / largest_angle));
      // Ten times as long as wide.
      const unsigned int n_t = static_cast<unsigned int>(
        std::ceil(0.1 * along.length() / (cylinder.radius * largest_angle)));
      return grid(n_s,
                  n_t,
                  [&](const double a, const double b, const double depth) {
                    const double r   = cylinder.radius * (0.9 + 0.1 * depth),
                                 phi = angle.at(a);
                    return cylinder.point + along.at(b) * axis +
                           r * (std::cos(phi) * up + std::sin(phi) * side);
                  });
    }
  } // namespace



  ObstacleLayer
  make_layer(const Obstacle &obstacle, const std::vector<Point<3>> &facing)
  {
    ObstacleLayer layer = obstacle.shape == Obstacle::Shape::plane ?
                            plane_layer(obstacle, facing) :
                            cylinder_layer(obstacle, facing);
    layer.displacement  = obstacle.displacement;
    return layer;
  }
} // namespace lamella
