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



  BoxSearch::BoxSearch(const std::vector<BoundingBox<3>> &boxes)
  {
    std::vector<Numbered> numbered;
    for (unsigned int i = 0; i < boxes.size(); ++i)
      numbered.emplace_back(boxes[i], i);
    tree = pack_rtree(numbered);
  }



  std::vector<unsigned int>
  BoxSearch::meeting(const BoundingBox<3> &box) const
  {
    std::vector<Numbered>     found;
    std::vector<unsigned int> numbers;
    tree.query(boost::geometry::index::intersects(box),
               std::back_inserter(found));
    for (const Numbered &one : found)
      numbers.push_back(one.second);
    std::sort(numbers.begin(), numbers.end());
    return numbers;
  }



  unsigned int
  BoxSearch::nearest(const Point<3> &x) const
  {
    std::vector<Numbered> found;
    tree.query(boost::geometry::index::nearest(x, 1),
               std::back_inserter(found));
    Assert(!found.empty(), ExcMessage("There are no boxes."));
    return found.front().second;
  }
} // namespace lamella
