// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/contact/pairing.h>
#include <lamella/contact/search.h>

#include <cmath>
#include <limits>

namespace lamella
{
  using namespace dealii;

  Pairing
  pair_node_to_node(const std::vector<SurfacePoint> &first,
                    const std::vector<SurfacePoint> &second,
                    const double                     tolerance)
  {
    std::vector<Point<3>> positions;
    for (const SurfacePoint &point : second)
      positions.push_back(point.position);
    const PointSearch search(positions);

    Pairing result;
    result.nearest_distance = std::numeric_limits<double>::max();
    result.smallest_offset  = std::numeric_limits<double>::max();
    for (unsigned int i = 0; i < first.size(); ++i)
      {
        // Nodes of both surfaces face each other, so the nearest one is it. A
        // node of an edge may have a twin of another normal at the same place.
        bool paired = false;
        for (const unsigned int j : search.nearest(first[i].position, 3))
          {
            const Tensor<1, 3> &n = first[i].normal;
            const Tensor<1, 3>  d = second[j].position - first[i].position;
            // Bodies that touch have a gap of rounding only.
            const double rounding =
              1e-14 * (first[i].position.norm() + second[j].position.norm());
            const double gap    = std::abs(d * n) < rounding ? 0. : d * n;
            const double offset = (d - gap * n).norm();
            result.nearest_distance =
              std::min(result.nearest_distance, d.norm());
            const bool opposed = n * second[j].normal < -0.5;
            if (opposed)
              result.smallest_offset = std::min(result.smallest_offset, offset);
            if (opposed && offset <= tolerance * std::sqrt(first[i].area))
              {
                result.pairs.push_back({i, j, n, gap});
                paired = true;
                break;
              }
          }
        result.unpaired += !paired;
      }
    return result;
  }
} // namespace lamella
