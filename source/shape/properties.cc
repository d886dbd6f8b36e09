// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/shape/properties.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>

#include <deal.II/grid/grid_tools.h>

#include <deal.II/numerics/rtree.h>

#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <array>
#include <numeric>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Those of SectionProperties, of sides as @p mapping has them.
    std::map<std::string, double>
    boundary_lengths(const SectionMesh &section, const Mapping<2> &mapping)
    {
      const FE_Nothing<2> nothing;
      FEFaceValues<2>     face_values(mapping,
                                  nothing,
                                  QGauss<1>(8),
                                  update_JxW_values);

      std::map<std::string, double> lengths;
      for (const auto &cell : section.mesh.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary())
            {
              face_values.reinit(cell, f);
              double &length =
                lengths[section.boundaries.at(cell->face(f)->boundary_id())];
              for (const unsigned int q :
                   face_values.quadrature_point_indices())
                length += face_values.JxW(q);
            }
      return lengths;
    }



    using CellIterator = Triangulation<2>::active_cell_iterator;

    /// Smallest sine of inner angles of @p cell; not positive if degenerate.
    double
    smallest_sine(const CellIterator &cell)
    {
      constexpr std::array<unsigned int, 4> around{{0, 1, 3, 2}};
      double                                smallest = 1.;
      for (unsigned int i = 0; i < 4; ++i)
        {
          const Point<2>     corner = cell->vertex(around[i]);
          const Tensor<1, 2> to   = cell->vertex(around[(i + 1) % 4]) - corner,
                             from = cell->vertex(around[(i + 3) % 4]) - corner;
          const double product    = to.norm() * from.norm();
          smallest                = std::min(smallest,
                              product > 0. ?
                                               (to[0] * from[1] - to[1] * from[0]) / product :
                                               0.);
        }
      return smallest;
    }



    void
    check_vertices(const SectionMesh &section, const Entry &entry)
    {
      std::vector<Point<2>> points;
      for (unsigned int v = 0; v < section.mesh.n_vertices(); ++v)
        if (section.mesh.get_used_vertices()[v])
          points.push_back(section.mesh.get_vertices()[v]);
      double shortest = std::numeric_limits<double>::max();
      for (const auto &face : section.mesh.active_face_iterators())
        shortest = std::min(shortest, face->diameter());
      const double   near = arithmetic::same_in_element * shortest;
      const Point<2> tolerance(near, near);
      const auto     tree = pack_rtree(points);
      for (const Point<2> &point : points)
        {
          const BoundingBox<2> here(
            std::make_pair(point + -1. * tolerance, point + tolerance));
          if (std::distance(tree.qbegin(
                              boost::geometry::index::intersects(here)),
                            tree.qend()) > 1)
            entry.refuse(
              "shape.double-node: there are two nodes at " + to_text(point) +
                ", so the cells of the two nodes are not connected",
              "In Gmsh, let adjacent surfaces use the same points and lines, "
              "or write 'Coherence;' (after meshing, 'Coherence Mesh;').");
        }
    }



    void
    check_connected(const SectionMesh &section, const Entry &entry)
    {
      std::vector<bool>     seen(section.mesh.n_active_cells(), false);
      std::vector<Point<2>> parts;
      for (const auto &start : section.mesh.active_cell_iterators())
        {
          if (seen[start->active_cell_index()])
            continue;
          parts.push_back(start->center());
          std::vector<CellIterator> open{start};
          seen[start->active_cell_index()] = true;
          while (!open.empty())
            {
              const CellIterator cell = open.back();
              open.pop_back();
              for (const unsigned int f : cell->face_indices())
                if (!cell->at_boundary(f) &&
                    !seen[cell->neighbor(f)->active_cell_index()])
                  {
                    open.push_back(cell->neighbor(f));
                    seen[cell->neighbor(f)->active_cell_index()] = true;
                  }
            }
        }
      if (parts.size() > 1)
        entry.refuse("shape.section-in-pieces: the section consists of " +
                       std::to_string(parts.size()) +
                       " unconnected parts; one part is at " +
                       to_text(parts[0]) + ", another at " + to_text(parts[1]),
                     "Connect the parts, or make a body of each.");
    }
  } // namespace



  SectionProperties
  section_properties(const SectionMesh &section)
  {
    // Degree 6 represents arcs of sensible meshes almost to rounding.
    const MappingQ<2>   mapping(6);
    const FE_Nothing<2> nothing;
    FEValues<2>         values(mapping,
                       nothing,
                       QGauss<2>(8),
                       update_quadrature_points | update_JxW_values);

    SectionProperties result;
    result.ply_areas.resize(section.plies.size());
    std::vector<std::pair<double, Point<2>>> points;
    Tensor<1, 2>                             first;
    for (const auto &cell : section.mesh.active_cell_iterators())
      {
        values.reinit(cell);
        for (const unsigned int q : values.quadrature_point_indices())
          {
            points.emplace_back(values.JxW(q), values.quadrature_point(q));
            result.ply_areas[cell->material_id()] += values.JxW(q);
            first += values.JxW(q) * Tensor<1, 2>(values.quadrature_point(q));
          }
      }
    result.boundary_lengths = boundary_lengths(section, mapping);
    result.area =
      std::accumulate(result.ply_areas.begin(), result.ply_areas.end(), 0.);
    result.centroid = Point<2>(first / result.area);
    for (const auto &[weight, x] : points)
      result.second_moments +=
        weight * outer_product(x - result.centroid, x - result.centroid);
    const auto box =
      GridTools::compute_bounding_box(section.mesh).get_boundary_points();
    result.low  = box.first;
    result.high = box.second;
    return result;
  }



  void
  check_section_mesh(const SectionMesh &section, const Entry &entry)
  {
    unsigned int bad = 0;
    Point<2>     where;
    for (const auto &cell : section.mesh.active_cell_iterators())
      if (smallest_sine(cell) < arithmetic::degenerate_sine)
        {
          where = bad == 0 ? cell->center() : where;
          ++bad;
        }
    if (bad > 0)
      entry.refuse(
        "shape.folded-cell: " + std::to_string(bad) +
          " cell(s) of the section are folded or have no area, the first at " +
          to_text(where) + " (an inner angle of 180 degrees or more)",
        "Mesh the section again; in Gmsh, 'Mesh.RecombinationAlgorithm = 3' or "
        "transfinite surfaces make better cells.");
    check_vertices(section, entry);
    check_connected(section, entry);
  }



  void
  check_proportions(const SectionMesh &section, const std::string &path)
  {
    // prm/cantilever.prm 1e6 times as wide as thick is right in all digits;
    // 1e7 times, a rigid rotation seems to cost no energy.
    constexpr double most = 2e6, sensible = 1e6;

    for (const auto &cell : section.mesh.active_cell_iterators())
      {
        const double length = cell->diameter(),
                     ratio  = length * length / cell->measure();
        if (ratio > most)
          throw InputError(
            path,
            "",
            "shape.cell-too-slender: a cell at " + to_text(cell->center()) +
              " is " + to_text(ratio, 2) +
              " times as long as thick; double precision allows at most " +
              to_text(sensible) + " times",
            "Check the units, or use more cells along the longer side.");
      }
  }
} // namespace lamella
