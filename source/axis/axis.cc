// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/axis/axis.h>
#include <lamella/base/arithmetic.h>
#include <lamella/base/processes.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/mapping_q.h>

#include <deal.II/grid/grid_generator.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <numeric>

namespace lamella
{
  using namespace dealii;

  std::vector<double>
  element_lengths(const AxisMesh &description)
  {
    std::vector<double> ends = description.breaks;
    ends.push_back(description.length);
    std::vector<double> lengths;
    double              begin = 0.;
    for (unsigned int piece = 0; piece < ends.size(); ++piece)
      {
        const unsigned int n = description.elements[piece];
        lengths.insert(lengths.end(), n, (ends[piece] - begin) / n);
        begin = ends[piece];
      }
    return lengths;
  }



  Axis::Axis(const AxisMesh &description_)
    : description(description_)
    , mesh(communicator(),
           Triangulation<1>::none,
           false,
           parallel::shared::Triangulation<1>::partition_custom_signal)
    , fe(description.equidistant_nodes ?
           FE_Q<1>(QIterated<1>(QTrapezoid<1>(), description.degree)) :
           FE_Q<1>(description.degree))
    , dof_handler(mesh)
  {
    make_mesh();
    dof_handler.distribute_dofs(fe);
    number_nodes();
    make_matrices();
  }



  void
  Axis::make_mesh()
  {
    const std::vector<double> lengths = element_lengths(description);
    // Equal parts in a row, whatever the lengths: work goes with elements.
    const auto owner = [n = lengths.size()](const std::size_t cell) {
      return cell * n_processes() / n;
    };
    const boost::signals2::scoped_connection partition =
      mesh.signals.create.connect([&]() {
        for (const auto &cell : mesh.active_cell_iterators())
          cell->set_subdomain_id(owner(cell->active_cell_index()));
      });
    GridGenerator::subdivided_hyper_rectangle(mesh,
                                              {lengths},
                                              Point<1>(0.),
                                              Point<1>(description.length));
    owned_cells.first = 0;
    while (owned_cells.first < lengths.size() &&
           owner(owned_cells.first) < this_process())
      ++owned_cells.first;
    owned_cells.second =
      owned_cells.first + mesh.n_locally_owned_active_cells();
  }



  std::pair<unsigned int, unsigned int>
  Axis::own_nodes() const
  {
    const std::size_t n = n_nodes(), p = this_process(), of = n_processes();
    return {n * p / of, n * (p + 1) / of};
  }



  void
  Axis::number_nodes()
  {
    const unsigned int    n = dof_handler.n_dofs();
    std::vector<Point<1>> positions(n);
    DoFTools::map_dofs_to_support_points(MappingQ<1>(1),
                                         dof_handler,
                                         positions);
    std::vector<types::global_dof_index> order(n), number(n);
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&positions](auto a, auto b) {
      return positions[a][0] < positions[b][0];
    });
    for (unsigned int i = 0; i < n; ++i)
      {
        number[order[i]] = i;
        node_positions.push_back(positions[order[i]][0]);
      }
    dof_handler.renumber_dofs(number);

    std::vector<types::global_dof_index> indices(fe.n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        cell->get_dof_indices(indices);
        cell_nodes.emplace_back(indices.begin(), indices.end());
        cell_bounds.emplace_back(cell->vertex(0)[0], cell->vertex(1)[0]);
      }
  }



  AxisPoint
  Axis::evaluate(const unsigned int cell, const double eta) const
  {
    const auto [begin, end] = cell_bounds[cell];
    AxisPoint point;
    point.cell = cell;
    point.y    = begin + eta * (end - begin);
    for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
      {
        // At a node the others vanish exactly, and rows there stay short.
        const double N = fe.shape_value(i, Point<1>(eta));
        point.N.push_back(std::abs(N) < arithmetic::rounding ? 0. : N);
        point.dN.push_back(fe.shape_grad(i, Point<1>(eta))[0] / (end - begin));
      }
    point.N_shear =
      description.assumed_shear ? projected_shape_functions(eta) : point.N;
    return point;
  }



  std::vector<double>
  Axis::projected_shape_functions(const double eta) const
  {
    const std::vector<Point<1>> tying = QGauss<1>(fe.degree).get_points();
    std::vector<double>         values(fe.n_dofs_per_cell(), 0.);
    for (unsigned int q = 0; q < tying.size(); ++q)
      {
        double L = 1.;
        for (unsigned int r = 0; r < tying.size(); ++r)
          if (r != q)
            L *= (eta - tying[r][0]) / (tying[q][0] - tying[r][0]);
        for (unsigned int i = 0; i < values.size(); ++i)
          values[i] += L * fe.shape_value(i, tying[q]);
      }
    return values;
  }



  void
  Axis::make_matrices()
  {
    const QGauss<1> quadrature(fe.degree + 1);
    for (unsigned int cell = 0; cell < n_cells(); ++cell)
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          points.push_back(evaluate(cell, quadrature.point(q)[0]));
          weights.push_back(quadrature.weight(q) *
                            (cell_end(cell) - cell_begin(cell)));
        }

    DynamicSparsityPattern pattern(n_nodes());
    for (const auto &nodes : cell_nodes)
      for (const unsigned int node : nodes)
        pattern.add_entries(node, nodes.begin(), nodes.end());
    sparsity.copy_from(pattern);
    for (Matrix &matrix : matrices)
      matrix.reinit(sparsity);
    for (unsigned int k = 0; k < points.size(); ++k)
      {
        const auto &nodes = cell_nodes[points[k].cell];
        for (unsigned int i = 0; i < nodes.size(); ++i)
          for (unsigned int j = 0; j < nodes.size(); ++j)
            {
              for (unsigned int p = 0; p < 2; ++p)
                for (unsigned int q = 0; q < 2; ++q)
                  matrices[2 * p + q].add(
                    nodes[i],
                    nodes[j],
                    weights[k] * (p ? points[k].dN : points[k].N)[i] *
                      (q ? points[k].dN : points[k].N)[j]);
              matrices[4].add(nodes[i],
                              nodes[j],
                              weights[k] * points[k].N_shear[i] *
                                points[k].N_shear[j]);
            }
      }
  }



  std::vector<std::pair<unsigned int, double>>
  Axis::locate(const double y, const double tolerance) const
  {
    std::vector<std::pair<unsigned int, double>> found;
    for (unsigned int cell = 0; cell < n_cells(); ++cell)
      {
        const auto [begin, end] = cell_bounds[cell];
        // An end of the element is one exactly.
        if (std::abs(y - begin) <= tolerance)
          found.emplace_back(cell, 0.);
        else if (std::abs(y - end) <= tolerance)
          found.emplace_back(cell, 1.);
        else if (y > begin && y < end)
          found.emplace_back(cell, (y - begin) / (end - begin));
      }
    return found;
  }



  std::pair<unsigned int, double>
  Axis::cell_of_node(const unsigned int node) const
  {
    for (unsigned int cell = 0; cell < n_cells(); ++cell)
      for (unsigned int i = 0; i < cell_nodes[cell].size(); ++i)
        if (cell_nodes[cell][i] == node)
          return {cell, fe.unit_support_point(i)[0]};
    Assert(false, ExcMessage("There is no such node."));
    return {};
  }



  std::vector<double>
  Axis::node_weights() const
  {
    std::vector<double> sums(n_nodes(), 0.);
    for (unsigned int k = 0; k < points.size(); ++k)
      {
        const auto &nodes = cell_nodes[points[k].cell];
        for (unsigned int i = 0; i < nodes.size(); ++i)
          sums[nodes[i]] += weights[k] * points[k].N[i];
      }
    return sums;
  }
} // namespace lamella
