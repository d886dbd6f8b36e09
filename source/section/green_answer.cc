// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/section/green_answer.h>

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
            const auto along = derivatives_of_field(points[p], a);
            for (unsigned int c = 0; c < 3; ++c)
              {
                G(9 * p + c, a)         = along[0][c];
                G(9 * p + 3 + c, n + a) = points[p].value[a][c];
                G(9 * p + 6 + c, a)     = along[1][c];
              }
          }
      return G;
    }



    /// Adds @p weight times D times the nine rows of @p G from @p first on to
    /// those of @p DG.
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
  } // namespace



  GreenAnswer::GreenAnswer(const FieldSpace &space)
    : space(space)
  {
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
  GreenAnswer::fields_of_cells() const
  {
    std::vector<const std::vector<unsigned int> *> lists;
    for (const Cell &cell : cells)
      lists.push_back(cell.fields);
    return lists;
  }



  std::vector<Gradient>
  GreenAnswer::gradients(const Cell        &cell,
                         const FieldParts  &q,
                         const unsigned int k) const
  {
    const unsigned int n = cell.fields->size();
    Vector             coefficients(2 * n), H(cell.G.m());
    for (unsigned int a = 0; a < n; ++a)
      {
        coefficients[a]     = q[FieldPart::value]((*cell.fields)[a], k);
        coefficients[n + a] = q[FieldPart::derivative]((*cell.fields)[a], k);
      }
    cell.G.vmult(H, coefficients);
    std::vector<Gradient> at_points(cell.points.size());
    for (unsigned int p = 0; p < at_points.size(); ++p)
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int c = 0; c < 3; ++c)
          at_points[p][i][c] = H[9 * p + 3 * i + c];
    return at_points;
  }



  SectionForces
  GreenAnswer::forces(const FieldParts &q) const
  {
    const unsigned int n_stations = q[FieldPart::value].n();
    SectionForces      result(space.n_fields(), n_stations);
    for (const Cell &cell : cells)
      for (unsigned int k = 0; k < n_stations; ++k)
        {
          const unsigned int          n = cell.fields->size();
          const std::vector<Gradient> H = gradients(cell, q, k);
          Vector                      P(cell.G.m()), work(2 * n);
          for (unsigned int p = 0; p < H.size(); ++p)
            {
              const Voigt strain = green_strain(H[p]),
                          stress = cell.points[p].weight *
                                   cell.points[p].law.stress(strain);
              result.energy[k] += 0.5 * (stress * strain);
              const Tensor<2, 3> at_point = first_stress(H[p], stress);
              for (unsigned int i = 0; i < 3; ++i)
                for (unsigned int c = 0; c < 3; ++c)
                  P[9 * p + 3 * i + c] = at_point[i][c];
            }
          cell.G.Tvmult(work, P);
          for (unsigned int a = 0; a < n; ++a)
            {
              const unsigned int alpha = (*cell.fields)[a];
              result.work[FieldPart::value](alpha, k) += work[a];
              result.work[FieldPart::derivative](alpha, k) += work[n + a];
            }
        }
    return result;
  }



  Stretch
  GreenAnswer::largest(const FieldParts &q) const
  {
    Stretch found;
    for (unsigned int k = 0; k < q[FieldPart::value].n(); ++k)
      {
        double area = 0., squares = 0.;
        for (const Cell &cell : cells)
          {
            const std::vector<Gradient> H = gradients(cell, q, k);
            for (unsigned int p = 0; p < H.size(); ++p)
              {
                const Stretch here   = stretch_of(H[p]);
                const double  weight = cell.points[p].weight;
                found.turn           = std::max(found.turn, here.turn);
                found.strain         = std::max(found.strain, here.strain);
                area += weight;
                squares += weight * here.along * here.along;
              }
          }
        found.along = std::max(found.along, std::sqrt(squares / area));
      }
    return found;
  }



  GreenAnswer::CellTangent
  GreenAnswer::tangent_of(
    const Cell                                            &cell,
    const std::function<Tensor<2, 9>(const unsigned int)> &D)
  {
    LAPACKFullMatrix<double> DG(cell.G.m(), cell.G.n());
    for (unsigned int p = 0; p < cell.points.size(); ++p)
      add_product(D(p), cell.points[p].weight, cell.G, 9 * p, DG);
    CellTangent tangent{cell.fields, LAPACKFullMatrix<double>(DG.n(), DG.n())};
    cell.G.Tmmult(tangent.matrix, DG);
    return tangent;
  }



  void
  GreenAnswer::for_each_cell(
    const FieldParts                               &q,
    const FieldParts                               &correction,
    const unsigned int                              k,
    const std::function<void(const CellTangent &)> &use) const
  {
    for (const Cell &cell : cells)
      {
        const std::vector<Gradient> H  = gradients(cell, q, k),
                                    dH = gradients(cell, correction, k);
        use(tangent_of(cell, [&](const unsigned int p) {
          return green_tangent(H[p], dH[p], cell.points[p].law);
        }));
      }
  }



  void
  GreenAnswer::for_each_cell_of_stress(
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
