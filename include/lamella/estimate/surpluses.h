// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_surpluses_h
#define lamella_estimate_surpluses_h

#include <lamella/body/beam_surplus.h>
#include <lamella/recover/goal_result.h>
#include <lamella/run/simulation.h>

#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// Signed changes of a goal from coarser models to the run by one source.
  struct Surplus
  {
    /// Changes from the two next coarser levels: one and two degrees less of
    /// the section, or half and a quarter of the elements (coarser_spans()).
    double last = 0., before = 0.;
    /// Sum of |contributions| of nodes and active constraints to `last`.
    double by_nodes = 0.;
  };

  /// Surpluses of a goal by source; Surplus::last of the axis by elements.
  struct SurplusParts
  {
    Surplus     section, axis;
    LocalErrors along_axis;
  };

  /// Hierarchical surpluses of a run: changes of its goals J from coarser
  /// models, without solution of these models. Let u_p be the solution with
  /// degree p, a(., .) the bilinear form of the stiffness K, z_p the dual
  /// solution of a goal (GoalDual), and L the interpolation into a coarser
  /// space (BeamSurplus). Then
  ///   J(u_p) - J(u_(p-1)) = a(u_p - u_(p-1), (1 - L) z_p)
  ///                       ~ a((1 - L) u_p, (1 - L) z_p):
  /// first by orthogonality, then since the surplus (1 - L) u approximates the
  /// change of u. For z = u the result is an upper bound; otherwise the
  /// strengthened Cauchy inequality with constant gamma bounds the error by the
  /// factor 1 / (1 - gamma^2) (Bank and Smith, SIAM J. Numer. Anal. 30 (1993)
  /// 921-935).
  ///
  /// In active constraints with matrix B, (1 - L) u has the jump B (1 - L) u,
  /// which the change of u does not have. The forces phi = -(C + a)^-1 B (1 -
  /// L) u, with the compliance C of the constraints and a of the contact law,
  /// remove the jump and add -phi . B (1 - L) z to the surplus. The error of
  /// the active set is not included. Costs one refined solution per goal, and
  /// four solutions and products with K in total. Collective.
  class Surpluses
  {
  public:
    /// Returns why @p run has no surpluses; empty if every body is a beam of
    /// LE-N, N >= 2 and N >= @p min_degree, with all fields at all nodes.
    static std::string
    unavailable_reason(const Simulation &run, const unsigned int min_degree);

    explicit Surpluses(const Simulation &run);

    /// Returns the surpluses of the goal with the dual solution @p z.
    SurplusParts
    of(const BlockVector &z) const;

  private:
    /// Parts of a displacement vector that the next coarser level cannot
    /// represent, and parts of the remainder that the level before cannot.
    struct Parts
    {
      BlockVector section, section_before, axis, axis_before;
    };
    Parts
    parts_of(const BlockVector &v) const;

    /// Forces of a part v of the displacements: K v, and phi of constraints.
    struct PartForces
    {
      BlockVector bodies;
      Vector      rows;
    };
    PartForces
    forces_of_part(const BlockVector &v) const;
    /// Returns the work of @p part_forces along @p z.
    double
    work(const PartForces &part_forces, const BlockVector &z) const;
    /// Returns the sum of |contributions| of nodes and constraints to work().
    double
    sizes(const PartForces &part_forces, const BlockVector &z) const;
    /// Returns work() by elements; elements merged in a coarser level share it.
    LocalErrors
    by_elements(const PartForces &part_forces, const BlockVector &z) const;
    /// Adds contributions of spans of @p body from @p products by DoFs.
    void
    add_spans(const unsigned int body,
              const Vector      &products,
              LocalErrors       &result) const;
    /// Returns the jump of @p v in the active constraints.
    Vector
    jumps(const BlockVector &v) const;

    const Simulation &run;
    /// Surpluses of beams; their spans at half and a quarter of the elements.
    std::vector<std::unique_ptr<const BeamSurplus>> of_beams;
    std::vector<std::vector<AxisSpan>>              halves, quarters;
    /// Forces of the parts of the displacements.
    std::unique_ptr<const PartForces> section, section_before, axis,
      axis_before;
  };
} // namespace lamella

#endif
