// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/section/lagrange_element.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/mapping_q.h>

#include <numeric>

namespace lamella
{
  using namespace dealii;

  LagrangeElement::LagrangeElement(std::shared_ptr<const SectionMesh> mesh_,
                                   const unsigned int                 degree)
    : CrossSectionElement(std::move(mesh_))
    , fe(degree)
    , dof_handler(mesh->mesh)
    , nodes()
  {
    dof_handler.distribute_dofs(fe);
    nodes.resize(dof_handler.n_dofs());
    DoFTools::map_dofs_to_support_points(MappingQ<2>(degree),
                                         dof_handler,
                                         nodes);
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        cells.emplace_back();
        cells.back().nodes.resize(fe.n_dofs_per_cell());
        cell->get_dof_indices(cells.back().nodes);
      }
    number_functions();
  }



  std::string
  LagrangeElement::name() const
  {
    const unsigned int nodes_per_cell = (fe.degree + 1) * (fe.degree + 1);
    return "LE-" + std::to_string(fe.degree) + " (L" +
           std::to_string(nodes_per_cell) + ")";
  }



  std::array<unsigned int, 3>
  LagrangeElement::replaced_nodes() const
  {
    const auto farthest = [this](const auto &measure) {
      unsigned int best = 0;
      for (unsigned int i = 1; i < nodes.size(); ++i)
        if (measure(nodes[i]) > measure(nodes[best]))
          best = i;
      return best;
    };
    const unsigned int a =
      farthest([this](const Point<2> &p) { return p.distance_square(origin); });
    const unsigned int b = farthest(
      [this, a](const Point<2> &p) { return p.distance_square(nodes[a]); });
    const Tensor<1, 2> line = nodes[b] - nodes[a];
    const unsigned int c    = farthest([this, a, &line](const Point<2> &p) {
      const Tensor<1, 2> d = p - nodes[a];
      return std::abs(line[0] * d[1] - line[1] * d[0]);
    });
    return {{a, b, c}};
  }



  void
  LagrangeElement::number_functions()
  {
    std::vector<unsigned int> function_of_node(nodes.size());
    const auto                replaced = replaced_nodes();
    for (unsigned int node = 0, next = 3; node < nodes.size(); ++node)
      {
        const bool gives_way =
          std::find(replaced.begin(), replaced.end(), node) != replaced.end();
        function_of_node[node] = gives_way ? 0 : next++;
      }

    for (Cell &cell : cells)
      {
        for (unsigned int i = 0; i < cell.nodes.size(); ++i)
          if (function_of_node[cell.nodes[i]] > 0)
            cell.warping.push_back(i);
        std::sort(cell.warping.begin(),
                  cell.warping.end(),
                  [&cell](const unsigned int i, const unsigned int j) {
                    return cell.nodes[i] < cell.nodes[j];
                  });
        cell.functions = {0, 1, 2};
        for (const unsigned int i : cell.warping)
          cell.functions.push_back(function_of_node[cell.nodes[i]]);
      }
  }



  void
  LagrangeElement::map_geometry(const unsigned int cell,
                                const Point<2>    &unit,
                                FunctionValues    &result) const
  {
    for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
      {
        const Point<2>    &node     = nodes[cells[cell].nodes[i]];
        const Tensor<1, 2> gradient = fe.shape_grad(i, unit);
        result.position += fe.shape_value(i, unit) * node;
        result.jacobian += outer_product(Tensor<1, 2>(node), gradient);
      }
  }



  FunctionValues
  LagrangeElement::evaluate(const unsigned int cell, const Point<2> &unit) const
  {
    FunctionValues result;
    map_geometry(cell, unit, result);
    const Tensor<2, 2> to_real = transpose(invert(result.jacobian));

    result.values    = {1.,
                        (result.position[0] - origin[0]) / length,
                        (result.position[1] - origin[1]) / length};
    result.gradients = {Tensor<1, 2>(),
                        Point<2>(1. / length, 0.),
                        Point<2>(0., 1. / length)};
    for (const unsigned int i : cells[cell].warping)
      {
        // At a node the others vanish exactly, and rows there stay short.
        const double value = fe.shape_value(i, unit);
        result.values.push_back(std::abs(value) < 1e-14 ? 0. : value);
        result.gradients.push_back(to_real * fe.shape_grad(i, unit));
      }
    return result;
  }



  std::vector<EdgePoint>
  LagrangeElement::edge_points(const std::string &boundary) const
  {
    const QGauss<1> quadrature(fe.degree + 1);
    std::map<dealii::types::global_dof_index, EdgePoint> found;
    for (const auto &[c, f] : boundary_faces(boundary))
      for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
        {
          const Point<2> unit = fe.unit_support_point(i);
          if (std::abs(unit[f / 2] - f % 2) > 1e-12)
            continue;
          EdgePoint &point = found[cells[c].nodes[i]];
          point.position   = nodes[cells[c].nodes[i]];
          point.cell       = c;
          point.unit       = unit;
          point.depth      = depth(c, f);
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            {
              const Point<2> x = face_point(f, quadrature.point(q)[0]);
              FunctionValues geometry;
              map_geometry(c, x, geometry);
              const Tensor<1, 2> n = scaled_face_normal(f, geometry.jacobian);
              const double share = fe.shape_value(i, x) * quadrature.weight(q);
              point.normal += share * n;
              point.weight += share * n.norm();
            }
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
  LagrangeElement::section_points() const
  {
    const QGauss<2>        quadrature(fe.degree + 1);
    std::vector<EdgePoint> points(nodes.size());
    for (unsigned int c = 0; c < cells.size(); ++c)
      for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
        {
          EdgePoint &point = points[cells[c].nodes[i]];
          point.position   = nodes[cells[c].nodes[i]];
          point.cell       = c;
          point.unit       = fe.unit_support_point(i);
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            {
              FunctionValues geometry;
              map_geometry(c, quadrature.point(q), geometry);
              point.weight += fe.shape_value(i, quadrature.point(q)) *
                              quadrature.weight(q) *
                              determinant(geometry.jacobian);
            }
        }
    return points;
  }
} // namespace lamella
