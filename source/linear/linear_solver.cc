// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/processes.h>
#include <lamella/base/text.h>
#include <lamella/linear/linear_solver.h>

namespace lamella
{
  std::string
  to_text(const SolverStatistics &statistics)
  {
    const std::string shared =
      n_processes() == 1 ?
        "" :
        " on " + std::to_string(n_processes()) + " processes";
    if (statistics.kind != SolverKind::cg)
      return (statistics.kind == SolverKind::mumps  ? "MUMPS" :
              statistics.kind == SolverKind::blocks ? "Dense blocks" :
                                                      "CHOLMOD") +
             shared + ", factor of " + to_text(statistics.non_zeros, 3) +
             " non-zeros";
    const double n = statistics.solutions;
    return "conjugate gradients with algebraic multigrid" + shared + ", " +
           std::to_string(statistics.solutions) + " solutions" +
           (n == 0 ? "" :
                     " of " + to_text(statistics.iterations / n, 3) +
                       " iterations on average, " +
                       std::to_string(statistics.max_iterations_per_solve) +
                       " at most");
  }



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
