// SPDX-License-Identifier: LGPL-2.1-or-later

// The points of a solid: where they are, which rows they give, and those that
// make up its surfaces.

#include <lamella/base/arithmetic.h>
#include <lamella/body/fields.h>
#include <lamella/body/line_crossings.h>
#include <lamella/body/solid.h>
#include <lamella/body/surface_names.h>
#include <lamella/body/surface_node.h>
#include <lamella/body/surface_topology.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_tools.h>

#include <set>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// The box grown by @p share of its section's diagonal across, where cells
    /// may be curved, and by next to nothing along the axis.
    BoundingBox<3>
    grown(const BoundingBox<3> &box, const double share)
    {
      auto [lower, upper] = box.get_boundary_points();
      const double across =
        share * std::hypot(upper[0] - lower[0], upper[2] - lower[2]);
      const double along = arithmetic::same_in_element * (upper[1] - lower[1]);
      for (const unsigned int d : {0, 1, 2})
        {
          lower[d] -= d == 1 ? along : across;
          upper[d] += d == 1 ? along : across;
        }
      return BoundingBox<3>({lower, upper});
    }



    /// The face @p face of the unit cube: where (0, 0) is, and its directions:
    /// along the section first, then the axis; on the ends xi and eta.
    struct UnitFace
    {
      Point<3>     origin;
      Tensor<1, 3> along_s, along_t;
    };

    UnitFace
    unit_face(const unsigned int face)
    {
      UnitFace           result;
      const unsigned int normal           = face / 2;
      result.origin[normal]               = face % 2;
      result.along_s[normal == 0 ? 2 : 0] = 1.;
      result.along_t[normal == 1 ? 2 : 1] = 1.;
      return result;
    }
  } // namespace



  void
  Solid::make_boxes()
  {
    std::vector<std::pair<BoundingBox<3>, unsigned int>> all;
    for (unsigned int cell = 0; cell < mesh.cells().size(); ++cell)
      all.emplace_back(grown(BoundingBox<3>(nodes_of(cell)),
                             is_curved ? 0.2 : arithmetic::same_in_element),
                       cell);
    boxes = pack_rtree(all);
  }



  std::pair<Point<3>, double>
  Solid::nearest_in_cell(const unsigned int cell, const Point<3> &x) const
  {
    const Hexahedron::Nodes nodes = nodes_of(cell);
    Point<3>                unit;
    try
      {
        unit =
          element.mapping().transform_real_to_unit_cell(element.cell(nodes),
                                                        Point<3>(x - nodes[0]));
      }
    catch (const Mapping<3>::ExcTransformationFailed &)
      {
        return {unit, std::numeric_limits<double>::max()};
      }
    // deal.II stops within 1e-11, and at a node the other shape functions are
    // to vanish but for rounding: one more step of Newton's method.
    const HexahedronPoint found = element.evaluate(nodes, unit);
    unit = GeometryInfo<3>::project_to_unit_cell(unit + invert(found.jacobian) *
                                                          (x - found.position));
    return {unit, x.distance(element.evaluate(nodes, unit).position)};
  }



  std::vector<std::vector<Location>>
  Solid::locate(const std::vector<Point<3>> &points) const
  {
    // GridTools knows the cells of this process only, takes 120 to 400 us
    // instead of 9 to 22 for a point at a node, where several cells meet, and
    // 2 ms to miss one that lies 1e-9 outside (1,000 to 1,600 hexahedra).
    // So: boxes of all cells, and the mapping's inverse in those around.

    // Positions come out of decimal texts and rotations.
    const double section_size =
      Tensor<1, 2>({box.side_length(0), box.side_length(2)}).norm();
    const double tolerance = arithmetic::same_place_across * section_size +
                             arithmetic::rounding_of_sums * axis_length;
    std::vector<std::vector<Location>> result;
    for (const Point<3> &point : points)
      {
        const Point<3> x = placement.to_body(point);
        BoundingBox<3> around(std::make_pair(x, x));
        around.extend(tolerance);
        std::vector<std::pair<BoundingBox<3>, unsigned int>> candidates;
        boxes.query(boost::geometry::index::intersects(around),
                    std::back_inserter(candidates));
        std::sort(candidates.begin(),
                  candidates.end(),
                  [](const auto &a, const auto &b) {
                    return a.second < b.second;
                  });

        std::map<unsigned int, Location> by_ply;
        Location::Place                  nearest{};
        double smallest = std::numeric_limits<double>::max();
        for (const auto &[cell_box, cell] : candidates)
          {
            const auto [unit, distance] = nearest_in_cell(cell, x);
            const unsigned int ply      = mesh.cells()[cell].ply;
            if (distance <= tolerance)
              {
                by_ply[ply].position = point;
                by_ply[ply].ply      = ply;
                by_ply[ply].places.push_back({cell, unit});
              }
            // A point beyond a curved side is on the body if it is within 2 %
            // of the cell's extension there (its box is larger by two fifths).
            const double size =
              Tensor<1, 2>({cell_box.side_length(0), cell_box.side_length(2)})
                .norm() /
              1.4;
            if (is_curved && distance < std::min(smallest, 0.02 * size))
              {
                smallest = distance;
                nearest  = {cell, unit};
              }
          }
        result.emplace_back();
        if (by_ply.empty() && smallest < std::numeric_limits<double>::max())
          result.back().push_back(
            {point, mesh.cells()[nearest.cell].ply, {nearest}});
        for (const auto &[ply, place] : by_ply)
          result.back().push_back(place);
      }
    return result;
  }



  Point<3>
  Solid::position(const Location::Place &place) const
  {
    return placement.to_scene(
      element.evaluate(nodes_of(place.cell), place.unit).position);
  }



  PlyAt
  Solid::ply_at(const Location::Place &place) const
  {
    const Point<3> x =
      element.evaluate(nodes_of(place.cell), place.unit).position;
    return {mesh.cells()[place.cell].ply, ply_axes(place.cell, x)};
  }



  std::vector<std::vector<Row>>
  Solid::rows(const std::vector<Location> &locations,
              const Quantity               quantity,
              const Frame                  frame) const
  {
    const unsigned int n = quantity == Quantity::displacement ? 3 : 6;
    std::vector<std::vector<Row>> result;
    for (const Location &where : locations)
      {
        const Location::Place &first = where.places[0];
        const Point<3>         x =
          element.evaluate(nodes_of(first.cell), first.unit).position;
        const FromStrain to_frame =
          from_strain(quantity,
                      frame,
                      placement,
                      ply_axes(first.cell, x),
                      law_at(first.cell, first.unit, x));
        std::vector<Row> rows(n);
        if (quantity != Quantity::displacement)
          for (unsigned int c = 0; c < n; ++c)
            rows[c].add_constant(to_frame.constant[c]);
        const double share = 1. / where.places.size();
        for (const Location::Place &place : where.places)
          {
            const Hexahedron::Nodes nodes = nodes_of(place.cell);
            const HexahedronPoint   point = element.evaluate(nodes, place.unit);
            const std::vector<DofIndex> dofs = dofs_of(place.cell);
            if (quantity == Quantity::displacement)
              {
                for (unsigned int d = 0; d < dofs.size(); ++d)
                  for (unsigned int c = 0; c < 3; ++c)
                    rows[c].add(dofs[d],
                                share * point.N[d / 3] *
                                  placement.axes[d % 3][c]);
                continue;
              }
            const std::vector<Voigt> B =
              element.strains(point, kinds[kind_of_cell[place.cell]].modes);
            for (unsigned int d = 0; d < dofs.size(); ++d)
              {
                const Voigt v = share * (to_frame.matrix * B[d]);
                for (unsigned int c = 0; c < 6; ++c)
                  rows[c].add(dofs[d], v[c]);
              }
          }
        for (Row &row : rows)
          {
            row.compress();
            // At a node all other shape functions vanish but for rounding.
            row.drop_below(arithmetic::rounding);
          }
        result.push_back(std::move(rows));
      }
    return result;
  }



  std::vector<std::string>
  Solid::surfaces() const
  {
    std::vector<std::string> names = mesh.sides();
    names.insert(names.end(), {"ends", "all"});
    return names;
  }



  std::vector<std::pair<unsigned int, unsigned int>>
  Solid::faces_of(const std::string &surface) const
  {
    std::vector<std::pair<unsigned int, unsigned int>> faces;
    for (unsigned int cell = 0; cell < mesh.cells().size(); ++cell)
      for (unsigned int f = 0; f < 6; ++f)
        {
          const int side = mesh.cells()[cell].sides[f];
          if (side == HexahedralMesh::inside)
            continue;
          if (surface_names::covers(surface, mesh.sides()[side]))
            faces.emplace_back(cell, f);
        }
    return faces;
  }



  SurfacePoint
  Solid::face_point(const unsigned int cell,
                    const unsigned int face,
                    const Point<3>    &unit) const
  {
    const HexahedronPoint at = element.evaluate(nodes_of(cell), unit);
    // Nanson: n da = det J J^-T n_0 da_0.
    Tensor<1, 3> n =
      determinant(at.jacobian) * (transpose(invert(at.jacobian)) *
                                  GeometryInfo<3>::unit_normal_vector[face]);
    const double area = n.norm();
    n /= area;

    SurfacePoint point;
    point.position = placement.to_scene(at.position);
    point.normal   = placement.vector_to_scene(n);
    point.area     = area;
    point.depth    = determinant(at.jacobian) / area;
    point.location = {point.position, mesh.cells()[cell].ply, {{cell, unit}}};
    // The work of the stress of n n on itself: shear strains count twice.
    Voigt                                                nn;
    constexpr std::array<std::array<unsigned int, 2>, 3> planes{
      {{{0, 1}}, {{0, 2}}, {{1, 2}}}};
    for (unsigned int d = 0; d < 3; ++d)
      {
        nn[d]     = n[d] * n[d];
        nn[3 + d] = 2. * n[planes[d][0]] * n[planes[d][1]];
      }
    point.normal_modulus = nn * (law(cell, at.position).stiffness() * nn);
    return point;
  }



  std::vector<SurfacePoint>
  Solid::surface_points(const std::string &surface) const
  {
    // Hanging nodes give their area to those that they hang on.
    std::map<unsigned int, const HexahedralMesh::HangingNode *> hangs;
    for (const HexahedralMesh::HangingNode &node : mesh.hanging_nodes())
      hangs[node.node] = &node;

    std::map<unsigned int, SurfaceNode> nodes;
    const QGauss<2>                     gauss(degree() + 2);
    for (const auto &[cell, face] : faces_of(surface))
      {
        const UnitFace          frame   = unit_face(face);
        const Hexahedron::Nodes corners = nodes_of(cell);
        const auto             &numbers = mesh.cells()[cell].nodes;
        for (unsigned int i = 0; i < numbers.size(); ++i)
          {
            const Point<3> &unit = element.unit_node(i);
            if (std::abs(unit[face / 2] - face % 2) > arithmetic::same_unit ||
                hangs.count(numbers[i]) > 0)
              continue;
            nodes[numbers[i]].meet(face_point(cell, face, unit));
          }
        // FEFaceValues would take 130 (degree 1) and 320 us (2) a face, this 12
        // and 45: they had to be made anew for each, as those that are kept
        // take the one cell of Hexahedron for what it was before.
        for (unsigned int q = 0; q < gauss.size(); ++q)
          {
            const Point<3> unit = frame.origin +
                                  gauss.point(q)[0] * frame.along_s +
                                  gauss.point(q)[1] * frame.along_t;
            const SurfacePoint    at    = face_point(cell, face, unit);
            const HexahedronPoint shape = element.evaluate(corners, unit);
            const auto add = [&](const unsigned int node, const double N) {
              nodes[node].add(N * gauss.weight(q) * at.area, at.normal);
            };
            for (unsigned int i = 0; i < numbers.size(); ++i)
              if (const auto found = hangs.find(numbers[i]);
                  found == hangs.end())
                add(numbers[i], shape.N[i]);
              else
                for (const auto &[master, weight] : found->second->masters)
                  add(master, weight * shape.N[i]);
          }
      }

    std::vector<SurfacePoint> points;
    for (const auto &[number, node] : nodes)
      if (node.is_there())
        points.push_back(node.finished());
    return points;
  }



  std::vector<Location>
  Solid::node_locations(
    const std::vector<std::pair<unsigned int, unsigned int>> &faces) const
  {
    std::set<unsigned int> seen;
    for (const HexahedralMesh::HangingNode &node : mesh.hanging_nodes())
      seen.insert(node.node);
    std::vector<Location> locations;
    for (const auto &[cell, face] : faces)
      {
        const auto &nodes = mesh.cells()[cell].nodes;
        for (unsigned int i = 0; i < nodes.size(); ++i)
          {
            const Point<3> &unit = element.unit_node(i);
            if ((face == numbers::invalid_unsigned_int ||
                 std::abs(unit[face / 2] - face % 2) < arithmetic::same_unit) &&
                seen.insert(nodes[i]).second)
              locations.push_back({placement.to_scene(mesh.nodes()[nodes[i]]),
                                   mesh.cells()[cell].ply,
                                   {{cell, unit}}});
          }
      }
    return locations;
  }



  std::vector<Location>
  Solid::fixing_points(const std::string &surface) const
  {
    return node_locations(faces_of(surface));
  }



  std::vector<Location>
  Solid::body_points() const
  {
    std::vector<std::pair<unsigned int, unsigned int>> all;
    for (unsigned int cell = 0; cell < mesh.cells().size(); ++cell)
      all.emplace_back(cell, numbers::invalid_unsigned_int);
    return node_locations(all);
  }



  std::vector<SurfaceFacet>
  Solid::surface_facets(const std::string &surface) const
  {
    std::vector<SurfaceFacet> facets;
    for (const auto &[cell, face] : faces_of(surface))
      {
        const UnitFace frame = unit_face(face);
        SurfaceFacet   facet;
        facet.cell     = cell;
        facet.origin   = frame.origin;
        facet.along_s  = frame.along_s;
        facet.along_t  = frame.along_t;
        facet.degree_s = facet.degree_t = degree();
        facet.trace_degree_s = facet.trace_degree_t = degree();
        for (unsigned int k = 0; k < 4; ++k)
          facet.corners[k] =
            surface_point(facet, Point<2>(k % 2, k / 2)).position;
        facets.push_back(facet);
      }
    return facets;
  }



  SurfaceTopology
  Solid::surface_topology(const std::string &surface) const
  {
    // A node that hangs at the place of another one is that one.
    std::vector<unsigned int> node(mesh.nodes().size());
    std::iota(node.begin(), node.end(), 0u);
    for (const HexahedralMesh::HangingNode &hanging : mesh.hanging_nodes())
      if (hanging.masters.size() == 1)
        node[hanging.node] = hanging.masters[0].first;

    const unsigned int              p = degree(), n = p + 1;
    const std::vector<unsigned int> order =
      FETools::lexicographic_to_hierarchic_numbering<3>(p);
    SurfaceTopology topology;
    for (const SurfaceFacet &facet : surface_facets(surface))
      {
        std::vector<std::uint64_t> nodes;
        for (unsigned int j = 0; j < n; ++j)
          for (unsigned int i = 0; i < n; ++i)
            {
              const Point<3> unit = facet.origin +
                                    double(i) / p * facet.along_s +
                                    double(j) / p * facet.along_t;
              unsigned int number = 0;
              for (unsigned int d = 3; d-- > 0;)
                number = number * n + std::lround(p * unit[d]);
              nodes.push_back(
                node[mesh.cells()[facet.cell].nodes[order[number]]]);
            }
        topology.add(facet, nodes, nodes);
      }

    for (const HexahedralMesh::HangingNode &hanging : mesh.hanging_nodes())
      if (hanging.masters.size() == 2 || hanging.masters.size() == 3)
        {
          // Of an edge's quadratic the two next to the node weigh most.
          auto masters = hanging.masters;
          Assert(masters.size() == degree() + 1,
                 ExcMessage("An edge hangs on one that hangs itself."));
          std::sort(masters.begin(),
                    masters.end(),
                    [](const auto &a, const auto &b) {
                      return a.second > b.second;
                    });
          topology.add_hanging(
            hanging.node, {{node[masters[0].first], node[masters[1].first]}});
        }
    return topology;
  }



  SurfacePoint
  Solid::surface_point(const SurfaceFacet &facet, const Point<2> &st) const
  {
    // The direction that neither s nor t runs along.
    unsigned int normal = 0;
    while (facet.along_s[normal] != 0. || facet.along_t[normal] != 0.)
      ++normal;
    return face_point(facet.cell,
                      2 * normal + (facet.origin[normal] == 0. ? 0 : 1),
                      facet.origin + st[0] * facet.along_s +
                        st[1] * facet.along_t);
  }



  void
  Solid::add_side_crossings(const unsigned int   cell,
                            const unsigned int   v,
                            const unsigned int   w,
                            const Point<2>      &a,
                            const Tensor<1, 2>  &d,
                            const double         tolerance,
                            std::vector<double> &crossings) const
  {
    const Hexahedron::Nodes nodes = nodes_of(cell);
    if (!is_curved)
      return add_edge_crossings({nodes[v][0], nodes[v][2]},
                                {nodes[w][0], nodes[w][2]},
                                a,
                                d,
                                tolerance,
                                crossings);
    const Point<3>     begin = GeometryInfo<3>::unit_cell_vertex(v);
    const Tensor<1, 3> along = GeometryInfo<3>::unit_cell_vertex(w) - begin;
    add_curve_crossings(
      [&](const double s) {
        const Point<3> x = element.evaluate(nodes, begin + s * along).position;
        return Point<2>(x[0], x[2]);
      },
      a,
      d,
      tolerance,
      crossings);
  }



  std::vector<double>
  Solid::line_breaks(const Point<3> &from, const Point<3> &to) const
  {
    const Point<3>     a = placement.to_body(from), b = placement.to_body(to);
    const Tensor<1, 3> d = b - a;
    Tensor<1, 2>       in_section;
    in_section[0] = d[0];
    in_section[1] = d[2];
    const double tolerance =
      arithmetic::same_place_across *
      Tensor<1, 2>({box.side_length(0), box.side_length(2)}).norm();

    std::vector<std::pair<BoundingBox<3>, unsigned int>> near;
    BoundingBox<3> around(std::vector<Point<3>>{a, b});
    around.extend(tolerance);
    boxes.query(boost::geometry::index::intersects(around),
                std::back_inserter(near));
    std::vector<double> breaks;
    for (const auto &[cell_box, cell] : near)
      {
        // Corners come first among the nodes: deal.II's vertices.
        const auto &nodes  = mesh.cells()[cell].nodes;
        const auto  corner = [&](const unsigned int v) {
          return mesh.nodes()[nodes[v]];
        };
        std::vector<double> crossings;
        if (std::abs(d[1]) > arithmetic::same_place_along * axis_length)
          for (const unsigned int v : {0, 2})
            crossings.push_back((corner(v)[1] - a[1]) / d[1]);
        if (in_section.norm() > tolerance)
          for (const auto &[v, w] :
               {std::pair<unsigned int, unsigned int>{0, 1},
                {4, 5},
                {0, 4},
                {1, 5}})
            add_side_crossings(
              cell, v, w, {a[0], a[2]}, in_section, tolerance, crossings);
        // Not where the line meets the planes of cells further away.
        for (const double t : crossings)
          if (grown(cell_box, arithmetic::same_in_element)
                .point_inside(a + t * d))
            breaks.push_back(t);
      }
    return tidy_breaks(std::move(breaks));
  }

} // namespace lamella
