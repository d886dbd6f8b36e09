// SPDX-License-Identifier: LGPL-2.1-or-later

// The surfaces of a solid: faces of its cells, their points, nodes and facets.

#include <lamella/base/arithmetic.h>
#include <lamella/body/solid.h>
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



    /// Cell numbers of the nodes of a facet of degree @p p: s first, xi first.
    std::vector<unsigned int>
    nodes_of_facet(const SurfaceFacet &facet, const unsigned int p)
    {
      const unsigned int        n = p + 1;
      std::vector<unsigned int> nodes;
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          {
            const Point<3> unit = facet.origin + double(i) / p * facet.along_s +
                                  double(j) / p * facet.along_t;
            unsigned int number = 0;
            for (unsigned int d = 3; d-- > 0;)
              number = number * n + std::lround(p * unit[d]);
            nodes.push_back(number);
          }
      return nodes;
    }



    /// The nodes next to a hanging node have the largest quadratic weights.
    std::pair<unsigned int, unsigned int>
    two_largest_weights(std::vector<std::pair<unsigned int, double>> masters)
    {
      std::sort(masters.begin(),
                masters.end(),
                [](const auto &a, const auto &b) {
                  return a.second > b.second;
                });
      return {masters[0].first, masters[1].first};
    }
  } // namespace



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



  void
  Solid::add_face(const unsigned int                   cell,
                  const unsigned int                   face,
                  const HangingNodes                  &hangs,
                  std::map<unsigned int, SurfaceNode> &nodes) const
  {
    const auto &numbers = mesh.cells()[cell].nodes;
    for (unsigned int i = 0; i < numbers.size(); ++i)
      {
        const Point<3> &unit = element.unit_node(i);
        if (std::abs(unit[face / 2] - face % 2) <= arithmetic::same_unit &&
            hangs.count(numbers[i]) == 0)
          nodes[numbers[i]].meet(face_point(cell, face, unit));
      }
    // FEFaceValues would take 130 (degree 1) and 320 us (2) a face, this 12
    // and 45: they had to be made anew for each, as those that are kept
    // take the one cell of Hexahedron for what it was before.
    const QGauss<2>         gauss(degree() + 2);
    const UnitFace          frame   = unit_face(face);
    const Hexahedron::Nodes corners = nodes_of(cell);
    for (unsigned int q = 0; q < gauss.size(); ++q)
      {
        const Point<3> unit = frame.origin + gauss.point(q)[0] * frame.along_s +
                              gauss.point(q)[1] * frame.along_t;
        const SurfacePoint    at    = face_point(cell, face, unit);
        const HexahedronPoint shape = element.evaluate(corners, unit);
        const auto add = [&](const unsigned int node, const double N) {
          nodes[node].add(N * gauss.weight(q) * at.area, at.normal);
        };
        for (unsigned int i = 0; i < numbers.size(); ++i)
          if (const auto found = hangs.find(numbers[i]); found == hangs.end())
            add(numbers[i], shape.N[i]);
          else
            for (const auto &[master, weight] : found->second->masters)
              add(master, weight * shape.N[i]);
      }
  }



  std::vector<SurfacePoint>
  Solid::surface_points(const std::string &surface) const
  {
    HangingNodes hangs;
    for (const HexahedralMesh::HangingNode &node : mesh.hanging_nodes())
      hangs[node.node] = &node;

    std::map<unsigned int, SurfaceNode> nodes;
    for (const auto &[cell, face] : faces_of(surface))
      add_face(cell, face, hangs, nodes);

    std::vector<SurfacePoint> points;
    for (const auto &[number, node] : nodes)
      if (node.has_point())
        points.push_back(node.finished());
    return points;
  }



  std::vector<Location>
  Solid::body_points() const
  {
    std::set<unsigned int> seen;
    for (const HexahedralMesh::HangingNode &node : mesh.hanging_nodes())
      seen.insert(node.node);
    std::vector<Location> locations;
    for (unsigned int cell = 0; cell < mesh.cells().size(); ++cell)
      {
        const auto &nodes = mesh.cells()[cell].nodes;
        for (unsigned int i = 0; i < nodes.size(); ++i)
          if (seen.insert(nodes[i]).second)
            locations.push_back({placement.to_scene(mesh.nodes()[nodes[i]]),
                                 mesh.cells()[cell].ply,
                                 {{cell, element.unit_node(i)}}});
      }
    return locations;
  }



  std::vector<SurfaceFacet>
  Solid::facets_of(const std::string &surface) const
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
            surface_point(facet, GeometryInfo<2>::unit_cell_vertex(k)).position;
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

    const std::vector<unsigned int> order =
      FETools::lexicographic_to_hierarchic_numbering<3>(degree());
    SurfaceTopology topology;
    for (const SurfaceFacet &facet : facets_of(surface))
      {
        std::vector<std::uint64_t> nodes;
        for (const unsigned int k : nodes_of_facet(facet, degree()))
          nodes.push_back(node[mesh.cells()[facet.cell].nodes[order[k]]]);
        topology.add(facet, nodes, nodes);
      }

    for (const HexahedralMesh::HangingNode &hanging : mesh.hanging_nodes())
      if (hanging.masters.size() == 2 || hanging.masters.size() == 3)
        {
          Assert(hanging.masters.size() == degree() + 1,
                 ExcMessage("An edge hangs on one that hangs itself."));
          const auto [one, other] = two_largest_weights(hanging.masters);
          topology.add_hanging(hanging.node, {{node[one], node[other]}});
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
} // namespace lamella
