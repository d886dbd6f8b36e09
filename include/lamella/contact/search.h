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
  /// Nearest-neighbour search in a fixed set of points, by Boost's R-tree,
  /// packed at once: O(n log n) to make, O(log n) a query as a rule. The points
  /// are copied. Numbers are places in the list that the set was made from.
  class PointSearch
  {
  public:
    explicit PointSearch(const std::vector<dealii::Point<3>> &points);

    /// Numbers of the @p n nearest points of the set, nearest first. Fewer if
    /// the set has fewer. Equally near ones come in no certain order.
    std::vector<unsigned int>
    nearest(const dealii::Point<3> &x, const unsigned int n) const;

  private:
    using Numbered = std::pair<dealii::Point<3>, unsigned int>;
    dealii::RTree<Numbered> tree;
  };

  /// Finds the axis-parallel boxes of a fixed set that meet a given one, or the
  /// nearest one, by Boost's R-tree, packed at once. The boxes are copied. This
  /// is the coarse phase of contact search; rays are met with the facets
  /// themselves in MeshSurface.
  class BoxSearch
  {
  public:
    /// No boxes; nearest() must not be called then.
    BoxSearch() = default;
    explicit BoxSearch(const std::vector<dealii::BoundingBox<3>> &boxes);

    /// Numbers of the boxes that meet @p box, ascending. Boxes that only touch
    /// count. Ascending, so results do not depend on the tree.
    std::vector<unsigned int>
    meeting(const dealii::BoundingBox<3> &box) const;

    /// The number of the box nearest to @p x. Distance 0 if @p x is in it; of
    /// several any.
    unsigned int
    nearest(const dealii::Point<3> &x) const;

  private:
    using Numbered = std::pair<dealii::BoundingBox<3>, unsigned int>;
    dealii::RTree<Numbered> tree;
  };
} // namespace lamella

#endif
