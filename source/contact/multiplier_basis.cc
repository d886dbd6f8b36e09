// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/contact/multiplier_basis.h>

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



  MultiplierBasis::MultiplierBasis(const ContactSurfacePair &sides)
    : sides(sides)
    , slave(*sides.slave)
    , nodes(slave.grid_nodes().size())
    , master_facet(numbers::invalid_unsigned_int)
  {
    for (unsigned int f = 0; f < slave.facets().size(); ++f)
      {
        const MeshSurface::Facet &facet = slave.facets()[f];
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
  MultiplierBasis::values(const Cell &cell, const Point<2> &st) const
  {
    const double s = (st[0] - cell.low[0]) / (cell.high[0] - cell.low[0]),
                 t = (st[1] - cell.low[1]) / (cell.high[1] - cell.low[1]);
    return {{(1. - s) * (1. - t), s * (1. - t), (1. - s) * t, s * t}};
  }



  void
  MultiplierBasis::add_full_areas(const Cell &cell)
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
  MultiplierBasis::add(const Cell        &cell,
                       const Point<2>    &st,
                       const double       weight,
                       const MasterPoint &opposite)
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
        sums.slave.normal_modulus += share * cell.facet->normal_modulus;
        sums.slave.depth += share * cell.facet->depth;
        if (sides.master_mesh != nullptr)
          {
            const MeshSurface::Facet &other =
              sides.master_mesh->facets()[opposite.hit.facet];
            sums.master.normal_modulus += share * other.normal_modulus;
            sums.master.depth += share * other.depth;
          }
      }
    add_traces(cell, st, shares, opposite);
  }



  void
  MultiplierBasis::add_traces(const Cell                  &cell,
                              const Point<2>              &st,
                              const std::array<double, 4> &share,
                              const MasterPoint           &opposite)
  {
    const auto add = [&](std::vector<Tensor<1, 3>> &sums) {
      const unsigned int n = trace.size();
      sums.resize(4 * n);
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int j = 0; j < n; ++j)
          sums[i * n + j] += (share[i] * trace[j]) * opposite.normal;
    };
    slave.evaluate_trace(*cell.facet, st, trace);
    add(slave_sums);
    if (sides.master_mesh == nullptr)
      return;
    if (opposite.hit.facet != master_facet)
      close_master(cell);
    master_facet = opposite.hit.facet;
    sides.master_mesh->evaluate_trace(sides.master_mesh->facets()[master_facet],
                                      opposite.hit.st,
                                      trace);
    add(master_sums);
  }



  void
  MultiplierBasis::close_master(const Cell &cell)
  {
    if (master_sums.empty())
      return;
    const auto &numbers = sides.master_mesh->facets()[master_facet].trace_nodes;
    for (unsigned int i = 0; i < 4; ++i)
      for (unsigned int j = 0; j < numbers.size(); ++j)
        nodes[cell.nodes[i]].sums.master_weights.emplace_back(
          numbers[j], master_sums[i * numbers.size() + j]);
    master_sums.clear();
  }



  void
  MultiplierBasis::close(const Cell &cell)
  {
    close_master(cell);
    if (slave_sums.empty())
      return;
    const auto &numbers = cell.facet->trace_nodes;
    for (unsigned int i = 0; i < 4; ++i)
      for (unsigned int j = 0; j < numbers.size(); ++j)
        nodes[cell.nodes[i]].sums.slave_weights.emplace_back(
          numbers[j], slave_sums[i * numbers.size() + j]);
    slave_sums.clear();
  }



  /// The hats of a continuous space: that of a hanging node belongs in halves
  /// to those of the nodes that it hangs between.
  void
  MultiplierBasis::distribute_to_ends(const MeshSurface::HangingNode &hanging)
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
        for (const auto side : {&WeightedGap::slave, &WeightedGap::master})
          {
            (sums.*side).normal_modulus +=
              0.5 * (from.sums.*side).normal_modulus;
            (sums.*side).depth += 0.5 * (from.sums.*side).depth;
          }
        for (const auto weights :
             {&WeightedGap::slave_weights, &WeightedGap::master_weights})
          for (const auto &[number, weight] : from.sums.*weights)
            (sums.*weights).emplace_back(number, 0.5 * weight);
      }
    nodes[hanging.node] = Node();
  }



  void
  MultiplierBasis::add_row(const unsigned int number, Gaps &result)
  {
    Node        &node = nodes[number];
    WeightedGap &gap  = node.sums;
    if (gap.area <= smallest_share * node.full_area)
      {
        ++result.unpaired;
        return;
      }
    gap.node       = slave.grid_location(number);
    gap.slave_node = number;
    gap.position   = slave.grid_nodes()[number].position;
    gap.spacing    = std::sqrt(node.full_area);
    gap.gap /= gap.area;
    gap.normal /= gap.area;
    for (LocalStiffness *side : {&gap.slave, &gap.master})
      {
        side->area = gap.area;
        side->normal_modulus /= gap.area;
        side->depth /= gap.area;
      }
    if (sides.master_mesh == nullptr)
      gap.master = gap.slave;
    for (auto *weights : {&gap.slave_weights, &gap.master_weights})
      {
        merge(*weights);
        for (auto &[number, weight] : *weights)
          weight /= gap.area;
      }
    const auto facing = find_master_point(*sides.master,
                                          gap.position,
                                          slave.grid_nodes()[number].normal,
                                          sides.search_radius);
    if (facing)
      {
        gap.opposite = facing->hit.position;
        gap.angle    = facing->angle;
      }
    node.rows = {{result.gaps.size(), 1.}};
    result.gaps.push_back(std::move(gap));
  }



  std::shared_ptr<const SlaveSurface>
  MultiplierBasis::slave_surface(const std::vector<std::vector<Polygon>> &parts,
                                 Gaps &result)
  {
    // Those that others hang on come later, and are known before.
    const auto &hanging = slave.hanging_nodes();
    for (auto node = hanging.rbegin(); node != hanging.rend(); ++node)
      for (const unsigned int end : node->ends)
        for (const auto &[row, share] : nodes[end].rows)
          nodes[node->node].rows.emplace_back(row, 0.5 * share);
    std::vector<SlaveSurface::Facet> facets;
    std::vector<unsigned int>        numbers(parts.size());
    for (unsigned int f = 0; f < parts.size(); ++f)
      {
        if (parts[f].empty())
          continue;
        numbers[f]                      = facets.size();
        const MeshSurface::Facet &facet = slave.facets()[f];
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
      point.part = numbers[point.slave.facet];
    return std::make_shared<const SlaveSurface>(SlaveSurface::Functions::hats,
                                                result.gaps.size(),
                                                std::move(facets));
  }



  void
  MultiplierBasis::finish(const std::vector<std::vector<Polygon>> &parts,
                          Gaps                                    &result)
  {
    std::vector<bool> hangs(nodes.size(), false);
    for (const MeshSurface::HangingNode &hanging : slave.hanging_nodes())
      {
        // Those that others hang on come later.
        Assert(!hangs[hanging.ends[0]] && !hangs[hanging.ends[1]],
               ExcInternalError());
        distribute_to_ends(hanging);
        hangs[hanging.node] = true;
      }
    for (unsigned int k = 0; k < nodes.size(); ++k)
      if (!hangs[k])
        add_row(k, result);
    result.surface = slave_surface(parts, result);
    result.slave   = renumber(result.gaps, &WeightedGap::slave_weights, slave);
    if (sides.master_mesh != nullptr)
      result.master =
        renumber(result.gaps, &WeightedGap::master_weights, *sides.master_mesh);
  }
} // namespace lamella
