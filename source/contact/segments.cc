// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/contact/segments.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <map>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    double
    cross(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
    {
      return a[0] * b[1] - a[1] * b[0];
    }



    // Relative to the area of the piece that is cut.
    constexpr double sliver = 1e-11;

    // Facets that look less than this against the direction of projection (a
    // cosine) are seen from the side.
    constexpr double edge_on = 0.1;



    void
    make_counterclockwise(Polygon &polygon)
    {
      if (area(polygon) < 0.)
        std::reverse(polygon.begin(), polygon.end());
    }
  } // namespace



  double
  area(const Polygon &polygon)
  {
    double sum = 0.;
    for (unsigned int i = 1; i + 1 < polygon.size(); ++i)
      sum += 0.5 * cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
    return sum;
  }



  Point<2>
  centroid(const Polygon &polygon)
  {
    Tensor<1, 2> moment;
    double       sum = 0.;
    for (unsigned int i = 1; i + 1 < polygon.size(); ++i)
      {
        const Tensor<1, 2> a = polygon[i] - polygon[0],
                           b = polygon[i + 1] - polygon[0];
        const double twice   = cross(a, b);
        moment += twice / 3. * (a + b);
        sum += twice;
      }
    return polygon[0] + moment / sum;
  }



  Polygon
  clipped(const Polygon &polygon, const Polygon &window)
  {
    Polygon result = polygon;
    for (unsigned int k = 0; k < window.size() && !result.empty(); ++k)
      {
        // What lies left of the line from p along d.
        const Point<2>    &p = window[k];
        const Tensor<1, 2> d = window[(k + 1) % window.size()] - p;
        result               = part_above(result,
                            [&](const Point<2> &x) { return cross(d, x - p); });
      }
    return result;
  }



  Polygon
  part_above(const Polygon                                 &polygon,
             const std::function<double(const Point<2> &)> &height)
  {
    std::vector<double> heights;
    for (const Point<2> &corner : polygon)
      heights.push_back(height(corner));
    Polygon result;
    for (unsigned int i = 0; i < polygon.size(); ++i)
      {
        const unsigned int next = (i + 1) % polygon.size();
        const double       of_a = heights[i], of_b = heights[next];
        if (of_a >= 0.)
          result.push_back(polygon[i]);
        if ((of_a > 0. && of_b < 0.) || (of_a < 0. && of_b > 0.))
          result.push_back(polygon[i] +
                           of_a / (of_a - of_b) * (polygon[next] - polygon[i]));
      }
    return result;
  }



  const Quadrature<2> &
  triangle_rule(const unsigned int degree)
  {
    // Witherden and Vincent's rules end at degree 13.
    static std::map<unsigned int, Quadrature<2>> rules;
    const auto                                   known = rules.find(degree);
    if (known != rules.end())
      return known->second;
    return rules
      .emplace(degree,
               degree > 13 ?
                 Quadrature<2>(QDuffy(degree / 2 + 2, 1.)) :
                 Quadrature<2>(QWitherdenVincentSimplex<2>(degree / 2 + 1)))
      .first->second;
  }



  ChordPlane::ChordPlane(const std::array<Point<3>, 4> &corners,
                         const Tensor<1, 3>            &outward)
    : origin(corners[0])
  {
    normal = cross_product_3d(corners[3] - corners[0], corners[2] - corners[1]);
    normal = normal / normal.norm();
    if (normal * outward < 0.)
      normal = -normal;
    e1 = corners[1] - corners[0];
    e1 = e1 - (e1 * normal) * normal;
    e1 = e1 / e1.norm();
    e2 = cross_product_3d(normal, e1);
    for (const unsigned int k : {0, 1, 3, 2})
      outline.push_back(project(corners[k], normal));
    make_counterclockwise(outline);
    area = lamella::area(outline);
  }



  Point<2>
  ChordPlane::project(const Point<3> &x, const Tensor<1, 3> &direction) const
  {
    const Tensor<1, 3> r = x - origin;
    const Tensor<1, 3> in_plane =
      r - (r * normal) / (direction * normal) * direction;
    return {in_plane * e1, in_plane * e2};
  }



  std::vector<Segment>
  cut(const ChordPlane   &plane,
      const Tensor<1, 3> &direction,
      const MeshSurface  &other,
      const double        search_radius)
  {
    // The prism in which the other surface may lie.
    std::vector<Point<3>> prism;
    for (const Point<2> &corner : plane.outline)
      for (const double along : {-search_radius, search_radius})
        prism.push_back(plane.origin + corner[0] * plane.e1 +
                        corner[1] * plane.e2 + along * direction);

    std::vector<Segment> segments;
    Polygon              window(4);
    for (const unsigned int f : other.facets_near(prism))
      {
        const MeshSurface::Facet &facet = other.facets()[f];
        if (facet.normal * direction > -edge_on)
          continue;
        const auto &x = facet.side.corners;
        window        = {plane.project(x[0], direction),
                         plane.project(x[1], direction),
                         plane.project(x[3], direction),
                         plane.project(x[2], direction)};
        make_counterclockwise(window);
        Segment segment;
        segment.facet   = f;
        segment.polygon = clipped(plane.outline, window);
        segment.area    = area(segment.polygon);
        if (segment.area > sliver * plane.area)
          segments.push_back(std::move(segment));
      }
    return segments;
  }
} // namespace lamella
