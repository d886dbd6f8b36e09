// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_pointwise_section_operator_h
#define lamella_section_pointwise_section_operator_h

#include <lamella/section/section_operator.h>

#include <vector>

namespace lamella
{
  /// A section operator that integrates strains, stresses and generalized
  /// forces over the integration points s of a section with weights w_s,
  ///   epsilon(x_s) = sum_alpha q_alpha D_s Phi_alpha + q_alpha' D_y Phi_alpha,
  ///   W_0 = sum_s w_s D_s^T C epsilon,   W_1 = sum_s w_s D_y^T C epsilon,
  /// see SectionOperator. It applies to any section. The cost per axis point is
  /// proportional to the number of points s times functions nonzero at each.
  class PointwiseSectionOperator : public SectionOperator
  {
  public:
    /// Constructs the operator of the functions number @p list of @p space.
    PointwiseSectionOperator(const SectionSpace       &space,
                             std::vector<unsigned int> list)
      : SectionOperator(space, std::move(list))
    {}

    SectionForces
    forces(const FieldParts &q) const override;

    /// Returns the stiffness rows of section functions and modes.
    std::vector<FactorRow>
    stiffness() const override;

  private:
    /// The amplitude q of a section function and q', or the conjugate forces. q
    /// has one value per strain component: transverse shear may be assumed.
    struct Coefficient
    {
      Voigt  value;
      double derivative = 0.;
    };

    /// Coefficients of all section functions, axis point by axis point.
    using Coefficients = std::vector<Coefficient>;

    Coefficients
    coefficients(const FieldParts &q) const;

    /// Adds the forces and the energy at the integration point @p point, with
    /// @p law and @p weight, to @p work and @p energy of each axis point.
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
