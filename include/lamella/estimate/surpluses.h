// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_surpluses_h
#define lamella_estimate_surpluses_h

#include <lamella/axis/axis.h>
#include <lamella/body/beam_surplus.h>
#include <lamella/recover/goal_result.h>
#include <lamella/run/simulation.h>
#include <lamella/scene/scene.h>

#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// Returns @p axis with about half as many elements. Neighbors are merged in
  /// pairs within each segment of the axis; of an odd number, three are merged
  /// where they are longest. On graded axes, where each segment is one element,
  /// pairs are formed between the points toward which elements get shorter; a
  /// single one between segments of several elements remains. All element ends
  /// of the result are element ends of @p axis.
  AxisMesh
  halved(const AxisMesh &axis);

  /// Applies halved() to @p axis @p times times and returns the elements. Each
  /// time, elements that were not merged get one degree less (at least 1).
  std::vector<AxisSpan>
  coarser_spans(AxisMesh axis, const unsigned int times);

  /// Returns @p scene with about half as many elements on the axis of each beam
  /// (halved()). The axes must already be divided into elements.
  Scene
  with_halved_axes(Scene scene);

  /// Returns @p scene with LE-N replaced by LE-(N-1) in all bodies, N >= 2.
  Scene
  with_lower_degree(Scene scene);

  /// Returns @p scene with @p fewer wave numbers less in SV-N, at least one.
  Scene
  with_fewer_waves(Scene scene, const unsigned int fewer);

  /// Returns @p scene with one section order less in bodies of SV, at least
  /// one, and with_lower_degree().
  Scene
  with_lower_section_order(Scene scene);

  /// Signed changes of a goal between successively coarser models and the run,
  /// due to one error source: the section mesh or the axis mesh.
  struct Surplus
  {
    /// Change to the run from one degree less or half of the elements.
    double last   = 0.,
           before = 0.; ///< Change from the second to the next coarser model.
  };

  /// Changes of a goal by the two error sources of a beam.
  struct SurplusParts
  {
    Surplus section,        ///< Changes by the degree of the section mesh.
      axis;                 ///< Changes by the number of axis elements.
    LocalErrors along_axis; ///< Contributions of elements to `axis.last`.
  };

  /// Hierarchical surpluses: changes of the goals J of a run from coarser
  /// models, without solution of these models. Let u_p be the solution with
  /// degree p, a(., .) the bilinear form of the stiffness K, z_p the dual
  /// solution of a goal (GoalDual), and L the interpolation into a coarser
  /// space (BeamSurplus). Then
  ///   J(u_p) - J(u_(p-1)) = a(u_p - u_(p-1), (1 - L) z_p)
  ///                       ~ a((1 - L) u_p, (1 - L) z_p):
  /// first by orthogonality, then since the surplus (1 - L) u approximates the
  /// change of u. For z = u the last expression bounds the change; else 1 / (1
  /// - gamma^2) times it does, with the constant gamma of the strengthened
  /// Cauchy inequality (Bank and Smith, SIAM J. Numer. Anal. 30, 1993).
  ///
  /// The surplus (1 - L) u violates the active constraints with matrix B by the
  /// jump B (1 - L) u; the change of u does not. The forces phi = -(C + a)^-1 B
  /// (1 - L) u, with the compliances C of the constraints and a of the contact
  /// law, remove the jump and add -phi . B (1 - L) z to the change of J. Errors
  /// due to a wrong active set are not included. Costs one solution per goal,
  /// and four solutions and products with K in total. Collective.
  class Surpluses
  {
  public:
    /// Returns why @p run has no surpluses. Empty if every body is a beam of
    /// LE-N, N >= 2 and N >= @p min_degree, with all functions at all nodes.
    static std::string
    unavailable_reason(const Simulation &run, const unsigned int min_degree);

    /// Computes the surpluses of the displacements of @p run, and their forces.
    explicit Surpluses(const Simulation &run);

    /// Returns the surpluses of the goal whose dual displacements are @p z.
    SurplusParts
    of(const BlockVector &z) const;

  private:
    /// Components of displacements that the next coarser section or axis cannot
    /// represent, and (`..._before`) those of the rest that the second cannot.
    struct Parts
    {
      BlockVector section, section_before, axis, axis_before;
    };
    Parts
    parts_of(const BlockVector &v) const;

    /// Forces of a displacement component v: K v, and those of constraints.
    struct PartForces
    {
      BlockVector bodies;
      Vector      rows;
    };
    PartForces
    forces_of_part(const BlockVector &v) const;
    /// Returns the work of @p part_forces along the dual component @p z.
    double
    work(const PartForces &part_forces, const BlockVector &z) const;
    /// Returns work() per element; elements merged in a coarser model share it.
    LocalErrors
    by_elements(const PartForces &part_forces, const BlockVector &z) const;
    /// Adds the errors of elements of @p body from the @p products per DoF.
    void
    add_spans(const unsigned int body,
              const Vector      &products,
              LocalErrors       &result) const;
    /// Returns the jump of @p v in the active constraints.
    Vector
    jumps(const BlockVector &v) const;

    const Simulation &run;
    /// Surpluses of beams; elements of axes halved once and twice.
    std::vector<std::unique_ptr<const BeamSurplus>> of_beams;
    std::vector<std::vector<AxisSpan>>              halves, quarters;
    /// Forces of the components of the displacements.
    std::unique_ptr<const PartForces> section, section_before, axis,
      axis_before;
  };
} // namespace lamella

#endif
