// SPDX-License-Identifier: LGPL-2.1-or-later

// The surfaces of a beam: points, facets, and how these hang together.

#include <lamella/base/arithmetic.h>
#include <lamella/base/linear_functional.h>
#include <lamella/body/beam.h>
#include <lamella/body/surface_topology.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace lamella
{
  using namespace dealii;

  std::vector<std::string>
  Beam::surfaces() const
  {
    std::vector<std::string> names;
    for (const auto &[id, name] :
         beam_section->element().section_mesh().boundaries)
      names.push_back(name);
    names.insert(names.end(), {"start", "end", "ends", "all"});
    return names;
  }



  SurfacePoint
  Beam::lateral_point(const EdgePoint   &edge,
                      const double       weight,
                      const unsigned int axis_cell,
                      const double       eta) const
  {
    const double y =
      beam_axis->cell_begin(axis_cell) +
      eta * (beam_axis->cell_end(axis_cell) - beam_axis->cell_begin(axis_cell));
    SurfacePoint point;
    point.position =
      placement.to_scene({edge.position[0], y, edge.position[1]});
    const Point<3> n(edge.normal[0], 0., edge.normal[1]);
    point.normal = placement.vector_to_scene(n);
    point.area   = edge.weight * weight;
    point.corner = edge.corner;
    point.depth  = edge.depth;
    point.location =
      location(point.position, axis_cell, eta, edge.cell, edge.unit);
    Voigt nn;
    nn[0]                = n[0] * n[0];
    nn[2]                = n[2] * n[2];
    nn[4]                = 2. * n[0] * n[2];
    const ElasticLaw law = beam_section->law(edge.cell, edge.position);
    point.normal_modulus = nn * (law.stiffness() * nn);
    return point;
  }



  SurfacePoint
  Beam::end_point(const EdgePoint &edge_point, const bool at_start) const
  {
    const unsigned int axis_cell = at_start ? 0 : beam_axis->n_cells() - 1;
    SurfacePoint       point;
    point.position = placement.to_scene({edge_point.position[0],
                                         at_start ? 0. : beam_axis->length(),
                                         edge_point.position[1]});
    point.normal =
      placement.vector_to_scene(Point<3>(0., at_start ? -1. : 1., 0.));
    point.area = edge_point.weight;
    point.depth =
      beam_axis->cell_end(axis_cell) - beam_axis->cell_begin(axis_cell);
    point.location = location(point.position,
                              axis_cell,
                              at_start ? 0. : 1.,
                              edge_point.cell,
                              edge_point.unit);
    point.normal_modulus =
      beam_section->law(edge_point.cell, edge_point.position).stiffness()[1][1];
    return point;
  }



  namespace
  {
    /// What a surface is made of: for each end of the axis that it has, whether
    /// it is the start, and the boundaries of the section.
    struct SurfaceParts
    {
      std::vector<bool>        ends;
      std::vector<std::string> boundaries;
    };

    SurfaceParts
    parts_of(const std::string &surface, const SectionMesh &section)
    {
      SurfaceParts parts;
      for (const bool at_start : {true, false})
        if (surface_names::covers(surface, surface_names::end_name(at_start)))
          parts.ends.push_back(at_start);
      if (surface_names::is_whole_surface(surface))
        for (const auto &[id, name] : section.boundaries)
          parts.boundaries.push_back(name);
      else if (parts.ends.empty())
        parts.boundaries = {surface};
      return parts;
    }



    /// The point at @p unit of @p cell, with the determinant as weight.
    EdgePoint
    point_in_section(const CrossSectionElement &element,
                     const unsigned int         cell,
                     const Point<2>            &unit)
    {
      const auto at = element.map(cell, unit);
      EdgePoint  point;
      point.position = at.position;
      point.weight   = determinant(at.jacobian);
      point.cell     = cell;
      point.unit     = unit;
      return point;
    }



    /// Numbers of the nodes of a grid of (degree + 1)^2 points on each cell of
    /// a section mesh; cells share the nodes at their vertices and lines.
    class SectionNodes
    {
    public:
      SectionNodes(const Triangulation<2> &mesh, const unsigned int degree)
        : p(degree)
        , n_vertices(mesh.n_vertices())
        , n_on_lines(std::uint64_t(mesh.n_raw_lines()) * (p - 1))
        , cells(mesh.active_cell_iterators().begin(),
                mesh.active_cell_iterators().end())
      {}

      unsigned int
      degree() const
      {
        return p;
      }

      /// The point (i, j) of @p cell: i along the unit square's x, j along z.
      std::uint64_t
      number(const unsigned int c,
             const unsigned int i,
             const unsigned int j) const
      {
        const auto &cell   = cells[c];
        const bool  i_ends = i == 0 || i == p, j_ends = j == 0 || j == p;
        if (i_ends && j_ends)
          return cell->vertex_index((i == p) + 2 * (j == p));
        if (!i_ends && !j_ends)
          return n_vertices + n_on_lines +
                 (std::uint64_t(cell->active_cell_index()) * p + j) * p + i;
        // deal.II's lines: x = 0, x = 1 upwards, z = 0, z = 1 to the right.
        const unsigned int f     = i_ends ? (i == p) : 2 + (j == p);
        const unsigned int begin = i_ends ? (i == p) : 2 * (j == p);
        const unsigned int k     = i_ends ? j : i;
        const bool         along =
          cell->line(f)->vertex_index(0) == cell->vertex_index(begin);
        return n_vertices + std::uint64_t(cell->line_index(f)) * (p - 1) +
               (along ? k : p - k) - 1;
      }

    private:
      unsigned int  p;
      std::uint64_t n_vertices, n_on_lines;
      std::vector<Triangulation<2>::active_cell_iterator> cells;
    };



    /// Numbers of the nodes of @p facet in the body: (node of the section)
    /// times the nodes of the axis plus (node of the axis).
    std::vector<std::uint64_t>
    facet_nodes(const SurfaceFacet &facet,
                const SectionNodes &section,
                const unsigned int  n_section_cells,
                const Axis         &axis)
    {
      const unsigned int        p         = section.degree();
      const unsigned int        c         = facet.cell % n_section_cells;
      const unsigned int        axis_cell = facet.cell / n_section_cells;
      std::vector<unsigned int> along     = axis.nodes_of_cell(axis_cell);
      std::sort(along.begin(), along.end());
      const auto node = [&](const unsigned int i,
                            const unsigned int j,
                            const unsigned int on_axis) {
        return section.number(c, i, j) * axis.n_nodes() + on_axis;
      };
      std::vector<std::uint64_t> nodes;
      if (facet.along_t[1] == 0.)
        {
          const unsigned int end =
            facet.origin[1] == 0. ? along.front() : along.back();
          for (unsigned int j = 0; j <= p; ++j)
            for (unsigned int i = 0; i <= p; ++i)
              nodes.push_back(node(i, j, end));
          return nodes;
        }
      // Along a side one of the two coordinates stands still.
      const auto at = [&](const unsigned int d, const unsigned int i) {
        const double unit =
          facet.origin[d] + facet.along_s[d] * double(i) / double(p);
        return static_cast<unsigned int>(std::lround(p * unit));
      };
      for (const unsigned int on_axis : along)
        for (unsigned int i = 0; i <= p; ++i)
          nodes.push_back(node(at(0, i), at(2, i), on_axis));
      return nodes;
    }
  } // namespace



  std::vector<SurfacePoint>
  Beam::surface_points(const std::string &surface) const
  {
    const CrossSectionElement &element = beam_section->element();
    const SurfaceParts        parts = parts_of(surface, element.section_mesh());
    std::vector<SurfacePoint> points;
    for (const bool at_start : parts.ends)
      for (const EdgePoint &p : element.coarse_section_grid(
             degree_at(at_start ? 0 : beam_axis->n_nodes() - 1)))
        points.push_back(end_point(p, at_start));

    const std::vector<double> weights = beam_axis->node_weights();
    for (const std::string &boundary : parts.boundaries)
      {
        std::map<unsigned int, std::vector<EdgePoint>> around;
        for (unsigned int node = 0; node < beam_axis->n_nodes(); ++node)
          {
            const auto [cell, eta]    = beam_axis->cell_of_node(node);
            const unsigned int degree = degree_at(node);
            if (around.count(degree) == 0)
              around[degree] = element.coarse_edge_points(boundary, degree);
            for (const EdgePoint &p : around[degree])
              points.push_back(lateral_point(p, weights[node], cell, eta));
          }
      }
    return points;
  }



  unsigned int
  Beam::degree_at(const unsigned int node) const
  {
    const unsigned int last = dof_map.fields(node).back();
    return last < space->first_mode() ? beam_section->field_degree(last) :
                                        beam_section->element().degree();
  }



  std::vector<EdgePoint>
  Beam::select_constraint_points(std::vector<EdgePoint>           points,
                                 const std::vector<unsigned int> &list) const
  {
    // A component's largest value is of the order of one.
    constexpr double nothing = arithmetic::rounding_of_solutions;
    if (3 * points.size() <= list.size() || list.back() < space->first_mode())
      return points;
    std::vector<Vector> fields;
    for (const unsigned int alpha : list)
      fields.push_back(space->in_section_functions(alpha));
    std::array<LAPACKFullMatrix<double>, 3> values;
    for (auto &component : values)
      component.reinit(points.size(), list.size());
    for (unsigned int p = 0; p < points.size(); ++p)
      {
        const SectionPoint at =
          beam_section->evaluate(points[p].cell, points[p].unit);
        for (unsigned int k = 0; k < list.size(); ++k)
          {
            Tensor<1, 3> u;
            for (unsigned int a = 0; a < at.fields->size(); ++a)
              u += fields[k][(*at.fields)[a]] * at.value[a];
            for (unsigned int c = 0; c < 3; ++c)
              values[c](p, k) = u[c];
          }
      }
    std::set<unsigned int> chosen;
    for (const auto &component : values)
      for (const unsigned int p : select_independent_rows(component, nothing))
        chosen.insert(p);
    std::vector<EdgePoint> few;
    for (const unsigned int p : chosen)
      few.push_back(points[p]);
    return few;
  }



  std::vector<Location>
  Beam::constraint_points(const std::string &surface) const
  {
    const CrossSectionElement &element = beam_section->element();
    const SurfaceParts    parts = parts_of(surface, element.section_mesh());
    std::vector<Location> locations;
    for (const bool at_start : parts.ends)
      {
        const unsigned int node   = at_start ? 0 : beam_axis->n_nodes() - 1;
        const unsigned int degree = degree_at(node);
        for (const EdgePoint &p :
             select_constraint_points(degree < element.degree() ?
                                        element.coarse_section_grid(degree) :
                                        element.section_points(),
                                      dof_map.fields(node)))
          locations.push_back(end_point(p, at_start).location);
      }
    for (const std::string &boundary : parts.boundaries)
      for (const SurfacePoint &point : surface_points(boundary))
        locations.push_back(point.location);
    return locations;
  }



  std::vector<Location>
  Beam::body_points() const
  {
    const CrossSectionElement &element = beam_section->element();
    std::map<unsigned int, std::vector<EdgePoint>> in_section{
      {element.degree(), element.section_points()}};
    std::vector<Location> locations;
    for (unsigned int node = 0; node < beam_axis->n_nodes(); ++node)
      {
        const auto [cell, eta]    = beam_axis->cell_of_node(node);
        const unsigned int degree = degree_at(node);
        if (in_section.count(degree) == 0)
          in_section[degree] = element.coarse_section_grid(degree);
        for (const EdgePoint &p : in_section[degree])
          locations.push_back(location(
            placement.to_scene(
              {p.position[0], beam_axis->nodes()[node], p.position[1]}),
            cell,
            eta,
            p.cell,
            p.unit));
      }
    return locations;
  }



  void
  Beam::complete(SurfaceFacet &facet) const
  {
    const CrossSectionElement &element = beam_section->element();
    const bool                 lateral = facet.along_t[1] != 0.;
    facet.degree_s                     = element.degree();
    facet.degree_t       = lateral ? beam_axis->degree() : element.degree();
    facet.trace_degree_s = element.trace_degree();
    facet.trace_degree_t =
      lateral ? beam_axis->degree() : element.trace_degree();
    for (unsigned int k = 0; k < 4; ++k)
      facet.corners[k] =
        surface_point(facet, GeometryInfo<2>::unit_cell_vertex(k)).position;
  }



  std::vector<SurfaceFacet>
  Beam::facets_of(const std::string &surface) const
  {
    const CrossSectionElement &element = beam_section->element();
    const SurfaceParts        parts = parts_of(surface, element.section_mesh());
    const unsigned int        n     = beam_section->n_cells();
    std::vector<SurfaceFacet> facets;
    for (const bool at_start : parts.ends)
      for (unsigned int c = 0; c < n; ++c)
        {
          SurfaceFacet facet;
          facet.cell       = at_start ? c : (beam_axis->n_cells() - 1) * n + c;
          facet.origin[1]  = at_start ? 0. : 1.;
          facet.along_s[0] = 1.;
          facet.along_t[2] = 1.;
          facets.push_back(facet);
        }
    for (const std::string &boundary : parts.boundaries)
      for (const auto &[c, face] : element.boundary_faces(boundary))
        for (unsigned int axis_cell = 0; axis_cell < beam_axis->n_cells();
             ++axis_cell)
          {
            const Point<2> begin = face_point(face, 0.),
                           end   = face_point(face, 1.);
            SurfaceFacet facet;
            facet.cell       = axis_cell * n + c;
            facet.origin     = Point<3>(begin[0], 0., begin[1]);
            facet.along_s[0] = end[0] - begin[0];
            facet.along_s[2] = end[1] - begin[1];
            facet.along_t[1] = 1.;
            facets.push_back(facet);
          }
    for (SurfaceFacet &facet : facets)
      complete(facet);
    return facets;
  }



  SurfacePoint
  Beam::surface_point(const SurfaceFacet &facet, const Point<2> &st) const
  {
    const CrossSectionElement &element   = beam_section->element();
    const unsigned int         c         = facet.cell % beam_section->n_cells();
    const unsigned int         axis_cell = facet.cell / beam_section->n_cells();
    const Point<3>             unit =
      facet.origin + st[0] * facet.along_s + st[1] * facet.along_t;
    if (facet.along_t[1] == 0.)
      return end_point(point_in_section(element, c, {unit[0], unit[2]}),
                       facet.origin[1] == 0.);
    // deal.II's faces of the unit square: x = 0, x = 1, y = 0, y = 1.
    const unsigned int face = facet.along_s[0] == 0. ?
                                (facet.origin[0] == 0. ? 0 : 1) :
                                (facet.origin[2] == 0. ? 2 : 3);
    return lateral_point(element.edge_point(c, face, st[0]),
                         beam_axis->cell_end(axis_cell) -
                           beam_axis->cell_begin(axis_cell),
                         axis_cell,
                         unit[1]);
  }



  SurfaceTopology
  Beam::surface_topology(const std::string &surface) const
  {
    const CrossSectionElement &element = beam_section->element();
    const Triangulation<2>    &mesh    = element.section_mesh().mesh;
    const SectionNodes         grid(mesh, element.degree()),
      trace(mesh, element.trace_degree());
    SurfaceTopology topology;
    for (const SurfaceFacet &facet : facets_of(surface))
      topology.add(
        facet,
        facet_nodes(facet, grid, beam_section->n_cells(), *beam_axis),
        facet_nodes(facet, trace, beam_section->n_cells(), *beam_axis));
    return topology;
  }
} // namespace lamella
