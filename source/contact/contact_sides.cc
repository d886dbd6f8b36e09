// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/contact/contact_sides.h>

#include <algorithm>
#include <numeric>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    std::vector<Point<3>>
    nodes_at_ends(const Body &body)
    {
      std::vector<Point<3>> nodes;
      for (const char *const end : {"start", "end"})
        for (const SurfacePoint &point : body.surface_points(end))
          nodes.push_back(point.position);
      return nodes;
    }
  } // namespace



  BodyEnds::BodyEnds(const Body &body)
    : near(arithmetic::same_position * body.size())
    , nodes(nodes_at_ends(body))
    , search(nodes)
  {}



  bool
  BodyEnds::has(const Point<3> &x) const
  {
    return x.distance(nodes[search.nearest(x, 1).front()]) <= near;
  }



  ContactSides::ContactSides(const ContactPair &contact, const Bodies &bodies)
    : pair(contact)
    , all_bodies(bodies)
    , standing(contact.obstacle)
  {}



  ContactSides::ContactSides(const ContactSides &undeformed,
                             const BlockVector  &u,
                             const LoadFactor   &factor)
    : pair(undeformed.pair)
    , all_bodies(undeformed.all_bodies)
    , undeformed(&undeformed)
    , u(u)
  {
    if (pair.obstacle == nullptr)
      return;
    auto moved = std::make_shared<Obstacle>(*pair.obstacle);
    moved->point += moved->displacement_at(factor, u);
    standing = moved;
  }



  const MeshSurface *
  ContactSides::surface(const bool second) const
  {
    if (second && pair.obstacle != nullptr)
      return nullptr;
    auto &made = surfaces[second];
    if (made == nullptr && undeformed == nullptr)
      made =
        std::make_unique<const MeshSurface>(*all_bodies[region(second).body],
                                            region(second).surface);
    else if (made == nullptr)
      {
        made = std::make_unique<const MeshSurface>(*undeformed->surface(second),
                                                   trace_displacements(second));
      }
    return made.get();
  }



  std::vector<bool>
  ContactSides::facets_of_part(const bool second) const
  {
    std::vector<bool> part;
    if (pair.where == nullptr)
      return part;
    const ContactSides &reference = undeformed != nullptr ? *undeformed : *this;
    for (const auto &facet : reference.surface(second)->facets())
      part.push_back((*pair.where)(facet.map(Point<2>(0.5, 0.5)).position) !=
                     0.);
    return part;
  }



  std::optional<Point<3>>
  ContactSides::divided_facet(const bool second) const
  {
    constexpr double inside = arithmetic::same_in_element;
    if (pair.where == nullptr)
      return {};
    const auto is_in = [&](const Point<3> &x) {
      return (*pair.where)(x) != 0.;
    };
    for (const auto &facet : surface(second)->facets())
      {
        const Point<3> center = facet.map(Point<2>(0.5, 0.5)).position;
        for (const double s : {inside, 1. - inside})
          for (const double t : {inside, 1. - inside})
            if (is_in(facet.map(Point<2>(s, t)).position) != is_in(center))
              return center;
      }
    return {};
  }



  std::vector<SurfacePoint>
  ContactSides::points(const bool second) const
  {
    const Region &side = region(second);
    return is_edge_contact() ?
             end_points(second) :
             displaced_points(
               second, all_bodies[side.body]->surface_points(side.surface));
  }



  std::vector<SurfacePoint>
  ContactSides::end_points(const bool second) const
  {
    const Region  &side   = region(second);
    const Body    &body   = *all_bodies[side.body];
    auto           points = body.surface_points(side.surface);
    const BodyEnds ends(body);
    points.erase(std::remove_if(points.begin(),
                                points.end(),
                                [&ends](const SurfacePoint &point) {
                                  return !ends.has(point.position);
                                }),
                 points.end());
    return displaced_points(second, std::move(points));
  }



  std::vector<SurfacePoint>
  ContactSides::displaced_points(const bool                second,
                                 std::vector<SurfacePoint> points) const
  {
    if (undeformed == nullptr)
      return points;
    const MeshSurface &before = *undeformed->surface(second),
                      &now    = *surface(second);
    for (SurfacePoint &point : points)
      if (const auto at = before.place_of(point.location, point.normal))
        {
          const MeshSurface::Facet &facet = now.facets()[at->facet];
          point.position                  = facet.map(at->st).position;
          point.normal                    = now.smooth_normal(facet, at->st);
        }
    return points;
  }



  const std::vector<Location> &
  ContactSides::trace_locations(const bool second) const
  {
    if (undeformed != nullptr)
      return undeformed->trace_locations(second);
    const MeshSurface &on = *surface(second);
    while (places[second].size() < on.n_trace_nodes())
      places[second].push_back(on.trace_location(places[second].size()));
    return places[second];
  }



  std::vector<Tensor<1, 3>>
  ContactSides::trace_displacements(const bool second) const
  {
    const unsigned int number  = region(second).body;
    const Body        &body    = *all_bodies[number];
    const Vector      &of_body = u.block(number);
    if (body.constraints_rotate())
      return body.displacements(trace_locations(second), of_body);
    std::vector<unsigned int> nodes(trace_locations(second).size());
    std::iota(nodes.begin(), nodes.end(), 0);
    std::vector<Tensor<1, 3>> result;
    for (const auto &row : trace_rows(second, nodes))
      result.emplace_back(
        Tensor<1, 3>({row[0](of_body), row[1](of_body), row[2](of_body)}));
    return result;
  }



  // Rows that do not rotate are those of the undeformed surface.
  const std::vector<std::vector<LinearFunctional>> &
  ContactSides::trace_rows(const bool                       second,
                           const std::vector<unsigned int> &nodes) const
  {
    const unsigned int number = region(second).body;
    const Body        &body   = *all_bodies[number];
    const bool turned = undeformed != nullptr && body.constraints_rotate();
    if (undeformed != nullptr && !turned)
      return undeformed->trace_rows(second, nodes);
    rows[second].resize(trace_locations(second).size());
    std::vector<unsigned int> missing;
    std::vector<Location>     at;
    for (const unsigned int node : nodes)
      if (rows[second][node].empty())
        {
          missing.push_back(node);
          at.push_back(trace_locations(second)[node]);
        }
    if (missing.empty())
      return rows[second];
    const auto found = body.rows(at, turned ? u.block(number) : undisplaced);
    for (unsigned int k = 0; k < missing.size(); ++k)
      rows[second][missing[k]] = found[k];
    return rows[second];
  }
} // namespace lamella
