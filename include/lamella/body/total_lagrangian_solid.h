// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_total_lagrangian_solid_h
#define lamella_body_total_lagrangian_solid_h

#include <lamella/body/solid.h>

namespace lamella
{
  /// A solid with finite rotations in the total Lagrangian formulation, with
  /// the displacement gradient H, Green's strain E and the second
  /// Piola-Kirchhoff stress S = C E. Nodal forces are
  ///   f_i = int grad N_i . (S (1 + H)) dV,
  /// over the undeformed body. Output has E and, as stress, R^T sigma R (Cauchy
  /// stress in axes that rotate with the material). Degree 2 only.
  class TotalLagrangianSolid : public Solid
  {
  public:
    /// Constructs the solid. Throws InputError for @p degree 1.
    TotalLagrangianSolid(const std::string                        &name,
                         const std::shared_ptr<const SectionMesh> &section,
                         const AxisMesh                           &axis,
                         const Placement                          &placement,
                         const unsigned int                        degree,
                         const SolidRefinement &refinement = {});

    bool
    has_finite_rotations() const override
    {
      return true;
    }
    std::vector<Vector>
    rigid_motions(const Vector &u) const override;
    void
    add_internal_forces(const Vector &u, Vector &f) const override;
    /// Calls @p use with the tangent stiffness of each locally owned
    /// hexahedron.
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
    FieldSample
    sample_at_element_point(const Location::Place &place,
                            const Vector          &u) const override;

  private:
    /// Returns the rotation of @p cell between its ends along the axis [rad].
    double
    rotation_along(const unsigned int cell, const Vector &u) const;

    /// Returns the matrix int grad N_i . D . grad N_k dV over @p cell, row by
    /// row, with @p D the derivative of the first Piola-Kirchhoff stress by H.
    std::vector<double>
    tangent_of(
      const unsigned int                                                  cell,
      const std::function<dealii::Tensor<2, 9>(const HexahedronPoint &)> &D)
      const;
  };
} // namespace lamella

#endif
