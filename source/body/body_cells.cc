// SPDX-License-Identifier: LGPL-2.1-or-later

// Functions of a body's element maps: crossings by lines, cuts, pictures.

#include <lamella/base/arithmetic.h>
#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/base/inverse_map.h>
#include <lamella/body/cell_grid.h>
#include <lamella/body/fields.h>
#include <lamella/body/line_crossings.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// The corners of an element, deal.II's order.
    std::vector<Point<3>>
    corners_of(const Body &body, const unsigned int cell)
    {
      return CellGrid(GridIntervals{{1, 1, 1}}).positions(body, cell);
    }



    /// Adds the parameter at which the line a + t d meets the side of a cell
    /// where its unit coordinate @p normal is @p side, the bilinear surface
    /// through its corners; nothing if the line is along it.
    void
    add_side_crossing(const std::vector<Point<3>> &corners,
                      const unsigned int           normal,
                      const unsigned int           side,
                      const Point<3>              &a,
                      const Tensor<1, 3>          &d,
                      std::vector<double>         &crossings)
    {
      const CellGrid     corner_grid(GridIntervals{{1, 1, 1}});
      const unsigned int s = normal == 0 ? 1 : 0, t = normal == 2 ? 1 : 2;
      // Of (s, t, parameter along the line).
      const auto missing = [&](const Point<3> &x) {
        Point<3> unit;
        unit[normal]           = side;
        unit[s]                = x[0];
        unit[t]                = x[1];
        const auto   functions = corner_grid.evaluate(unit);
        Tensor<1, 3> rest      = a + x[2] * d;
        for (unsigned int k = 0; k < corners.size(); ++k)
          rest -= functions.N[k] * corners[k];
        const Tensor<2, 3> by_unit = unit_gradient(corners, functions);
        Tensor<2, 3>       jacobian;
        for (unsigned int c = 0; c < 3; ++c)
          {
            jacobian[c][0] = by_unit[c][s];
            jacobian[c][1] = by_unit[c][t];
            jacobian[c][2] = -d[c];
          }
        return std::make_pair(rest, jacobian);
      };
      const auto is_near = [](Point<3> &x) {
        return std::abs(x[0] - 0.5) < 2. && std::abs(x[1] - 0.5) < 2.;
      };
      const InverseImage<3> found =
        inverse_image(Point<3>(0.5, 0.5, 0.5), false, missing, is_near);
      const double at_least = -arithmetic::same_in_element;
      if (found.change < arithmetic::same_unit &&
          std::min(found.unit[0], found.unit[1]) > at_least &&
          std::max(found.unit[0], found.unit[1]) < 1. - at_least)
        crossings.push_back(found.unit[2]);
    }



    /// Returns the fields of the element @p cell at @p etas in [0, 1] along the
    /// axis, with @p n intervals in the section.
    OutputCell
    sample_grid(const Body                &body,
                const unsigned int         cell,
                const GridIntervals       &n,
                const std::vector<double> &etas,
                const Vector              &u)
    {
      const PlyAndAxes middle = body.ply_at({cell, Point<3>(0.5, 0.5, 0.5)});
      OutputCell       result;
      result.ply        = middle.ply;
      result.fiber      = body.place().vector_to_scene(middle.axes[0]);
      result.ply_normal = body.place().vector_to_scene(middle.axes[2]);
      for (unsigned int k = 0; k <= n[2]; ++k)
        for (const double eta : etas)
          for (unsigned int i = 0; i <= n[0]; ++i)
            {
              const Location::Place place{
                cell, Point<3>(double(i) / n[0], eta, double(k) / n[2])};
              result.positions.push_back(body.position(place));
              result.samples.push_back(
                body.sample({result.positions.back(), result.ply, {place}}, u));
            }
      return result;
    }



    /// Returns true if the elements @p before and @p cell are axial neighbors.
    bool
    is_adjacent(const Body        &body,
                const unsigned int before,
                const unsigned int cell)
    {
      const auto middle_is_on = [&body](const unsigned int of,
                                        const double       eta,
                                        const unsigned int other) {
        const auto found =
          body.locate({body.position({of, Point<3>(0.5, eta, 0.5)})})[0];
        return std::any_of(found.begin(), found.end(), [&](const Location &at) {
          return std::any_of(at.places.begin(),
                             at.places.end(),
                             [&](const Location::Place &place) {
                               return place.cell == other;
                             });
        });
      };
      return middle_is_on(before, 1., cell) || middle_is_on(cell, 0., before);
    }



    /// Replaces the fields of @p grid on the face of the element @p cell
    /// nearest to the start by means with those of the adjacent element.
    void
    average_with_previous_layer(const Body        &body,
                                const unsigned int cell,
                                const Vector      &u,
                                OutputCell        &grid)
    {
      // The cells before share section points with this one's own: the middle
      // of one of the two sides that meet lies on the other.
      std::map<unsigned int, bool> known;
      const auto                   counts = [&](const Location::Place &place) {
        if (place.cell == cell)
          return true;
        if (place.unit[1] < 1. - arithmetic::same_in_element)
          return false;
        const auto [found, is_new] = known.emplace(place.cell, false);
        if (is_new)
          found->second = is_adjacent(body, place.cell, cell);
        return found->second;
      };
      auto locations = body.locate(grid.positions);
      for (unsigned int k = 0; k < grid.samples.size(); ++k)
        for (Location &where : locations[k])
          if (where.ply == grid.ply)
            {
              auto &places = where.places;
              places.erase(std::remove_if(places.begin(),
                                          places.end(),
                                          [&](const Location::Place &place) {
                                            return !counts(place);
                                          }),
                           places.end());
              grid.samples[k] = body.sample(where, u);
            }
    }



    /// The elements of a body along its axis: their ends, and the element
    /// before one that begins at a cut, with the same corners if no nodes hang.
    class Layers
    {
    public:
      Layers(const Body &body, const double cut)
        : body(body)
        , unit(arithmetic::same_position * body.size())
      {
        const unsigned int n = body.cells().n;
        for (unsigned int cell = 0; cell < n; ++cell)
          {
            ranges.emplace_back(along(cell, 0.), along(cell, 1.));
            length = std::max(length, ranges.back().second);
          }
        for (unsigned int cell = 0; cell < n; ++cell)
          if (std::abs(ranges[cell].second - cut) <= tolerance())
            by_end[side(cell, 1.)] = cell;
      }

      /// A length: what is nearer is at the same place along the axis.
      double
      tolerance() const
      {
        return arithmetic::same_position_along * length;
      }

      /// A cell's begin and end.
      std::pair<double, double>
      range(const unsigned int cell) const
      {
        return ranges[cell];
      }

      double
      end() const
      {
        return length;
      }

      std::optional<unsigned int>
      before(const unsigned int cell) const
      {
        const auto found = by_end.find(side(cell, 0.));
        return found == by_end.end() ? std::nullopt :
                                       std::make_optional(found->second);
      }

    private:
      double
      along(const unsigned int cell, const double eta) const
      {
        return body.place().to_body(
          body.position({cell, Point<3>(0., eta, 0.)}))[1];
      }

      /// Corners of a side, rounded far below element size, far above rounding.
      std::array<long, 12>
      side(const unsigned int cell, const double eta) const
      {
        std::array<long, 12> key;
        for (unsigned int v = 0; v < 4; ++v)
          {
            const Point<3> x =
              body.position({cell, Point<3>(v % 2, eta, v > 1 ? 1. : 0.)});
            for (unsigned int c = 0; c < 3; ++c)
              key[3 * v + c] = std::lround(x[c] / unit);
          }
        return key;
      }

      const Body                                  &body;
      double                                       unit, length = 0.;
      std::vector<std::pair<double, double>>       ranges;
      std::map<std::array<long, 12>, unsigned int> by_end;
    };
  } // namespace



  BoundingBox<3>
  Body::bounding_box() const
  {
    std::vector<Point<3>> corners;
    for (unsigned int cell = 0; cell < cells().n; ++cell)
      for (const Point<3> &corner : corners_of(*this, cell))
        corners.push_back(corner);
    return BoundingBox<3>(corners);
  }



  std::vector<double>
  Body::line_breaks(const Point<3> &from, const Point<3> &to) const
  {
    BoundingBox<3> around(std::vector<Point<3>>{from, to});
    around.extend(arithmetic::same_position_across * size());
    std::vector<double> breaks;
    for (unsigned int cell = 0; cell < cells().n; ++cell)
      {
        const std::vector<Point<3>> corners = corners_of(*this, cell);
        if (around.get_neighbor_type(BoundingBox<3>(corners)) ==
            NeighborType::not_neighbors)
          continue;
        for (unsigned int normal = 0; normal < 3; ++normal)
          for (const unsigned int side : {0, 1})
            add_side_crossing(corners, normal, side, from, to - from, breaks);
      }
    return merge_breaks(std::move(breaks));
  }



  unsigned int
  Body::line_degree(const Point<3> &from, const Point<3> &to) const
  {
    const GridIntervals degrees = cells().degrees;
    const Tensor<1, 3>  d       = placement.vector_to_body(to - from);
    unsigned int        sum     = 0;
    for (unsigned int c = 0; c < 3; ++c)
      if (std::abs(d[c]) > arithmetic::same_position_along * d.norm())
        sum += degrees[c];
    return sum;
  }



  std::vector<OutputCell>
  Body::cut(const double position, const unsigned int n, const Vector &u) const
  {
    const Layers            layers(*this, position);
    const double            tolerance = layers.tolerance();
    std::vector<OutputCell> found;
    for (unsigned int cell = 0; cell < cells().n; ++cell)
      {
        const auto [begin, end] = layers.range(cell);
        const bool between =
                     position > begin + tolerance && position < end - tolerance,
                   behind = std::abs(position - begin) <= tolerance,
                   last   = std::abs(position - end) <= tolerance &&
                          end > layers.end() - tolerance;
        if (!between && !behind && !last)
          continue;
        found.push_back(sample_grid(
          *this, cell, {{n, 0, n}}, {(position - begin) / (end - begin)}, u));
        if (!behind || begin <= tolerance)
          continue;
        if (const auto before = layers.before(cell))
          {
            const OutputCell other =
              sample_grid(*this, *before, {{n, 0, n}}, {1.}, u);
            for (unsigned int k = 0; k < other.samples.size(); ++k)
              found.back().samples[k] =
                mean_sample({other.samples[k], found.back().samples[k]});
          }
        else
          average_with_previous_layer(*this, cell, u, found.back());
      }
    return found;
  }



  void
  Body::for_each_output_cell(const GridIntervals      &n,
                             const Vector             &u,
                             const OutputCellCallback &use) const
  {
    std::vector<double> etas;
    for (unsigned int j = 0; j <= n[1]; ++j)
      etas.push_back(double(j) / n[1]);
    const auto [begin, end] = cells().own;
    for (unsigned int cell = begin; cell < end; ++cell)
      use(cell - begin, sample_grid(*this, cell, n, etas, u));
  }



  std::vector<OutputCell>
  output_cells(const Body &body, const unsigned int n, const Vector &u)
  {
    std::vector<OutputCell> cells;
    body.for_each_output_cell({{n, n, n}},
                              u,
                              [&cells](const unsigned int number,
                                       const OutputCell  &cell) {
                                if (number >= cells.size())
                                  cells.resize(number + 1);
                                cells[number] = cell;
                              });
    return cells;
  }



  CellGrid::CellGrid(const GridIntervals &degrees)
    : degrees(degrees)
  {
    std::array<const GaussLobattoBasis *, 3> basis;
    for (unsigned int d = 0; d < 3; ++d)
      basis[d] = &GaussLobattoBasis::of_degree(degrees[d]);
    for (unsigned int k = 0; k <= degrees[2]; ++k)
      for (unsigned int j = 0; j <= degrees[1]; ++j)
        for (unsigned int i = 0; i <= degrees[0]; ++i)
          grid.emplace_back(basis[0]->point(i),
                            basis[1]->point(j),
                            basis[2]->point(k));
  }



  CellGrid::Functions
  CellGrid::evaluate(const Point<3> &unit) const
  {
    using Values = std::array<double, GaussLobattoBasis::max_size>;
    std::array<Values, 3> L, dL;
    for (unsigned int d = 0; d < 3; ++d)
      GaussLobattoBasis::of_degree(degrees[d])
        .evaluate(unit[d], L[d].data(), dL[d].data());
    Functions functions;
    for (unsigned int k = 0; k <= degrees[2]; ++k)
      for (unsigned int j = 0; j <= degrees[1]; ++j)
        for (unsigned int i = 0; i <= degrees[0]; ++i)
          {
            functions.N.push_back(L[0][i] * L[1][j] * L[2][k]);
            functions.dN.push_back(Point<3>(dL[0][i] * L[1][j] * L[2][k],
                                            L[0][i] * dL[1][j] * L[2][k],
                                            L[0][i] * L[1][j] * dL[2][k]));
          }
    return functions;
  }



  std::vector<Point<3>>
  CellGrid::positions(const Body &body, const unsigned int cell) const
  {
    std::vector<Point<3>> x;
    for (const Point<3> &unit : grid)
      x.push_back(body.position({cell, unit}));
    return x;
  }
} // namespace lamella
