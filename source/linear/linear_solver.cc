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
} // namespace lamella
