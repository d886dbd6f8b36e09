// SPDX-License-Identifier: LGPL-2.1-or-later

// Where along bodies a scene asks for stresses (node_fields.h).

#include <lamella/adapt/node_fields.h>
#include <lamella/recover/box_points.h>

#include <algorithm>

namespace lamella
{
  using namespace dealii;

  std::vector<StressRange>
  stress_ranges(const Bodies             &bodies,
                const std::vector<Probe> &probes,
                const std::vector<Line>  &lines,
                const std::vector<Cut>   &cuts)
  {
    std::vector<StressRange> places;
    const auto               add = [&](const unsigned int           body,
                         const std::vector<Point<3>> &corners) {
      std::vector<double> along;
      for (const Point<3> &corner : corners)
        along.push_back(bodies[body]->place().to_body(corner)[1]);
      const auto [least, greatest] =
        std::minmax_element(along.begin(), along.end());
      places.push_back({body, *least, *greatest});
    };
    for (const Probe &probe : probes)
      add(probe.body, box_corners(probe.position, probe.box));
    for (const Line &line : lines)
      add(line.body, {line.from, line.to});
    for (const Cut &cut : cuts)
      places.push_back({cut.body, cut.position, cut.position});
    return places;
  }
} // namespace lamella
