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
   * Beam. Displacements add up as ever: rows of displacements, supports and
   * dead loads are those of the Beam.
   *
   * Samples have Green's strain E, and as stress R^T sigma R, Cauchy's in axes
   * that turn with the material (PolarDecomposition): where nothing turns these
   * are the body's axes, and ply axes turn along, so that both mean what they
   * do of a Beam. second_order() is that of small rotations. E_yy and the
   * transverse shears of samples are least-squares polynomials of degree 2
   * through their values at the stations. Their other parts oscillate between
   * stations without physical meaning (GreenAnswer).
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

    bool
    turns() const override
    {
      return true;
    }
    std::vector<Vector>
    rigid_motions_at(const Vector &u) const override;
    Deformation
    deformation(const Vector &u) const override;
    void
    for_each_block_of_heat(
      const Vector                                      &u,
      const std::function<void(const StiffnessBlock &)> &use) const override;

  protected:
    /// Those of Green's strain.
    SectionForces
    section_forces(const SectionAnswer &answer,
                   const FieldParts    &q) const override;
    FieldSample
    sample_at(const SectionPoint &point,
              const AxisPoint    &on_axis,
              const Vector       &u) const override;

    /// A block for each own element of the axis and cell of the section.
    void
    for_each_tangent_block(
      const Vector                                      &u,
      const Vector                                      &correction,
      const bool                                         with_values,
      const std::function<void(const StiffnessBlock &)> &use) const override;

  private:
    /// The coefficients of @p u of the fields at @p point of the section, at
    /// the one station @p on_axis.
    FieldParts
    parts_at(const SectionPoint &point,
             const AxisPoint    &on_axis,
             const Vector       &u) const;

    /// Returns the smoothed strain of samples of @p point at @p on_axis, with
    /// the displacement gradient @p H there.
    Voigt
    strain_at(const SectionPoint &point,
              const AxisPoint    &on_axis,
              const Gradient     &H,
              const Vector       &u) const;

    /// How far the middle of the section turns from one end of the axis element
    /// @p cell to the other [rad].
    double
    turn_along(const unsigned int cell, const Vector &u) const;

    /// Its blocks of the axis element @p cell, one for each cell of the
    /// section, without values; with zeros.
    std::vector<StiffnessBlock>
    empty_blocks(const unsigned int cell) const;
    std::vector<StiffnessBlock>
    zero_blocks(const unsigned int cell) const;

    /// The block of the axis element @p cell and the section's cell whose
    /// fields are @p on_section, without values.
    StiffnessBlock
    empty_block(const unsigned int               cell,
                const std::vector<unsigned int> &on_section) const;

    /// Adds the values of the axis element @p cell to its @p blocks.
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

    /// Subtracts the assumed-strain terms of the section's @p tangents from
    /// @p block of the axis element @p cell (GreenAnswer::for_each_cell()).
    void
    take_off(const unsigned int                           cell,
             const std::vector<GreenAnswer::CellTangent> &tangents,
             StiffnessBlock                              &block) const;

    const GreenAnswer green;
  };
} // namespace lamella

#endif
