// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_total_lagrangian_beam_h
#define lamella_body_total_lagrangian_beam_h

#include <lamella/body/beam.h>
#include <lamella/section/finite_strain_section_operator.h>

namespace lamella
{
  /**
   * A beam with finite rotations in the total Lagrangian formulation, on the
   * fields and the axis of a Beam. Its internal forces follow from Green's
   * strain and the second Piola-Kirchhoff stress (FiniteStrainSectionOperator),
   *   f_(i,alpha) = int N_i W_0,alpha + N_i' W_1,alpha dy,
   * over the undeformed body, and the tangent is their derivative, at u = 0 the
   * stiffness of the Beam. Displacements are additive: rows of displacements,
   * supports and dead loads are those of the Beam.
   *
   * Samples have Green's strain E, and as stress R^T sigma R, Cauchy's in axes
   * that rotate with the material (PolarDecomposition), as ply axes do. E_yy
   * and the transverse shears of samples are least-squares polynomials of
   * degree 2 through their values at the stations, as other parts oscillate in
   * between. Limited to B4 and theories whose strains are those of their
   * displacements (LE, TE-2 and up).
   */
  class TotalLagrangianBeam : public Beam
  {
  public:
    /// Constructs a beam as Beam does. Throws InputError if unsupported.
    TotalLagrangianBeam(const std::string             &name,
                        std::shared_ptr<const Section> section,
                        std::shared_ptr<const Axis>    axis,
                        const Placement               &placement);

    bool
    has_finite_rotations() const override
    {
      return true;
    }
    std::vector<Vector>
    rigid_motions_at(const Vector &u) const override;
    Deformation
    deformation(const Vector &u) const override;
    void
    for_each_thermal_block(
      const Vector                                      &u,
      const std::function<void(const StiffnessBlock &)> &use) const override;

  protected:
    /// Returns the forces of Green's strain.
    SectionForces
    section_forces(const SectionOperator &section_operator,
                   const FieldParts      &q) const override;
    FieldSample
    sample_at(const SectionPoint &point,
              const AxisPoint    &on_axis,
              const Vector       &u) const override;

    /// Calls @p use with a block per own axis element and section cell.
    void
    for_each_tangent_block(
      const Vector                                      &u,
      const Vector                                      &correction,
      const bool                                         with_values,
      const std::function<void(const StiffnessBlock &)> &use) const override;

  private:
    /// Returns the coefficients of @p u at @p point and @p on_axis.
    FieldParts
    parts_at(const SectionPoint &point,
             const AxisPoint    &on_axis,
             const Vector       &u) const;

    /// Returns the smoothed strain at @p point and @p on_axis, gradient @p H.
    Voigt
    strain_at(const SectionPoint &point,
              const AxisPoint    &on_axis,
              const Gradient     &H,
              const Vector       &u) const;

    /// Returns the rotation between the ends of axis element @p cell [rad].
    double
    rotation_along(const unsigned int cell, const Vector &u) const;

    /// Return the blocks of @p cell, one per section cell: no values, or zeros.
    std::vector<StiffnessBlock>
    empty_blocks(const unsigned int cell) const;
    std::vector<StiffnessBlock>
    zero_blocks(const unsigned int cell) const;

    /// Returns the block of @p cell and fields @p on_section without values.
    StiffnessBlock
    empty_block(const unsigned int               cell,
                const std::vector<unsigned int> &on_section) const;

    /// Adds the values of the axis element @p cell to its @p blocks.
    void
    add_values(const unsigned int           cell,
               const Vector                &u,
               const Vector                &correction,
               std::vector<StiffnessBlock> &blocks) const;

    /// Adds the section's @p tangent at station @p k of @p cell to @p block.
    void
    add_station(const unsigned int                              cell,
                const unsigned int                              k,
                const FiniteStrainSectionOperator::CellTangent &tangent,
                StiffnessBlock                                 &block) const;

    /// Subtracts the assumed-strain terms of the section's @p tangents from
    /// @p block of the axis element @p cell
    /// (FiniteStrainSectionOperator::for_each_cell()).
    void
    subtract_assumed_strain(
      const unsigned int                                           cell,
      const std::vector<FiniteStrainSectionOperator::CellTangent> &tangents,
      StiffnessBlock                                              &block) const;

    const FiniteStrainSectionOperator green;
  };
} // namespace lamella

#endif
