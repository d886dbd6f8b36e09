// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/body/surface_node.h>

#include <cmath>

namespace lamella
{
  using namespace dealii;

  void
  SurfaceNode::meet(const SurfacePoint &at)
  {
    const double cos_corner = std::cos(20. * numbers::PI / 180.);
    if (!met)
      {
        point        = at;
        point.corner = false;
      }
    else if (at.normal * point.normal < cos_corner)
      point.corner = true;
    met = true;
  }



  void
  SurfaceNode::distribute_to_ends(SurfaceNode &one_end, SurfaceNode &other_end)
  {
    for (SurfaceNode *end : {&one_end, &other_end})
      {
        end->area += 0.5 * area;
        end->weighted += 0.5 * weighted;
      }
    met = false;
  }



  SurfacePoint
  SurfaceNode::finished() const
  {
    SurfacePoint result = point;
    result.area         = area;
    result.normal       = weighted / weighted.norm();
    return result;
  }
} // namespace lamella
