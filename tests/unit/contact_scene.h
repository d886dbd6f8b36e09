// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_tests_unit_contact_scene_h
#define lamella_tests_unit_contact_scene_h

#include "fixtures.h"

#include <lamella/solve/nonlinear_solver.h>
#include <lamella/solve/parameters.h>

#include <algorithm>

namespace lamella
{
  /// A row that keeps @p point of the body @p body above a rigid floor at the
  /// distance @p gap below it.
  inline GapConstraint
  above_floor(const Bodies           &bodies,
              const dealii::Point<3> &point,
              const double            gap,
              const Enforcement       enforcement,
              const double            penalty,
              const unsigned int      body = 0)
  {
    const Location where = bodies[body]->locate({point}).at(0).at(0);
    GapConstraint  row;
    row.parts       = {{body, bodies[body]->rows({where}, undisplaced)[0][2]}};
    row.initial_gap = gap;
    row.enforcement = enforcement;
    row.penalty     = penalty;
    return row;
  }

  /// What solves for @p rows in the way @p which, ready.
  inline std::unique_ptr<LinearSystem>
  linear_system(const Strategy             which,
                Structure                 &structure,
                const GapConstraints      &rows,
                const NonlinearParameters &parameters = NonlinearParameters())
  {
    return std::make_unique<LinearSystem>(which == Strategy::full ?
                                            linearized_without_solvers(
                                              structure) :
                                            linearized(structure),
                                          rows,
                                          parameters,
                                          which);
  }

  /// A structure with gap rows and what solves for them.
  struct ContactScene
  {
    std::unique_ptr<Structure>    structure;
    std::vector<GapConstraint>    rows;
    std::unique_ptr<LinearSystem> solver;

    void
    prepare(const Strategy which)
    {
      solver = linear_system(which, *structure, rows);
    }

    State
    solve(const double factor = 1., const State &previous = State()) const
    {
      return NonlinearSolver(*solver).solve(factor, previous).state;
    }

    /// How far g >= 0, lambda >= 0, g lambda = 0 are missed: the largest of -g
    /// over the largest displacement, of -lambda over the largest force, and
    /// of |g lambda| over both.
    double
    violation(const State &state, const double factor = 1.) const
    {
      double force = 0., worst = 0.;
      for (const double f : state.force)
        force = std::max(force, std::abs(f));
      const double size = state.u.linfty_norm();
      for (unsigned int r = 0; r < rows.size(); ++r)
        {
          const double g = rows[r].gap(state.u, factor);
          if (g < 0.)
            worst = std::max(worst, -g / size);
          if (state.force[r] != 0.)
            worst = std::max({worst,
                              std::abs(g * state.force[r]) / (force * size),
                              -state.force[r] / force});
        }
      return worst;
    }
  };

  inline double
  sum(const std::vector<double> &forces)
  {
    double all = 0.;
    for (const double f : forces)
      all += f;
    return all;
  }
} // namespace lamella

#endif
