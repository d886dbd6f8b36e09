// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/contact/body_ends.h>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    std::vector<Point<3>>
    nodes_at_ends(const Body &body)
    {
      std::vector<Point<3>> nodes;
      for (const char *const end : {"start", "end"})
        for (const SurfacePoint &point : body.surface_points(end))
          nodes.push_back(point.position);
      return nodes;
    }
  } // namespace



  BodyEnds::BodyEnds(const Body &body)
    : near(arithmetic::same_position * body.size())
    , nodes(nodes_at_ends(body))
    , search(nodes)
  {}



  bool
  BodyEnds::has(const Point<3> &x) const
  {
    return x.distance(nodes[search.nearest(x, 1).front()]) <= near;
  }
} // namespace lamella
