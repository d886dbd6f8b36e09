// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/inverse_map.h>
#include <lamella/contact/multiplier_basis.h>
#include <lamella/contact/pairing.h>
#include <lamella/contact/segments.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>

// Mortar integrals by segments (Puso, Int. J. Numer. Meth. Eng. 59 (2004)
// 315-336; Puso and Laursen, Comput. Methods Appl. Mech. Eng. 193 (2004)
// 601-629). For each cell of the slave grid, add_cell():
// 1. the chord plane of the cell, and the averaged normal at its center;
// 2. segments: the cell clipped with the projected master facets (cut());
// 3. triangles of each segment with Gauss points, exact if both are flat;
// 4. at each point the opposite place along the averaged normal
//    (find_master_point()), and its contribution to the hat functions
//    (MultiplierBasis).
// Against an obstacle, Gauss points of the cell replace the segments.
// Degree of the rule: 2 for the hat function plus those of the traces.
namespace lamella
{
  using namespace dealii;

  namespace
  {
    // cos 80 degrees: limit of opposed normals at points of a segment whose
    // centroid faces the other side.
    constexpr double nearly_faces = 0.17;
    constexpr double anywhere     = std::numeric_limits<double>::max();

    // Additional degrees of the Gauss rule on curved facets.
    constexpr unsigned int degrees_for_curves = 2;

    using Vector3 = Tensor<1, 3>;



    /// Returns a rule exact for hat times trace functions on flat facets.
    const Quadrature<2> &
    rule_of_segment(const MeshSurface::Facet &slave,
                    const MeshSurface::Facet &master)
    {
      const SurfaceFacet &a = slave.side, &b = master.side;
      // A hat function is of degree 2 on triangles.
      const unsigned int degree =
        2 +
        std::max(a.trace_degree_s + a.trace_degree_t,
                 b.trace_degree_s + b.trace_degree_t) +
        (slave.map.is_affine() && master.map.is_affine() ? 0 :
                                                           degrees_for_curves);
      return triangle_rule(degree);
    }



    class Integrator
    {
    public:
      explicit Integrator(const ContactSurfacePair &sides)
        : sides(sides)
        , hats(sides)
        , parts(sides.slave->facets().size())
      {}

      // Cell by cell; hats.finish() divides by A_i and distributes hanging
      // nodes.
      Gaps
      run()
      {
        for (const Cell &cell : hats.cells())
          {
            if (!sides.part.empty() && !sides.part[cell.number])
              continue;
            hats.add_full_areas(cell);
            if (sides.master_mesh != nullptr)
              add_cell(cell);
            else
              integrate_cell_on_obstacle(cell);
            hats.close(cell);
          }
        hats.finish(parts, result);
        return std::move(result);
      }

    private:
      using Cell = MultiplierBasis::Cell;

      /// A point of the slave side.
      struct SlavePoint
      {
        Point<2> st;
        Point<3> position;
        /// Normal of the continuous field, and of the facet.
        Vector3 normal, own_normal;
        /// |d_s x d_t|.
        double density;
      };

      // Position, continuous normal and area per unit of the square at (s, t).
      SlavePoint
      evaluate(const Cell &cell, const Point<2> &st) const
      {
        const auto    place   = cell.facet->map(st);
        const Vector3 normal  = cell.facet->map.outward(place);
        const double  density = normal.norm();
        return {st,
                place.position,
                sides.slave->smooth_normal(*cell.facet, st),
                normal / density,
                density};
      }

      // Segments along the averaged normal at the center of the cell.
      void
      add_cell(const Cell &cell)
      {
        std::array<Point<3>, 4> corners;
        for (unsigned int k = 0; k < 4; ++k)
          corners[k] = cell.facet
                         ->map(Point<2>((k % 2 == 0 ? cell.low : cell.high)[0],
                                        (k / 2 == 0 ? cell.low : cell.high)[1]))
                         .position;
        const SlavePoint middle =
          evaluate(cell, cell.low + 0.5 * (cell.high - cell.low));
        const ChordPlane plane(corners, middle.own_normal);

        const auto facing   = find_master_point(*sides.master,
                                              middle.position,
                                              middle.normal,
                                              sides.search_radius);
        const auto segments = cut(plane,
                                  facing ? facing->normal : middle.normal,
                                  *sides.master_mesh,
                                  sides.search_radius);

        // If segments overlap, facets lie behind each other.
        std::vector<unsigned int> candidates;
        double                    covered = 0.;
        for (const Segment &segment : segments)
          {
            candidates.push_back(segment.facet);
            covered += segment.area;
          }
        const bool layered =
          covered > (1. + arithmetic::quadrature_tolerance) * plane.area;
        for (const Segment &segment : segments)
          add_segment(cell, plane, segment, candidates, layered);
      }

      // Tensor-product Gauss rule on the cell; the integrand is smooth.
      void
      integrate_cell_on_obstacle(const Cell &cell)
      {
        const unsigned int degree = std::max(cell.facet->side.trace_degree_s,
                                             cell.facet->side.trace_degree_t);
        const QGauss<2>    rule(degree / 2 + 1 + degrees_for_curves);
        const Tensor<1, 2> size  = cell.high - cell.low;
        bool               faces = false;
        for (unsigned int q = 0; q < rule.size(); ++q)
          {
            const SlavePoint point    = evaluate(cell, cell.at(rule.point(q)));
            const auto       opposite = find_master_point(*sides.master,
                                                    point.position,
                                                    point.normal,
                                                    sides.search_radius);
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

      // Fan of triangles from the first corner; a segment is convex. Weights
      // are areas on the facet: those in the chord plane over the cosine of
      // normals.
      void
      add_segment(const Cell                      &cell,
                  const ChordPlane                &plane,
                  const Segment                   &segment,
                  const std::vector<unsigned int> &candidates,
                  const bool                       layered)
      {
        const Quadrature<2> &rule =
          rule_of_segment(*cell.facet,
                          sides.master_mesh->facets()[segment.facet]);
        const Polygon &corners = segment.polygon;
        // A segment is included as a whole, by its centroid: otherwise the area
        // of a row at the search radius would depend on the quadrature points.
        const Search search{segment.facet, candidates, layered};
        if (!master_point(slave_point_at(cell, plane, centroid(corners)),
                          search,
                          sides.search_radius,
                          min_facing_cosine))
          return;
        add_part(cell, plane, corners);
        for (unsigned int k = 1; k + 1 < corners.size(); ++k)
          {
            const Tensor<1, 2> along  = corners[k] - corners[0],
                               across = corners[k + 1] - corners[0];
            const double twice_area =
              along[0] * across[1] - along[1] * across[0];
            for (unsigned int q = 0; q < rule.size() && twice_area > 0.; ++q)
              {
                const SlavePoint point =
                  slave_point_at(cell,
                                 plane,
                                 corners[0] + rule.point(q)[0] * along +
                                   rule.point(q)[1] * across);
                if (const auto opposite =
                      master_point(point, search, anywhere, nearly_faces))
                  add_point(cell,
                            point,
                            rule.weight(q) * twice_area /
                              (point.own_normal * plane.normal),
                            *opposite);
              }
          }
      }

      /// Stores the part of @p cell with the @p corners in its chord plane.
      void
      add_part(const Cell       &cell,
               const ChordPlane &plane,
               const Polygon    &corners)
      {
        Polygon part;
        for (const Point<2> &corner : corners)
          part.push_back(slave_point_at(cell, plane, corner).st);
        // (s, t) and the plane may have opposite orientations.
        if (area(part) < 0.)
          std::reverse(part.begin(), part.end());
        parts[cell.number].push_back(part);
      }

      // Inverse map: Newton's method for the (s, t) whose projection along the
      // plane's normal is the point p,
      //   p - P x(s, t) = 0,  Jacobian [e_1, e_2]^T [d_s x, d_t x].
      SlavePoint
      slave_point_at(const Cell       &cell,
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
        const Point<2> st =
          inverse_image(cell.low + 0.5 * (cell.high - cell.low),
                        cell.facet->map.is_affine(),
                        missing,
                        [](const Point<2> &) { return true; })
            .unit;
        return evaluate(cell, st);
      }

      /// Facet that a point faces, or else one of the candidates beside it.
      struct Search
      {
        unsigned int                     facet;
        const std::vector<unsigned int> &candidates;
        bool                             layered;
      };
      // The opposite place on the segment's facet, on a candidate, or on the
      // whole surface. The nearest of layered facets counts; others hide behind
      // it.
      std::optional<MasterPoint>
      master_point(const SlavePoint &point,
                   const Search     &search,
                   const double      search_radius,
                   const double      opposed) const
      {
        const MeshSurface              &mesh = *sides.master_mesh;
        const std::vector<unsigned int> own{search.facet};
        const auto find = [&](const MasterSurface &on, const double radius) {
          return find_master_point(
            on, point.position, point.normal, radius, opposed);
        };
        const auto on_own = find(SurfacePart(mesh, own), search_radius);
        // At the edge of a curved facet, the neighbor's segment may begin
        // slightly before or after the facet, or be an omitted sliver.
        if (!on_own)
          {
            const auto beside =
              find(SurfacePart(mesh, search.candidates), search_radius);
            return beside ?
                     beside :
                     find(mesh,
                          std::min(search_radius, 2. * sides.search_radius));
          }
        if (search.layered)
          {
            const auto   nearest = mesh.intersect_facets(search.candidates,
                                                       point.position,
                                                       on_own->normal,
                                                       search_radius);
            const double rounding =
              arithmetic::same_position * mesh.body().size();
            if (nearest && std::abs(nearest->distance) + rounding <
                             std::abs(on_own->hit.distance))
              return {};
          }
        return on_own;
      }

      // Points deeper than a cell are listed, not integrated
      // (make_interface()).
      void
      add_point(const Cell        &cell,
                const SlavePoint  &point,
                const double       weight,
                const MasterPoint &opposite)
      {
        if (exceeds_cell_depth(sides, opposite.hit, cell.facet->depth))
          {
            result.deep_penetrations.push_back(
              {point.position, opposite.hit.position, -opposite.hit.distance});
            return;
          }

        result.points.push_back({{cell.number, point.st},
                                 {opposite.hit.facet, opposite.hit.st},
                                 weight});
        hats.add(cell, point.st, weight, opposite);
      }

      const ContactSurfacePair &sides;
      MultiplierBasis           hats;
      Gaps                      result;
      /// Parts of each facet that face the other side, in its unit square.
      std::vector<std::vector<Polygon>> parts;
    };
  } // namespace



  Gaps
  weighted_gaps(const ContactSurfacePair &sides)
  {
    return Integrator(sides).run();
  }
} // namespace lamella
