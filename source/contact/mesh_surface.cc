// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/contact/contact_sides.h>
#include <lamella/contact/mesh_surface.h>
#include <lamella/contact/slave_surface.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>

#include <array>
#include <cmath>
#include <map>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // cos 45: where normals of facets differ by more, an edge is sharp.
    constexpr double sharp = 0.7;

    // More functions than any basis has.
    constexpr unsigned int max_size = GaussLobattoBasis::max_size;
  } // namespace



  MeshSurface::MeshSurface(const Body &body, const std::string &surface)
    : surface_body(body)
  {
    const SurfaceTopology topology = body.surface_topology(surface);
    trace_locations.resize(topology.n_trace,
                           {numbers::invalid_unsigned_int, Point<2>()});
    for (const SurfaceTopology::Facet &facet : topology.facets)
      make_facet(facet);
    split_at_edges(topology);
    find_neighbors();
    average_normals();
    make_search();
  }



  MeshSurface::MeshSurface(const MeshSurface               &undeformed,
                           const std::vector<Tensor<1, 3>> &u)
    : MeshSurface(undeformed)
  {
    AssertDimension(u.size(), n_trace_nodes());
    std::vector<Tensor<1, 3>> of_facet;
    for (Facet &facet : all_facets)
      {
        of_facet.clear();
        for (const unsigned int node : facet.trace_nodes)
          of_facet.push_back(u[node]);
        facet.map = facet.map.moved(facet.trace_s->size() - 1,
                                    facet.trace_t->size() - 1,
                                    of_facet);
        for (unsigned int k = 0; k < 4; ++k)
          facet.side.corners[k] =
            facet.map(GeometryInfo<2>::unit_cell_vertex(k)).position;
        measure(facet);
        facet.normal = outward_normal(facet, facet.map(Point<2>(0.5, 0.5)));
      }
    for (unsigned int k = 0; k < nodes.size(); ++k)
      nodes[k].position = all_facets[grid_points_on_facets[k].first]
                            .map(grid_points_on_facets[k].second)
                            .position;
    average_normals();
    make_search();
  }



  void
  MeshSurface::make_facet(const SurfaceTopology::Facet &from)
  {
    const SurfaceFacet &side   = from.side;
    const auto          basis  = GaussLobattoBasis::of_degree;
    const SurfacePoint  middle = surface_body.surface_point(side, {0.5, 0.5});
    all_facets.emplace_back(side, FacetMap(surface_body, side));
    Facet &facet         = all_facets.back();
    facet.grid_s         = &basis(side.degree_s);
    facet.grid_t         = &basis(side.degree_t);
    facet.trace_s        = &basis(side.trace_degree_s);
    facet.trace_t        = &basis(side.trace_degree_t);
    facet.trace_nodes    = from.trace;
    facet.nodes_of_body  = from.grid;
    facet.normal         = middle.normal;
    facet.normal_modulus = middle.normal_modulus;
    facet.depth          = middle.depth;

    measure(facet);

    const GaussLobattoBasis &s = *facet.trace_s, &t = *facet.trace_t;
    for (unsigned int k = 0; k < from.trace.size(); ++k)
      if (auto &[at, st] = trace_locations[from.trace[k]];
          at == numbers::invalid_unsigned_int)
        {
          at = all_facets.size() - 1;
          st = {s.point(k % s.size()), t.point(k / s.size())};
        }
  }



  void
  MeshSurface::measure(Facet &facet) const
  {
    const auto &x = facet.side.corners;
    facet.center =
      x[0] + 0.25 * ((x[1] - x[0]) + (x[2] - x[0]) + (x[3] - x[0]));
    facet.radius = 0.;
    for (const Point<3> &node : facet.map.control_points())
      facet.radius = std::max(facet.radius, node.distance(facet.center));
    // Between its nodes a curve may leave their ball a little.
    facet.radius *=
      facet.map.is_straight() ? 1. + arithmetic::same_in_element : 1.1;
  }



  void
  MeshSurface::find_neighbors()
  {
    // Sides by the numbers of their ends, which two facets share; what is finer
    // beyond a side hangs on it.
    std::map<std::pair<unsigned int, unsigned int>, unsigned int> count;
    std::vector<bool> hangs(nodes.size(), false);
    for (const HangingNode &node : hanging)
      for (const unsigned int k : {node.node, node.ends[0], node.ends[1]})
        hangs[k] = true;
    const auto sides_of = [](const Facet &facet) {
      const auto        &k = facet.grid_nodes;
      const unsigned int n = facet.grid_s->size(), last = k.size() - 1;
      const auto both = [&](const unsigned int a, const unsigned int b) {
        return std::make_pair(std::min(k[a], k[b]), std::max(k[a], k[b]));
      };
      return std::array<std::pair<unsigned int, unsigned int>, 4>{
        {both(0, last + 1 - n),
         both(n - 1, last),
         both(0, n - 1),
         both(last + 1 - n, last)}};
    };
    for (const Facet &facet : all_facets)
      for (const auto &side : sides_of(facet))
        ++count[side];
    const BodyEnds ends(surface_body);
    for (Facet &facet : all_facets)
      {
        const auto sides = sides_of(facet);
        for (unsigned int k = 0; k < 4; ++k)
          {
            const auto [one, other] = sides[k];
            facet.has_neighbor[k] =
              count[sides[k]] > 1 || (hangs[one] && hangs[other]);
            facet.at_body_end[k] =
              ends.has(nodes[one].position) && ends.has(nodes[other].position);
          }
      }
  }



  std::optional<unsigned int>
  MeshSurface::on_side(const std::vector<unsigned int> &numbers,
                       const Tensor<1, 3>              &normal) const
  {
    const auto found =
      std::find_if(numbers.begin(), numbers.end(), [&](const unsigned int k) {
        return nodes[k].normal * normal > sharp;
      });
    if (found == numbers.end())
      return {};
    return *found;
  }



  void
  MeshSurface::split_at_edges(const SurfaceTopology &topology)
  {
    // Our nodes, one for each side of a sharp edge, of a node of the body.
    std::vector<std::vector<unsigned int>> sides(topology.n_grid);
    for (unsigned int f = 0; f < all_facets.size(); ++f)
      {
        Facet                   &facet = all_facets[f];
        const GaussLobattoBasis &s = *facet.grid_s, &t = *facet.grid_t;
        const auto              &of_body = topology.facets[f].grid;
        for (unsigned int k = 0; k < of_body.size(); ++k)
          {
            const Point<2>     st(s.point(k % s.size()), t.point(k / s.size()));
            const Place        place  = facet.map(st);
            const Tensor<1, 3> normal = outward_normal(facet, place);
            auto               number = on_side(sides[of_body[k]], normal);
            if (!number)
              {
                // The normal of the first facet, until it is averaged.
                number = nodes.size();
                nodes.push_back({place.position, normal});
                grid_points_on_facets.emplace_back(f, st);
                sides[of_body[k]].push_back(*number);
              }
            facet.grid_nodes.push_back(*number);
          }
      }
    find_hanging_nodes(topology, sides);
  }



  void
  MeshSurface::find_hanging_nodes(
    const SurfaceTopology                        &topology,
    const std::vector<std::vector<unsigned int>> &sides)
  {
    for (const HangingNode &node : topology.hanging)
      for (const unsigned int k : sides[node.node])
        {
          const auto a = on_side(sides[node.ends[0]], nodes[k].normal),
                     b = on_side(sides[node.ends[1]], nodes[k].normal);
          if (a && b)
            hanging.push_back({k, {{*a, *b}}});
        }
    // Short edges first: a node may hang on an edge that hangs on a longer one.
    const auto length = [&](const HangingNode &node) {
      return nodes[node.ends[0]].position.distance(
        nodes[node.ends[1]].position);
    };
    std::sort(hanging.begin(),
              hanging.end(),
              [&](const HangingNode &a, const HangingNode &b) {
                return std::make_pair(length(a), a.node) <
                       std::make_pair(length(b), b.node);
              });
  }



  void
  MeshSurface::average_normals()
  {
    std::vector<Tensor<1, 3>>    sums(nodes.size());
    std::array<double, max_size> s, t;
    for (const Facet &facet : all_facets)
      {
        const QGauss<2> rule(
          std::max(facet.trace_s->size(), facet.trace_t->size()) + 1);
        for (unsigned int q = 0; q < rule.size(); ++q)
          {
            facet.grid_s->evaluate(rule.point(q)[0], s.data(), nullptr);
            facet.grid_t->evaluate(rule.point(q)[1], t.data(), nullptr);
            const Tensor<1, 3> n =
              rule.weight(q) * facet.map.outward(facet.map(rule.point(q)));
            for (unsigned int k = 0; k < facet.grid_nodes.size(); ++k)
              sums[facet.grid_nodes[k]] +=
                s[k % facet.grid_s->size()] * t[k / facet.grid_s->size()] * n;
          }
      }
    for (unsigned int k = 0; k < nodes.size(); ++k)
      nodes[k].normal = sums[k] / sums[k].norm();
    // The field is continuous: from long edges to short ones.
    for (auto node = hanging.rbegin(); node != hanging.rend(); ++node)
      {
        const Tensor<1, 3> n =
          nodes[node->ends[0]].normal + nodes[node->ends[1]].normal;
        nodes[node->node].normal = n / n.norm();
      }
    for (Facet &facet : all_facets)
      {
        facet.is_flat = facet.map.is_affine();
        for (const unsigned int k : facet.grid_nodes)
          facet.is_flat =
            facet.is_flat && (nodes[k].normal - facet.normal).norm() <
                               arithmetic::rounding_of_sums;
      }
  }



  void
  MeshSurface::make_search()
  {
    Assert(!all_facets.empty(), ExcMessage("The surface has no facets."));
    const Facet       &first = all_facets.front();
    const Tensor<1, 3> along = first.map(Point<2>(0.5, 0.5)).d_s;
    frame[0]                 = along / along.norm();
    frame[1]                 = first.normal;
    frame[2]                 = cross_product_3d(frame[0], frame[1]);

    std::vector<BoundingBox<3>> of_facets;
    for (const Facet &facet : all_facets)
      {
        const auto  &x = facet.map.control_points();
        const double margin =
          (facet.map.is_straight() ? arithmetic::same_in_element : 0.1) *
          facet.radius;
        Point<3> low = to_frame(x[0]), high = low;
        for (const Point<3> &node : x)
          for (unsigned int c = 0; c < 3; ++c)
            {
              low[c]  = std::min(low[c], to_frame(node)[c]);
              high[c] = std::max(high[c], to_frame(node)[c]);
            }
        const Point<3> around(margin, margin, margin);
        of_facets.emplace_back(
          std::make_pair(Point<3>(low - around), Point<3>(high + around)));
      }
    boxes = BoxSearch(of_facets);
  }



  Point<3>
  MeshSurface::to_frame(const Point<3> &x) const
  {
    return Point<3>(frame * x);
  }



  Tensor<1, 3>
  MeshSurface::outward_normal(const Facet &facet, const Place &place) const
  {
    const Tensor<1, 3> n = facet.map.outward(place);
    return n / n.norm();
  }



  Tensor<1, 3>
  MeshSurface::smooth_normal(const Facet &facet, const Point<2> &st) const
  {
    if (facet.is_flat)
      return facet.normal;
    std::array<double, max_size> s, t;
    facet.grid_s->evaluate(st[0], s.data(), nullptr);
    facet.grid_t->evaluate(st[1], t.data(), nullptr);
    Tensor<1, 3>        sum;
    const unsigned int *node = facet.grid_nodes.data();
    for (unsigned int j = 0; j < facet.grid_t->size(); ++j)
      for (unsigned int i = 0; i < facet.grid_s->size(); ++i, ++node)
        sum += (s[i] * t[j]) * nodes[*node].normal;
    return sum / sum.norm();
  }



  void
  MeshSurface::evaluate_trace(const Facet         &facet,
                              const Point<2>      &st,
                              std::vector<double> &values) const
  {
    evaluate_on_grid(*facet.trace_s, *facet.trace_t, st, values);
  }



  Location
  MeshSurface::grid_location(const unsigned int node) const
  {
    const auto &[facet, st] = grid_points_on_facets[node];
    return surface_body.surface_point(all_facets[facet].side, st).location;
  }



  unsigned int
  MeshSurface::grid_node(const Location     &location,
                         const Tensor<1, 3> &normal) const
  {
    const auto at = place_of(location, normal);
    AssertThrow(at, ExcInternalError());
    const Facet &facet   = all_facets[at->facet];
    const auto   nearest = [](const GaussLobattoBasis &basis, const double x) {
      unsigned int best = 0;
      for (unsigned int k = 1; k < basis.size(); ++k)
        if (std::abs(basis.point(k) - x) < std::abs(basis.point(best) - x))
          best = k;
      return best;
    };
    return facet
      .grid_nodes[nearest(*facet.grid_t, at->st[1]) * facet.grid_s->size() +
                  nearest(*facet.grid_s, at->st[0])];
  }



  Location
  MeshSurface::trace_location(const unsigned int node) const
  {
    const auto &[facet, st] = trace_locations[node];
    return surface_body.surface_point(all_facets[facet].side, st).location;
  }



  std::optional<MeshSurface::FacetPoint>
  MeshSurface::place_of(const Location     &location,
                        const Tensor<1, 3> &normal) const
  {
    std::optional<FacetPoint> found;
    double                    best = -2.;
    for (const Location::Place &place : location.places)
      for (unsigned int f = 0; f < all_facets.size(); ++f)
        {
          const SurfaceFacet &side = all_facets[f].side;
          if (side.cell != place.cell)
            continue;
          const Tensor<1, 3> d = place.unit - side.origin;
          const Point<2>     st(d * side.along_s, d * side.along_t);
          const Tensor<1, 3> off =
            d - st[0] * side.along_s - st[1] * side.along_t;
          const double alike = all_facets[f].normal * normal;
          if (off.norm() < arithmetic::same_in_element && alike > best)
            {
              found = FacetPoint{f, st};
              best  = alike;
            }
        }
    return found;
  }



  std::optional<SurfaceHit>
  MeshSurface::intersect_facet(const unsigned int  facet_index,
                               const Point<3>     &x,
                               const Tensor<1, 3> &d) const
  {
    const Facet       &facet     = all_facets[facet_index];
    const Tensor<1, 3> to_center = facet.center - x;
    if ((to_center - (to_center * d) * d).norm_square() >
        facet.radius * facet.radius)
      return {};

    const auto found = line_intersection(facet.map, x, d);
    if (!found)
      return {};
    const Point<2> &st    = *found;
    const Place     place = facet.map(st);
    SurfaceHit      hit;
    hit.position = place.position;
    hit.normal   = smooth_normal(facet, st);
    hit.distance = d * (place.position - x);
    hit.facet    = facet_index;
    hit.st       = st;
    if (d * outward_normal(facet, place) >= 0. || d * hit.normal >= 0.)
      return {};
    return hit;
  }



  std::optional<SurfaceHit>
  MeshSurface::intersect_facets(const std::vector<unsigned int> &facets,
                                const Point<3>                  &x,
                                const Tensor<1, 3>              &d,
                                const double search_radius) const
  {
    std::optional<SurfaceHit> nearest;
    for (const unsigned int facet : facets)
      {
        const auto hit = intersect_facet(facet, x, d);
        if (hit && std::abs(hit->distance) <=
                     (nearest ? std::abs(nearest->distance) : search_radius))
          nearest = hit;
      }
    return nearest;
  }



  std::optional<SurfaceHit>
  MeshSurface::meet(const Point<3>     &x,
                    const Tensor<1, 3> &d,
                    const double        search_radius) const
  {
    return intersect_facets(facets_near(
                              {x - search_radius * d, x + search_radius * d}),
                            x,
                            d,
                            search_radius);
  }



  Tensor<1, 3>
  MeshSurface::normal_near(const Point<3> &x) const
  {
    return all_facets[boxes.nearest(to_frame(x))].normal;
  }



  std::vector<unsigned int>
  MeshSurface::facets_near(const std::vector<Point<3>> &points) const
  {
    Point<3> low = to_frame(points[0]), high = low;
    for (const Point<3> &point : points)
      for (unsigned int c = 0; c < 3; ++c)
        {
          low[c]  = std::min(low[c], to_frame(point)[c]);
          high[c] = std::max(high[c], to_frame(point)[c]);
        }
    return boxes.meeting(BoundingBox<3>(std::make_pair(low, high)));
  }
} // namespace lamella
