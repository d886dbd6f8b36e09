// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/linear/row_products.h>

namespace lamella
{
  RowProducts::RowProducts(const LinearSolver &solver,
                           const DofIndex      n_dofs,
                           Solve               solve)
    : solver(solver)
    , n_dofs(n_dofs)
    , solve(std::move(solve))
  {}



  void
  RowProducts::append(const std::vector<LinearFunctional> &added)
  {
    if (added.empty())
      return;
    const unsigned int first = rows.size();
    rows.insert(rows.end(), added.begin(), added.end());
    const std::vector<double> values = solve(rows, first);
    for (unsigned int i = 0; i < added.size(); ++i)
      kept.emplace_back(values.begin() + i * rows.size(),
                        values.begin() + (i + 1) * rows.size());
  }



  std::vector<double>
  RowProducts::products(const unsigned int first) const
  {
    const std::size_t   n = size() - first;
    std::vector<double> result(n * size());
    for (unsigned int j = 0; j < size(); ++j)
      for (unsigned int i = first; i < size(); ++i)
        result[j * n + i - first] = kept[std::max(i, j)][std::min(i, j)];
    return result;
  }



  Vector
  RowProducts::displacement(const std::vector<double> &lambda) const
  {
    Vector x(n_dofs);
    for (unsigned int k = 0; k < rows.size(); ++k)
      if (lambda[k] != 0.)
        rows[k].add_to(x, lambda[k]);
    solver.solve(x);
    return x;
  }
} // namespace lamella
