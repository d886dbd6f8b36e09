// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_pointwise_section_operator_h
#define lamella_section_pointwise_section_operator_h

#include <lamella/section/section_operator.h>

#include <vector>

namespace lamella
{
  /// A section operator by points of the section: strains, stresses, and work,
  ///   epsilon(x_s) = sum_alpha q_alpha D_s Phi_alpha + q_alpha' D_y Phi_alpha,
  ///   W_0 = sum_s w_s D_s^T C epsilon,   W_1 = sum_s w_s D_y^T C epsilon.
  /// For any section and any list, at a cost of (points) times (fields at a
  /// point) per station. Evaluates each point once for all stations.
  class PointwiseSectionOperator : public SectionOperator
  {
  public:
    PointwiseSectionOperator(const SectionSpace       &space,
                             std::vector<unsigned int> list)
      : SectionOperator(space, std::move(list))
    {}

    SectionForces
    forces(const FieldParts &q) const override;

    /// Returns the sparse rows of the section's matrices, and rows of modes.
    std::vector<FactorRow>
    stiffness() const override;

  private:
    /// Factors of a field's part of strains (transverse shear may have its own)
    /// and of its derivative, or their work.
    struct Coefficient
    {
      Voigt  value;
      double derivative = 0.;
    };

    /// Coefficients of each field of the section, station after station.
    using Coefficients = std::vector<Coefficient>;

    Coefficients
    coefficients(const FieldParts &q) const;

    /// Adds the work at @p point of @p law and @p weight [length^2] to @p work
    /// and to @p energy of each station.
    void
    add_point(const SectionPoint  &point,
              const double         weight,
              const ElasticLaw    &law,
              const Coefficients  &q,
              Coefficients        &work,
              std::vector<double> &energy) const;
  };
} // namespace lamella

#endif
