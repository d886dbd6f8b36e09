// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/body/surface_topology.h>
#include <lamella/contact/slave_surface.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    using Facet  = SlaveSurface::Facet;
    using Shares = std::vector<std::pair<unsigned int, double>>;

    const Polygon unit_square{{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}};



    /// Of the rows @p at_node the one whose normal is most like @p normal; none
    /// if that is another side of an edge.
    Shares
    row_on(const std::vector<unsigned int> &at_node,
           const Tensor<1, 3>              &normal,
           const std::vector<SlaveNode>    &nodes)
    {
      // cos 60.
      constexpr double like_it = 0.5;
      const auto       along   = [&](const unsigned int k) {
        return std::abs(nodes[k].normal * normal) / nodes[k].normal.norm();
      };
      const auto best =
        std::max_element(at_node.begin(),
                         at_node.end(),
                         [&](const unsigned int a, const unsigned int b) {
                           return along(a) < along(b);
                         });
      if (best == at_node.end() || along(*best) < like_it)
        return {};
      return {{*best, 1.}};
    }



    /// Gives the functions of nodes without a row, between two that have one on
    /// a line of @p n nodes from @p begin in steps of @p step, to these.
    void
    share_between(std::vector<Shares>     &rows,
                  const GaussLobattoBasis &places,
                  const unsigned int       begin,
                  const unsigned int       step)
    {
      const auto at = [&](const unsigned int k) -> Shares & {
        return rows[begin + k * step];
      };
      unsigned int last = numbers::invalid_unsigned_int;
      for (unsigned int k = 0; k < places.size(); ++k)
        {
          if (at(k).empty())
            continue;
          if (last != numbers::invalid_unsigned_int)
            for (unsigned int between = last + 1; between < k; ++between)
              {
                const double t = (places.point(between) - places.point(last)) /
                                 (places.point(k) - places.point(last));
                for (const auto &[row, share] : at(last))
                  at(between).emplace_back(row, (1. - t) * share);
                for (const auto &[row, share] : at(k))
                  at(between).emplace_back(row, t * share);
              }
          last = k;
        }
    }



    /// Of nodes that hang, to which rows of those that they hang between their
    /// functions belong; @p at_node are the rows at each node.
    std::vector<Shares>
    hanging_node_shares(const SurfaceTopology                        &topology,
                        const std::vector<std::vector<unsigned int>> &at_node)
    {
      std::vector<Shares> of_node(topology.n_grid);
      for (const auto &[node, ends] : topology.hanging)
        for (const unsigned int end : ends)
          if (at_node[end].size() == 1)
            of_node[end] = {{at_node[end].front(), 1.}};
      // A node may hang on one that hangs itself.
      for (unsigned int pass = 0; pass < topology.hanging.size(); ++pass)
        {
          bool is_done = true;
          for (const auto &[node, ends] : topology.hanging)
            if (of_node[node].empty() && !of_node[ends[0]].empty() &&
                !of_node[ends[1]].empty())
              {
                for (const unsigned int end : ends)
                  for (const auto &[row, share] : of_node[end])
                    of_node[node].emplace_back(row, 0.5 * share);
                is_done = false;
              }
          if (is_done)
            break;
        }
      return of_node;
    }



    bool
    has_no_row(const std::vector<Shares> &rows)
    {
      return std::all_of(rows.begin(), rows.end(), [](const Shares &shares) {
        return shares.empty();
      });
    }



    /// The facets of @p topology with the rows of their nodes.
    std::vector<Facet>
    all_facets(const Body                   &body,
               const SurfaceTopology        &topology,
               const std::vector<SlaveNode> &nodes)
    {
      std::vector<std::vector<unsigned int>> at_node(topology.n_grid);
      for (unsigned int k = 0; k < nodes.size(); ++k)
        if (!nodes[k].location.places.empty())
          if (const auto node =
                topology.grid_node(nodes[k].location.places.front()))
            at_node[*node].push_back(k);
      const std::vector<Shares> hanging =
        hanging_node_shares(topology, at_node);
      std::vector<Facet> facets;
      for (const SurfaceTopology::Facet &from : topology.facets)
        {
          std::vector<Shares> rows;
          const Tensor<1, 3>  normal =
            body.surface_point(from.side, {0.5, 0.5}).normal;
          for (const unsigned int node : from.grid)
            rows.push_back(at_node[node].empty() ?
                             hanging[node] :
                             row_on(at_node[node], normal, nodes));
          if (has_no_row(rows))
            continue;
          const auto &s = GaussLobattoBasis::of_degree(from.side.degree_s),
                     &t = GaussLobattoBasis::of_degree(from.side.degree_t);
          for (unsigned int j = 0; j < t.size(); ++j)
            share_between(rows, s, j * s.size(), 1);
          for (unsigned int i = 0; i < s.size(); ++i)
            share_between(rows, t, i, s.size());
          facets.push_back({FacetMap(body, from.side),
                            from.side.degree_s,
                            from.side.degree_t,
                            from.grid,
                            rows,
                            {unit_square}});
        }
      return facets;
    }
  } // namespace



  SlaveSurface
  make_nodal_slave_surface(const Body                   &body,
                           const std::string            &surface,
                           const std::vector<SlaveNode> &nodes,
                           const bool                    whole)
  {
    std::vector<Facet> facets =
      all_facets(body, body.surface_topology(surface), nodes);
    const auto is_whole = [](const Facet &facet) {
      return std::none_of(facet.rows.begin(),
                          facet.rows.end(),
                          [](const Shares &shares) { return shares.empty(); });
    };
    std::vector<bool> has_whole(nodes.size(), false);
    for (const Facet &facet : facets)
      if (is_whole(facet))
        for (const Shares &shares : facet.rows)
          for (const auto &[row, share] : shares)
            has_whole[row] = true;
    if (whole)
      for (Facet &facet : facets)
        if (!is_whole(facet))
          for (Shares &shares : facet.rows)
            shares.erase(std::remove_if(shares.begin(),
                                        shares.end(),
                                        [&](const auto &share) {
                                          return has_whole[share.first];
                                        }),
                         shares.end());
    facets.erase(std::remove_if(facets.begin(),
                                facets.end(),
                                [](const Facet &facet) {
                                  return has_no_row(facet.rows);
                                }),
                 facets.end());
    return SlaveSurface(SlaveSurface::Functions::trace,
                        nodes.size(),
                        std::move(facets));
  }
} // namespace lamella
