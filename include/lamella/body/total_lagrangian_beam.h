// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_total_lagrangian_beam_h
#define lamella_body_total_lagrangian_beam_h

#include <lamella/body/beam.h>
#include <lamella/section/finite_strain_section_operator.h>

namespace lamella
{
  /// A beam with finite rotations in the total Lagrangian formulation, with the
  /// kinematics of Beam. Green's strain and the second Piola-Kirchhoff stress
  /// give generalized forces W_0,alpha and W_1,alpha of a section
  /// (FiniteStrainSectionOperator), conjugate to the amplitude of section
  /// function alpha and its axial derivative. Nodal forces are
  ///   f_(i,alpha) = int N_i W_0,alpha + N_i' W_1,alpha dy,
  /// over the undeformed axis, for node i. Supports and dead loads are those of
  /// a Beam: displacements are linear in the DoFs.
  ///
  /// Output has Green's strain E and as stress R^T sigma R, the Cauchy stress
  /// in axes that rotate with the material. For output, E_yy and transverse
  /// shear strains are fitted by quadratic polynomials along each element.
  class TotalLagrangianBeam : public FiniteRotationBeam
  {
  public:
    /// Constructs the beam. Throws InputError unless axis elements are B4 and
    /// the theory is LE or TE-N, N > 1.
    TotalLagrangianBeam(const std::string                    &name,
                        const std::shared_ptr<const Section> &section,
                        const std::shared_ptr<const Axis>    &axis,
                        const Placement                      &placement);

    std::vector<Vector>
    rigid_motions(const Vector &u) const override;
    /// Calls @p use with the tangent stiffness of each locally owned axis
    /// element, one block per section cell.
    void
    for_each_stiffness_block(const Vector        &u,
                             const Vector        &correction,
                             const bool           with_values,
                             const BlockCallback &use) const override;
    Deformation
    deformation(const Vector &u) const override;
    std::vector<dealii::Point<3>>
    inverted_points(const Vector &u) const override;
    void
    for_each_thermal_block(const Vector        &u,
                           const BlockCallback &use) const override;

  protected:
    /// Returns the section forces, nonlinear in @p q due to Green's strain.
    SectionForces
    section_forces(const SectionOperator &section_operator,
                   const FieldParts      &q) const override;
    FieldSample
    sample_at(const SectionPoint &point,
              const AxisPoint    &on_axis,
              const Vector       &u) const override;


  private:
    /// Returns amplitudes (at @p on_axis) of functions in the cell of @p point.
    FieldParts
    parts_at(const SectionPoint &point,
             const AxisPoint    &on_axis,
             const Vector       &u) const;

    /// Returns Green's strain for output at the section point @p point and axis
    /// point @p on_axis, with the displacement gradient @p H there.
    Voigt
    strain_at(const SectionPoint &point,
              const AxisPoint    &on_axis,
              const Gradient     &H,
              const Vector       &u) const;

    /// Returns the rotation between the ends of axis element @p cell [rad].
    double
    rotation_along(const unsigned int cell, const Vector &u) const;

    /// Returns one matrix block per section cell for the axis element @p cell,
    /// with zeros if @p with_values is true, otherwise without values.
    std::vector<StiffnessBlock>
    make_blocks(const unsigned int cell, const bool with_values) const;

    /// Adds the tangent stiffness of the axis element @p cell to its @p blocks.
    void
    add_values(const unsigned int           cell,
               const Vector                &u,
               const Vector                &correction,
               std::vector<StiffnessBlock> &blocks) const;

    /// Adds the section @p tangent at Gauss point @p k of @p cell to @p block.
    void
    add_station(const unsigned int                              cell,
                const unsigned int                              k,
                const FiniteStrainSectionOperator::CellTangent &tangent,
                StiffnessBlock                                 &block) const;

    /// Subtracts the assumed-strain terms of the section @p tangents from
    /// @p block of the axis element @p cell (FiniteStrainSectionOperator).
    void
    subtract_assumed_strain(
      const unsigned int                                           cell,
      const std::vector<FiniteStrainSectionOperator::CellTangent> &tangents,
      StiffnessBlock                                              &block) const;

    const FiniteStrainSectionOperator green;
  };
} // namespace lamella

#endif
