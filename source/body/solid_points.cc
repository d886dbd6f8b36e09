// SPDX-License-Identifier: LGPL-2.1-or-later

// The points of a solid: where they are, and which rows they give.

#include <lamella/base/arithmetic.h>
#include <lamella/body/fields.h>
#include <lamella/body/line_crossings.h>
#include <lamella/body/solid.h>

#include <deal.II/base/geometry_info.h>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// The box grown by @p share of its section's diagonal across, where cells
    /// may be curved, and by next to nothing along the axis.
    BoundingBox<3>
    enlarged(const BoundingBox<3> &box, const double share)
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
  } // namespace



  void
  Solid::make_boxes()
  {
    std::vector<std::pair<BoundingBox<3>, unsigned int>> all;
    for (unsigned int cell = 0; cell < mesh.cells().size(); ++cell)
      all.emplace_back(enlarged(BoundingBox<3>(nodes_of(cell)),
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
    const double tolerance = arithmetic::same_position_across * section_size +
                             arithmetic::rounding_of_sums * axis_length;
    std::vector<std::vector<Location>> result;
    for (const Point<3> &point : points)
      result.push_back(locate(point, tolerance));
    return result;
  }



  std::vector<std::pair<BoundingBox<3>, unsigned int>>
  Solid::cells_near(BoundingBox<3> around, const double tolerance) const
  {
    around.extend(tolerance);
    std::vector<std::pair<BoundingBox<3>, unsigned int>> near;
    boxes.query(boost::geometry::index::intersects(around),
                std::back_inserter(near));
    return near;
  }



  std::vector<Location>
  Solid::locate(const Point<3> &point, const double tolerance) const
  {
    const Point<3> x = placement.to_body(point);
    auto           candidates =
      cells_near(BoundingBox<3>(std::make_pair(x, x)), tolerance);
    std::sort(candidates.begin(),
              candidates.end(),
              [](const auto &a, const auto &b) { return a.second < b.second; });

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
    std::vector<Location> found;
    if (by_ply.empty() && smallest < std::numeric_limits<double>::max())
      found.push_back({point, mesh.cells()[nearest.cell].ply, {nearest}});
    for (const auto &[ply, place] : by_ply)
      found.push_back(place);
    return found;
  }



  Point<3>
  Solid::position(const Location::Place &place) const
  {
    return placement.to_scene(
      element.evaluate(nodes_of(place.cell), place.unit).position);
  }



  PlyAndAxes
  Solid::ply_at(const Location::Place &place) const
  {
    const Point<3> x =
      element.evaluate(nodes_of(place.cell), place.unit).position;
    return {mesh.cells()[place.cell].ply, ply_axes(place.cell, x)};
  }



  void
  Solid::add_to_rows(const Location::Place         &place,
                     const Quantity                 quantity,
                     const StrainMap               &to_frame,
                     const double                   share,
                     std::vector<LinearFunctional> &rows) const
  {
    const HexahedronPoint point =
      element.evaluate(nodes_of(place.cell), place.unit);
    const std::vector<DofIndex> dofs = dofs_of(place.cell);
    if (quantity == Quantity::displacement)
      {
        for (unsigned int d = 0; d < dofs.size(); ++d)
          for (unsigned int c = 0; c < 3; ++c)
            rows[c].add(dofs[d],
                        share * point.N[d / 3] * placement.axes[d % 3][c]);
        return;
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



  std::vector<std::vector<LinearFunctional>>
  Solid::rows(const std::vector<Location> &locations,
              const Vector &,
              const Quantity quantity,
              const Frame    frame) const
  {
    const unsigned int n = quantity == Quantity::displacement ? 3 : 6;
    std::vector<std::vector<LinearFunctional>> result;
    for (const Location &where : locations)
      {
        const Location::Place &first = where.places[0];
        const Point<3>         x =
          element.evaluate(nodes_of(first.cell), first.unit).position;
        const StrainMap to_frame =
          make_strain_map(quantity,
                          frame,
                          placement,
                          ply_axes(first.cell, x),
                          law_at(first.cell, first.unit, x));
        std::vector<LinearFunctional> rows(n);
        if (quantity != Quantity::displacement)
          for (unsigned int c = 0; c < n; ++c)
            rows[c].add_constant(to_frame.constant[c]);
        const double share = 1. / where.places.size();
        for (const Location::Place &place : where.places)
          add_to_rows(place, quantity, to_frame, share, rows);
        for (LinearFunctional &row : rows)
          {
            row.compress();
            // At a node all other shape functions vanish but for rounding.
            row.drop_below(arithmetic::rounding);
          }
        result.push_back(std::move(rows));
      }
    return result;
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
      arithmetic::same_position_across *
      Tensor<1, 2>({box.side_length(0), box.side_length(2)}).norm();

    std::vector<double> breaks;
    for (const auto &[cell_box, cell] :
         cells_near(BoundingBox<3>(std::vector<Point<3>>{a, b}), tolerance))
      {
        // Corners come first among the nodes: deal.II's vertices.
        const auto &nodes  = mesh.cells()[cell].nodes;
        const auto  corner = [&](const unsigned int v) {
          return mesh.nodes()[nodes[v]];
        };
        std::vector<double> crossings;
        if (std::abs(d[1]) > arithmetic::same_position_along * axis_length)
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
          if (enlarged(cell_box, arithmetic::same_in_element)
                .point_inside(a + t * d))
            breaks.push_back(t);
      }
    return merge_breaks(std::move(breaks));
  }



  // The fields of a solid at points, for probes, lines, contours and pictures.

  FieldSample
  Solid::sample_at_element_point(const Location::Place &place,
                                 const Vector          &u) const
  {
    const Hexahedron::Nodes  nodes = nodes_of(place.cell);
    const HexahedronPoint    point = element.evaluate(nodes, place.unit);
    const std::vector<Voigt> B =
      element.strains(point, kinds[kind_of_cell[place.cell]].modes);
    const std::vector<double> v     = relative_displacements(place.cell, u);
    const DofIndex            first = 3 * mesh.cells()[place.cell].nodes[0];

    Tensor<1, 3> displacement;
    Voigt        strain;
    for (unsigned int c = 0; c < 3; ++c)
      displacement[c] = u[first + c];
    for (unsigned int d = 0; d < v.size(); ++d)
      {
        displacement[d % 3] += point.N[d / 3] * v[d];
        strain += v[d] * B[d];
      }

    return sample_of(displacement,
                     strain,
                     placement,
                     ply_axes(place.cell, point.position),
                     law_at(place.cell, place.unit, point.position));
  }



  FieldSample
  Solid::sample(const Location &location, const Vector &u) const
  {
    std::vector<FieldSample> samples;
    for (const Location::Place &place : location.places)
      samples.push_back(sample_at_element_point(place, u));
    return mean_sample(samples);
  }
} // namespace lamella
