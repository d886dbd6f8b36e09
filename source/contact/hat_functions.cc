// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/contact/hat_functions.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Relative to the hat function's own integral: what faces less of the other
    // side does so by rounding.
    constexpr double smallest_share = arithmetic::rounding_of_results;



    /// Sums the weights of each number, in ascending order.
    void
    merge(ConstraintGeometry::Weights &weights)
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
    renumber(std::vector<WeightedGap>   &gaps,
             ConstraintGeometry::Weights WeightedGap::*weights,
             const MeshSurface                        &surface)
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
  } // namespace



  HatFunctions::HatFunctions(const Sides &sides)
    : sides(sides)
    , carrying(*sides.carrying)
    , nodes(carrying.grid_nodes().size())
    , opposing_facet(numbers::invalid_unsigned_int)
  {
    for (unsigned int f = 0; f < carrying.facets().size(); ++f)
      {
        const MeshSurface::Facet &facet = carrying.facets()[f];
        const GaussLobattoBasis  &s = *facet.grid_s, &t = *facet.grid_t;
        const auto               &numbers = facet.grid_nodes;
        for (unsigned int j = 0; j + 1 < t.size(); ++j)
          for (unsigned int i = 0; i + 1 < s.size(); ++i)
            {
              const unsigned int k = j * s.size() + i;
              grid.push_back({f,
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



  std::array<double, 4>
  HatFunctions::values(const Cell &cell, const Point<2> &st) const
  {
    const double s = (st[0] - cell.low[0]) / (cell.high[0] - cell.low[0]),
                 t = (st[1] - cell.low[1]) / (cell.high[1] - cell.low[1]);
    return {{(1. - s) * (1. - t), s * (1. - t), (1. - s) * t, s * t}};
  }



  void
  HatFunctions::add_full_areas(const Cell &cell)
  {
    const QGauss<2>    rule(3);
    const Tensor<1, 2> size = cell.high - cell.low;
    for (unsigned int q = 0; q < rule.size(); ++q)
      {
        const Point<2> st = cell.at(rule.point(q));
        const double   dA = rule.weight(q) * size[0] * size[1] *
                          cell.facet->map.outward(cell.facet->map(st)).norm();
        const auto phi = values(cell, st);
        for (unsigned int i = 0; i < 4; ++i)
          nodes[cell.nodes[i]].full_area += phi[i] * dA;
      }
  }



  void
  HatFunctions::add(const Cell       &cell,
                    const Point<2>   &st,
                    const double      weight,
                    const Opposition &opposite)
  {
    const auto            phi = values(cell, st);
    std::array<double, 4> shares;
    for (unsigned int i = 0; i < 4; ++i)
      {
        Node        &node  = nodes[cell.nodes[i]];
        WeightedGap &sums  = node.sums;
        const double share = shares[i] = phi[i] * weight;
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
    add_traces(cell, st, shares, opposite);
  }



  void
  HatFunctions::add_traces(const Cell                  &cell,
                           const Point<2>              &st,
                           const std::array<double, 4> &share,
                           const Opposition            &opposite)
  {
    const auto add = [&](std::vector<Tensor<1, 3>> &sums) {
      const unsigned int n = trace.size();
      sums.resize(4 * n);
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int j = 0; j < n; ++j)
          sums[i * n + j] += (share[i] * trace[j]) * opposite.normal;
    };
    carrying.evaluate_trace(*cell.facet, st, trace);
    add(carrying_sums);
    if (sides.opposing_mesh == nullptr)
      return;
    if (opposite.hit.facet != opposing_facet)
      close_opposing(cell);
    opposing_facet = opposite.hit.facet;
    sides.opposing_mesh->evaluate_trace(
      sides.opposing_mesh->facets()[opposing_facet], opposite.hit.st, trace);
    add(opposing_sums);
  }



  void
  HatFunctions::close_opposing(const Cell &cell)
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
  HatFunctions::close(const Cell &cell)
  {
    close_opposing(cell);
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
  HatFunctions::share_out(const MeshSurface::HangingNode &hanging)
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
        for (const auto side : {&WeightedGap::carrying, &WeightedGap::opposing})
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
  HatFunctions::add_row(const unsigned int number, Gaps &result)
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
  HatFunctions::carrying_surface(const std::vector<std::vector<Polygon>> &parts,
                                 Gaps &result)
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
      CarryingSurface::Functions::hats, result.gaps.size(), std::move(facets));
  }



  void
  HatFunctions::finish(std::vector<std::vector<Polygon>> parts, Gaps &result)
  {
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
        add_row(k, result);
    result.surface = carrying_surface(parts, result);
    result.carrying =
      renumber(result.gaps, &WeightedGap::carrying_weights, carrying);
    if (sides.opposing_mesh != nullptr)
      result.opposing = renumber(result.gaps,
                                 &WeightedGap::opposing_weights,
                                 *sides.opposing_mesh);
  }
} // namespace lamella
