// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/section/pointwise_section_operator.h>

namespace lamella
{
  using namespace dealii;

  PointwiseSectionOperator::Coefficients
  PointwiseSectionOperator::coefficients(const FieldParts &q) const
  {
    FieldParts all;
    for (unsigned int p = 0; p < FieldPart::n; ++p)
      all[p] = space.in_section(list, q[p]);
    Coefficients result;
    result.reserve(all[FieldPart::value].m() * all[FieldPart::value].n());
    for (unsigned int k = 0; k < all[FieldPart::value].n(); ++k)
      for (unsigned int alpha = 0; alpha < all[FieldPart::value].m(); ++alpha)
        {
          Coefficient one;
          for (unsigned int c = 0; c < 6; ++c)
            one.value[c] =
              all[is_transverse_shear(c) ? FieldPart::shear_value :
                                           FieldPart::value](alpha, k);
          one.derivative = all[FieldPart::derivative](alpha, k);
          result.push_back(one);
        }
    return result;
  }



  void
  PointwiseSectionOperator::add_point(const SectionPoint  &point,
                                      const double         weight,
                                      const ElasticLaw    &law,
                                      const Coefficients  &q,
                                      Coefficients        &work,
                                      std::vector<double> &energy) const
  {
    const std::vector<unsigned int> &fields   = *point.fields;
    const unsigned int               n_fields = q.size() / energy.size();
    for (unsigned int k = 0; k < energy.size(); ++k)
      {
        const Coefficient *const here  = &q[k * n_fields];
        Coefficient *const       there = &work[k * n_fields];
        Voigt                    strain;
        for (unsigned int a = 0; a < fields.size(); ++a)
          {
            const Coefficient &one = here[fields[a]];
            for (unsigned int c = 0; c < 6; ++c)
              strain[c] += one.value[c] * point.in_plane[a][c] +
                           one.derivative * point.along[a][c];
          }
        const Voigt stress = weight * law.stress(strain);
        energy[k] += 0.5 * (stress * strain);
        for (unsigned int a = 0; a < fields.size(); ++a)
          {
            Coefficient &one = there[fields[a]];
            for (unsigned int c = 0; c < 6; ++c)
              one.value[c] += point.in_plane[a][c] * stress[c];
            one.derivative += point.along[a] * stress;
          }
      }
  }



  SectionForces
  PointwiseSectionOperator::forces(const FieldParts &q) const
  {
    const Section     &section    = space.section();
    const unsigned int n          = section.n_fields();
    const unsigned int n_stations = q[FieldPart::value].n();
    const Coefficients given      = coefficients(q);
    Coefficients       work(given.size());
    SectionForces      result(n, n_stations);
    // Some sections do not keep points that have weights, nor their laws.
    const bool   keeps_points = !section.integration_weights().empty();
    unsigned int s            = 0;
    section.for_each_point([&](const SectionPoint &point, const double weight) {
      if (keeps_points)
        add_point(
          point, weight, section.law_at_point(s++), given, work, result.energy);
      else
        add_point(point,
                  weight,
                  section.law(point.cell, point.position),
                  given,
                  work,
                  result.energy);
    });
    for (unsigned int k = 0; k < n_stations; ++k)
      for (unsigned int alpha = 0; alpha < n; ++alpha)
        {
          const Coefficient &one                  = work[k * n + alpha];
          const Voigt       &w                    = one.value;
          result.work[FieldPart::value](alpha, k) = w[0] + w[1] + w[2] + w[4];
          result.work[FieldPart::shear_value](alpha, k) = w[3] + w[5];
          result.work[FieldPart::derivative](alpha, k)  = one.derivative;
        }
    return on_list(space, list, result);
  }



  std::vector<FactorRow>
  PointwiseSectionOperator::stiffness() const
  {
    std::vector<bool> carried(space.n_fields(), false);
    for (const unsigned int alpha : list)
      carried[alpha] = true;
    return space.rows(carried);
  }
} // namespace lamella
