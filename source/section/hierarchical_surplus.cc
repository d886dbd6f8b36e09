// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/section/hierarchical_surplus.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

namespace lamella
{
  using namespace dealii;

  bool
  HierarchicalSurplus::is_possible(const Section &section)
  {
    return section.theory().is_layerwise() && section.element().degree() > 1;
  }



  HierarchicalSurplus::HierarchicalSurplus(const Section &section)
    : section(section)
    , beyond(degree() - 1)
  {
    const std::vector<EdgePoint> nodes = section.element().section_points();
    factorize(nodes);
    for (unsigned int q = 1; q < degree(); ++q)
      for (const EdgePoint &node : nodes)
        {
          std::array<LinearFunctional, 3> rows =
            displacement(node.cell, node.unit);
          const auto coarse = interpolated(node.cell, node.unit, q);
          for (unsigned int c = 0; c < 3; ++c)
            {
              rows[c].add(coarse[c], -1.);
              rows[c].compress();
              rows[c].drop_below(arithmetic::rounding);
              beyond[q - 1].push_back(std::move(rows[c]));
            }
        }
  }



  std::array<LinearFunctional, 3>
  HierarchicalSurplus::displacement(const unsigned int cell,
                                    const Point<2>    &unit) const
  {
    const SectionPoint              point = section.evaluate(cell, unit);
    std::array<LinearFunctional, 3> rows;
    for (unsigned int k = 0; k < point.fields->size(); ++k)
      for (unsigned int c = 0; c < 3; ++c)
        rows[c].add((*point.fields)[k], point.value[k][c]);
    return rows;
  }



  std::array<LinearFunctional, 3>
  HierarchicalSurplus::interpolated(const unsigned int cell,
                                    const Point<2>    &unit,
                                    const unsigned int q) const
  {
    const GaussLobattoBasis &basis = GaussLobattoBasis::of_degree(q);
    const auto               grid  = grid_points(basis, basis);
    std::vector<double>      weights;
    evaluate_on_grid(basis, basis, unit, weights);
    std::array<LinearFunctional, 3> rows;
    for (unsigned int m = 0; m < grid.size(); ++m)
      {
        const auto at = displacement(cell, grid[m]);
        for (unsigned int c = 0; c < 3; ++c)
          rows[c].add(at[c], weights[m]);
      }
    return rows;
  }



  void
  HierarchicalSurplus::factorize(const std::vector<EdgePoint> &nodes)
  {
    std::vector<LinearFunctional> rows;
    for (const EdgePoint &node : nodes)
      for (LinearFunctional &row : displacement(node.cell, node.unit))
        rows.push_back(std::move(row));
    Assert(rows.size() == section.n_fields(), ExcInternalError());
    DynamicSparsityPattern dynamic(rows.size());
    for (unsigned int i = 0; i < rows.size(); ++i)
      for (const auto &[field, value] : rows[i].entries())
        dynamic.add(i, field);
    SparsityPattern pattern;
    pattern.copy_from(dynamic);
    Matrix at_nodes(pattern);
    for (unsigned int i = 0; i < rows.size(); ++i)
      for (const auto &[field, value] : rows[i].entries())
        at_nodes.set(i, field, value);
    from_nodes.factorize(at_nodes);
  }



  void
  HierarchicalSurplus::remove_lower_degree(const unsigned int q,
                                           Vector            &c) const
  {
    Vector surplus(c.size());
    for (unsigned int i = 0; i < c.size(); ++i)
      surplus[i] = beyond[q - 1][i](c);
    from_nodes.solve(surplus);
    c = surplus;
  }
} // namespace lamella
