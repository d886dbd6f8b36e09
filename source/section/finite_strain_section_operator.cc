// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/section/finite_strain_section_operator.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Of points that have the same fields the matrix of H, nine rows each.
    LAPACKFullMatrix<double>
    gradients_of_fields(const std::vector<SectionPoint> &points)
    {
      const unsigned int       n = points[0].fields->size();
      LAPACKFullMatrix<double> G(9 * points.size(), 2 * n);
      for (unsigned int p = 0; p < points.size(); ++p)
        for (unsigned int a = 0; a < n; ++a)
          {
            const auto along = field_derivatives(points[p], a);
            for (unsigned int c = 0; c < 3; ++c)
              {
                G(9 * p + c, a)         = along[0][c];
                G(9 * p + 3 + c, n + a) = points[p].value[a][c];
                G(9 * p + 6 + c, a)     = along[1][c];
              }
          }
      return G;
    }



    /// Adds @p weight D G to @p DG, nine rows from @p first on.
    void
    add_product(const Tensor<2, 9>             &D,
                const double                    weight,
                const LAPACKFullMatrix<double> &G,
                const unsigned int              first,
                LAPACKFullMatrix<double>       &DG)
    {
      for (unsigned int b = 0; b < G.n(); ++b)
        for (unsigned int r = 0; r < 9; ++r)
          for (unsigned int s = 0; s < 9; ++s)
            DG(first + r, b) += weight * D[r][s] * G(first + s, b);
    }



    /// Sets row @p p of @p rows to the work of @p P on columns of @p G.
    void
    set_row(const unsigned int              p,
            const Tensor<2, 3>             &P,
            const LAPACKFullMatrix<double> &G,
            LAPACKFullMatrix<double>       &rows)
    {
      for (unsigned int b = 0; b < G.n(); ++b)
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int c = 0; c < 3; ++c)
            rows(p, b) += P[i][c] * G(9 * p + 3 * i + c, b);
    }
  } // namespace



  FiniteStrainSectionOperator::FiniteStrainSectionOperator(
    const SectionSpace &space,
    const unsigned int  n_stations)
    : space(space)
  {
    const unsigned int degree = n_stations - 1;
    const QGauss<1>    rule(n_stations);
    weights = rule.get_weights();
    for (unsigned int k = 0; k < n_stations; ++k)
      modes.push_back(std::sqrt(2. * degree + 1.) *
                      legendre(degree, 2. * rule.point(k)[0] - 1.)[degree]);
    const Section &section = space.section();
    Assert(space.n_fields() == section.n_fields() &&
             !section.completes_strains(),
           ExcNotImplemented());
    std::vector<std::vector<SectionPoint>> points;
    section.for_each_point([&](const SectionPoint &at, const double weight) {
      if (cells.empty() || cells.back().fields != at.fields)
        {
          cells.emplace_back();
          cells.back().fields = at.fields;
          points.emplace_back();
        }
      cells.back().points.push_back(
        {weight, section.law(at.cell, at.position), at.cell, at.position});
      points.back().push_back(at);
    });
    for (unsigned int c = 0; c < cells.size(); ++c)
      cells[c].G = gradients_of_fields(points[c]);
  }



  std::vector<const std::vector<unsigned int> *>
  FiniteStrainSectionOperator::fields_of_cells() const
  {
    std::vector<const std::vector<unsigned int> *> lists;
    for (const Cell &cell : cells)
      lists.push_back(cell.fields);
    return lists;
  }



  std::vector<std::vector<Gradient>>
  FiniteStrainSectionOperator::gradients(const Cell       &cell,
                                         const FieldParts &q) const
  {
    const unsigned int n = cell.fields->size(), n_points = cell.points.size();
    std::vector<std::vector<Gradient>> at_stations(
      q[FieldPart::value].n(), std::vector<Gradient>(n_points));
    Vector coefficients(2 * n), H(cell.G.m());
    for (unsigned int k = 0; k < at_stations.size(); ++k)
      {
        for (unsigned int a = 0; a < n; ++a)
          {
            coefficients[a] = q[FieldPart::value]((*cell.fields)[a], k);
            coefficients[n + a] =
              q[FieldPart::derivative]((*cell.fields)[a], k);
          }
        cell.G.vmult(H, coefficients);
        for (unsigned int p = 0; p < n_points; ++p)
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int c = 0; c < 3; ++c)
              at_stations[k][p][i][c] = H[9 * p + 3 * i + c];
      }
    return at_stations;
  }



  void
  FiniteStrainSectionOperator::lower(std::vector<Voigt> &values) const
  {
    constexpr unsigned int yy  = 1;
    double                 sum = 0.;
    for (unsigned int k = 0; k < values.size(); ++k)
      sum += share(k) * values[k][yy];
    for (unsigned int k = 0; k < values.size(); ++k)
      values[k][yy] -= modes[k] * sum;
  }



  std::vector<Vector>
  FiniteStrainSectionOperator::first_stresses(
    const Cell                               &cell,
    const std::vector<std::vector<Gradient>> &H,
    std::vector<double>                      &energy) const
  {
    std::vector<Vector> P(H.size(), Vector(cell.G.m()));
    for (unsigned int p = 0; p < cell.points.size(); ++p)
      {
        std::vector<Voigt> strain, stress;
        for (unsigned int k = 0; k < H.size(); ++k)
          strain.push_back(green_strain(H[k][p]));
        lower(strain);
        for (unsigned int k = 0; k < H.size(); ++k)
          {
            stress.push_back(cell.points[p].weight *
                             cell.points[p].law.stress(strain[k]));
            energy[k] += 0.5 * (stress[k] * strain[k]);
          }
        lower(stress);
        for (unsigned int k = 0; k < H.size(); ++k)
          {
            const Tensor<2, 3> at_point = first_stress(H[k][p], stress[k]);
            for (unsigned int i = 0; i < 3; ++i)
              for (unsigned int c = 0; c < 3; ++c)
                P[k][9 * p + 3 * i + c] = at_point[i][c];
          }
      }
    return P;
  }



  SectionForces
  FiniteStrainSectionOperator::forces(const FieldParts &q) const
  {
    const unsigned int n_stations = q[FieldPart::value].n();
    SectionForces      result(space.n_fields(), n_stations);
    for (const Cell &cell : cells)
      {
        const unsigned int        n = cell.fields->size();
        const std::vector<Vector> P =
          first_stresses(cell, gradients(cell, q), result.energy);
        Vector work(2 * n);
        for (unsigned int k = 0; k < n_stations; ++k)
          {
            cell.G.Tvmult(work, P[k]);
            for (unsigned int a = 0; a < n; ++a)
              {
                const unsigned int alpha = (*cell.fields)[a];
                result.work[FieldPart::value](alpha, k) += work[a];
                result.work[FieldPart::derivative](alpha, k) += work[n + a];
              }
          }
      }
    return result;
  }



  Stretch
  FiniteStrainSectionOperator::largest(const FieldParts &q) const
  {
    Stretch             found;
    double              area = 0.;
    std::vector<double> squares(q[FieldPart::value].n(), 0.);
    for (const Cell &cell : cells)
      {
        const auto H = gradients(cell, q);
        for (unsigned int p = 0; p < cell.points.size(); ++p)
          {
            const double weight = cell.points[p].weight;
            area += weight;
            for (unsigned int k = 0; k < squares.size(); ++k)
              {
                const Stretch here = stretch_of(H[k][p]);
                found.rotation     = std::max(found.rotation, here.rotation);
                found.strain       = std::max(found.strain, here.strain);
                squares[k] += weight * here.along * here.along;
              }
          }
      }
    for (const double square : squares)
      found.along = std::max(found.along, std::sqrt(square / area));
    return found;
  }



  std::optional<std::pair<unsigned int, Point<2>>>
  FiniteStrainSectionOperator::inverted_point(const FieldParts &q) const
  {
    for (const Cell &cell : cells)
      {
        const auto H = gradients(cell, q);
        for (unsigned int k = 0; k < H.size(); ++k)
          for (unsigned int p = 0; p < cell.points.size(); ++p)
            if (is_inverted(H[k][p]))
              return std::make_pair(k, cell.points[p].position);
      }
    return std::nullopt;
  }



  FiniteStrainSectionOperator::CellTangent
  FiniteStrainSectionOperator::tangent_of(
    const Cell                                            &cell,
    const std::function<Tensor<2, 9>(const unsigned int)> &D)
  {
    LAPACKFullMatrix<double> DG(cell.G.m(), cell.G.n());
    for (unsigned int p = 0; p < cell.points.size(); ++p)
      add_product(D(p), cell.points[p].weight, cell.G, 9 * p, DG);
    CellTangent tangent;
    tangent.fields = cell.fields;
    tangent.matrix.reinit(DG.n(), DG.n());
    cell.G.Tmmult(tangent.matrix, DG);
    return tangent;
  }



  FiniteStrainSectionOperator::CellTangent
  FiniteStrainSectionOperator::tangent_at(const Cell                  &cell,
                                          const std::vector<Gradient> &H,
                                          const std::vector<Voigt>    &second)
  {
    CellTangent tangent = tangent_of(cell, [&](const unsigned int p) {
      return green_tangent(H[p], second[p], cell.points[p].law);
    });
    Voigt       along;
    along[1] = 1.;
    tangent.stretch.reinit(H.size(), cell.G.n());
    tangent.on_stretch.reinit(H.size(), cell.G.n());
    for (unsigned int p = 0; p < H.size(); ++p)
      {
        const Voigt C_yy = cell.points[p].law.stress(along);
        set_row(p, first_stress(H[p], along), cell.G, tangent.stretch);
        set_row(p,
                cell.points[p].weight *
                  first_stress(H[p], C_yy - 0.5 * C_yy[1] * along),
                cell.G,
                tangent.on_stretch);
      }
    return tangent;
  }



  void
  FiniteStrainSectionOperator::for_each_cell(
    const FieldParts                                            &q,
    const FieldParts                                            &correction,
    const std::function<void(const std::vector<CellTangent> &)> &use) const
  {
    for (const Cell &cell : cells)
      {
        const auto H = gradients(cell, q), dH = gradients(cell, correction);
        std::vector<std::vector<Voigt>> second(
          H.size(), std::vector<Voigt>(cell.points.size()));
        for (unsigned int p = 0; p < cell.points.size(); ++p)
          {
            std::vector<Voigt> values;
            for (unsigned int k = 0; k < H.size(); ++k)
              values.push_back(predicted_strain(H[k][p], dH[k][p]));
            lower(values);
            for (Voigt &value : values)
              value = cell.points[p].law.stress(value);
            lower(values);
            for (unsigned int k = 0; k < H.size(); ++k)
              second[k][p] = values[k];
          }
        std::vector<CellTangent> tangents;
        for (unsigned int k = 0; k < H.size(); ++k)
          tangents.push_back(tangent_at(cell, H[k], second[k]));
        use(tangents);
      }
  }



  void
  FiniteStrainSectionOperator::for_each_cell_of_stress(
    const std::function<Voigt(const unsigned int, const dealii::Point<2> &)>
                                                   &stress,
    const std::function<void(const CellTangent &)> &use) const
  {
    for (const Cell &cell : cells)
      use(tangent_of(cell, [&](const unsigned int p) {
        const Point &at = cell.points[p];
        return stress_tangent(stress(at.cell, at.position));
      }));
  }
} // namespace lamella
