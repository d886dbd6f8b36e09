// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/linear_algebra.h>
#include <lamella/section/lagrange_element.h>

#include <deal.II/base/quadrature_lib.h>

#include <map>

namespace lamella
{
  using namespace dealii;

  LagrangeElement::LagrangeElement(
    const std::shared_ptr<const SectionMesh> &mesh_,
    const unsigned int                        degree,
    const double                              column_aspect,
    const Basis                               basis)
    : CrossSectionElement(mesh_, degree)
    , basis(basis)
    , cells(geometry.n_cells())
  {
    if (is_hierarchical())
      {
        for (unsigned int q = 1; q < degree; ++q)
          coarse.push_back(std::make_unique<SectionGeometry>(mesh_, q));
        number_hierarchical_functions();
        return;
      }
    const Grid grid = find_grid(column_aspect);
    in_columns      = grid.n_columns > 0;
    if (in_columns)
      number_column_functions(grid);
    else
      number_nodal_functions();
    collect_numbers();
  }



  std::array<unsigned int, 3>
  LagrangeElement::replaced_nodes(const std::vector<Point<2>> &nodes) const
  {
    const auto farthest = [&nodes](const auto &measure) {
      unsigned int best = 0;
      for (unsigned int i = 1; i < nodes.size(); ++i)
        if (measure(nodes[i]) > measure(nodes[best]))
          best = i;
      return best;
    };
    const unsigned int a =
      farthest([this](const Point<2> &p) { return p.distance_square(origin); });
    const unsigned int b = farthest(
      [&nodes, a](const Point<2> &p) { return p.distance_square(nodes[a]); });
    const Tensor<1, 2> line = nodes[b] - nodes[a];
    const unsigned int c    = farthest([&nodes, a, &line](const Point<2> &p) {
      const Tensor<1, 2> d = p - nodes[a];
      return std::abs(line[0] * d[1] - line[1] * d[0]);
    });
    return {{a, b, c}};
  }



  void
  LagrangeElement::number_nodal_functions()
  {
    const unsigned int        n = geometry.nodes().size();
    std::vector<unsigned int> function_of_node(n);
    const auto                replaced = replaced_nodes(geometry.nodes());
    levels.assign(n, 1);
    std::fill(levels.begin(), levels.begin() + 3, 0);
    for (unsigned int node = 0, next = 3; node < n; ++node)
      {
        const bool gives_way =
          std::find(replaced.begin(), replaced.end(), node) != replaced.end();
        function_of_node[node] = gives_way ? 0 : next++;
      }
    for (unsigned int c = 0; c < cells.size(); ++c)
      {
        const auto &nodes = geometry.nodes_of_cell(c);
        for (unsigned int i = 0; i < nodes.size(); ++i)
          if (function_of_node[nodes[i]] > 0)
            cells[c].functions.push_back(
              {function_of_node[nodes[i]], LocalFunction::Kind::nodal, {i}});
      }
  }



  namespace
  {
    /// Distinct values of coordinate @p d of @p nodes, and their indices.
    std::pair<std::vector<double>, std::vector<unsigned int>>
    distinct_coordinates(const std::vector<Point<2>> &nodes,
                         const unsigned int           d)
    {
      std::vector<double> all;
      for (const Point<2> &node : nodes)
        all.push_back(node[d]);
      std::sort(all.begin(), all.end());
      const double tolerance =
        arithmetic::same_position * (all.back() - all.front());
      std::vector<double> values;
      for (const double value : all)
        if (values.empty() || value - values.back() > tolerance)
          values.push_back(value);
      std::vector<unsigned int> places;
      for (const Point<2> &node : nodes)
        places.push_back(
          std::lower_bound(values.begin(), values.end(), node[d] - tolerance) -
          values.begin());
      return {values, places};
    }
  } // namespace



  LagrangeElement::Grid
  LagrangeElement::find_grid(const double column_aspect) const
  {
    const auto [xs, column_of] = distinct_coordinates(geometry.nodes(), 0);
    const auto [zs, place_of]  = distinct_coordinates(geometry.nodes(), 1);
    const double width         = xs.back() - xs.front(),
                 height        = zs.back() - zs.front();
    if (xs.size() * zs.size() != geometry.nodes().size() ||
        std::max(width, height) < column_aspect * std::min(width, height))
      return {};
    if (width > height)
      return {column_of,
              place_of,
              static_cast<unsigned int>(xs.size()),
              static_cast<unsigned int>(zs.size())};
    return {place_of,
            column_of,
            static_cast<unsigned int>(zs.size()),
            static_cast<unsigned int>(xs.size())};
  }



  LagrangeElement::ColumnNumbers
  LagrangeElement::number_columns(const Grid &grid)
  {
    // 1, x, z stand for both functions of the first column and one of the last.
    ColumnNumbers numbers;
    numbers.constant.assign(grid.n_columns, 0);
    numbers.slope.assign(grid.n_columns, 0);
    numbers.of_node.assign(grid.column.size(), 0);
    levels.assign(3, 0);
    for (unsigned int i = 0; i < grid.n_columns; ++i)
      {
        if (i > 0 && i + 1 < grid.n_columns)
          {
            numbers.constant[i] = levels.size();
            levels.push_back(1);
          }
        if (i > 0)
          {
            numbers.slope[i] = levels.size();
            levels.push_back(1);
          }
      }
    for (unsigned int node = 0; node < numbers.of_node.size(); ++node)
      if (grid.place[node] > 0 && grid.place[node] + 1 < grid.n_places)
        {
          numbers.of_node[node] = levels.size();
          levels.push_back(2);
        }
    return numbers;
  }



  void
  LagrangeElement::number_column_functions(const Grid &grid)
  {
    const auto box = bounding_box().get_boundary_points();
    long_side =
      box.second[0] - box.first[0] > box.second[1] - box.first[1] ? 0 : 1;
    column_length =
      0.5 * (box.second[1 - long_side] - box.first[1 - long_side]);

    const ColumnNumbers numbers = number_columns(grid);
    for (unsigned int c = 0; c < cells.size(); ++c)
      {
        const auto &nodes = geometry.nodes_of_cell(c);
        std::map<unsigned int, std::vector<unsigned int>> columns;
        for (unsigned int i = 0; i < nodes.size(); ++i)
          {
            columns[grid.column[nodes[i]]].push_back(i);
            if (numbers.of_node[nodes[i]] > 0)
              cells[c].functions.push_back(
                {numbers.of_node[nodes[i]], LocalFunction::Kind::nodal, {i}});
          }
        for (const auto &[column, members] : columns)
          {
            if (numbers.constant[column] > 0)
              cells[c].functions.push_back({numbers.constant[column],
                                            LocalFunction::Kind::column,
                                            members});
            if (numbers.slope[column] > 0)
              cells[c].functions.push_back({numbers.slope[column],
                                            LocalFunction::Kind::column_slope,
                                            members});
          }
      }
  }



  void
  LagrangeElement::collect_numbers()
  {
    for (Cell &cell : cells)
      {
        std::sort(cell.functions.begin(),
                  cell.functions.end(),
                  [](const LocalFunction &a, const LocalFunction &b) {
                    return a.number < b.number;
                  });
        cell.numbers = {0, 1, 2};
        for (const LocalFunction &function : cell.functions)
          cell.numbers.push_back(function.number);
      }
  }



  FunctionValues
  LagrangeElement::evaluate(const unsigned int cell, const Point<2> &unit) const
  {
    const auto [position, jacobian] = geometry.map(cell, unit);
    FunctionValues     result       = linear_functions(position, jacobian);
    const Tensor<2, 2> to_real      = transpose(invert(jacobian));
    if (is_hierarchical())
      append_products(cells[cell], unit, to_real, result);
    else
      append_functions(cells[cell], unit, to_real, result);
    return result;
  }



  void
  LagrangeElement::append_functions(const Cell         &cell,
                                    const Point<2>     &unit,
                                    const Tensor<2, 2> &to_real,
                                    FunctionValues     &values) const
  {
    const unsigned int across = 1 - long_side;
    const double t = (values.position[across] - origin[across]) / column_length;
    for (const LocalFunction &function : cell.functions)
      {
        double       value = 0.;
        Tensor<1, 2> gradient;
        for (const unsigned int i : function.nodes)
          {
            value += geometry.fe().shape_value(i, unit);
            gradient += to_real * geometry.fe().shape_grad(i, unit);
          }
        // At a node the others vanish exactly, and rows there stay short.
        if (std::abs(value) < arithmetic::rounding)
          value = 0.;
        if (function.kind != LocalFunction::Kind::nodal)
          gradient[across] = 0.;
        if (function.kind == LocalFunction::Kind::column_slope)
          {
            gradient *= t;
            gradient[across] = value / column_length;
            value *= t;
          }
        values.values.push_back(value);
        values.gradients.push_back(gradient);
      }
  }



  std::vector<EdgePoint>
  LagrangeElement::edge_points(const std::string &boundary) const
  {
    return edge_points_of(geometry, boundary);
  }



  std::vector<EdgePoint>
  LagrangeElement::coarse_edge_points(const std::string &boundary,
                                      const unsigned int degree) const
  {
    return edge_points_of(degree <= coarse.size() ? *coarse[degree - 1] :
                                                    geometry,
                          boundary);
  }



  std::vector<EdgePoint>
  LagrangeElement::edge_points_of(const SectionGeometry &grid,
                                  const std::string     &boundary) const
  {
    const FE_Q<2>                    &fe = grid.fe();
    const QGauss<1>                   quadrature(degree() + 1);
    std::map<unsigned int, EdgePoint> found;
    for (const auto &[c, f] : boundary_faces(boundary))
      for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
        {
          const Point<2> unit = fe.unit_support_point(i);
          if (std::abs(unit[f / 2] - f % 2) > arithmetic::rounding_of_results)
            continue;
          const unsigned int node  = grid.nodes_of_cell(c)[i];
          EdgePoint         &point = found[node];
          point.position           = &grid == &geometry ? grid.nodes()[node] :
                                                          geometry.map(c, unit).position;
          point.cell               = c;
          point.unit               = unit;
          point.depth              = depth(c, f);
          const auto value         = [&, face = f](const double t) {
            return fe.shape_value(i, face_point(face, t));
          };
          add_side(point,
                   side_share(c, f, quadrature, value),
                   scaled_face_normal(f, geometry.map(c, unit).jacobian));
        }

    std::vector<EdgePoint> points;
    for (auto &[node, point] : found)
      {
        point.normal /= point.normal.norm();
        points.push_back(point);
      }
    return points;
  }



  std::vector<EdgePoint>
  LagrangeElement::section_grid() const
  {
    return grid_points_of(geometry);
  }



  std::vector<EdgePoint>
  LagrangeElement::coarse_section_grid(const unsigned int degree) const
  {
    return grid_points_of(degree <= coarse.size() ? *coarse[degree - 1] :
                                                    geometry);
  }



  std::vector<EdgePoint>
  LagrangeElement::grid_points_of(const SectionGeometry &grid) const
  {
    const FE_Q<2>         &fe = grid.fe();
    const QGauss<2>        quadrature(degree() + 1);
    const unsigned int     n = fe.n_dofs_per_cell();
    std::vector<EdgePoint> points(grid.nodes().size());
    FullMatrix<double>     shares(n, quadrature.size());
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        shares(i, q) =
          fe.shape_value(i, quadrature.point(q)) * quadrature.weight(q);
    Vector areas(quadrature.size()), weights(n);
    for (unsigned int c = 0; c < cells.size(); ++c)
      {
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          areas[q] = determinant(geometry.map(c, quadrature.point(q)).jacobian);
        shares.vmult(weights, areas);
        for (unsigned int i = 0; i < n; ++i)
          {
            const unsigned int node  = grid.nodes_of_cell(c)[i];
            EdgePoint         &point = points[node];
            point.cell               = c;
            point.unit               = fe.unit_support_point(i);
            point.position           = &grid == &geometry ?
                                         grid.nodes()[node] :
                                         geometry.map(c, point.unit).position;
            point.weight += weights[i];
          }
      }
    return points;
  }
} // namespace lamella
