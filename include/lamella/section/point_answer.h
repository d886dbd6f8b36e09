// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_section_point_answer_h
#define lamella_section_point_answer_h

#include <lamella/section/section_answer.h>

#include <vector>

namespace lamella
{
  /**
   * By the points of the section, with the few fields that live at each: strain
   * first, then stress, then its work,
   *   epsilon(x_s) = sum_alpha q_alpha D_s Phi_alpha + q_alpha' D_y Phi_alpha,
   *   W_0 = sum_s w_s D_s^T C epsilon,   W_1 = sum_s w_s D_y^T C epsilon.
   * For any section and any list; costs (points) times (fields at a point) a
   * station. A point is looked at once for all stations.
   */
  class PointAnswer : public SectionAnswer
  {
  public:
    PointAnswer(const FieldSpace &space, std::vector<unsigned int> list)
      : SectionAnswer(space, std::move(list))
    {}

    SectionForces
    forces(const FieldParts &q) const override;

    /// The sparse rows of the section's matrices, and those of modes.
    std::vector<FactorRow>
    stiffness() const override;

  private:
    /// Of a field what multiplies or collects its part of each strain
    /// (transverse shear strains may have values of their own), and its
    /// derivative.
    struct Coefficient
    {
      Voigt  value;
      double derivative = 0.;
    };

    /// A number for each field of the section, station after station.
    using Coefficients = std::vector<Coefficient>;

    Coefficients
    coefficients(const FieldParts &q) const;

    /// Adds the work at @p point, whose law is @p law, to @p work and to
    /// @p energy, of each station; @p weight is what the point stands for
    /// [length^2].
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
