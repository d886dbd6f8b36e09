// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/inverse_map.h>
#include <lamella/contact/mesh_surface.h>

#include <deal.II/base/quadrature_lib.h>

#include <array>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // How far outside of a facet's unit square a hit still counts: positions
    // come out of decimal texts and rotations.
    constexpr double outside = 1e-7;

    // cos 45: where normals of facets differ by more, an edge is sharp.
    constexpr double sharp = 0.7;

    // More functions than any basis has.
    constexpr unsigned int max_size = GaussLobattoBasis::max_size;



    /// Points closer than this, a length, are one but for rounding.
    double
    same_place(const Body &body)
    {
      return 1e-12 * (10. * body.size() + body.centre().norm());
    }



    /// (n_1 - n_2) / |n_1 - n_2|, unless the normals look the same way.
    std::optional<Tensor<1, 3>>
    averaged_normal(const Tensor<1, 3> &n1, const Tensor<1, 3> &n2)
    {
      constexpr double   parallel = 0.2;
      const Tensor<1, 3> sum      = n1 - n2;
      if (sum.norm() < parallel)
        return {};
      return sum / sum.norm();
    }
  } // namespace



  std::optional<Opposition>
  opposing_place(const OpposingSurface &other,
                 const Point<3>        &x,
                 const Tensor<1, 3>    &n1,
                 const double           reach,
                 const double           opposed)
  {
    // The error of an iterate is at most a few times its last change.
    constexpr unsigned int max_iterations = 50;
    constexpr double       small = 1e-14, accepted = 1e-11;

    Tensor<1, 3> n   = n1;
    auto         hit = other.meet(x, n, reach);
    if (!hit)
      {
        const Tensor<1, 3> near = other.normal_near(x);
        if (n1 * near > -opposed)
          return {};
        n   = *averaged_normal(n1, near);
        hit = other.meet(x, n, reach);
      }
    double change = 1.;
    for (unsigned int k = 0; hit && k < max_iterations; ++k)
      {
        const auto next = averaged_normal(n1, hit->normal);
        if (!next)
          return {};
        change = (*next - n).norm();
        if (change < small)
          break;
        n   = *next;
        hit = other.meet(x, n, reach);
      }
    if (!hit || change > accepted || n1 * hit->normal > -opposed)
      return {};
    // |n_1 - n_2| = 2 cos(angle / 2), |n_1 + n_2| = 2 sin(angle / 2).
    return Opposition{
      *hit, n, 2. * std::asin(std::min(1., 0.5 * (n1 + hit->normal).norm()))};
  }



  ObstacleSurface::ObstacleSurface(std::shared_ptr<const Obstacle> obstacle)
    : obstacle(std::move(obstacle))
  {}



  std::optional<SurfaceHit>
  ObstacleSurface::meet(const Point<3>     &x,
                        const Tensor<1, 3> &d,
                        const double        reach) const
  {
    const std::optional<Hit> hit = lamella::meet(*obstacle, x, d);
    if (!hit || std::abs(hit->distance) > reach)
      return {};
    SurfaceHit result;
    static_cast<Hit &>(result) = *hit;
    return result;
  }



  Tensor<1, 3>
  ObstacleSurface::normal_near(const Point<3> &x) const
  {
    const Tensor<1, 3> &axis = obstacle->direction;
    if (obstacle->shape == Obstacle::Shape::plane)
      return axis;
    const Tensor<1, 3> r =
      x - obstacle->point - ((x - obstacle->point) * axis) * axis;
    return r.norm() > 0. ? r / r.norm() : r;
  }



  MeshSurface::MeshSurface(const Body &body, const std::string &surface)
    : surface_body(body)
  {
    PointNumbering numbering(same_place(body));
    for (const SurfaceFacet &side : body.surface_facets(surface))
      {
        all_facets.emplace_back();
        Facet &facet  = all_facets.back();
        facet.side    = side;
        facet.grid_s  = &GaussLobattoBasis::of_degree(side.degree_s);
        facet.grid_t  = &GaussLobattoBasis::of_degree(side.degree_t);
        facet.trace_s = &GaussLobattoBasis::of_degree(side.trace_degree_s);
        facet.trace_t = &GaussLobattoBasis::of_degree(side.trace_degree_t);
        make_map(facet);

        const SurfacePoint middle =
          body.surface_point(side, Point<2>(0.5, 0.5));
        facet.normal         = middle.normal;
        facet.normal_modulus = middle.normal_modulus;
        facet.depth          = middle.depth;
        const Place place    = map(facet, Point<2>(0.5, 0.5));
        facet.orientation =
          cross_product_3d(place.d_s, place.d_t) * middle.normal > 0. ? 1. :
                                                                        -1.;
        number_trace_nodes(facet, numbering);
      }
    number_grid_nodes();
    average_normals();
    make_search();
  }



  void
  MeshSurface::number_trace_nodes(Facet &facet, PointNumbering &numbering)
  {
    for (unsigned int j = 0; j < facet.trace_t->size(); ++j)
      for (unsigned int i = 0; i < facet.trace_s->size(); ++i)
        {
          const Point<2> st(facet.trace_s->point(i), facet.trace_t->point(j));
          const unsigned int number = numbering.number(map(facet, st).position);
          if (number == trace_places.size())
            trace_places.emplace_back(all_facets.size() - 1, st);
          facet.trace_nodes.push_back(number);
        }
  }



  void
  MeshSurface::number_grid_nodes()
  {
    PointNumbering numbering(same_place(surface_body));
    for (Facet &facet : all_facets)
      for (unsigned int j = 0; j < facet.grid_t->size(); ++j)
        for (unsigned int i = 0; i < facet.grid_s->size(); ++i)
          {
            const Place place =
              map(facet,
                  Point<2>(facet.grid_s->point(i), facet.grid_t->point(j)));
            const Tensor<1, 3> normal = outward_normal(facet, place);
            unsigned int       number = numbers::invalid_unsigned_int;
            // The normal of the first facet there, until it is averaged.
            for (const unsigned int k : numbering.at(place.position))
              if (nodes[k].normal * normal > sharp)
                number = std::min(number, k);
            if (number == numbers::invalid_unsigned_int)
              {
                number = numbering.add(place.position);
                nodes.push_back({place.position, normal});
              }
            facet.grid_nodes.push_back(number);
          }
    find_hanging_nodes(numbering);
  }



  void
  MeshSurface::find_hanging_nodes(const PointNumbering &numbering)
  {
    // With the length of the edge: short ones first, since a node may hang on
    // one that hangs on a longer edge itself.
    std::vector<std::pair<double, HangingNode>> found;
    for (const Facet &facet : all_facets)
      {
        const GaussLobattoBasis &s = *facet.grid_s, &t = *facet.grid_t;
        const auto look = [&](const unsigned int a, const unsigned int b) {
          const auto place = [&](const unsigned int k) {
            return Point<2>(s.point(k % s.size()), t.point(k / s.size()));
          };
          const Place middle =
            map(facet, place(a) + 0.5 * (place(b) - place(a)));
          const unsigned int p = facet.grid_nodes[a], q = facet.grid_nodes[b];
          for (const unsigned int k : numbering.at(middle.position))
            if (nodes[k].normal * outward_normal(facet, middle) > sharp)
              found.push_back(
                {nodes[p].position.distance(nodes[q].position), {k, {{p, q}}}});
        };
        for (unsigned int i = 0; i + 1 < s.size(); ++i)
          for (const unsigned int j : {0u, t.size() - 1})
            look(j * s.size() + i, j * s.size() + i + 1);
        for (unsigned int j = 0; j + 1 < t.size(); ++j)
          for (const unsigned int i : {0u, s.size() - 1})
            look(j * s.size() + i, (j + 1) * s.size() + i);
      }
    std::sort(found.begin(), found.end(), [](const auto &a, const auto &b) {
      return std::make_pair(a.first, a.second.node) <
             std::make_pair(b.first, b.second.node);
    });
    // Two facets may share the long edge.
    std::vector<bool> known(nodes.size(), false);
    for (const auto &[length, node] : found)
      if (!known[node.node])
        {
          hanging.push_back(node);
          known[node.node] = true;
        }
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
            const Place        place = map(facet, rule.point(q));
            const Tensor<1, 3> n     = facet.orientation * rule.weight(q) *
                                   cross_product_3d(place.d_s, place.d_t);
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
        facet.is_flat = facet.is_affine;
        for (const unsigned int k : facet.grid_nodes)
          facet.is_flat =
            facet.is_flat && (nodes[k].normal - facet.normal).norm() < 1e-13;
      }
  }



  void
  MeshSurface::make_map(Facet &facet)
  {
    // The map in the trace nodes; along t it may be linear, and along s.
    const GaussLobattoBasis &s = *facet.trace_s, &t = *facet.trace_t;
    std::vector<Point<3>>    x;
    double                   size = 0.;
    for (unsigned int j = 0; j < t.size(); ++j)
      for (unsigned int i = 0; i < s.size(); ++i)
        {
          x.push_back(
            surface_body
              .surface_point(facet.side, Point<2>(s.point(i), t.point(j)))
              .position);
          size = std::max(size, x.back().distance(x.front()));
        }
    const double       tolerance = 1e-12 * size + 1e-15 * x.front().norm();
    const unsigned int last_s = s.size() - 1, last_t = t.size() - 1;
    const auto         at = [&](const unsigned int i, const unsigned int j) {
      return x[j * s.size() + i];
    };
    bool linear_s = true, linear_t = true;
    for (unsigned int j = 0; j <= last_t; ++j)
      for (unsigned int i = 0; i <= last_s; ++i)
        {
          const Point<3> along_s =
            at(0, j) + s.point(i) * (at(last_s, j) - at(0, j));
          const Point<3> along_t =
            at(i, 0) + t.point(j) * (at(i, last_t) - at(i, 0));
          linear_s = linear_s && at(i, j).distance(along_s) < tolerance;
          linear_t = linear_t && at(i, j).distance(along_t) < tolerance;
        }
    for (unsigned int j = 0; j <= last_t; ++j)
      for (unsigned int i = 0; i <= last_s; ++i)
        if ((!linear_s || i == 0 || i == last_s) &&
            (!linear_t || j == 0 || j == last_t))
          facet.map_nodes.push_back(at(i, j));
    facet.map_s = linear_s ? &GaussLobattoBasis::of_degree(1) : facet.trace_s;
    facet.map_t = linear_t ? &GaussLobattoBasis::of_degree(1) : facet.trace_t;

    facet.origin.position = at(0, 0);
    facet.origin.d_s      = at(last_s, 0) - at(0, 0);
    facet.origin.d_t      = at(0, last_t) - at(0, 0);
    facet.is_affine =
      linear_s && linear_t &&
      (at(last_s, last_t) - at(last_s, 0) - facet.origin.d_t).norm() <
        tolerance;

    // Between its nodes a curve may leave their ball a little.
    facet.centre = at(0, 0) + 0.25 * ((at(last_s, 0) - at(0, 0)) +
                                      (at(0, last_t) - at(0, 0)) +
                                      (at(last_s, last_t) - at(0, 0)));
    for (const Point<3> &node : x)
      facet.radius = std::max(facet.radius, node.distance(facet.centre));
    facet.radius *= linear_s && linear_t ? 1. + 1e-6 : 1.1;
  }



  void
  MeshSurface::make_search()
  {
    Assert(!all_facets.empty(), ExcMessage("The surface has no facets."));
    const Facet       &first = all_facets.front();
    const Tensor<1, 3> along = map(first, Point<2>(0.5, 0.5)).d_s;
    frame[0]                 = along / along.norm();
    frame[1]                 = first.normal;
    frame[2]                 = cross_product_3d(frame[0], frame[1]);

    std::vector<BoundingBox<3>> of_facets;
    for (const Facet &facet : all_facets)
      {
        const bool   curved = facet.map_nodes.size() > 4;
        const double margin = (curved ? 0.1 : 1e-6) * facet.radius;
        Point<3>     low = to_frame(facet.map_nodes[0]), high = low;
        for (const Point<3> &node : facet.map_nodes)
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



  MeshSurface::Place
  MeshSurface::map(const Facet &facet, const Point<2> &st) const
  {
    Place place;
    if (facet.is_affine)
      {
        place = facet.origin;
        place.position += st[0] * place.d_s + st[1] * place.d_t;
        return place;
      }
    std::array<double, max_size> s, d_s, t, d_t;
    facet.map_s->evaluate(st[0], s.data(), d_s.data());
    facet.map_t->evaluate(st[1], t.data(), d_t.data());
    const Point<3> *node = facet.map_nodes.data();
    for (unsigned int j = 0; j < facet.map_t->size(); ++j)
      for (unsigned int i = 0; i < facet.map_s->size(); ++i, ++node)
        for (unsigned int c = 0; c < 3; ++c)
          {
            place.position[c] += s[i] * t[j] * (*node)[c];
            place.d_s[c] += d_s[i] * t[j] * (*node)[c];
            place.d_t[c] += s[i] * d_t[j] * (*node)[c];
          }
    return place;
  }



  Tensor<1, 3>
  MeshSurface::outward_normal(const Facet &facet, const Place &place) const
  {
    const Tensor<1, 3> n =
      facet.orientation * cross_product_3d(place.d_s, place.d_t);
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
    std::array<double, max_size> s, t;
    facet.trace_s->evaluate(st[0], s.data(), nullptr);
    facet.trace_t->evaluate(st[1], t.data(), nullptr);
    values.clear();
    for (unsigned int j = 0; j < facet.trace_t->size(); ++j)
      for (unsigned int i = 0; i < facet.trace_s->size(); ++i)
        values.push_back(s[i] * t[j]);
  }



  Location
  MeshSurface::trace_location(const unsigned int node) const
  {
    const auto &[facet, st] = trace_places[node];
    return surface_body.surface_point(all_facets[facet].side, st).location;
  }



  std::optional<SurfaceHit>
  MeshSurface::meet_facet(const unsigned int  number,
                          const Point<3>     &x,
                          const Tensor<1, 3> &d) const
  {
    constexpr double accepted = 1e-12, lost = 10.;

    const Facet       &facet     = all_facets[number];
    const Tensor<1, 3> to_centre = facet.centre - x;
    if ((to_centre - (to_centre * d) * d).norm_square() >
        facet.radius * facet.radius)
      return {};

    // Two directions across the ray, in which X(s, t) - x is to vanish.
    unsigned int least = std::abs(d[1]) < std::abs(d[0]) ? 1 : 0;
    least              = std::abs(d[2]) < std::abs(d[least]) ? 2 : least;
    Tensor<1, 3> a;
    a[least]             = 1.;
    a                    = cross_product_3d(d, a);
    a                    = a / a.norm();
    const Tensor<1, 3> b = cross_product_3d(d, a);

    const auto missing = [&](const Point<2> &st) {
      const Place  place = map(facet, st);
      const auto   r     = x - place.position;
      Tensor<2, 2> across;
      across[0][0] = a * place.d_s;
      across[0][1] = a * place.d_t;
      across[1][0] = b * place.d_s;
      across[1][1] = b * place.d_t;
      return std::make_pair(Tensor<1, 2>({a * r, b * r}), across);
    };
    // Written so that what is not a number is lost.
    const auto is_near = [](const Point<2> &st) { return st.norm() < lost; };
    const auto [st, change] =
      inverse_image(Point<2>(0.5, 0.5), facet.is_affine, missing, is_near);
    if (!is_near(st) || change > accepted)
      return {};
    for (unsigned int c = 0; c < 2; ++c)
      if (st[c] < -outside || st[c] > 1. + outside)
        return {};
    const Place place = map(facet, st);
    SurfaceHit  hit;
    hit.position = place.position;
    hit.normal   = smooth_normal(facet, st);
    hit.distance = d * (place.position - x);
    hit.facet    = number;
    hit.st       = st;
    if (d * outward_normal(facet, place) >= 0. || d * hit.normal >= 0.)
      return {};
    return hit;
  }



  std::optional<SurfaceHit>
  MeshSurface::meet_among(const std::vector<unsigned int> &facets,
                          const Point<3>                  &x,
                          const Tensor<1, 3>              &d,
                          const double                     reach) const
  {
    std::optional<SurfaceHit> nearest;
    for (const unsigned int facet : facets)
      {
        const auto hit = meet_facet(facet, x, d);
        if (hit && std::abs(hit->distance) <=
                     (nearest ? std::abs(nearest->distance) : reach))
          nearest = hit;
      }
    return nearest;
  }



  std::optional<SurfaceHit>
  MeshSurface::meet(const Point<3>     &x,
                    const Tensor<1, 3> &d,
                    const double        reach) const
  {
    return meet_among(facets_near({x - reach * d, x + reach * d}), x, d, reach);
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
