// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/contact/gap_constraints.h>
#include <lamella/contact/pairing.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Nodes without a partner that face the other surface all the same.
    unsigned int
    count_facing(const std::vector<SurfacePoint> &points,
                 const std::vector<bool>         &is_paired,
                 const MeshSurface               &other,
                 const double                     search_radius)
    {
      unsigned int count = 0;
      for (unsigned int k = 0; k < points.size(); ++k)
        if (!is_paired[k] && find_master_point(other,
                                               points[k].position,
                                               points[k].normal,
                                               search_radius))
          ++count;
      return count;
    }



    /// The nodes of both sides and which of them face each other.
    struct NodePairs
    {
      std::vector<SurfacePoint> first, second;
      Pairing                   pairing;
      /// Of either side, those without a partner that face the other surface.
      unsigned int beside = 0, beside_second = 0;
    };



    NodePairs
    pair_nodes(const ContactSides &sides, const double search_radius)
    {
      NodePairs nodes;
      nodes.first            = sides.points(false);
      nodes.second           = sides.points(true);
      nodes.pairing          = pair_node_to_node(nodes.first,
                                        nodes.second,
                                        sides.contact().tolerance,
                                        search_radius);
      const Pairing &pairing = nodes.pairing;
      if (pairing.pairs.empty() ||
          pairing.unpaired + pairing.unpaired_second == 0)
        return nodes;
      std::vector<bool> first_paired(nodes.first.size(), false),
        second_paired(nodes.second.size(), false);
      for (const PointPair &pair : pairing.pairs)
        {
          first_paired[pair.first]   = true;
          second_paired[pair.second] = true;
        }
      nodes.beside        = count_facing(nodes.first,
                                  first_paired,
                                  *sides.surface(true),
                                  search_radius);
      nodes.beside_second = count_facing(nodes.second,
                                         second_paired,
                                         *sides.surface(false),
                                         search_radius);
      return nodes;
    }



    /// The gap of @p pair of the nodes @p a and @p b, whose places have the
    /// number @p k on either side.
    WeightedGap
    gap_between(const SurfacePoint &a,
                const SurfacePoint &b,
                const PointPair    &pair,
                const unsigned int  k)
    {
      const double area = std::min(a.area, b.area);
      WeightedGap  gap;
      gap.node     = a.location;
      gap.position = a.position;
      gap.opposite = b.position;
      gap.normal   = pair.normal;
      gap.area     = area;
      gap.spacing  = std::sqrt(area);
      gap.gap      = pair.initial_gap;
      gap.angle =
        2. * std::asin(std::min(1., 0.5 * (a.normal + b.normal).norm()));
      gap.slave          = {a.normal_modulus, area, a.depth};
      gap.master         = {b.normal_modulus, area, b.depth};
      gap.slave_weights  = {{k, pair.normal}};
      gap.master_weights = {{k, pair.normal}};
      return gap;
    }



    /// Counts the nodes without a partner, with a note of those that face the
    /// other surface all the same.
    void
    note_unpaired_nodes(const NodePairs &nodes, ContactInterface &interface)
    {
      interface.unpaired_second          = nodes.pairing.unpaired_second;
      interface.nonmatching_nodes        = nodes.beside;
      interface.nonmatching_nodes_second = nodes.beside_second;
      if (nodes.beside + nodes.beside_second > 0)
        interface.notes.push_back(
          "contact.nonmatching-nodes: contact " + interface.name + ": " +
          std::to_string(nodes.beside) + " nodes of First and " +
          std::to_string(nodes.beside_second) +
          " nodes of Second face no node of the other surface and can "
          "penetrate it. Use Discretization = auto or surface to surface, or "
          "give both surfaces the same nodes");
    }
  } // namespace



  Discretization
  choose_discretization(const ContactSides &sides, const double search_radius)
  {
    const ContactPair &contact = sides.contact();
    if (contact.discretization != Discretization::automatic)
      return contact.discretization;
    if (contact.obstacle != nullptr)
      return Discretization::surface_to_surface;
    const NodePairs nodes = pair_nodes(sides, search_radius);
    return !nodes.pairing.pairs.empty() &&
               nodes.beside + nodes.beside_second == 0 ?
             Discretization::node_to_node :
             Discretization::surface_to_surface;
  }



  Gaps
  node_to_node(const ContactSides &sides,
               const double        search_radius,
               ContactInterface   &interface)
  {
    const NodePairs nodes = pair_nodes(sides, search_radius);
    note_unpaired_nodes(nodes, interface);
    const Pairing &pairing = nodes.pairing;
    Gaps           result;
    result.unpaired = pairing.unpaired;
    for (const PointPair &pair : pairing.pairs)
      {
        const SurfacePoint &a = nodes.first[pair.first],
                           &b = nodes.second[pair.second];
        if (exceeds_cell_depth(pair.initial_gap, a.depth, b.depth))
          {
            result.deep_penetrations.push_back(
              {a.position, b.position, -pair.initial_gap});
            continue;
          }
        result.gaps.push_back(gap_between(a, b, pair, result.gaps.size()));
        result.slave.push_back(a.location);
        result.master.push_back(b.location);
      }
    return result;
  }
} // namespace lamella
