// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_surpluses_h
#define lamella_estimate_surpluses_h

#include <lamella/body/beam_surplus.h>
#include <lamella/run/simulation.h>

#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// About what a goal has changed by from poorer models to the run, in its
  /// unit, signed.
  struct Surplus
  {
    /// From one degree less of this source to the run, and from two degrees
    /// less to one.
    double last = 0., before = 0.;
    /// The sum over the nodes of the size of what each has of `last`: parts of
    /// the axis that cancel do not here.
    double by_nodes = 0.;
  };

  /// By source.
  struct SurplusBySource
  {
    Surplus section, axis;
  };

  /**
   * Surpluses of a run, without any model beside it. With z the dual of a goal
   * on the run's own factor (GoalDual) and L the interpolation into a poorer
   * space (BeamSurplus),
   *   J(u_p) - J(u_(p-1)) = a(u_p - u_(p-1), (1 - L) z_p)
   *                       ~ a((1 - L) u_p, (1 - L) z_p):
   * the first by orthogonality, the second since the surplus of u is near to
   * its change. For z = u it is an upper bound; otherwise the strengthened
   * Cauchy inequality holds it within 1 / (1 - gamma^2) (Bank and Smith, SIAM
   * J. Numer. Anal. 30 (1993) 921-935; Deuflhard, Leinen and Yserentant, IMPACT
   * Comput. Sci. Eng. 1 (1989) 3-35).
   *
   * Costs a solution with its refinement a goal, eight products with the
   * stiffness in all. The active set is the run's: that it is wrong is not
   * seen. Refers to the run, whose last step is solved. Collective.
   */
  class Surpluses
  {
  public:
    /// Why there are none of @p run: a sentence without a full stop, empty if
    /// there are. Every body has to be a beam of LE-N, N at least @p
    /// least_degree and 2, on elements B3 or B4.
    static std::string
    reason_for_none(const Simulation &run, const unsigned int least_degree);

    explicit Surpluses(const Simulation &run);

    /// Those of the goal with the dual @p z.
    SurplusBySource
    of(const BlockVector &z) const;

  private:
    /// What a vector has beyond the space of one degree less, and what of the
    /// rest beyond that of two.
    struct Parts
    {
      BlockVector section, section_before, axis, axis_before;
    };
    Parts
    parts_of(const BlockVector &v) const;

    const Simulation &run;
    /// A body each.
    std::vector<std::unique_ptr<const BeamSurplus>> of_beams;
    /// Of the displacements, times the stiffness.
    Parts forces;
  };
} // namespace lamella

#endif
