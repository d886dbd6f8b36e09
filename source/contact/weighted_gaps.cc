// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/inverse_map.h>
#include <lamella/contact/segments.h>
#include <lamella/contact/weighted_gaps.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Relative to the hat function's own integral: what faces less of the other
    // side does so by rounding.
    constexpr double smallest_share = arithmetic::rounding_of_results;

    // cos 80: how far from opposed the normals of a point may be in the middle
    // of others that face the other side.
    constexpr double nearly_faces = 0.17;
    constexpr double anywhere     = std::numeric_limits<double>::max();

    // Of the Gauss rule, for what is not polynomial on curved facets.
    constexpr unsigned int degrees_for_curves = 2;

    using Vector3 = Tensor<1, 3>;



    /// Sums the weights of each number, in ascending order.
    void
    merge(RowGeometry::Weights &weights)
    {
      std::sort(weights.begin(),
                weights.end(),
                [](const auto &a, const auto &b) { return a.first < b.first; });
      unsigned int n = 0;
      for (unsigned int k = 1; k < weights.size(); ++k)
        if (weights[k].first == weights[n].first)
          weights[n].second += weights[k].second;
        else
          weights[++n] = weights[k];
      weights.resize(std::min<std::size_t>(n + 1, weights.size()));
    }



    /// Numbers the locations that the weights of all rows refer to from 0 on.
    std::vector<Location>
    renumber(std::vector<WeightedGap> &gaps,
             RowGeometry::Weights WeightedGap::*weights,
             const MeshSurface                 &surface)
    {
      const unsigned int        none = numbers::invalid_unsigned_int;
      std::vector<unsigned int> place(surface.n_trace_nodes(), none);
      std::vector<Location>     locations;
      for (WeightedGap &gap : gaps)
        for (auto &weight : gap.*weights)
          {
            if (place[weight.first] == none)
              {
                place[weight.first] = locations.size();
                locations.push_back(surface.trace_location(weight.first));
              }
            weight.first = place[weight.first];
          }
      return locations;
    }



    class Integrator
    {
    public:
      explicit Integrator(const Sides &sides);

      Gaps
      run();

    private:
      /// A cell of the grid of nodes: part of a facet.
      struct Cell
      {
        unsigned int                number;
        const MeshSurface::Facet   *facet;
        Point<2>                    low, high;
        std::array<unsigned int, 4> nodes;
      };

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

      /// A point of the carrying side.
      struct CarryingPoint
      {
        Point<2> st;
        Point<3> position;
        /// Of the continuous field, and the facet's own.
        Vector3 normal, own_normal;
        /// |d_s x d_t|.
        double density;
      };

      void
      make_cells();
      CarryingPoint
      evaluate(const Cell &cell, const Point<2> &st) const;
      std::array<double, 4>
      hats(const Cell &cell, const Point<2> &st) const;
      void
      add_full_areas(const Cell &cell);
      void
      add_cell(const Cell &cell);
      void
      add_cell_against_obstacle(const Cell &cell);
      void
      add_segment(const Cell                      &cell,
                  const ChordPlane                &plane,
                  const Segment                   &segment,
                  const std::vector<unsigned int> &candidates,
                  const bool                       layered);
      void
      add_part(const Cell       &cell,
               const ChordPlane &plane,
               const Polygon    &corners);
      CarryingPoint
      point_above(const Cell       &cell,
                  const ChordPlane &plane,
                  const Point<2>   &p) const;
      /// Where @p point faces @p facet, or one of @p candidates beside it.
      struct Search
      {
        unsigned int                     facet;
        const std::vector<unsigned int> &candidates;
        bool                             layered;
      };
      std::optional<Opposition>
      opposition(const CarryingPoint &point,
                 const Search        &search,
                 const double         reach,
                 const double         opposed) const;
      void
      add_point(const Cell          &cell,
                const CarryingPoint &point,
                const double         weight,
                const Opposition    &opposite);
      void
      flush_opposing(const Cell &cell);
      void
      flush_carrying(const Cell &cell);
      void
      share_out(const MeshSurface::HangingNode &hanging);
      void
      finish(const unsigned int number);
      std::shared_ptr<const CarryingSurface>
      carrying_surface();

      const Sides       &sides;
      const MeshSurface &carrying;
      std::vector<Cell>  cells;
      std::vector<Node>  nodes;
      Gaps               result;
      /// Of each facet what faces the other side, in its unit square.
      std::vector<std::vector<Polygon>> parts;

      /// Of the current cell: integrals of hat times trace function times n,
      /// those of the opposing side for one facet at a time.
      std::vector<Vector3> carrying_sums, opposing_sums;
      unsigned int         opposing_facet = numbers::invalid_unsigned_int;
      std::vector<double>  trace;
    };



    Integrator::Integrator(const Sides &sides)
      : sides(sides)
      , carrying(*sides.carrying)
    {
      make_cells();
    }



    void
    Integrator::make_cells()
    {
      nodes.resize(carrying.grid_nodes().size());
      parts.resize(carrying.facets().size());
      for (unsigned int f = 0; f < carrying.facets().size(); ++f)
        {
          const MeshSurface::Facet &facet = carrying.facets()[f];
          const GaussLobattoBasis  &s = *facet.grid_s, &t = *facet.grid_t;
          const auto               &numbers = facet.grid_nodes;
          for (unsigned int j = 0; j + 1 < t.size(); ++j)
            for (unsigned int i = 0; i + 1 < s.size(); ++i)
              {
                const unsigned int k = j * s.size() + i;
                cells.push_back({f,
                                 &facet,
                                 Point<2>(s.point(i), t.point(j)),
                                 Point<2>(s.point(i + 1), t.point(j + 1)),
                                 {{numbers[k],
                                   numbers[k + 1],
                                   numbers[k + s.size()],
                                   numbers[k + s.size() + 1]}}});
              }
        }
    }



    Integrator::CarryingPoint
    Integrator::evaluate(const Cell &cell, const Point<2> &st) const
    {
      const auto    place   = cell.facet->map(st);
      const Vector3 normal  = cell.facet->map.outward(place);
      const double  density = normal.norm();
      return {st,
              place.position,
              carrying.smooth_normal(*cell.facet, st),
              normal / density,
              density};
    }



    std::array<double, 4>
    Integrator::hats(const Cell &cell, const Point<2> &st) const
    {
      const double s = (st[0] - cell.low[0]) / (cell.high[0] - cell.low[0]),
                   t = (st[1] - cell.low[1]) / (cell.high[1] - cell.low[1]);
      return {{(1. - s) * (1. - t), s * (1. - t), (1. - s) * t, s * t}};
    }



    void
    Integrator::add_full_areas(const Cell &cell)
    {
      const QGauss<2>    rule(3);
      const Tensor<1, 2> size = cell.high - cell.low;
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          const Point<2> st(cell.low[0] + rule.point(q)[0] * size[0],
                            cell.low[1] + rule.point(q)[1] * size[1]);
          const double   dA =
            rule.weight(q) * size[0] * size[1] * evaluate(cell, st).density;
          const auto phi = hats(cell, st);
          for (unsigned int i = 0; i < 4; ++i)
            nodes[cell.nodes[i]].full_area += phi[i] * dA;
        }
    }



    void
    Integrator::add_cell(const Cell &cell)
    {
      std::array<Point<3>, 4> corners;
      for (unsigned int k = 0; k < 4; ++k)
        corners[k] = cell.facet
                       ->map(Point<2>((k % 2 == 0 ? cell.low : cell.high)[0],
                                      (k / 2 == 0 ? cell.low : cell.high)[1]))
                       .position;
      const CarryingPoint middle =
        evaluate(cell, cell.low + 0.5 * (cell.high - cell.low));
      const ChordPlane plane(corners, middle.own_normal);

      const auto facing   = opposing_place(*sides.opposing,
                                         middle.position,
                                         middle.normal,
                                         sides.reach);
      const auto segments = cut(plane,
                                facing ? facing->normal : middle.normal,
                                *sides.opposing_mesh,
                                sides.reach);

      // Facets that overlap lie behind each other.
      std::vector<unsigned int> candidates;
      double                    covered = 0.;
      for (const Segment &segment : segments)
        {
          candidates.push_back(segment.facet);
          covered += segment.area;
        }
      const bool layered = covered > (1. + arithmetic::integrated) * plane.area;
      for (const Segment &segment : segments)
        add_segment(cell, plane, segment, candidates, layered);
    }



    void
    Integrator::add_cell_against_obstacle(const Cell &cell)
    {
      const unsigned int degree = std::max(cell.facet->side.trace_degree_s,
                                           cell.facet->side.trace_degree_t);
      const QGauss<2>    rule(degree / 2 + 1 + degrees_for_curves);
      const Tensor<1, 2> size  = cell.high - cell.low;
      bool               faces = false;
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          const CarryingPoint point =
            evaluate(cell,
                     Point<2>(cell.low[0] + rule.point(q)[0] * size[0],
                              cell.low[1] + rule.point(q)[1] * size[1]));
          const auto opposite = opposing_place(*sides.opposing,
                                               point.position,
                                               point.normal,
                                               sides.reach);
          if (opposite)
            add_point(cell,
                      point,
                      rule.weight(q) * size[0] * size[1] * point.density,
                      *opposite);
          faces |= opposite.has_value();
        }
      if (faces)
        parts[cell.number].push_back({cell.low,
                                      Point<2>(cell.high[0], cell.low[1]),
                                      cell.high,
                                      Point<2>(cell.low[0], cell.high[1])});
    }



    void
    Integrator::add_segment(const Cell                      &cell,
                            const ChordPlane                &plane,
                            const Segment                   &segment,
                            const std::vector<unsigned int> &candidates,
                            const bool                       layered)
    {
      const MeshSurface::Facet &other =
        sides.opposing_mesh->facets()[segment.facet];
      const SurfaceFacet &a = cell.facet->side, &b = other.side;
      // A hat function is of degree 2 on triangles.
      const unsigned int degree =
        2 +
        std::max(a.trace_degree_s + a.trace_degree_t,
                 b.trace_degree_s + b.trace_degree_t) +
        (cell.facet->map.is_affine() && other.map.is_affine() ?
           0 :
           degrees_for_curves);
      const Quadrature<2> &rule    = triangle_rule(degree);
      const Polygon       &corners = segment.polygon;
      // A segment faces the other side as a whole or not at all, as its middle
      // does: were its points to decide one by one, the area of a row at the
      // end of the reach would be a matter of where the rule has its points.
      const Search search{segment.facet, candidates, layered};
      if (!opposition(point_above(cell, plane, centroid(corners)),
                      search,
                      sides.reach,
                      faces_from_60))
        return;
      add_part(cell, plane, corners);
      for (unsigned int k = 1; k + 1 < corners.size(); ++k)
        {
          const Tensor<1, 2> along  = corners[k] - corners[0],
                             across = corners[k + 1] - corners[0];
          const double twice_area = along[0] * across[1] - along[1] * across[0];
          for (unsigned int q = 0; q < rule.size() && twice_area > 0.; ++q)
            {
              const CarryingPoint point =
                point_above(cell,
                            plane,
                            corners[0] + rule.point(q)[0] * along +
                              rule.point(q)[1] * across);
              const auto opposite =
                opposition(point, search, anywhere, nearly_faces);
              if (opposite)
                add_point(cell,
                          point,
                          rule.weight(q) * twice_area /
                            (point.own_normal * plane.normal),
                          *opposite);
            }
        }
    }



    /// @p corners of what of @p cell faces the other side, in its chord plane.
    void
    Integrator::add_part(const Cell       &cell,
                         const ChordPlane &plane,
                         const Polygon    &corners)
    {
      Polygon part;
      for (const Point<2> &corner : corners)
        part.push_back(point_above(cell, plane, corner).st);
      // (s, t) and the plane may look at the facet from different sides.
      if (area(part) < 0.)
        std::reverse(part.begin(), part.end());
      parts[cell.number].push_back(part);
    }



    Integrator::CarryingPoint
    Integrator::point_above(const Cell       &cell,
                            const ChordPlane &plane,
                            const Point<2>   &p) const
    {
      const auto missing = [&](const Point<2> &st) {
        const auto   place = cell.facet->map(st);
        Tensor<2, 2> in_plane;
        in_plane[0][0] = place.d_s * plane.e1;
        in_plane[0][1] = place.d_t * plane.e1;
        in_plane[1][0] = place.d_s * plane.e2;
        in_plane[1][1] = place.d_t * plane.e2;
        return std::make_pair(p - plane.project(place.position, plane.normal),
                              in_plane);
      };
      const Point<2> st = inverse_image(cell.low + 0.5 * (cell.high - cell.low),
                                        cell.facet->map.is_affine(),
                                        missing,
                                        [](const Point<2> &) { return true; })
                            .unit;
      return evaluate(cell, st);
    }



    std::optional<Opposition>
    Integrator::opposition(const CarryingPoint &point,
                           const Search        &search,
                           const double         reach,
                           const double         opposed) const
    {
      const MeshSurface              &mesh = *sides.opposing_mesh;
      const std::vector<unsigned int> own{search.facet};
      const auto                      on_own = opposing_place(
        SurfacePart(mesh, own), point.position, point.normal, reach, opposed);
      // Next to the edge of a curved facet the neighbour's segment may begin a
      // little earlier or later than the facet, or be a sliver that was left
      // out.
      if (!on_own)
        {
          const auto beside =
            opposing_place(SurfacePart(mesh, search.candidates),
                           point.position,
                           point.normal,
                           reach,
                           opposed);
          return beside ? beside :
                          opposing_place(mesh,
                                         point.position,
                                         point.normal,
                                         std::min(reach, 2. * sides.reach),
                                         opposed);
        }
      if (search.layered)
        {
          const auto   nearest  = mesh.meet_among(search.candidates,
                                               point.position,
                                               on_own->normal,
                                               reach);
          const double rounding = arithmetic::same_place * mesh.body().size();
          if (nearest && std::abs(nearest->distance) + rounding <
                           std::abs(on_own->hit.distance))
            return {};
        }
      return on_own;
    }



    void
    Integrator::add_point(const Cell          &cell,
                          const CarryingPoint &point,
                          const double         weight,
                          const Opposition    &opposite)
    {
      const double depth = opposing_depth(sides, opposite.hit);
      if (is_too_deep(opposite.hit.distance, cell.facet->depth, depth))
        {
          result.too_deep.push_back(
            {point.position, opposite.hit.position, -opposite.hit.distance});
          return;
        }

      result.points.push_back({{cell.number, point.st},
                               {opposite.hit.facet, opposite.hit.st},
                               weight});
      const auto phi = hats(cell, point.st);
      for (unsigned int i = 0; i < 4; ++i)
        {
          Node        &node  = nodes[cell.nodes[i]];
          WeightedGap &sums  = node.sums;
          const double share = phi[i] * weight;
          if (phi[i] > node.nearest)
            {
              node.nearest  = phi[i];
              sums.opposite = opposite.hit.position;
              sums.angle    = opposite.angle;
            }
          sums.area += share;
          sums.gap += share * opposite.hit.distance;
          sums.normal += share * opposite.normal;
          sums.carrying.normal_modulus += share * cell.facet->normal_modulus;
          sums.carrying.depth += share * cell.facet->depth;
          if (sides.opposing_mesh != nullptr)
            {
              const MeshSurface::Facet &other =
                sides.opposing_mesh->facets()[opposite.hit.facet];
              sums.opposing.normal_modulus += share * other.normal_modulus;
              sums.opposing.depth += share * other.depth;
            }
        }

      const auto add = [&](std::vector<Vector3> &sums) {
        const unsigned int n = trace.size();
        sums.resize(4 * n);
        for (unsigned int i = 0; i < 4; ++i)
          for (unsigned int j = 0; j < n; ++j)
            sums[i * n + j] += (phi[i] * weight * trace[j]) * opposite.normal;
      };
      carrying.evaluate_trace(*cell.facet, point.st, trace);
      add(carrying_sums);
      if (sides.opposing_mesh == nullptr)
        return;
      if (opposite.hit.facet != opposing_facet)
        flush_opposing(cell);
      opposing_facet = opposite.hit.facet;
      sides.opposing_mesh->evaluate_trace(
        sides.opposing_mesh->facets()[opposing_facet], opposite.hit.st, trace);
      add(opposing_sums);
    }



    void
    Integrator::flush_opposing(const Cell &cell)
    {
      if (opposing_sums.empty())
        return;
      const auto &numbers =
        sides.opposing_mesh->facets()[opposing_facet].trace_nodes;
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int j = 0; j < numbers.size(); ++j)
          nodes[cell.nodes[i]].sums.opposing_weights.emplace_back(
            numbers[j], opposing_sums[i * numbers.size() + j]);
      opposing_sums.clear();
    }



    void
    Integrator::flush_carrying(const Cell &cell)
    {
      if (carrying_sums.empty())
        return;
      const auto &numbers = cell.facet->trace_nodes;
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int j = 0; j < numbers.size(); ++j)
          nodes[cell.nodes[i]].sums.carrying_weights.emplace_back(
            numbers[j], carrying_sums[i * numbers.size() + j]);
      carrying_sums.clear();
    }



    /// The hats of a continuous space: that of a hanging node belongs in halves
    /// to those of the nodes that it hangs between.
    void
    Integrator::share_out(const MeshSurface::HangingNode &hanging)
    {
      const Node &from = nodes[hanging.node];
      for (const unsigned int end : hanging.ends)
        {
          Node        &to   = nodes[end];
          WeightedGap &sums = to.sums;
          to.full_area += 0.5 * from.full_area;
          sums.area += 0.5 * from.sums.area;
          sums.gap += 0.5 * from.sums.gap;
          sums.normal += 0.5 * from.sums.normal;
          for (const auto side :
               {&WeightedGap::carrying, &WeightedGap::opposing})
            {
              (sums.*side).normal_modulus +=
                0.5 * (from.sums.*side).normal_modulus;
              (sums.*side).depth += 0.5 * (from.sums.*side).depth;
            }
          for (const auto weights :
               {&WeightedGap::carrying_weights, &WeightedGap::opposing_weights})
            for (const auto &[number, weight] : from.sums.*weights)
              (sums.*weights).emplace_back(number, 0.5 * weight);
        }
      nodes[hanging.node] = Node();
    }



    void
    Integrator::finish(const unsigned int number)
    {
      Node        &node = nodes[number];
      WeightedGap &gap  = node.sums;
      if (gap.area <= smallest_share * node.full_area)
        {
          ++result.unpaired;
          return;
        }
      gap.node     = carrying.grid_location(number);
      gap.position = carrying.grid_nodes()[number].position;
      gap.spacing  = std::sqrt(node.full_area);
      gap.gap /= gap.area;
      gap.normal /= gap.area;
      for (LocalStiffness *side : {&gap.carrying, &gap.opposing})
        {
          side->area = gap.area;
          side->normal_modulus /= gap.area;
          side->depth /= gap.area;
        }
      if (sides.opposing_mesh == nullptr)
        gap.opposing = gap.carrying;
      for (auto *weights : {&gap.carrying_weights, &gap.opposing_weights})
        {
          merge(*weights);
          for (auto &[number, weight] : *weights)
            weight /= gap.area;
        }
      const auto facing = opposing_place(*sides.opposing,
                                         gap.position,
                                         carrying.grid_nodes()[number].normal,
                                         sides.reach);
      if (facing)
        {
          gap.opposite = facing->hit.position;
          gap.angle    = facing->angle;
        }
      node.rows = {{result.gaps.size(), 1.}};
      result.gaps.push_back(std::move(gap));
    }



    std::shared_ptr<const CarryingSurface>
    Integrator::carrying_surface()
    {
      // Those that others hang on come later, and are known before.
      const auto &hanging = carrying.hanging_nodes();
      for (auto node = hanging.rbegin(); node != hanging.rend(); ++node)
        for (const unsigned int end : node->ends)
          for (const auto &[row, share] : nodes[end].rows)
            nodes[node->node].rows.emplace_back(row, 0.5 * share);
      std::vector<CarryingSurface::Facet> facets;
      std::vector<unsigned int>           numbers(parts.size());
      for (unsigned int f = 0; f < parts.size(); ++f)
        {
          if (parts[f].empty())
            continue;
          numbers[f]                      = facets.size();
          const MeshSurface::Facet &facet = carrying.facets()[f];
          facets.push_back({facet.map,
                            facet.side.degree_s,
                            facet.side.degree_t,
                            facet.nodes_of_body,
                            {},
                            parts[f]});
          for (const unsigned int node : facet.grid_nodes)
            facets.back().rows.push_back(nodes[node].rows);
        }
      for (GapPoint &point : result.points)
        point.part = numbers[point.carrying.facet];
      return std::make_shared<const CarryingSurface>(
        CarryingSurface::Functions::hats,
        result.gaps.size(),
        std::move(facets));
    }



    Gaps
    Integrator::run()
    {
      for (const Cell &cell : cells)
        {
          add_full_areas(cell);
          if (sides.opposing_mesh != nullptr)
            add_cell(cell);
          else
            add_cell_against_obstacle(cell);
          flush_carrying(cell);
          flush_opposing(cell);
        }
      std::vector<bool> hangs(nodes.size(), false);
      for (const MeshSurface::HangingNode &hanging : carrying.hanging_nodes())
        {
          // Those that others hang on come later.
          Assert(!hangs[hanging.ends[0]] && !hangs[hanging.ends[1]],
                 ExcInternalError());
          share_out(hanging);
          hangs[hanging.node] = true;
        }
      for (unsigned int k = 0; k < nodes.size(); ++k)
        if (!hangs[k])
          finish(k);
      result.surface = carrying_surface();
      result.carrying =
        renumber(result.gaps, &WeightedGap::carrying_weights, carrying);
      if (sides.opposing_mesh != nullptr)
        result.opposing = renumber(result.gaps,
                                   &WeightedGap::opposing_weights,
                                   *sides.opposing_mesh);
      return std::move(result);
    }
  } // namespace



  Gaps
  weighted_gaps(const Sides &sides)
  {
    return Integrator(sides).run();
  }
} // namespace lamella
