// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/linear/factor_row.h>
#include <lamella/section/section_space.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// The five matrices in the order of FactorRow::entries.
    const Matrix &
    matrix_of(const Section &section, const unsigned int m)
    {
      return m < 4 ? section.S(m / 2, m % 2) : section.S_shear();
    }



    /// The entries between the fields @p a and @p b, of dense numbers @p i and
    /// @p j, of which one at least is dense: from @p dense between dense
    /// fields, from @p SB between these and others. S_00, S_11 and the part in
    /// shear are symmetric, S_10 is the transpose of S_01.
    std::array<double, 5>
    entries_between(const std::array<LAPACKFullMatrix<double>, 5> &dense,
                    const std::array<LAPACKFullMatrix<double>, 5> &SB,
                    const unsigned int                             i,
                    const unsigned int                             j,
                    const unsigned int                             a,
                    const unsigned int                             b)
    {
      constexpr std::array<unsigned int, 5> transposed{{0, 2, 1, 3, 4}};
      const unsigned int                    n_dense = dense[0].n();
      std::array<double, 5>                 values{};
      for (unsigned int m = 0; m < 5; ++m)
        values[m] = i < n_dense && j < n_dense ? dense[m](i, j) :
                    j < n_dense                ? SB[m](a, j) :
                                                 SB[transposed[m]](b, i);
      return values;
    }



    /// Adds @p factor times the @p n numbers of a mode to @p sum.
    void
    add_scaled(const double      *mode,
               const unsigned int n,
               const double       factor,
               double            *sum)
    {
      for (unsigned int alpha = 0; alpha < n; ++alpha)
        sum[alpha] += factor * mode[alpha];
    }



    /// Integrates rho Phi_alpha . Phi_beta over the section into @p mass, point
    /// by point. The points integrate products of strains exactly, and
    /// therefore those of displacements on cells with straight edges.
    void
    integrate_mass(const Section             &section,
                   const std::vector<double> &densities,
                   Matrix                    &mass)
    {
      std::vector<double> row;
      section.for_each_point(
        [&](const SectionPoint &point, const double weight) {
          const double m = weight * densities[section.cell_ply(point.cell)];
          const std::vector<unsigned int> &fields = *point.fields;
          row.resize(fields.size());
          for (unsigned int a = 0; a < fields.size(); ++a)
            {
              for (unsigned int b = 0; b < fields.size(); ++b)
                row[b] = m * (point.value[a] * point.value[b]);
              mass.add(
                fields[a], row.size(), fields.data(), row.data(), true, true);
            }
        });
    }



    /// Appends the entries of row @p a of @p mass that are @p carried to @p
    /// row, with ascending columns.
    void
    append_row(const Matrix            &mass,
               const unsigned int       a,
               const std::vector<bool> &carried,
               FactorRow               &row)
    {
      std::map<unsigned int, double> sorted;
      for (auto entry = mass.begin(a); entry != mass.end(a); ++entry)
        // Functions along different axes have no mass in common.
        if (carried[entry->column()] && entry->value() != 0.)
          sorted[entry->column()] = entry->value();
      for (const auto &[column, value] : sorted)
        {
          row.columns.push_back(column);
          row.entries.push_back({{value}});
        }
    }
  } // namespace



  SectionSpace::SectionSpace(std::shared_ptr<const Section> section)
    : base(std::move(section))
    , modes(base->n_fields(), 0)
    , of_fields(measured())
  {}



  SectionSpace::SectionSpace(std::shared_ptr<const Section> section,
                             const FieldColumns            &columns)
    : base(std::move(section))
    , modes(columns)
    , of_fields(measured())
  {
    if (n_modes() == 0)
      return;
    AssertDimension(modes.m(), base->n_fields());
    Assert(base->n_fields() >= n_rigid, ExcMessage("There is no torsion."));
    for (const unsigned int m : {0, 1, 3, 4})
      {
        const LAPACKFullMatrix<double> SB = times_dense(matrix_of(*base, m));
        LAPACKFullMatrix<double>       of_modes(n_modes(), n_dense());
        modes.Tmmult(of_modes, SB);
        dense[m].reinit(n_dense(), n_dense());
        for (unsigned int b = 0; b < n_dense(); ++b)
          for (unsigned int a = 0; a < n_dense(); ++a)
            dense[m](a, b) = a < n_rigid ? SB(a, b) : of_modes(a - n_rigid, b);
      }
    dense[2].reinit(n_dense(), n_dense());
    dense[1].transpose(dense[2]);
  }



  LAPACKFullMatrix<double>
  SectionSpace::times_dense(const Matrix &S) const
  {
    LAPACKFullMatrix<double> fields(base->n_fields(), n_dense());
    for (unsigned int b = 0; b < n_dense(); ++b)
      if (b < n_rigid)
        fields(b, b) = 1.;
      else
        std::copy_n(mode(b - n_rigid), base->n_fields(), &fields(0, b));
    return times_columns(S, fields);
  }



  Vector
  SectionSpace::in_section_functions(const unsigned int alpha) const
  {
    Vector result(base->n_fields());
    if (alpha < first_mode())
      result[alpha] = 1.;
    else
      std::copy_n(mode(alpha - first_mode()), result.size(), result.begin());
    return result;
  }



  std::vector<double>
  SectionSpace::measured() const
  {
    std::vector<double> squares(n_fields(), 0.);
    const auto          evaluate_cell = [&squares](const unsigned int  alpha,
                                          const Tensor<1, 3> &value) {
      squares[alpha] = std::max(squares[alpha], value.norm_square());
    };
    for (const SectionPoint &point : base->integration_points())
      {
        const std::vector<unsigned int> &fields = *point.fields;
        for (unsigned int a = 0; a < fields.size(); ++a)
          evaluate_cell(fields[a], point.value[a]);
        for (unsigned int j = 0; j < n_modes(); ++j)
          {
            Tensor<1, 3> value;
            for (unsigned int a = 0; a < fields.size(); ++a)
              value += mode(j)[fields[a]] * point.value[a];
            evaluate_cell(first_mode() + j, value);
          }
      }
    for (double &square : squares)
      square = square > 0. ? std::sqrt(square) : 1.;
    return squares;
  }



  void
  SectionSpace::expand(std::vector<double> &coefficients) const
  {
    AssertDimension(coefficients.size(), n_fields());
    const unsigned int n = base->n_fields();
    for (unsigned int j = 0; j < n_modes(); ++j)
      if (const double factor = coefficients[n + j]; factor != 0.)
        add_scaled(this->mode(j), n, factor, coefficients.data());
    coefficients.resize(n);
  }



  bool
  SectionSpace::is_dense(const std::vector<unsigned int> &list) const
  {
    return n_modes() > 0 &&
           std::all_of(list.begin(), list.end(), [this](const unsigned int a) {
             return dense_number(a) < n_dense();
           });
  }



  LAPACKFullMatrix<double>
  SectionSpace::in_section(const std::vector<unsigned int> &list,
                           const LAPACKFullMatrix<double>  &q) const
  {
    AssertDimension(q.m(), list.size());
    const unsigned int       n = base->n_fields();
    LAPACKFullMatrix<double> result(n, q.n());
    for (unsigned int k = 0; k < q.n(); ++k)
      for (unsigned int a = 0; a < list.size(); ++a)
        if (const double factor = q(a, k); list[a] < n)
          result(list[a], k) += factor;
        else if (factor != 0.)
          add_scaled(this->mode(list[a] - n), n, factor, &result(0, k));
    return result;
  }



  LAPACKFullMatrix<double>
  SectionSpace::on_list(const std::vector<unsigned int> &list,
                        const LAPACKFullMatrix<double>  &work) const
  {
    const unsigned int n = base->n_fields();
    AssertDimension(work.m(), n);
    LAPACKFullMatrix<double> result(list.size(), work.n());
    for (unsigned int k = 0; k < work.n(); ++k)
      for (unsigned int a = 0; a < list.size(); ++a)
        {
          const double *const column = &work(0, k);
          if (list[a] < n)
            result(a, k) = column[list[a]];
          else
            {
              const double *const mode = this->mode(list[a] - n);
              result(a, k) = std::inner_product(mode, mode + n, column, 0.);
            }
        }
    return result;
  }



  std::vector<FactorRow>
  SectionSpace::rows(const std::vector<bool> &carried) const
  {
    AssertDimension(carried.size(), n_fields());
    const unsigned int     n = base->n_fields();
    std::vector<FactorRow> result(n_fields());
    for (unsigned int a = 0; a < n; ++a)
      if (carried[a])
        result[a] = factor_row(
          [this](const unsigned int m) -> auto & {
            return matrix_of(*base, m);
          },
          a,
          [&](const unsigned int b) { return carried[b]; });
    if (n_modes() == 0)
      return result;

    // And with the modes.
    const bool sparse_too =
      std::find(carried.begin() + n_rigid, carried.begin() + n, true) !=
      carried.begin() + n;
    std::array<LAPACKFullMatrix<double>, 5> SB;
    if (sparse_too)
      for (unsigned int m = 0; m < 5; ++m)
        SB[m] = times_dense(matrix_of(*base, m));
    for (unsigned int a = 0; a < n_fields(); ++a)
      for (unsigned int b = a < n ? n : 0; carried[a] && b < n_fields(); ++b)
        if (carried[b])
          {
            result[a].columns.push_back(b);
            result[a].entries.push_back(entries_between(
              dense, SB, dense_number(a), dense_number(b), a, b));
          }
    return result;
  }



  // B^T M B of rigid functions and modes, M B between these and the others.
  std::vector<FactorRow>
  SectionSpace::mass_rows(const std::vector<double> &densities,
                          const std::vector<bool>   &carried) const
  {
    AssertDimension(carried.size(), n_fields());
    Matrix mass(base->S(0, 0).get_sparsity_pattern());
    integrate_mass(*base, densities, mass);
    const unsigned int     n = base->n_fields();
    std::vector<FactorRow> result(n_fields());
    for (unsigned int a = 0; a < n; ++a)
      if (carried[a])
        append_row(mass, a, carried, result[a]);
    if (n_modes() == 0)
      return result;

    const LAPACKFullMatrix<double> MB = times_dense(mass);
    const auto entry = [&](const unsigned int a, const unsigned int b) {
      if (b < n)
        return MB(b, a - n + n_rigid);
      const double *const column = &MB(0, b - n + n_rigid);
      return a < n ?
               column[a] :
               std::inner_product(mode(a - n), mode(a - n) + n, column, 0.);
    };
    for (unsigned int a = 0; a < n_fields(); ++a)
      for (unsigned int b = a < n ? n : 0; carried[a] && b < n_fields(); ++b)
        if (carried[b])
          {
            result[a].columns.push_back(b);
            result[a].entries.push_back({{entry(a, b)}});
          }
    return result;
  }
} // namespace lamella
