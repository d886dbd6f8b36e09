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
  /// About what a goal has changed by from poorer models to the run, in its
  /// unit, signed.
  struct Surplus
  {
    /// From what is poorer in this source to the run, and from what is poorer
    /// still to that: one and two degrees less of the section, halves and
    /// quarters of the elements along the axis (coarser_spans()).
    double last = 0., before = 0.;
    /// The sum over nodes and active rows of the size of what each has of
    /// `last`: parts of the axis that cancel do not here.
    double by_nodes = 0.;
  };

  /// By source, and what the axis has of it by elements (`last`).
  struct SurplusBySource
  {
    Surplus     section, axis;
    LocalErrors along_axis;
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
   * Where rows are active, (1 - L) u opens them by B (1 - L) u, which the
   * change of u does not: rows B, their compliance C and softness a held, it
   * answers with the forces phi = -(C + a)^-1 B (1 - L) u,   which adds   -phi
   * . B (1 - L) z to the surplus: all that a force which two bodies exert on
   * each other at a few places changes by.
   *
   * Costs a solution with its refinement a goal; four solutions and products
   * with the stiffness in all. The active set is the run's: that it is wrong is
   * not seen. Refers to the run, whose last step is solved. Collective.
   */
  class Surpluses
  {
  public:
    /// Why there are none of @p run: a sentence without a full stop, empty if
    /// there are. Every body has to be a beam of LE-N, N at least @p
    /// least_degree and 2, with all fields of the section at all nodes.
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

    /// What answers a part of the displacements, v: K v in the bodies and phi
    /// in the active rows.
    struct Answer
    {
      BlockVector bodies;
      Vector      rows;
    };
    Answer
    answer_to(const BlockVector &v) const;
    /// What @p answer does along @p z.
    double
    work(const Answer &answer, const BlockVector &z) const;
    /// The same by the sizes of what nodes and rows have of it.
    double
    sizes(const Answer &answer, const BlockVector &z) const;
    /// work() by elements, which share what the span has that they are in.
    LocalErrors
    by_elements(const Answer &answer, const BlockVector &z) const;
    /// What the spans of @p body have of the products @p products of its DoFs.
    void
    add_spans(const unsigned int body,
              const Vector      &products,
              LocalErrors       &result) const;
    /// How far @p v opens the active rows.
    Vector
    openings(const BlockVector &v) const;

    const Simulation &run;
    /// A body each: its surplus, halves and quarters of its elements.
    std::vector<std::unique_ptr<const BeamSurplus>> of_beams;
    std::vector<std::vector<AxisSpan>>              halves, quarters;
    /// To the parts of the displacements.
    std::unique_ptr<const Answer> section, section_before, axis, axis_before;
  };
} // namespace lamella

#endif
