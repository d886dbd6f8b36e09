// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_multiplier_basis_h
#define lamella_contact_multiplier_basis_h

#include <lamella/contact/pairing.h>
#include <lamella/contact/segments.h>

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace lamella
{
  /// Multiplier functions phi_i (hat functions) on the grid of the slave nodes,
  /// with their mortar integrals for weighted_gaps(). Grid cells lie between
  /// adjacent Gauss-Lobatto points of a facet; phi_i is bilinear in the facet
  /// parameters on each cell. Call add() at all points of a cell, then close().
  class MultiplierBasis
  {
  public:
    /// A grid cell: the rectangle of a facet between adjacent slave nodes.
    struct Cell
    {
      unsigned int              number;  ///< Index of the facet.
      const MeshSurface::Facet *facet;   ///< Facet of the slave surface.
      dealii::Point<2>          low,     ///< Smallest parameters (s, t).
        high;                            ///< Largest parameters (s, t).
      std::array<unsigned int, 4> nodes; ///< Grid nodes at the corners.

      /// Returns the facet parameters of @p unit, a point in the unit square.
      dealii::Point<2>
      at(const dealii::Point<2> &unit) const
      {
        return {low[0] + unit[0] * (high[0] - low[0]),
                low[1] + unit[1] * (high[1] - low[1])};
      }
    };

    /// Creates the grid cells on the slave surface of @p sides.
    explicit MultiplierBasis(const ContactSurfacePair &sides);

    /// Returns the grid cells of all facets.
    const std::vector<Cell> &
    cells() const
    {
      return grid;
    }

    /// Adds the integrals of the four hat functions over the whole @p cell,
    /// whether or not it faces the master surface.
    void
    add_full_areas(const Cell &cell);

    /// Adds the integration point @p st of @p cell, with the area @p weight and
    /// the point @p opposite on the master surface, to the mortar integrals.
    void
    add(const Cell             &cell,
        const dealii::Point<2> &st,
        const double            weight,
        const MasterPoint      &opposite);

    /// Completes the integrals on @p cell; no more points may be added to it.
    void
    close(const Cell &cell);

    /// Computes one weighted gap per grid node. Sets the gaps of @p result with
    /// their points and the slave surface, but not the integration points. @p
    /// parts are the polygons of each facet that face the master surface.
    void
    finish(const std::vector<std::vector<Polygon>> &parts, Gaps &result);

  private:
    /// Sums of the integrals of one hat function.
    struct Node
    {
      WeightedGap sums;
      /// Largest value of the function at integration points up to now.
      double nearest = 0.;
      /// Integral of the function over all of its cells.
      double full_area = 0.;
      /// Weighted gaps to which the function contributes, with factors.
      std::vector<std::pair<unsigned int, double>> rows;
    };

    std::array<double, 4>
    values(const Cell &cell, const dealii::Point<2> &st) const;
    void
    add_traces(const Cell                  &cell,
               const dealii::Point<2>      &st,
               const std::array<double, 4> &share,
               const MasterPoint           &opposite);
    void
    close_master(const Cell &cell);
    void
    distribute_to_ends(const MeshSurface::HangingNode &hanging);
    void
    add_row(const unsigned int number, Gaps &result);
    std::shared_ptr<const SlaveSurface>
    slave_surface(const std::vector<std::vector<Polygon>> &parts, Gaps &result);

    const ContactSurfacePair &sides;
    const MeshSurface        &slave;
    std::vector<Cell>         grid;
    std::vector<Node>         nodes;

    /// Integrals of hat function times trace function times n on the current
    /// cell (on the master side for one facet at a time).
    std::vector<dealii::Tensor<1, 3>> slave_sums, master_sums;
    unsigned int                      master_facet;
    std::vector<double>               trace;
  };
} // namespace lamella

#endif
