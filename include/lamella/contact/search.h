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

  /// Numbers points in the order that they come in.
  class PointNumbering
  {
  public:
    /// Points closer than @p tolerance (a length) are at one place.
    explicit PointNumbering(const double tolerance);

    /// The numbers of the points at the place of @p x.
    std::vector<unsigned int>
    at(const dealii::Point<3> &x) const;

    /// The next number, for a point at @p x.
    unsigned int
    add(const dealii::Point<3> &x);

    /// The number of the place of @p x, a new one if it has none yet.
    unsigned int
    number(const dealii::Point<3> &x);

    unsigned int
    size() const
    {
      return tree.size();
    }

  private:
    using Numbered = std::pair<dealii::Point<3>, unsigned int>;
    double                  tolerance;
    dealii::RTree<Numbered> tree;
  };

  /// Finds the boxes of a set that meet a given one, by Boost's R-tree.
  class BoxSearch
  {
  public:
    BoxSearch() = default;
    explicit BoxSearch(const std::vector<dealii::BoundingBox<3>> &boxes);

    /// Numbers of the boxes that meet @p box, ascending.
    std::vector<unsigned int>
    meeting(const dealii::BoundingBox<3> &box) const;

    /// The number of the box nearest to @p x.
    unsigned int
    nearest(const dealii::Point<3> &x) const;

  private:
    using Numbered = std::pair<dealii::BoundingBox<3>, unsigned int>;
    dealii::RTree<Numbered> tree;
  };
} // namespace lamella

#endif
