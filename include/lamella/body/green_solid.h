// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_green_solid_h
#define lamella_body_green_solid_h

#include <lamella/body/solid.h>
#include <lamella/section/finite_strain.h>

namespace lamella
{
  /**
   * A solid that turns by any angle: Total Lagrange on the hexahedra of a
   * Solid, as GreenBeam on the fields of a Beam. With the gradients H of the
   * shape functions' sum, Green's strain E and S = C E, over the undeformed
   * body
   *   f_i = int grad N_i . (S (1 + H)) dV,
   * and its tangent is their derivative. Samples have E, and as stress
   * R^T sigma R.
   *
   * Of degree 2 alone: the incompatible modes of degree 1 are those of small
   * strains.
   */
  class GreenSolid : public Solid
  {
  public:
    /// As the constructor of Solid. Throws InputError for degree 1.
    GreenSolid(const std::string                 &name,
               std::shared_ptr<const SectionMesh> section,
               const AxisMesh                    &axis,
               const Placement                   &placement,
               const unsigned int                 degree,
               const SolidRefinement             &refinement = {});

    bool
    turns() const override
    {
      return true;
    }
    std::vector<Vector>
    rigid_motions_at(const Vector &u) const override;
    void
    add_internal_forces(const Vector &u, Vector &f) const override;
    /// The mean strain along the axis is the root mean square over each
    /// hexahedron, its turn that between its ends along the axis.
    Deformation
    deformation(const Vector &u) const override;
    void
    for_each_block_of_heat(
      const Vector                                      &u,
      const std::function<void(const StiffnessBlock &)> &use) const override;

  protected:
    FieldSample
    sample_place(const Location::Place &place, const Vector &u) const override;
    /// A block for each own hexahedron.
    void
    for_each_tangent_block(
      const Vector                                      &u,
      const Vector                                      &correction,
      const bool                                         with_values,
      const std::function<void(const StiffnessBlock &)> &use) const override;

  private:
    /// H of @p u at @p point of @p cell.
    Gradient
    gradient_at(const unsigned int     cell,
                const HexahedronPoint &point,
                const Vector          &u) const;

    /// By how much @p cell turns from one of its ends along the axis to the
    /// other [rad].
    double
    turn_along(const unsigned int cell, const Vector &u) const;

    /// int grad N_i . D . grad N_k dV over @p cell, row by row, where @p D
    /// gives the derivative of the first stress at its integration points.
    std::vector<double>
    tangent_of(
      const unsigned int                                                  cell,
      const std::function<dealii::Tensor<2, 9>(const HexahedronPoint &)> &D)
      const;
  };
} // namespace lamella

#endif
