// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/section/lagrange_element.h>

#include <deal.II/base/quadrature_lib.h>

#include <map>

namespace lamella
{
  using namespace dealii;

  LagrangeElement::LagrangeElement(std::shared_ptr<const SectionMesh> mesh_,
                                   const unsigned int                 degree,
                                   const double column_aspect)
    : CrossSectionElement(mesh_)
    , geometry(mesh_, degree)
    , cells(geometry.n_cells())
  {
    const Grid grid = find_grid(column_aspect);
    if (grid.n_columns > 0)
      number_column_functions(grid);
    else
      number_nodal_functions();
    collect_numbers();
  }



  std::array<unsigned int, 3>
  LagrangeElement::replaced_nodes() const
  {
    const auto &nodes    = geometry.nodes();
    const auto  farthest = [&nodes](const auto &measure) {
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
    const auto                replaced = replaced_nodes();
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
    /// The distinct values of coordinate @p d of @p nodes, ascending, and the
    /// place of each node among them.
    std::pair<std::vector<double>, std::vector<unsigned int>>
    distinct_coordinates(const std::vector<Point<2>> &nodes,
                         const unsigned int           d)
    {
      std::vector<double> all;
      for (const Point<2> &node : nodes)
        all.push_back(node[d]);
      std::sort(all.begin(), all.end());
      const double        tolerance = 1e-9 * (all.back() - all.front());
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



  void
  LagrangeElement::number_column_functions(const Grid &grid)
  {
    const auto box = bounding_box().get_boundary_points();
    long_side =
      box.second[0] - box.first[0] > box.second[1] - box.first[1] ? 0 : 1;
    column_length =
      0.5 * (box.second[1 - long_side] - box.first[1 - long_side]);

    // 1, x, z stand for both functions of the first column and one of the last.
    std::vector<unsigned int> constant(grid.n_columns, 0),
      slope(grid.n_columns, 0);
    levels.assign(3, 0);
    for (unsigned int i = 0; i < grid.n_columns; ++i)
      {
        if (i > 0 && i + 1 < grid.n_columns)
          {
            constant[i] = levels.size();
            levels.push_back(1);
          }
        if (i > 0)
          {
            slope[i] = levels.size();
            levels.push_back(1);
          }
      }
    std::vector<unsigned int> of_node(grid.column.size(), 0);
    for (unsigned int node = 0; node < of_node.size(); ++node)
      if (grid.place[node] > 0 && grid.place[node] + 1 < grid.n_places)
        {
          of_node[node] = levels.size();
          levels.push_back(2);
        }

    for (unsigned int c = 0; c < cells.size(); ++c)
      {
        const auto &nodes = geometry.nodes_of_cell(c);
        std::map<unsigned int, std::vector<unsigned int>> columns;
        for (unsigned int i = 0; i < nodes.size(); ++i)
          {
            columns[grid.column[nodes[i]]].push_back(i);
            if (of_node[nodes[i]] > 0)
              cells[c].functions.push_back(
                {of_node[nodes[i]], LocalFunction::Kind::nodal, {i}});
          }
        for (const auto &[column, members] : columns)
          {
            if (constant[column] > 0)
              cells[c].functions.push_back(
                {constant[column], LocalFunction::Kind::column, members});
            if (slope[column] > 0)
              cells[c].functions.push_back(
                {slope[column], LocalFunction::Kind::column_slope, members});
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
    const unsigned int across       = 1 - long_side;
    const double       t = (position[across] - origin[across]) / column_length;

    for (const LocalFunction &function : cells[cell].functions)
      {
        double       value = 0.;
        Tensor<1, 2> gradient;
        for (const unsigned int i : function.nodes)
          {
            value += geometry.fe().shape_value(i, unit);
            gradient += to_real * geometry.fe().shape_grad(i, unit);
          }
        // At a node the others vanish exactly, and rows there stay short.
        if (std::abs(value) < 1e-14)
          value = 0.;
        if (function.kind != LocalFunction::Kind::nodal)
          gradient[across] = 0.;
        if (function.kind == LocalFunction::Kind::column_slope)
          {
            gradient *= t;
            gradient[across] = value / column_length;
            value *= t;
          }
        result.values.push_back(value);
        result.gradients.push_back(gradient);
      }
    return result;
  }



  std::vector<EdgePoint>
  LagrangeElement::edge_points(const std::string &boundary) const
  {
    const FE_Q<2>                    &fe = geometry.fe();
    const QGauss<1>                   quadrature(fe.degree + 1);
    std::map<unsigned int, EdgePoint> found;
    for (const auto &[c, f] : boundary_faces(boundary))
      for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
        {
          const Point<2> unit = fe.unit_support_point(i);
          if (std::abs(unit[f / 2] - f % 2) > 1e-12)
            continue;
          const unsigned int node  = geometry.nodes_of_cell(c)[i];
          EdgePoint         &point = found[node];
          point.position           = geometry.nodes()[node];
          point.cell               = c;
          point.unit               = unit;
          point.depth              = depth(c, f);
          Tensor<1, 2> normal;
          double       weight = 0.;
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            {
              const Point<2>     x = face_point(f, quadrature.point(q)[0]);
              const Tensor<1, 2> n =
                scaled_face_normal(f, geometry.map(c, x).jacobian);
              const double share = fe.shape_value(i, x) * quadrature.weight(q);
              normal += share * n;
              weight += share * n.norm();
            }
          add_side(point,
                   normal,
                   weight,
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
    const FE_Q<2>         &fe = geometry.fe();
    const QGauss<2>        quadrature(fe.degree + 1);
    std::vector<EdgePoint> points(geometry.nodes().size());
    for (unsigned int c = 0; c < cells.size(); ++c)
      for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
        {
          const unsigned int node  = geometry.nodes_of_cell(c)[i];
          EdgePoint         &point = points[node];
          point.position           = geometry.nodes()[node];
          point.cell               = c;
          point.unit               = fe.unit_support_point(i);
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            point.weight +=
              fe.shape_value(i, quadrature.point(q)) * quadrature.weight(q) *
              determinant(geometry.map(c, quadrature.point(q)).jacobian);
        }
    return points;
  }
} // namespace lamella
