// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/section/section_operator.h>

#include <algorithm>

namespace lamella
{
  using namespace dealii;

  FieldParts
  field_parts(const unsigned int n_fields, const unsigned int n_stations)
  {
    FieldParts parts;
    for (LAPACKFullMatrix<double> &part : parts)
      part.reinit(n_fields, n_stations);
    return parts;
  }



  SectionForces
  on_list(const SectionSpace              &space,
          const std::vector<unsigned int> &list,
          const SectionForces             &forces)
  {
    SectionForces result;
    for (unsigned int p = 0; p < FieldPart::n; ++p)
      result.work[p] = space.on_list(list, forces.work[p]);
    result.energy = forces.energy;
    return result;
  }



  double
  SectionOperator::largest_rotation(const FieldParts &q) const
  {
    FieldParts all;
    for (unsigned int p = 0; p < FieldPart::n; ++p)
      all[p] = space.in_section(list, q[p]);
    const auto &points  = space.section().integration_points();
    double      largest = 0.;
    for (unsigned int s = 0; s < points.size(); s += stride)
      for (unsigned int k = 0; k < all[FieldPart::value].n(); ++k)
        {
          const SectionPoint &point = points[s];
          Tensor<1, 3>        slope;
          double              twist = 0., strain_xy = 0., strain_yz = 0.;
          for (unsigned int a = 0; a < point.fields->size(); ++a)
            {
              const unsigned int alpha = (*point.fields)[a];
              const double       shear = all[FieldPart::shear_value](alpha, k),
                           along       = all[FieldPart::derivative](alpha, k);
              slope += along * point.value[a];
              twist += all[FieldPart::value](alpha, k) * point.twist[a];
              strain_xy +=
                shear * point.in_plane[a][3] + along * point.along[a][3];
              strain_yz +=
                shear * point.in_plane[a][5] + along * point.along[a][5];
            }
          // curl u / 2 with d u_y / dz = gamma_yz - d u_z / dy and so on.
          const Point<3> rotation(slope[2] - 0.5 * strain_yz,
                                  twist,
                                  0.5 * strain_xy - slope[0]);
          largest = std::max(largest, rotation.norm());
        }
    return largest;
  }



  std::unique_ptr<const SectionOperator>
  make_section_operator(const SectionSpace       &space,
                        std::vector<unsigned int> list,
                        const bool                assumed_shear)
  {
    if (ProductSectionOperator::is_possible(space, list, assumed_shear))
      return std::make_unique<ProductSectionOperator>(space,
                                                      std::move(list),
                                                      assumed_shear);
    return std::make_unique<PointwiseSectionOperator>(space, std::move(list));
  }



  namespace
  {
    /// Number of points that determine the rotation of smooth modes.
    unsigned int
    stride_of(const SectionSpace &space)
    {
      constexpr std::size_t enough = 200;
      return space.section().spans_the_section() ?
               1 :
               std::max<std::size_t>(
                 1, space.section().integration_points().size() / enough);
    }
  } // namespace



  bool
  ProductSectionOperator::is_possible(const SectionSpace              &space,
                                      const std::vector<unsigned int> &fields,
                                      const bool assumed_shear)
  {
    return space.section().spans_the_section() ?
             space.n_modes() == 0 :
             !assumed_shear && space.is_dense(fields);
  }



  ProductSectionOperator::ProductSectionOperator(
    const SectionSpace       &space,
    std::vector<unsigned int> fields,
    const bool                assumed_shear)
    : SectionOperator(space, std::move(fields), stride_of(space))
    , parts(assumed_shear ? std::vector<unsigned int>{FieldPart::value,
                                                      FieldPart::shear_value,
                                                      FieldPart::derivative} :
                            std::vector<unsigned int>{FieldPart::value,
                                                      FieldPart::derivative})
  {
    Assert(is_possible(space, list, assumed_shear), ExcInternalError());
    const unsigned int n = list.size();
    S.reinit(parts.size() * n, parts.size() * n);
    for (unsigned int q = 0; q < parts.size(); ++q)
      for (unsigned int b = 0; b < n; ++b)
        for (unsigned int p = 0; p < parts.size(); ++p)
          for (unsigned int a = 0; a < n; ++a)
            S(p * n + a, q * n + b) = product(parts[p], parts[q], a, b);
  }



  double
  ProductSectionOperator::product(const unsigned int p,
                                  const unsigned int q,
                                  const unsigned int a,
                                  const unsigned int b) const
  {
    const unsigned int alpha = list[a], beta = list[b];
    if (!space.section().spans_the_section())
      return space.dense_S(p == FieldPart::derivative,
                           q ==
                             FieldPart::derivative)(space.dense_number(alpha),
                                                    space.dense_number(beta));
    const auto moment = [&](const unsigned int i, const unsigned int j) {
      return space.section().moments(i, j)(alpha, beta);
    };
    using namespace FieldPart;
    // Values are one part or two.
    if (parts.size() == n || (p == derivative && q == derivative))
      return moment(p, q);
    if (p == derivative)
      return moment(p, value) + moment(p, shear_value);
    if (q == derivative)
      return moment(value, q) + moment(shear_value, q);
    return moment(value, value) +
           (moment(value, shear_value) + moment(shear_value, value) +
            moment(shear_value, shear_value));
  }



  unsigned int
  ProductSectionOperator::first_row(const unsigned int p) const
  {
    return list.size() *
           (p == FieldPart::value ?
              0 :
              parts.size() - (p == FieldPart::derivative ? 1 : 2));
  }



  SectionForces
  ProductSectionOperator::forces(const FieldParts &q) const
  {
    const unsigned int n = list.size(), n_stations = q[FieldPart::value].n();
    const double       h     = space.section().element().reference_length();
    const unsigned int shear = first_row(FieldPart::shear_value),
                       along = first_row(FieldPart::derivative);
    LAPACKFullMatrix<double> strains(S.m(), n_stations),
      works(S.m(), n_stations);
    for (unsigned int k = 0; k < n_stations; ++k)
      {
        for (const unsigned int part : parts)
          std::copy_n(&q[part](0, k), n, &strains(first_row(part), k));
        for (const auto &[translation, slope] : RigidField::bending)
          {
            strains(along + translation, k) += strains(shear + slope, k) / h;
            strains(shear + slope, k) = 0.;
          }
      }
    S.mmult(works, strains);

    SectionForces result(n, n_stations);
    for (unsigned int k = 0; k < n_stations; ++k)
      {
        for (unsigned int a = 0; a < S.m(); ++a)
          result.energy[k] += 0.5 * strains(a, k) * works(a, k);
        for (const auto &[translation, slope] : RigidField::bending)
          works(shear + slope, k) = works(along + translation, k) / h;
        for (const unsigned int part : parts)
          std::copy_n(&works(first_row(part), k), n, &result.work[part](0, k));
      }
    return result;
  }



  std::array<double, 5>
  ProductSectionOperator::entries(const unsigned int a,
                                  const unsigned int b) const
  {
    const unsigned int shear = first_row(FieldPart::shear_value),
                       along = first_row(FieldPart::derivative);
    std::array<double, 5> result{
      {S(a, b), S(a, along + b), S(along + a, b), S(along + a, along + b), 0.}};
    if (parts.size() == FieldPart::n)
      {
        result[4] = S(a, shear + b) + S(shear + a, b) + S(shear + a, shear + b);
        result[0] += result[4];
        result[1] += S(shear + a, along + b);
        result[2] += S(along + a, shear + b);
      }
    return result;
  }



  std::vector<FactorRow>
  ProductSectionOperator::stiffness() const
  {
    std::vector<FactorRow> rows(space.n_fields());
    for (unsigned int a = 0; a < list.size(); ++a)
      {
        FactorRow &row = rows[list[a]];
        row.columns    = list;
        row.entries.reserve(list.size());
        for (unsigned int b = 0; b < list.size(); ++b)
          row.entries.push_back(entries(a, b));
      }
    return rows;
  }



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
