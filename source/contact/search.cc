// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/contact/search.h>

#include <algorithm>

namespace lamella
{
  using namespace dealii;

  PointSearch::PointSearch(const std::vector<Point<3>> &points)
  {
    std::vector<Numbered> numbered;
    for (unsigned int i = 0; i < points.size(); ++i)
      numbered.emplace_back(points[i], i);
    tree = pack_rtree(numbered);
  }



  std::vector<unsigned int>
  PointSearch::nearest(const Point<3> &x, const unsigned int n) const
  {
    std::vector<Numbered> found;
    tree.query(boost::geometry::index::nearest(x, n),
               std::back_inserter(found));
    std::sort(found.begin(),
              found.end(),
              [&x](const Numbered &a, const Numbered &b) {
                return a.first.distance_square(x) < b.first.distance_square(x);
              });
    std::vector<unsigned int> numbers;
    for (const Numbered &point : found)
      numbers.push_back(point.second);
    return numbers;
  }
} // namespace lamella
