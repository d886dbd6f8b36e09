// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_parameters_h
#define lamella_solve_parameters_h

#include <lamella/solve/contact_solver.h>

#include <deal.II/base/parameter_handler.h>

#include <vector>

namespace lamella
{
  enum class Strategy
  {
    undefined,
    condensed,
    full
  };

  /// What a scene says of the solution.
  struct SolveParameters
  {
    std::vector<double> load_factors;
    Strategy            strategy = Strategy::undefined;
    SolverParameters    loop;
    SolverKind          solver = SolverKind::automatic;
    /// Bytes on each machine; 0: what it has.
    double memory_limit = 0.;
    /// In rad; beyond it a run fails.
    double rotation_limit = 0.;

    static void
    declare(dealii::ParameterHandler &prm);

    /// Throws InputError.
    static SolveParameters
    parse(const dealii::ParameterHandler &prm);
  };
} // namespace lamella

#endif
