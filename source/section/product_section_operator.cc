// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/section/product_section_operator.h>

#include <algorithm>

namespace lamella
{
  using namespace dealii;

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
} // namespace lamella
