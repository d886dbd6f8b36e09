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
  /// Nearest-neighbor search in a fixed list of points with Boost's packed
  /// R-tree. Results are indices in that list.
  class PointSearch
  {
  public:
    /// Builds the tree of @p points [length]; their indices are the results.
    explicit PointSearch(const std::vector<dealii::Point<3>> &points);

    /// Returns the indices of the @p n points nearest to @p x, nearest first;
    /// all points if there are fewer than @p n.
    std::vector<unsigned int>
    nearest(const dealii::Point<3> &x, const unsigned int n) const;

  private:
    using Numbered = std::pair<dealii::Point<3>, unsigned int>;
    dealii::RTree<Numbered> tree;
  };

  /// Search in a fixed list of axis-parallel boxes with Boost's packed R-tree,
  /// the coarse phase of contact search. Results are indices in that list.
  class BoxSearch // NOLINT(bugprone-exception-escape): moves of the R-tree
  {
  public:
    /// Creates an empty list, for which nearest() must not be called.
    BoxSearch() = default;
    /// Builds the tree of @p boxes [length]; their indices are the results.
    explicit BoxSearch(const std::vector<dealii::BoundingBox<3>> &boxes);

    /// Returns the ascending indices of all boxes that intersect @p box.
    std::vector<unsigned int>
    meeting(const dealii::BoundingBox<3> &box) const;

    /// Returns the index of the box that contains @p x, or else of the nearest.
    unsigned int
    nearest(const dealii::Point<3> &x) const;

  private:
    using Numbered = std::pair<dealii::BoundingBox<3>, unsigned int>;
    dealii::RTree<Numbered> tree;
  };
} // namespace lamella

#endif
