// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/section/green_answer.h>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Where i and j stand in the order of Eq. 4.
    constexpr unsigned int place[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};

    /// E_ij of H_i . H_j / 2 alone, shears twice.
    Voigt
    quadratic_strain(const Gradient &H)
    {
      Voigt e;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = i; j < 3; ++j)
          e[place[i][j]] = (i == j ? 0.5 : 1.) * (H[i] * H[j]);
      return e;
    }



    Tensor<2, 3>
    unpacked(const Voigt &s)
    {
      Tensor<2, 3> S;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          S[i][j] = s[place[i][j]];
      return S;
    }



    /// dE / dH at H, with F_j = e_j + H_j: a row a strain, a column for each
    /// component of H, row after row of it.
    std::array<std::array<double, 9>, 6>
    strain_derivative(const Gradient &H)
    {
      Tensor<2, 3> F = H;
      for (unsigned int i = 0; i < 3; ++i)
        F[i][i] += 1.;
      std::array<std::array<double, 9>, 6> B{};
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = i; j < 3; ++j)
          for (unsigned int c = 0; c < 3; ++c)
            {
              B[place[i][j]][3 * i + c] += i == j ? F[i][c] : F[j][c];
              if (i != j)
                B[place[i][j]][3 * j + c] += F[i][c];
            }
      return B;
    }



    /// B^T C B + S (x) 1, times @p weight.
    std::array<std::array<double, 9>, 9>
    point_tangent(const Gradient     &H,
                  const ElasticLaw   &law,
                  const Tensor<2, 3> &S,
                  const double        weight)
    {
      const auto                           B = strain_derivative(H);
      std::array<std::array<double, 9>, 9> D{};
      for (unsigned int n = 0; n < 9; ++n)
        {
          Voigt column;
          for (unsigned int e = 0; e < 6; ++e)
            column[e] = B[e][n];
          const Voigt stress = law.stress(column);
          for (unsigned int m = 0; m < 9; ++m)
            for (unsigned int e = 0; e < 6; ++e)
              D[m][n] += weight * B[e][m] * stress[e];
        }
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          for (unsigned int c = 0; c < 3; ++c)
            D[3 * i + c][3 * j + c] += weight * S[i][j];
      return D;
    }
  } // namespace



  Voigt
  green_strain(const Gradient &H)
  {
    Voigt e = quadratic_strain(H);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        e[place[i][j]] += H[i][j];
    return e;
  }



  GreenAnswer::GreenAnswer(const FieldSpace &space)
    : space(space)
  {
    const Section &section = space.section();
    Assert(space.n_fields() == section.n_fields() &&
             !section.completes_strains(),
           ExcNotImplemented());
    section.for_each_point([&](const SectionPoint &at, const double weight) {
      if (cells.empty() || cells.back().fields != at.fields)
        cells.push_back({at.fields, {}});
      Point point{weight, section.law(at.cell, at.position), at.value, {}, {}};
      for (unsigned int a = 0; a < at.fields->size(); ++a)
        {
          // D_s Phi and the twist hold all derivatives within the section.
          const Voigt &e = at.in_plane[a];
          point.along_x.push_back(
            Tensor<1, 3>({e[0], e[3], 0.5 * e[4] - at.twist[a]}));
          point.along_z.push_back(
            Tensor<1, 3>({0.5 * e[4] + at.twist[a], e[5], e[2]}));
        }
      cells.back().points.push_back(std::move(point));
    });
  }



  std::vector<const std::vector<unsigned int> *>
  GreenAnswer::fields_of_cells() const
  {
    std::vector<const std::vector<unsigned int> *> lists;
    for (const Cell &cell : cells)
      lists.push_back(cell.fields);
    return lists;
  }



  Gradient
  GreenAnswer::gradient(const Cell        &cell,
                        const Point       &point,
                        const FieldParts  &q,
                        const unsigned int k) const
  {
    Gradient H;
    for (unsigned int a = 0; a < cell.fields->size(); ++a)
      {
        const unsigned int alpha = (*cell.fields)[a];
        const double       value = q[FieldPart::value](alpha, k);
        H[0] += value * point.along_x[a];
        H[1] += q[FieldPart::derivative](alpha, k) * point.value[a];
        H[2] += value * point.along_z[a];
      }
    return H;
  }



  SectionForces
  GreenAnswer::forces(const FieldParts &q) const
  {
    const unsigned int n_stations = q[FieldPart::value].n();
    SectionForces      result(space.n_fields(), n_stations);
    for (const Cell &cell : cells)
      for (const Point &point : cell.points)
        for (unsigned int k = 0; k < n_stations; ++k)
          {
            const Gradient H      = gradient(cell, point, q, k);
            const Voigt    strain = green_strain(H),
                        stress    = point.weight * point.law.stress(strain);
            result.energy[k] += 0.5 * (stress * strain);
            // First Piola-Kirchhoff, a row a direction: S (1 + H).
            const Tensor<2, 3> S = unpacked(stress), P = S + S * H;
            for (unsigned int a = 0; a < cell.fields->size(); ++a)
              {
                const unsigned int alpha = (*cell.fields)[a];
                result.work[FieldPart::value](alpha, k) +=
                  P[0] * point.along_x[a] + P[2] * point.along_z[a];
                result.work[FieldPart::derivative](alpha, k) +=
                  P[1] * point.value[a];
              }
          }
    return result;
  }



  std::array<std::array<double, 9>, 9>
  GreenAnswer::tangent_at(const Cell        &cell,
                          const Point       &point,
                          const FieldParts  &q,
                          const FieldParts  &correction,
                          const unsigned int k) const
  {
    const Gradient H         = gradient(cell, point, q, k);
    const Voigt    predicted = point.law.stress(
      green_strain(H) - quadratic_strain(gradient(cell, point, correction, k)));
    return point_tangent(H, point.law, unpacked(predicted), point.weight);
  }



  LAPACKFullMatrix<double>
  GreenAnswer::gradients(const Cell &cell) const
  {
    const unsigned int       n = cell.fields->size();
    LAPACKFullMatrix<double> G(9 * cell.points.size(), 2 * n);
    for (unsigned int p = 0; p < cell.points.size(); ++p)
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int c = 0; c < 3; ++c)
          {
            G(9 * p + c, a)         = cell.points[p].along_x[a][c];
            G(9 * p + 3 + c, n + a) = cell.points[p].value[a][c];
            G(9 * p + 6 + c, a)     = cell.points[p].along_z[a][c];
          }
    return G;
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
        const LAPACKFullMatrix<double> G = gradients(cell);
        LAPACKFullMatrix<double>       DG(G.m(), G.n());
        for (unsigned int p = 0; p < cell.points.size(); ++p)
          {
            const auto D = tangent_at(cell, cell.points[p], q, correction, k);
            for (unsigned int b = 0; b < G.n(); ++b)
              for (unsigned int r = 0; r < 9; ++r)
                for (unsigned int s = 0; s < 9; ++s)
                  DG(9 * p + r, b) += D[r][s] * G(9 * p + s, b);
          }
        CellTangent tangent{cell.fields,
                            LAPACKFullMatrix<double>(G.n(), G.n())};
        G.Tmmult(tangent.matrix, DG);
        use(tangent);
      }
  }
} // namespace lamella
