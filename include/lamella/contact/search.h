// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_search_h
#define lamella_contact_search_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>

#include <deal.II/numerics/rtree.h>

#include <utility>
#include <vector>

namespace lamella
{
  /// Nearest-neighbor search in a fixed set of points with Boost's packed
  /// R-tree. Numbers are indices in the list.
  class PointSearch
  {
  public:
    explicit PointSearch(const std::vector<dealii::Point<3>> &points);

    /// Returns the numbers of the @p n nearest points (or all), nearest first.
    std::vector<unsigned int>
    nearest(const dealii::Point<3> &x, const unsigned int n) const;

  private:
    using Numbered = std::pair<dealii::Point<3>, unsigned int>;
    dealii::RTree<Numbered> tree;
  };

  /// Search in a fixed set of axis-parallel boxes with Boost's packed R-tree,
  /// the coarse phase of contact search. Numbers are indices in the list.
  class BoxSearch
  {
  public:
    /// Creates an empty set, for which nearest() must not be called.
    BoxSearch() = default;
    explicit BoxSearch(const std::vector<dealii::BoundingBox<3>> &boxes);

    /// Returns the numbers of all boxes that meet @p box, ascending.
    std::vector<unsigned int>
    meeting(const dealii::BoundingBox<3> &box) const;

    /// Returns the number of a box nearest to @p x, or that contains x.
    unsigned int
    nearest(const dealii::Point<3> &x) const;

  private:
    using Numbered = std::pair<dealii::BoundingBox<3>, unsigned int>;
    dealii::RTree<Numbered> tree;
  };
} // namespace lamella

#endif
