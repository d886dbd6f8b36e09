// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_green_beam_h
#define lamella_body_green_beam_h

#include <lamella/body/beam.h>
#include <lamella/section/green_answer.h>

namespace lamella
{
  /**
   * A beam that turns by any angle: Total Lagrange on the fields and the axis
   * of a Beam. Its internal forces follow from Green's strain and the second
   * Piola-Kirchhoff stress (GreenAnswer), integrated over the undeformed body,
   *   f_(i,alpha) = int N_i W_0,alpha + N_i' W_1,alpha dy,
   * and its tangent is their derivative. At u = 0 that is the stiffness of the
   * Beam. Displacements add up as ever: rows, supports and dead loads are those
   * of the Beam. Strains, stresses and rotations at points, pictures and
   * second_order() are still those of small rotations.
   *
   * With B4 alone and for theories whose strains are those of their
   * displacements (LE, TE-2 and up).
   */
  class GreenBeam : public Beam
  {
  public:
    /// As the constructor of Beam. Throws InputError for the theories and axes
    /// that it is not for.
    GreenBeam(const std::string             &name,
              std::shared_ptr<const Section> section,
              std::shared_ptr<const Axis>    axis,
              const Placement               &placement);

    StiffnessTerms
    tangent_terms(const Vector                  &u,
                  const Vector                  &correction,
                  const std::vector<SpringTerm> &springs = {}) const override;
    void
    add_tangent_forces(const Vector &u,
                       const Vector &w,
                       Vector       &f) const override;
    std::unique_ptr<LinearSolver>
    make_tangent_solver(const Vector                  &u,
                        const Vector                  &correction,
                        const Constraints             &constraints,
                        const std::vector<SpringTerm> &springs = {},
                        const SolverKind     asked   = SolverKind::automatic,
                        const SolverMonitor &monitor = {}) const override;

  protected:
    /// Those of Green's strain.
    SectionForces
    section_forces(const SectionAnswer &answer,
                   const FieldParts    &q) const override;

  private:
    /// Calls @p use with the derivative of the forces at @p u, with the stress
    /// that the @p correction predicted, block by block: one for each own
    /// element of the axis and cell of the section.
    void
    for_each_tangent_block(
      const Vector                                      &u,
      const Vector                                      &correction,
      const bool                                         with_values,
      const std::function<void(const StiffnessBlock &)> &use) const;

    /// The block of the axis element @p cell and the section's cell whose
    /// fields are @p on_section, without values.
    StiffnessBlock
    empty_block(const unsigned int               cell,
                const std::vector<unsigned int> &on_section) const;

    /// Gives @p blocks, one for each cell of the section, the values of the
    /// axis element @p cell.
    void
    add_values(const unsigned int           cell,
               const Vector                &u,
               const Vector                &correction,
               std::vector<StiffnessBlock> &blocks) const;

    /// Adds to @p block, of the axis element @p cell, what the section's
    /// @p tangent at its station @p k does.
    void
    add_station(const unsigned int              cell,
                const unsigned int              k,
                const GreenAnswer::CellTangent &tangent,
                StiffnessBlock                 &block) const;

    const GreenAnswer green;
  };
} // namespace lamella

#endif
