// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_hat_functions_h
#define lamella_contact_hat_functions_h

#include <lamella/contact/pairing.h>
#include <lamella/contact/segments.h>

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace lamella
{
  /**
   * The hat functions on the grid of the carrying side's nodes, and what they
   * gather of the gap: the integrals of weighted_gaps(). The grid's cells are
   * those between Gauss-Lobatto points, each a part of a facet; phi_i is
   * bilinear in the facet's (s, t) on each.
   *
   * Cells are taken one after the other: add() for each point of one, then
   * close().
   */
  class HatFunctions
  {
  public:
    /// A cell of the grid of nodes: part of a facet.
    struct Cell
    {
      unsigned int                number;
      const MeshSurface::Facet   *facet;
      dealii::Point<2>            low, high;
      std::array<unsigned int, 4> nodes;

      dealii::Point<2>
      at(const dealii::Point<2> &unit) const
      {
        return {low[0] + unit[0] * (high[0] - low[0]),
                low[1] + unit[1] * (high[1] - low[1])};
      }
    };

    explicit HatFunctions(const Sides &sides);

    const std::vector<Cell> &
    cells() const
    {
      return grid;
    }

    /// Adds the integrals over all of @p cell, whatever it faces.
    void
    add_full_areas(const Cell &cell);

    /// Adds what a point of @p cell at @p st has with its part @p weight of the
    /// area, @p opposite to it.
    void
    add(const Cell             &cell,
        const dealii::Point<2> &st,
        const double            weight,
        const Opposition       &opposite);

    /// No more points of @p cell.
    void
    close(const Cell &cell);

    /// The averages, in the order of the grid's nodes; fills all of @p result
    /// but its points. @p parts are, of each facet, what faces the other side,
    /// in its unit square. To be called once.
    void
    finish(std::vector<std::vector<Polygon>> parts, Gaps &result);

  private:
    /// What a hat function gathers.
    struct Node
    {
      WeightedGap sums;
      /// The largest value of the hat function where the other side was met:
      /// that place stands for what the node faces.
      double nearest = 0.;
      /// The integral over all of its cells, whatever they face.
      double full_area = 0.;
      /// The rows that the function belongs to, and its share in them.
      std::vector<std::pair<unsigned int, double>> rows;
    };

    std::array<double, 4>
    values(const Cell &cell, const dealii::Point<2> &st) const;
    void
    add_traces(const Cell                  &cell,
               const dealii::Point<2>      &st,
               const std::array<double, 4> &share,
               const Opposition            &opposite);
    void
    close_opposing(const Cell &cell);
    void
    share_out(const MeshSurface::HangingNode &hanging);
    void
    add_row(const unsigned int node, Gaps &result);
    std::shared_ptr<const CarryingSurface>
    carrying_surface(const std::vector<std::vector<Polygon>> &parts,
                     Gaps                                    &result);

    const Sides       &sides;
    const MeshSurface &carrying;
    std::vector<Cell>  grid;
    std::vector<Node>  nodes;

    /// Of the current cell: integrals of hat times trace function times n,
    /// those of the opposing side for one facet at a time.
    std::vector<dealii::Tensor<1, 3>> carrying_sums, opposing_sums;
    unsigned int                      opposing_facet;
    std::vector<double>               trace;
  };
} // namespace lamella

#endif
