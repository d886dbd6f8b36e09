// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/body/facet_map.h>

#include <algorithm>

namespace lamella
{
  using namespace dealii;

  FacetMap::FacetMap(const Body &body, const SurfaceFacet &facet)
  {
    const GaussLobattoBasis &s = GaussLobattoBasis::of_degree(
                              facet.trace_degree_s),
                            &t = GaussLobattoBasis::of_degree(
                              facet.trace_degree_t);
    std::vector<Point<3>> x;
    for (const Point<2> &st : grid_points(s, t))
      x.push_back(body.surface_point(facet, st).position);
    keep(s, t, x);
    const Point<2> middle(0.5, 0.5);
    if (outward((*this)(middle)) * body.surface_point(facet, middle).normal <
        0.)
      orientation = -1.;
  }



  void
  FacetMap::keep(const GaussLobattoBasis     &s,
                 const GaussLobattoBasis     &t,
                 const std::vector<Point<3>> &x)
  {
    double size = 0.;
    for (const Point<3> &node : x)
      size = std::max(size, node.distance(x.front()));
    const double tolerance =
      arithmetic::rounding_of_results * size + 1e-15 * x.front().norm();
    const unsigned int last_s = s.size() - 1, last_t = t.size() - 1;
    const auto         at = [&](const unsigned int i, const unsigned int j) {
      return x[j * s.size() + i];
    };
    bool linear_s = true, linear_t = true;
    for (unsigned int j = 0; j <= last_t; ++j)
      for (unsigned int i = 0; i <= last_s; ++i)
        {
          const Point<3> on_s =
            at(0, j) + s.point(i) * (at(last_s, j) - at(0, j));
          const Point<3> on_t =
            at(i, 0) + t.point(j) * (at(i, last_t) - at(i, 0));
          linear_s = linear_s && at(i, j).distance(on_s) < tolerance;
          linear_t = linear_t && at(i, j).distance(on_t) < tolerance;
        }
    nodes.clear();
    for (unsigned int j = 0; j <= last_t; ++j)
      for (unsigned int i = 0; i <= last_s; ++i)
        if ((!linear_s || i == 0 || i == last_s) &&
            (!linear_t || j == 0 || j == last_t))
          nodes.push_back(at(i, j));
    along_s = linear_s ? &GaussLobattoBasis::of_degree(1) : &s;
    along_t = linear_t ? &GaussLobattoBasis::of_degree(1) : &t;

    origin.position = at(0, 0);
    origin.d_s      = at(last_s, 0) - at(0, 0);
    origin.d_t      = at(0, last_t) - at(0, 0);
    affine =
      linear_s && linear_t &&
      (at(last_s, last_t) - at(last_s, 0) - origin.d_t).norm() < tolerance;
  }



  FacetMap
  FacetMap::moved(const unsigned int               degree_s,
                  const unsigned int               degree_t,
                  const std::vector<Tensor<1, 3>> &u) const
  {
    const GaussLobattoBasis &s = GaussLobattoBasis::of_degree(degree_s),
                            &t = GaussLobattoBasis::of_degree(degree_t);
    AssertDimension(u.size(), s.size() * t.size());
    std::vector<Point<3>> x;
    for (const Point<2> &st : grid_points(s, t))
      x.push_back((*this)(st).position + u[x.size()]);
    FacetMap result = *this;
    result.keep(s, t, x);
    return result;
  }



  FacetMap::FacetMap(const unsigned int           degree_s,
                     const unsigned int           degree_t,
                     const std::vector<Point<3>> &control_points)
    : along_s(&GaussLobattoBasis::of_degree(degree_s))
    , along_t(&GaussLobattoBasis::of_degree(degree_t))
    , nodes(control_points)
  {
    AssertDimension(nodes.size(), along_s->size() * along_t->size());
    const Point<3> &corner = nodes.front(), &on_s = nodes[degree_s],
                   &on_t = nodes[nodes.size() - 1 - degree_s];
    origin.position      = corner;
    origin.d_s           = on_s - corner;
    origin.d_t           = on_t - corner;
    double size          = 0.;
    for (const Point<3> &node : nodes)
      size = std::max(size, node.distance(corner));
    affine = is_straight() && (nodes.back() - on_s - origin.d_t).norm() <
                                1e-12 * size + 1e-15 * corner.norm();
  }



  FacetMap::Place
  FacetMap::operator()(const Point<2> &st) const
  {
    Place place;
    if (affine)
      {
        place = origin;
        place.position += st[0] * place.d_s + st[1] * place.d_t;
        return place;
      }
    std::array<double, GaussLobattoBasis::max_size> s, d_s, t, d_t;
    along_s->evaluate(st[0], s.data(), d_s.data());
    along_t->evaluate(st[1], t.data(), d_t.data());
    const Point<3> *node = nodes.data();
    for (unsigned int j = 0; j < along_t->size(); ++j)
      for (unsigned int i = 0; i < along_s->size(); ++i, ++node)
        for (unsigned int c = 0; c < 3; ++c)
          {
            place.position[c] += s[i] * t[j] * (*node)[c];
            place.d_s[c] += d_s[i] * t[j] * (*node)[c];
            place.d_t[c] += s[i] * d_t[j] * (*node)[c];
          }
    return place;
  }



  FacetMap::Curvature
  FacetMap::curvature(const Point<2> &st) const
  {
    Curvature curvature;
    if (affine)
      return curvature;
    std::array<double, GaussLobattoBasis::max_size> s, d_s, d_ss, t, d_t, d_tt;
    along_s->evaluate(st[0], s.data(), d_s.data(), d_ss.data());
    along_t->evaluate(st[1], t.data(), d_t.data(), d_tt.data());
    const Point<3> *node = nodes.data();
    for (unsigned int j = 0; j < along_t->size(); ++j)
      for (unsigned int i = 0; i < along_s->size(); ++i, ++node)
        for (unsigned int c = 0; c < 3; ++c)
          {
            curvature.d_ss[c] += d_ss[i] * t[j] * (*node)[c];
            curvature.d_st[c] += d_s[i] * d_t[j] * (*node)[c];
            curvature.d_tt[c] += s[i] * d_tt[j] * (*node)[c];
          }
    return curvature;
  }
} // namespace lamella
