// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_search_h
#define lamella_contact_search_h

#include <deal.II/base/point.h>

#include <deal.II/numerics/rtree.h>

#include <utility>
#include <vector>

namespace lamella
{
  /// Finds the points of a set near a given one, by Boost's R-tree.
  class PointSearch
  {
  public:
    explicit PointSearch(const std::vector<dealii::Point<3>> &points);

    /// Numbers of the @p n nearest points of the set, nearest first.
    std::vector<unsigned int>
    nearest(const dealii::Point<3> &x, const unsigned int n) const;

  private:
    using Numbered = std::pair<dealii::Point<3>, unsigned int>;
    dealii::RTree<Numbered> tree;
  };
} // namespace lamella

#endif
