// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/base/inverse_map.h>
#include <lamella/body/surface_topology.h>
#include <lamella/contact/slave_surface.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // How far outside of a facet's unit square a place still counts: positions
    // come out of decimal texts and rotations.
    constexpr double outside = 1e-7;

    // Of the rule, for what is not polynomial on curved facets; and into how
    // many parts each way a strip cuts these.
    constexpr unsigned int degrees_more_on_curves = 4, parts_of_curves = 4;

    // Coordinates closer than this share of the surface's extent are the same.
    constexpr double same = 1e-6;



    /// Whether @p st is in @p polygon, counterclockwise, or next to it.
    bool
    contains(const Polygon &polygon, const Point<2> &st)
    {
      for (unsigned int k = 0; k < polygon.size(); ++k)
        {
          const Tensor<1, 2> side =
                               polygon[(k + 1) % polygon.size()] - polygon[k],
                             d = st - polygon[k];
          if (side[0] * d[1] - side[1] * d[0] < -outside * side.norm())
            return false;
        }
      return polygon.size() > 2;
    }



    /// What of the triangle @p piece of @p map lies in @p strip, its end not
    /// included: on a triangle what is linear along the sides is linear all
    /// over, so strips side by side leave nothing out and share nothing.
    Polygon
    within(const ContactStrip &strip, const FacetMap &map, const Polygon &piece)
    {
      const auto place = [&](const unsigned int k) {
        return map(piece[k]).position[strip.axis];
      };
      const Tensor<1, 2> along = piece[1] - piece[0], up = piece[2] - piece[0];
      const double       twice_area = along[0] * up[1] - along[1] * up[0];
      if (!(twice_area > 0.))
        return {};
      const double of_along = place(1) - place(0), of_up = place(2) - place(0);
      const double rounding = 1e-12 * map.control_points().front().distance(
                                        map.control_points().back());
      const auto above = [&](const double bound, const Point<2> &st) {
        const Tensor<1, 2> d      = st - piece[0];
        const double       height = place(0) - bound +
                              ((d[0] * up[1] - d[1] * up[0]) * of_along +
                               (along[0] * d[1] - along[1] * d[0]) * of_up) /
                                twice_area;
        return std::abs(height) < rounding ? 0. : height;
      };
      if (std::all_of(piece.begin(), piece.end(), [&](const Point<2> &st) {
            return above(strip.to, st) == 0.;
          }))
        return {};
      return part_above(
        part_above(piece,
                   [&](const Point<2> &st) { return above(strip.from, st); }),
        [&](const Point<2> &st) { return -above(strip.to, st); });
    }



    /// What of @p part lies in @p strip, in pieces.
    std::vector<Polygon>
    clipped_to_strip(const ContactStrip &strip,
                     const FacetMap     &map,
                     const Polygon      &part)
    {
      const unsigned int   n = map.is_affine() ? 1 : parts_of_curves;
      std::vector<Polygon> pieces;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          {
            const double  s = double(i) / n, t = double(j) / n, h = 1. / n;
            const Polygon piece = n == 1 ? part :
                                           clipped(part,
                                                   {Point<2>(s, t),
                                                    Point<2>(s + h, t),
                                                    Point<2>(s + h, t + h),
                                                    Point<2>(s, t + h)});
            for (unsigned int k = 1; k + 1 < piece.size(); ++k)
              pieces.push_back(
                within(strip, map, {piece[0], piece[k], piece[k + 1]}));
          }
      return pieces;
    }



    /// The two hats that are not zero at @p t on the grid @p nodes: of the
    /// first one the number and the value; that of the next is the rest.
    std::pair<unsigned int, double>
    hat_function_at(const GaussLobattoBasis &nodes, const double t)
    {
      unsigned int k = 0;
      while (k + 2 < nodes.size() && nodes.point(k + 1) <= t)
        ++k;
      return {k,
              (nodes.point(k + 1) - t) / (nodes.point(k + 1) - nodes.point(k))};
    }



    /// A node with rows of its own, and its neighbor along a line.
    struct LineNode
    {
      Point<3>                    position;
      std::set<unsigned int>      rows;
      std::optional<unsigned int> next;
      bool                        has_previous = false;
    };

    using LineNodes = std::map<unsigned int, LineNode>;



    /// The nodes of @p facet that have rows of their own.
    void
    add_nodes(const SlaveSurface::Facet &facet, LineNodes &nodes)
    {
      const GaussLobattoBasis &s = GaussLobattoBasis::of_degree(facet.degree_s),
                              &t = GaussLobattoBasis::of_degree(facet.degree_t);
      for (unsigned int k = 0; k < facet.nodes.size(); ++k)
        if (facet.rows[k].size() == 1 && facet.rows[k][0].second == 1.)
          {
            LineNode &node = nodes[facet.nodes[k]];
            node.position =
              facet.map({s.point(k % s.size()), t.point(k / s.size())})
                .position;
            node.rows.insert(facet.rows[k][0].first);
          }
    }



    /// Links those of @p facet that follow each other on a line of its grid, if
    /// @p order of two places is not 0: 1 if the second comes after the first.
    void
    link(const SlaveSurface::Facet                                    &facet,
         const std::function<int(const Point<3> &, const Point<3> &)> &order,
         LineNodes                                                    &nodes)
    {
      const unsigned int n = facet.degree_s + 1, m = facet.degree_t + 1;
      const auto         link_line = [&](const unsigned int begin,
                                 const unsigned int step,
                                 const unsigned int count) {
        std::optional<unsigned int> last;
        for (unsigned int k = 0; k < count; ++k)
          {
            const unsigned int here = facet.nodes[begin + k * step];
            const auto         node = nodes.find(here);
            if (node == nodes.end())
              continue;
            if (last)
              {
                const int way =
                  order(nodes.at(*last).position, node->second.position);
                const unsigned int from = way > 0 ? *last : here,
                                   to   = way > 0 ? here : *last;
                if (way != 0 && !nodes.at(from).next &&
                    !nodes.at(to).has_previous)
                  {
                    nodes.at(from).next       = to;
                    nodes.at(to).has_previous = true;
                  }
              }
            last = here;
          }
      };
      for (unsigned int j = 0; j < m; ++j)
        link_line(j * n, 1, n);
      for (unsigned int i = 0; i < n; ++i)
        link_line(i, n, m);
    }
  } // namespace



  SlaveSurface::SlaveSurface(const Functions    functions,
                             const unsigned int n_rows,
                             std::vector<Facet> facets)
    : kind(functions)
    , rows(n_rows)
    , all(std::move(facets))
    , whole(rows)
  {
    std::vector<BoundingBox<3>> of_facets;
    for (const Facet &facet : all)
      {
        BoundingBox<3> box(facet.map.control_points());
        // Between its nodes a curve may leave their box a little.
        const auto [low, high] = box.get_boundary_points();
        box.extend((facet.map.is_straight() ? 1e-6 : 0.1) * low.distance(high));
        of_facets.push_back(box);
      }
    boxes = BoxSearch(of_facets);
    for (const Facet &facet : all)
      for (const Polygon &part : facet.parts)
        add_integrals(facet, part, whole);
  }



  void
  SlaveSurface::evaluate(const Facet         &facet,
                         const Point<2>      &st,
                         std::vector<double> &values) const
  {
    const GaussLobattoBasis &s = GaussLobattoBasis::of_degree(facet.degree_s),
                            &t = GaussLobattoBasis::of_degree(facet.degree_t);
    if (kind == Functions::trace)
      {
        evaluate_on_grid(s, t, st, values);
        return;
      }
    values.assign(s.size() * t.size(), 0.);
    const auto [i, of_i]     = hat_function_at(s, st[0]);
    const auto [j, of_j]     = hat_function_at(t, st[1]);
    const unsigned int k     = j * s.size() + i;
    values[k]                = of_i * of_j;
    values[k + 1]            = (1. - of_i) * of_j;
    values[k + s.size()]     = of_i * (1. - of_j);
    values[k + s.size() + 1] = (1. - of_i) * (1. - of_j);
  }



  std::vector<double>
  SlaveSurface::functions_at(const Place &place) const
  {
    std::vector<double> values;
    evaluate(all[place.facet], place.st, values);
    return values;
  }



  void
  SlaveSurface::add_integrals(const Facet            &facet,
                              const Polygon          &part,
                              std::vector<Integrals> &sums) const
  {
    if (part.size() < 3)
      return;
    const auto         of_map = facet.map.degrees();
    const unsigned int degree =
      1 + (kind == Functions::hats ? 2 : facet.degree_s + facet.degree_t) +
      (facet.map.is_affine() ? 0 :
                               of_map[0] + of_map[1] + degrees_more_on_curves);
    const Quadrature<2> &rule = triangle_rule(degree);
    std::vector<double>  values;
    for (unsigned int k = 1; k + 1 < part.size(); ++k)
      {
        const Tensor<1, 2> along = part[k] - part[0],
                           up    = part[k + 1] - part[0];
        const double twice_area  = along[0] * up[1] - along[1] * up[0];
        for (unsigned int q = 0; q < rule.size(); ++q)
          {
            const Point<2> st =
              part[0] + rule.point(q)[0] * along + rule.point(q)[1] * up;
            const auto   place = facet.map(st);
            const double dA    = rule.weight(q) * twice_area *
                              cross_product_3d(place.d_s, place.d_t).norm();
            evaluate(facet, st, values);
            for (unsigned int i = 0; i < values.size(); ++i)
              for (const auto &[row, share] : facet.rows[i])
                {
                  sums[row].area += share * values[i] * dA;
                  sums[row].moment +=
                    (share * values[i] * dA) * Tensor<1, 3>(place.position);
                }
          }
      }
  }



  std::vector<SlaveSurface::Integrals>
  SlaveSurface::integrals(const ContactStrip &strip) const
  {
    std::vector<Integrals> sums(rows);
    for (const Facet &facet : all)
      for (const Polygon &part : facet.parts)
        for (const Polygon &piece : clipped_to_strip(strip, facet.map, part))
          add_integrals(facet, piece, sums);
    return sums;
  }



  std::optional<SlaveSurface::Place>
  SlaveSurface::on_line(const Point<3>     &x,
                        const Tensor<1, 3> &d,
                        const double        search_radius) const
  {
    if (all.empty())
      return {};
    std::optional<Place> nearest;
    double               least = search_radius;
    for (const unsigned int f : boxes.meeting(
           BoundingBox<3>(std::vector<Point<3>>{x - search_radius * d,
                                                x + search_radius * d})))
      {
        const Facet &facet = all[f];
        const auto   st    = line_intersection(facet.map, x, d);
        if (!st || std::none_of(facet.parts.begin(),
                                facet.parts.end(),
                                [&](const Polygon &part) {
                                  return contains(part, *st);
                                }))
          continue;
        const double distance = std::abs((facet.map(*st).position - x) * d);
        if (distance > least || (nearest && distance == least))
          continue;
        least   = distance;
        nearest = Place{f, *st};
      }
    return nearest;
  }



  std::vector<std::vector<std::vector<unsigned int>>>
  SlaveSurface::lines(const unsigned int axis, const unsigned int across) const
  {
    LineNodes nodes;
    for (const Facet &facet : all)
      add_nodes(facet, nodes);
    std::vector<Point<3>> positions;
    for (const auto &[number, node] : nodes)
      positions.push_back(node.position);
    if (positions.empty())
      return {};
    const BoundingBox<3> box(positions);
    const double         rounding =
      same * std::max(box.side_length(axis), box.side_length(across));
    const auto order = [&](const Point<3> &a, const Point<3> &b) {
      const double along = b[axis] - a[axis];
      return std::abs(b[across] - a[across]) > rounding ||
                 std::abs(along) <= rounding ?
               0 :
             along > 0. ? 1 :
                          -1;
    };
    for (const Facet &facet : all)
      link(facet, order, nodes);

    std::vector<std::vector<std::vector<unsigned int>>> lines;
    for (const auto &[number, first] : nodes)
      if (!first.has_previous)
        {
          lines.emplace_back();
          for (const LineNode *node = &first;;)
            {
              lines.back().emplace_back(node->rows.begin(), node->rows.end());
              if (!node->next)
                break;
              node = &nodes.at(*node->next);
            }
        }
    return lines;
  }



  std::optional<Point<2>>
  line_intersection(const FacetMap     &map,
                    const Point<3>     &x,
                    const Tensor<1, 3> &d)
  {
    constexpr double accepted = 1e-12, lost = 10.;

    // Two directions across the ray, in which X(s, t) - x is to vanish.
    unsigned int least = std::abs(d[1]) < std::abs(d[0]) ? 1 : 0;
    least              = std::abs(d[2]) < std::abs(d[least]) ? 2 : least;
    Tensor<1, 3> a;
    a[least]             = 1.;
    a                    = cross_product_3d(d, a);
    a                    = a / a.norm();
    const Tensor<1, 3> b = cross_product_3d(d, a);

    const auto missing = [&](const Point<2> &st) {
      const auto   place = map(st);
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
      inverse_image(Point<2>(0.5, 0.5), map.is_affine(), missing, is_near);
    if (!is_near(st) || change > accepted)
      return {};
    for (unsigned int c = 0; c < 2; ++c)
      if (st[c] < -outside || st[c] > 1. + outside)
        return {};
    return st;
  }
} // namespace lamella
