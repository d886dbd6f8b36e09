// SPDX-License-Identifier: LGPL-2.1-or-later

// The points of a beam: where they are, which rows they give, and those that
// make up its surfaces.

#include <lamella/base/exceptions.h>
#include <lamella/body/beam.h>
#include <lamella/body/fields.h>
#include <lamella/body/line_crossings.h>

#include <deal.II/base/quadrature_lib.h>

namespace lamella
{
  using namespace dealii;

  Location
  Beam::location(const Point<3>    &position,
                 const unsigned int axis_cell,
                 const double       eta,
                 const unsigned int section_cell,
                 const Point<2>    &unit) const
  {
    return {position,
            beam_section->cell_ply(section_cell),
            {{axis_cell * beam_section->n_cells() + section_cell,
              {unit[0], eta, unit[1]}}}};
  }



  std::vector<std::vector<Location>>
  Beam::locate(const std::vector<Point<3>> &points) const
  {
    std::vector<std::vector<Location>> result;
    for (const Point<3> &point : points)
      {
        const Point<3> x = placement.to_body(point);
        // Positions come out of decimal texts and rotations.
        const auto on_axis =
          beam_axis->locate(x[1], 1e-10 * beam_axis->length());
        const auto in_section = beam_section->locate(
          {x[0], x[2]}, 1e-8 * beam_section->element().reference_length());
        std::map<unsigned int, Location> by_ply;
        for (const auto &[section_cell, unit] : in_section)
          for (const auto &[axis_cell, eta] : on_axis)
            {
              const Location one =
                location(point, axis_cell, eta, section_cell, unit);
              Location &all = by_ply[one.ply];
              all.position  = point;
              all.ply       = one.ply;
              all.places.push_back(one.places[0]);
            }
        result.emplace_back();
        for (const auto &[ply, place] : by_ply)
          result.back().push_back(place);
      }
    return result;
  }



  Point<3>
  Beam::position(const Location::Place &place) const
  {
    const unsigned int axis_cell = place.cell / beam_section->n_cells();
    const Point<2>     x         = beam_section->element()
                         .evaluate(place.cell % beam_section->n_cells(),
                                   {place.unit[0], place.unit[2]})
                         .position;
    const double begin = beam_axis->cell_begin(axis_cell),
                 end   = beam_axis->cell_end(axis_cell);
    return placement.to_scene(
      {x[0], begin + place.unit[1] * (end - begin), x[1]});
  }



  std::array<unsigned int, 3>
  Beam::recovery_degrees() const
  {
    // Kirchhoff's constraint leaves the rotation -w' one degree below w, and
    // with it the strain of bending.
    const Theory      &theory  = beam_section->theory();
    const unsigned int along   = beam_axis->degree(),
                       section = theory.kind == Theory::Kind::LE ?
                                   beam_section->element().degree() :
                                   0;
    return {{section,
             theory.kind == Theory::Kind::EBBT ? along - 1 : along,
             section}};
  }



  std::vector<std::vector<Row>>
  Beam::rows(const std::vector<Location> &locations,
             const Quantity               quantity,
             const Frame                  frame) const
  {
    const unsigned int n = quantity == Quantity::displacement ? 3 : 6;
    std::vector<std::vector<Row>> result;
    for (const Location &where : locations)
      {
        const FromStrain to_frame =
          from_strain(quantity,
                      frame,
                      placement,
                      beam_section->plies()[where.ply].axes(),
                      beam_section->law(where.places[0].cell %
                                        beam_section->n_cells()));
        std::vector<Row> rows(n);
        if (quantity != Quantity::displacement)
          for (unsigned int c = 0; c < n; ++c)
            rows[c].add_constant(to_frame.constant[c]);
        for (const Location::Place &place : where.places)
          {
            const AxisPoint axis_point =
              beam_axis->evaluate(place.cell / beam_section->n_cells(),
                                  place.unit[1]);
            const SectionPoint point =
              beam_section->evaluate(place.cell % beam_section->n_cells(),
                                     {place.unit[0], place.unit[2]});
            const auto &nodes = beam_axis->nodes_of_cell(axis_point.cell);
            for (unsigned int i = 0; i < nodes.size(); ++i)
              for (unsigned int a = 0; a < point.fields->size(); ++a)
                {
                  const int k = dof_map.place(nodes[i], (*point.fields)[a]);
                  if (k < 0)
                    continue;
                  const DofIndex dof   = dof_map.first(nodes[i]) + k;
                  const double   share = 1. / where.places.size();
                  if (quantity == Quantity::displacement)
                    {
                      const Tensor<1, 3> v =
                        placement.vector_to_scene(point.value[a]);
                      for (unsigned int c = 0; c < 3; ++c)
                        rows[c].add(dof, share * axis_point.N[i] * v[c]);
                    }
                  else
                    {
                      Voigt strain = axis_point.dN[i] * point.along[a];
                      for (unsigned int c = 0; c < 6; ++c)
                        strain[c] +=
                          (is_transverse_shear(c) ? axis_point.N_shear :
                                                    axis_point.N)[i] *
                          point.in_plane[a][c];
                      const Voigt v = to_frame.matrix * strain;
                      for (unsigned int c = 0; c < 6; ++c)
                        rows[c].add(dof, share * v[c]);
                    }
                }
          }
        for (Row &row : rows)
          row.compress();
        result.push_back(std::move(rows));
      }
    return result;
  }



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
    point.normal_modulus = nn * (beam_section->law(edge.cell).stiffness() * nn);
    return point;
  }



  SurfacePoint
  Beam::end_point(const EdgePoint &in_section, const bool at_start) const
  {
    const unsigned int axis_cell = at_start ? 0 : beam_axis->n_cells() - 1;
    SurfacePoint       point;
    point.position = placement.to_scene({in_section.position[0],
                                         at_start ? 0. : beam_axis->length(),
                                         in_section.position[1]});
    point.normal =
      placement.vector_to_scene(Point<3>(0., at_start ? -1. : 1., 0.));
    point.area = in_section.weight;
    point.depth =
      beam_axis->cell_end(axis_cell) - beam_axis->cell_begin(axis_cell);
    point.location       = location(point.position,
                              axis_cell,
                              at_start ? 0. : 1.,
                              in_section.cell,
                              in_section.unit);
    point.normal_modulus = beam_section->law(in_section.cell).stiffness()[1][1];
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
      if (surface == "start" || surface == "end")
        return {{surface == "start"}, {}};
      if (surface == "ends")
        return {{true, false}, {}};
      if (surface != "all")
        return {{}, {surface}};
      SurfaceParts parts{{true, false}, {}};
      for (const auto &[id, name] : section.boundaries)
        parts.boundaries.push_back(name);
      return parts;
    }
  } // namespace



  std::vector<SurfacePoint>
  Beam::surface_points(const std::string &surface) const
  {
    const CrossSectionElement &element = beam_section->element();
    const SurfaceParts        parts = parts_of(surface, element.section_mesh());
    std::vector<SurfacePoint> points;
    for (const bool at_start : parts.ends)
      for (const EdgePoint &p : element.section_grid())
        points.push_back(end_point(p, at_start));

    const std::vector<double> weights = beam_axis->node_weights();
    for (const std::string &boundary : parts.boundaries)
      {
        const auto around = element.edge_points(boundary);
        for (unsigned int node = 0; node < beam_axis->n_nodes(); ++node)
          {
            const auto [cell, eta] = beam_axis->place_of_node(node);
            for (const EdgePoint &p : around)
              points.push_back(lateral_point(p, weights[node], cell, eta));
          }
      }
    return points;
  }



  std::vector<Location>
  Beam::fixing_points(const std::string &surface) const
  {
    const CrossSectionElement &element = beam_section->element();
    const SurfaceParts    parts = parts_of(surface, element.section_mesh());
    std::vector<Location> locations;
    for (const bool at_start : parts.ends)
      for (const EdgePoint &p : element.section_points())
        locations.push_back(end_point(p, at_start).location);
    for (const std::string &boundary : parts.boundaries)
      for (const SurfacePoint &point : surface_points(boundary))
        locations.push_back(point.location);
    return locations;
  }



  std::vector<Location>
  Beam::body_points() const
  {
    const auto            in_section = beam_section->element().section_points();
    std::vector<Location> locations;
    for (unsigned int node = 0; node < beam_axis->n_nodes(); ++node)
      {
        const auto [cell, eta] = beam_axis->place_of_node(node);
        for (const EdgePoint &p : in_section)
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



  namespace
  {
    /// The point at @p unit of @p cell, its weight the determinant of the
    /// cell's map.
    EdgePoint
    point_in_section(const CrossSectionElement &element,
                     const unsigned int         cell,
                     const Point<2>            &unit)
    {
      const FunctionValues at = element.evaluate(cell, unit);
      EdgePoint            point;
      point.position = at.position;
      point.weight   = determinant(at.jacobian);
      point.cell     = cell;
      point.unit     = unit;
      return point;
    }
  } // namespace



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
      facet.corners[k] = surface_point(facet, Point<2>(k % 2, k / 2)).position;
  }



  std::vector<SurfaceFacet>
  Beam::surface_facets(const std::string &surface) const
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



  namespace
  {
    /// Adds the parameters at which the segment a + t d, projected into the
    /// section, passes vertices or crosses the sides of @p mesh's cells.
    void
    add_section_breaks(const Triangulation<2> &mesh,
                       const Point<2>         &a,
                       const Tensor<1, 2>     &d,
                       const double            tolerance,
                       std::vector<double>    &breaks)
    {
      if (d.norm() <= tolerance)
        return;
      for (const auto &cell : mesh.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          add_edge_crossings(cell->face(f)->vertex(0),
                             cell->face(f)->vertex(1),
                             a,
                             d,
                             tolerance,
                             breaks);
    }
  } // namespace



  std::vector<double>
  Beam::line_breaks(const Point<3> &from, const Point<3> &to) const
  {
    const Point<3>      a = placement.to_body(from), b = placement.to_body(to);
    const Tensor<1, 3>  d = b - a;
    std::vector<double> breaks;
    if (std::abs(d[1]) > 1e-10 * beam_axis->length())
      for (unsigned int cell = 0; cell < beam_axis->n_cells(); ++cell)
        breaks.push_back((beam_axis->cell_end(cell) - a[1]) / d[1]);
    Tensor<1, 2> in_section;
    in_section[0] = d[0];
    in_section[1] = d[2];
    add_section_breaks(beam_section->element().section_mesh().mesh,
                       {a[0], a[2]},
                       in_section,
                       1e-8 * beam_section->element().reference_length(),
                       breaks);
    return tidy_breaks(std::move(breaks));
  }



  unsigned int
  Beam::line_degree(const Point<3> &from, const Point<3> &to) const
  {
    const Tensor<1, 3> d         = placement.vector_to_body(to - from);
    const double       tolerance = 1e-10 * d.norm();
    const unsigned int p         = beam_section->element().degree();
    return (std::abs(d[0]) > tolerance ? p : 0) +
           (std::abs(d[1]) > tolerance ? beam_axis->degree() : 0) +
           (std::abs(d[2]) > tolerance ? p : 0);
  }



  unsigned int
  Beam::degree() const
  {
    return std::max(beam_section->element().degree(), beam_axis->degree());
  }
} // namespace lamella
