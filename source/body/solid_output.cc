// SPDX-License-Identifier: LGPL-2.1-or-later

// The fields of a solid at points, for probes, lines, contours and pictures.

#include <lamella/base/arithmetic.h>
#include <lamella/body/fields.h>
#include <lamella/body/solid.h>

#include <array>
#include <map>

namespace lamella
{
  using namespace dealii;

  FieldSample
  Solid::sample_place(const Location::Place &place, const Vector &u) const
  {
    const Hexahedron::Nodes  nodes = nodes_of(place.cell);
    const HexahedronPoint    point = element.evaluate(nodes, place.unit);
    const std::vector<Voigt> B =
      element.strains(point, kinds[kind_of_cell[place.cell]].modes);
    const std::vector<double> v     = relative_displacements(place.cell, u);
    const DofIndex            first = 3 * mesh.cells()[place.cell].nodes[0];

    Tensor<1, 3> displacement;
    Voigt        strain;
    for (unsigned int c = 0; c < 3; ++c)
      displacement[c] = u[first + c];
    for (unsigned int d = 0; d < v.size(); ++d)
      {
        displacement[d % 3] += point.N[d / 3] * v[d];
        strain += v[d] * B[d];
      }

    return sample_of(displacement,
                     strain,
                     placement,
                     ply_axes(place.cell, point.position),
                     law_at(place.cell, place.unit, point.position));
  }



  FieldSample
  Solid::sample(const Location &where, const Vector &u) const
  {
    std::vector<FieldSample> samples;
    for (const Location::Place &place : where.places)
      samples.push_back(sample_place(place, u));
    return mean_of(samples);
  }



  OutputCell
  Solid::sample_grid(const unsigned int         cell,
                     const GridIntervals       &n,
                     const std::vector<double> &etas,
                     const Vector              &u) const
  {
    const unsigned int ply = mesh.cells()[cell].ply;
    OutputCell         result;
    result.ply       = ply;
    const Triad axes = ply_axes(
      cell, element.evaluate(nodes_of(cell), Point<3>(0.5, 0.5, 0.5)).position);
    result.fibre      = placement.vector_to_scene(axes[0]);
    result.ply_normal = placement.vector_to_scene(axes[2]);
    for (unsigned int k = 0; k <= n[2]; ++k)
      for (const double eta : etas)
        for (unsigned int i = 0; i <= n[0]; ++i)
          {
            const Location::Place place{
              cell, Point<3>(double(i) / n[0], eta, double(k) / n[2])};
            result.positions.push_back(position(place));
            result.samples.push_back(sample_place(place, u));
          }
    return result;
  }



  void
  Solid::average_with_layer_before(const unsigned int cell,
                                   const Vector      &u,
                                   OutputCell        &grid) const
  {
    // The cells before share section points with this one's own: the middle of
    // one of the two sides that meet lies on the other.
    const auto middle = [this](const unsigned int of, const double eta) {
      return element.evaluate(nodes_of(of), Point<3>(0.5, eta, 0.5)).position;
    };
    const double tolerance =
      arithmetic::same_place_across * (box.side_length(0) + box.side_length(2));
    std::map<unsigned int, bool> known;
    const auto                   meets = [&](const unsigned int before) {
      const auto [found, is_new] = known.emplace(before, false);
      if (is_new)
        found->second =
          nearest_in_cell(cell, middle(before, 1.)).second < tolerance ||
          nearest_in_cell(before, middle(cell, 0.)).second < tolerance;
      return found->second;
    };
    auto locations = locate(grid.positions);
    for (unsigned int k = 0; k < grid.samples.size(); ++k)
      for (Location &where : locations[k])
        if (where.ply == grid.ply)
          {
            auto &places = where.places;
            places.erase(
              std::remove_if(places.begin(),
                             places.end(),
                             [&](const Location::Place &place) {
                               return place.cell != cell &&
                                      (place.unit[1] <
                                         1. - arithmetic::same_in_element ||
                                       !meets(place.cell));
                             }),
              places.end());
            grid.samples[k] = sample(where, u);
          }
  }



  namespace
  {
    /// The corners of a cell at its start (half = 0) or end (2) along the axis.
    std::array<unsigned int, 4>
    corners(const HexahedralMesh::Cell &cell, const unsigned int half)
    {
      return {{cell.nodes[half],
               cell.nodes[half + 1],
               cell.nodes[half + 4],
               cell.nodes[half + 5]}};
    }
  } // namespace



  std::vector<OutputCell>
  Solid::cut(const double at, const unsigned int n, const Vector &u) const
  {
    const double tolerance = arithmetic::same_place_along * axis_length;
    const auto  &all       = mesh.cells();
    const auto   y = [&](const unsigned int cell, const unsigned int k) {
      return mesh.nodes()[all[cell].nodes[k]][1];
    };
    // Where no nodes hang, a cell before has the same corners.
    std::map<std::array<unsigned int, 4>, unsigned int> before;
    for (unsigned int cell = 0; cell < all.size(); ++cell)
      if (std::abs(y(cell, 2) - at) <= tolerance)
        before[corners(all[cell], 2)] = cell;

    std::vector<OutputCell> cells;
    for (unsigned int cell = 0; cell < all.size(); ++cell)
      {
        // Corners 0 and 2 are at the cell's two ends.
        const double begin = y(cell, 0), end = y(cell, 2);
        const bool   between = at > begin + tolerance && at < end - tolerance,
                   behind    = std::abs(at - begin) <= tolerance,
                   last      = std::abs(at - end) <= tolerance &&
                          end > axis_length - tolerance;
        if (!between && !behind && !last)
          continue;
        cells.push_back(
          sample_grid(cell, {{n, 0, n}}, {(at - begin) / (end - begin)}, u));
        if (!behind || begin <= tolerance)
          continue;
        const auto found = before.find(corners(all[cell], 0));
        if (found == before.end())
          average_with_layer_before(cell, u, cells.back());
        else
          {
            const OutputCell other =
              sample_grid(found->second, {{n, 0, n}}, {1.}, u);
            for (unsigned int k = 0; k < other.samples.size(); ++k)
              cells.back().samples[k] =
                mean_of({other.samples[k], cells.back().samples[k]});
          }
      }
    return cells;
  }



  void
  Solid::for_each_output_cell(const GridIntervals   &n,
                              const Vector          &u,
                              const UseOfOutputCell &use) const
  {
    std::vector<double> etas;
    for (unsigned int j = 0; j <= n[1]; ++j)
      etas.push_back(double(j) / n[1]);
    const auto [begin, end] = mesh.owned_cells();
    for (unsigned int cell = begin; cell < end; ++cell)
      use(cell - begin, sample_grid(cell, n, etas, u));
  }
} // namespace lamella
