// SPDX-License-Identifier: LGPL-2.1-or-later

// The matrices of a section: by integration over each cell where fields live on
// few cells, from moments of the expansion functions where they live on all.

#include <lamella/section/section.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>

namespace lamella
{
  using namespace dealii;

  void
  Section::make_pattern()
  {
    DynamicSparsityPattern pattern(n_fields());
    for (const std::vector<unsigned int> &coupled : cell_fields)
      for (const unsigned int alpha : coupled)
        pattern.add_entries(alpha, coupled.begin(), coupled.end(), true);
    sparsity.copy_from(pattern);
    for (Matrix &matrix : matrices)
      matrix.reinit(sparsity);
  }



  void
  Section::make_matrices()
  {
    make_pattern();
    // Linear fields are nonzero on all cells, so their rows are dense: they are
    // summed beside the matrix, which avoids searches in long rows.
    const unsigned int n_dense =
      std::count_if(fields.begin(),
                    fields.end(),
                    [](const SectionFunction &field) {
                      return field.level == 0;
                    });
    DenseRows dense;
    for (std::vector<Vector> &rows : dense)
      rows.assign(n_dense, Vector(n_fields()));
    for (unsigned int cell = 0; cell < n_cells(); ++cell)
      {
        StrainParts strain, stress;
        find_cell_strains(cell, strain, stress);
        add_cell_matrices(cell, strain, stress, dense);
      }
    for (unsigned int m = 0; m < matrices.size(); ++m)
      for (unsigned int alpha = 0; alpha < n_dense; ++alpha)
        for (auto entry = matrices[m].begin(alpha);
             entry != matrices[m].end(alpha);
             ++entry)
          entry->value() = dense[m][alpha][entry->column()];
  }



  void
  Section::find_cell_strains(const unsigned int cell,
                             StrainParts       &strain,
                             StrainParts       &stress) const
  {
    const unsigned int n_points = points.size() / n_cells();
    const unsigned int n        = cell_fields[cell].size();
    for (unsigned int p = 0; p < 3; ++p)
      {
        strain[p].reinit(6 * n_points, n);
        stress[p].reinit(6 * n_points, n);
      }
    for (unsigned int k = 0; k < n_points; ++k)
      {
        const unsigned int   number = cell * n_points + k;
        const SectionPoint  &point  = points[number];
        const ElasticTensor &C      = law_at_point(number).stiffness();
        for (unsigned int a = 0; a < n; ++a)
          {
            std::array<Voigt, 3> e;
            for (unsigned int c = 0; c < 6; ++c)
              e[is_transverse_shear(c) ? 1 : 0][c] = point.in_plane[a][c];
            e[2] = point.along[a];
            for (unsigned int p = 0; p < 3; ++p)
              {
                const Voigt s = weights[number] * (C * e[p]);
                for (unsigned int c = 0; c < 6; ++c)
                  {
                    strain[p](6 * k + c, a) = e[p][c];
                    stress[p](6 * k + c, a) = s[c];
                  }
              }
          }
      }
  }



  void
  Section::add_cell_matrices(const unsigned int cell,
                             const StrainParts &strain,
                             const StrainParts &stress,
                             DenseRows         &dense)
  {
    const auto              &numbers = cell_fields[cell];
    const unsigned int       n       = numbers.size();
    LAPACKFullMatrix<double> product(n, n);
    std::vector<double>      row(n);
    // Which of the matrices the product of parts p and q belongs to.
    constexpr unsigned int S_00 = 0, S_01 = 1, S_10 = 2, S_11 = 3, shear = 4;
    constexpr std::array<std::array<unsigned int, 3>, 3> part_of{
      {{{S_00, shear, S_01}}, {{shear, shear, S_01}}, {{S_10, S_10, S_11}}}};
    for (unsigned int p = 0; p < 3; ++p)
      for (unsigned int q = 0; q < 3; ++q)
        {
          strain[p].Tmmult(product, stress[q]);
          for (unsigned int a = 0; a < n; ++a)
            {
              for (unsigned int b = 0; b < n; ++b)
                row[b] = product(a, b);
              for (const unsigned int m :
                   part_of[p][q] == shear ?
                     std::vector<unsigned int>{S_00, shear} :
                     std::vector<unsigned int>{part_of[p][q]})
                if (numbers[a] < dense[m].size())
                  for (unsigned int b = 0; b < n; ++b)
                    dense[m][numbers[a]][numbers[b]] += row[b];
                else
                  matrices[m].add(
                    numbers[a], n, numbers.data(), row.data(), false, true);
            }
        }
  }



  namespace
  {
    /// A part of a field's strain: @p factor times the function @p function, or
    /// its derivative with respect to x or z, in the component @p strain.
    struct StrainPart
    {
      enum Derivative : unsigned int
      {
        none,
        d_dx,
        d_dz
      };
      unsigned int strain;
      Derivative   derivative;
      unsigned int function;
      double       factor;
    };

    /// Of a field the parts that its value multiplies, without and with nothing
    /// but transverse shear, and those that its derivative along y multiplies.
    using FieldStrain = std::array<std::vector<StrainPart>, 3>;



    void
    add_part(std::vector<StrainPart> &parts, const StrainPart &part)
    {
      for (StrainPart &known : parts)
        if (known.strain == part.strain &&
            known.derivative == part.derivative &&
            known.function == part.function)
          {
            known.factor += part.factor;
            return;
          }
      parts.push_back(part);
    }



    /// The strains of @p field (Eq. 4: xx, yy, zz, xy, xz, yz). Derivatives of
    /// (x - x_c) / h and (z - z_c) / h are 1 / h times the function 1: what of
    /// the rigid turn about y cancels then does so to the last bit.
    FieldStrain
    strains_of(const SectionFunction &field, const double h)
    {
      using D = StrainPart::Derivative;
      struct Entry
      {
        unsigned int part, strain;
        D            derivative;
      };
      static const std::array<std::vector<Entry>, 3> of_component{
        {{{0, 0, D::d_dx}, {0, 4, D::d_dz}, {2, 3, D::none}},
         {{1, 3, D::d_dx}, {1, 5, D::d_dz}, {2, 1, D::none}},
         {{0, 2, D::d_dz}, {0, 4, D::d_dx}, {2, 5, D::none}}}};
      FieldStrain result;
      for (const SectionFunction::Term &term : field.terms)
        for (const Entry &entry : of_component[term.component])
          {
            StrainPart part{entry.strain,
                            entry.derivative,
                            term.function,
                            term.factor};
            if (term.function < 3 && entry.derivative != D::none)
              {
                if (entry.derivative != (term.function == 1 ? D::d_dx :
                                         term.function == 2 ? D::d_dz :
                                                              D::none))
                  continue;
                part = {entry.strain, D::none, 0, term.factor / h};
              }
            add_part(result[entry.part], part);
          }
      return result;
    }



    /// A part of a section with constant stiffness: a ply, or a harmonic of a
    /// ply whose varying law weights its integrals.
    struct StiffnessPart
    {
      unsigned int  ply, harmonic;
      ElasticTensor C;
    };

    std::vector<StiffnessPart>
    stiffness_parts(const PlyLaws &laws)
    {
      std::vector<StiffnessPart> parts;
      for (unsigned int ply = 0; ply < laws.n_plies(); ++ply)
        {
          const unsigned int first = parts.size();
          if (!laws.has_varying_law(ply))
            parts.push_back({ply, 0, laws.constant(ply).stiffness()});
          else
            for (const ElasticTensor &C : laws.stiffness_harmonics(ply))
              parts.push_back(
                {ply, static_cast<unsigned int>(parts.size()) - first, C});
        }
      return parts;
    }



    /// Functions and their derivatives with respect to x and z at the points of
    /// a cell, each times the root of the point's area.
    using CellFunctions = std::array<LAPACKFullMatrix<double>, 3>;

    /// int D_a F_k D_b F_l over each part, a and b of StrainPart::Derivative.
    using FunctionMoments =
      std::vector<std::array<std::array<LAPACKFullMatrix<double>, 3>, 3>>;

    /// Adds the integrals over a cell to those of the part of @p harmonic,
    /// which has the values @p weight at the cell's points.
    void
    add_cell_moments(const CellFunctions         &D,
                     const unsigned int           harmonic,
                     const std::vector<double>   &weight,
                     FunctionMoments::value_type &of_part)
    {
      for (unsigned int b = 0; b < 3; ++b)
        {
          LAPACKFullMatrix<double> weighted;
          if (harmonic > 0)
            {
              weighted = D[b];
              for (unsigned int q = 0; q < weighted.m(); ++q)
                for (unsigned int k = 0; k < weighted.n(); ++k)
                  weighted(q, k) *= weight[q];
            }
          for (unsigned int a = 0; a <= b; ++a)
            D[a].Tmmult(of_part[a][b],
                        harmonic > 0 ? weighted : D[b],
                        /*adding=*/true);
        }
    }



    /// Writes @p element at @p quadrature of @p cell to @p D; returns points.
    std::vector<Point<2>>
    evaluate_functions(const CrossSectionElement &element,
                       const unsigned int         cell,
                       const QGauss<2>           &quadrature,
                       CellFunctions             &D)
    {
      std::vector<Point<2>> positions;
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          const FunctionValues f = element.evaluate(cell, quadrature.point(q));
          const double         root =
            std::sqrt(quadrature.weight(q) * determinant(f.jacobian));
          for (unsigned int k = 0; k < element.n_functions(); ++k)
            {
              D[0](q, k) = root * f.values[k];
              D[1](q, k) = root * f.gradients[k][0];
              D[2](q, k) = root * f.gradients[k][1];
            }
          positions.push_back(f.position);
        }
      return positions;
    }



    /// The moments of a > b from those of a < b.
    void
    fill_by_symmetry(FunctionMoments &moments)
    {
      const unsigned int n = moments.empty() ? 0 : moments[0][0][0].m();
      for (auto &of_part : moments)
        for (unsigned int a = 0; a < 3; ++a)
          for (unsigned int b = 0; b < a; ++b)
            for (unsigned int k = 0; k < n; ++k)
              for (unsigned int l = 0; l < n; ++l)
                of_part[a][b](k, l) = of_part[b][a](l, k);
    }



    FunctionMoments
    function_moments(const CrossSectionElement        &element,
                     const std::vector<unsigned int>  &ply_of_cell,
                     const PlyLaws                    &laws,
                     const std::vector<StiffnessPart> &parts)
    {
      const unsigned int n = element.n_functions();
      FunctionMoments    moments(parts.size());
      for (auto &of_part : moments)
        for (auto &row : of_part)
          for (LAPACKFullMatrix<double> &one : row)
            one.reinit(n, n);
      const QGauss<2> quadrature(element.n_gauss_points());
      CellFunctions   D;
      for (LAPACKFullMatrix<double> &values : D)
        values.reinit(quadrature.size(), n);
      std::vector<PlyLaws::Harmonics> at_point(quadrature.size());
      std::vector<double>             weight(quadrature.size());
      for (unsigned int cell = 0; cell < ply_of_cell.size(); ++cell)
        {
          const unsigned int          ply = ply_of_cell[cell];
          const std::vector<Point<2>> x =
            evaluate_functions(element, cell, quadrature, D);
          if (laws.has_varying_law(ply))
            for (unsigned int q = 0; q < quadrature.size(); ++q)
              at_point[q] = laws.harmonics(ply, x[q]);
          for (unsigned int p = 0; p < parts.size(); ++p)
            if (parts[p].ply == ply)
              {
                for (unsigned int q = 0; q < quadrature.size(); ++q)
                  weight[q] = at_point[q][parts[p].harmonic];
                add_cell_moments(D, parts[p].harmonic, weight, moments[p]);
              }
        }
      fill_by_symmetry(moments);
      return moments;
    }
  } // namespace



  void
  Section::make_moments()
  {
    const std::vector<StiffnessPart> materials = stiffness_parts(laws);
    const FunctionMoments            functions =
      function_moments(*expansion, ply_of_cell, laws, materials);
    std::vector<FieldStrain> parts;
    for (const SectionFunction &field : fields)
      parts.push_back(strains_of(field, expansion->reference_length()));

    const unsigned int n = n_fields();
    for (unsigned int p = 0; p < 3; ++p)
      for (unsigned int q = 0; q < 3; ++q)
        {
          LAPACKFullMatrix<double> &moment = strain_moments[p][q];
          moment.reinit(n, n);
          for (unsigned int b = 0; b < n; ++b)
            for (unsigned int a = 0; a < n; ++a)
              {
                double sum = 0.;
                for (unsigned int m = 0; m < materials.size(); ++m)
                  for (const StrainPart &i : parts[a][p])
                    for (const StrainPart &j : parts[b][q])
                      sum +=
                        i.factor * j.factor *
                        materials[m].C[i.strain][j.strain] *
                        functions[m][i.derivative][j.derivative](i.function,
                                                                 j.function);
                moment(a, b) = sum;
              }
        }
    add_moments();
  }



  void
  Section::add_moments()
  {
    const unsigned int n = n_fields();
    make_pattern();
    const auto &m = strain_moments;
    for (unsigned int a = 0; a < n; ++a)
      for (unsigned int b = 0; b < n; ++b)
        {
          const double shear = m[0][1](a, b) + m[1][0](a, b) + m[1][1](a, b);
          matrices[0].set(a, b, m[0][0](a, b) + shear);
          matrices[1].set(a, b, m[0][2](a, b) + m[1][2](a, b));
          matrices[2].set(a, b, m[2][0](a, b) + m[2][1](a, b));
          matrices[3].set(a, b, m[2][2](a, b));
          matrices[4].set(a, b, shear);
        }
  }
} // namespace lamella
