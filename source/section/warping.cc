// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/linear/factor_row.h>
#include <lamella/linear/factorization.h>
#include <lamella/section/warping.h>

#include <algorithm>
#include <numeric>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int n_rigid = RigidField::n_all;
    // Of a field's norm: what is left of it without what is known is rounding.
    constexpr double nothing_new = 1e-8;



    /// a - b c.
    void
    subtract_product(FieldColumns       &a,
                     const FieldColumns &b,
                     const FieldColumns &c)
    {
      FieldColumns product(a.m(), a.n());
      b.mmult(product, c);
      for (unsigned int j = 0; j < a.n(); ++j)
        std::transform(
          &a(0, j), &a(0, j) + a.m(), &product(0, j), &a(0, j), std::minus<>());
    }



    /// Takes what lies along @p known out of @p fields, whose metrics (M times
    /// the fields) follow; twice, for the sake of rounding.
    void
    make_free_of(const FieldColumns &known,
                 const FieldColumns &known_metrics,
                 FieldColumns       &fields,
                 FieldColumns       &metrics)
    {
      if (known.n() == 0)
        return;
      FieldColumns gram(known.n(), known.n()), parts(known.n(), fields.n()),
        amplitudes(parts);
      known.Tmmult(gram, known_metrics);
      gram.invert();
      for (unsigned int pass = 0; pass < 2; ++pass)
        {
          known_metrics.Tmmult(parts, fields);
          gram.mmult(amplitudes, parts);
          subtract_product(fields, known, amplitudes);
          subtract_product(metrics, known_metrics, amplitudes);
        }
    }



    /// u . v of two columns of as many rows.
    double
    product(const FieldColumns &u, const FieldColumns &v, const unsigned int j)
    {
      return std::inner_product(&u(0, j), &u(0, j) + u.m(), &v(0, j), 0.);
    }



    /// Displacements of the point @p point due to @p columns, in turn.
    std::vector<Tensor<1, 3>>
    displacements(const SectionPoint &point, const FieldColumns &columns)
    {
      std::vector<Tensor<1, 3>> result(columns.n());
      for (unsigned int j = 0; j < columns.n(); ++j)
        for (unsigned int a = 0; a < point.fields->size(); ++a)
          result[j] += columns((*point.fields)[a], j) * point.value[a];
      return result;
    }
  } // namespace



  Warping::Warping(const Section &section)
    : section(section)
  {
    smaller_extent    = section.extents().first;
    const double rate = 0.1 / smaller_extent;
    metric_matrix.reinit(section.S(0, 0).get_sparsity_pattern());
    metric_matrix.copy_from(section.S(0, 0));
    metric_matrix.add(rate * rate, section.S(1, 1));
    FullMatrix<double> gram(n_rigid);
    for (unsigned int r = 0; r < n_rigid; ++r)
      {
        Vector rigid(section.n_fields());
        rigid[r] = 1.;
        rigid_products.push_back(traction(rigid));
        for (unsigned int s = 0; s < n_rigid; ++s)
          gram(r, s) = rigid_products[r][s];
      }
    gram.gauss_jordan();
    inverse.reinit(n_rigid);
    inverse = gram;
  }



  Vector
  Warping::traction(const Vector &field) const
  {
    Vector      result(section.n_fields());
    const auto &points  = section.integration_points();
    const auto &weights = section.integration_weights();
    for (unsigned int k = 0; k < points.size(); ++k)
      {
        const auto  &numbers = *points[k].fields;
        Tensor<1, 3> value;
        for (unsigned int a = 0; a < numbers.size(); ++a)
          value += field[numbers[a]] * points[k].value[a];
        value *= weights[k];
        for (unsigned int a = 0; a < numbers.size(); ++a)
          result[numbers[a]] += value * points[k].value[a];
      }
    return result;
  }



  void
  Warping::remove_rigid(Vector &field) const
  {
    Vector parts(n_rigid), amplitudes(n_rigid);
    for (unsigned int r = 0; r < n_rigid; ++r)
      parts[r] = rigid_products[r] * field;
    inverse.vmult(amplitudes, parts);
    for (unsigned int r = 0; r < n_rigid; ++r)
      field[r] -= amplitudes[r];
  }



  FieldColumns
  Warping::metric(const FieldColumns &fields) const
  {
    if (fields.n() == 0)
      return fields;
    return times_columns(metric_matrix, fields);
  }



  Warping::WarpingFields
  Warping::remove_rigid_parts_of(const std::vector<Vector> &snapshots,
                                 const FieldColumns        &warpings) const
  {
    WarpingFields result;
    result.fields.reinit(section.n_fields(), snapshots.size());
    for (unsigned int j = 0; j < snapshots.size(); ++j)
      {
        Vector field = snapshots[j];
        remove_rigid(field);
        std::copy(field.begin(), field.end(), &result.fields(0, j));
      }
    result.metrics = metric(result.fields);
    std::vector<double> before(snapshots.size());
    for (unsigned int j = 0; j < before.size(); ++j)
      before[j] = product(result.fields, result.metrics, j);
    make_free_of(warpings, metric(warpings), result.fields, result.metrics);
    for (unsigned int j = 0; j < before.size(); ++j)
      {
        const double square = product(result.fields, result.metrics, j);
        result.norms.push_back(square > nothing_new * nothing_new * before[j] ?
                                 std::sqrt(square) :
                                 0.);
      }
    return result;
  }



  std::vector<double>
  Warping::strengths(const std::vector<Vector> &snapshots,
                     const FieldColumns        &warpings) const
  {
    return snapshots.empty() ? std::vector<double>() :
                               remove_rigid_parts_of(snapshots, warpings).norms;
  }



  FieldColumns
  Warping::basis(const std::vector<Vector> &snapshots,
                 const FieldColumns        &warpings,
                 const FieldColumns        &known,
                 const double               tolerance) const
  {
    const unsigned int n = section.n_fields();
    if (snapshots.empty())
      return FieldColumns(n, 0);
    WarpingFields             free = remove_rigid_parts_of(snapshots, warpings);
    std::vector<unsigned int> fresh;
    for (unsigned int j = 0; j < snapshots.size(); ++j)
      {
        if (!(free.norms[j] > 0.))
          continue;
        fresh.push_back(j);
        for (FieldColumns *columns : {&free.fields, &free.metrics})
          for (unsigned int i = 0; i < n; ++i)
            (*columns)(i, j) /= free.norms[j];
      }
    if (fresh.empty())
      return FieldColumns(n, 0);
    FieldColumns fields  = selected_columns(free.fields, fresh),
                 metrics = selected_columns(free.metrics, fresh);
    make_free_of(known, metric(known), fields, metrics);
    return orthonormal(fields, metrics, tolerance);
  }



  FieldColumns
  Warping::weighted_basis(const std::vector<Vector> &snapshots,
                          const FieldColumns        &warpings,
                          const FieldColumns        &known,
                          const double               tolerance) const
  {
    if (snapshots.empty())
      return FieldColumns(section.n_fields(), 0);
    WarpingFields free = remove_rigid_parts_of(snapshots, warpings);
    make_free_of(known, metric(known), free.fields, free.metrics);
    return orthonormal(free.fields, free.metrics, tolerance);
  }



  FieldColumns
  orthonormal(const FieldColumns &fields,
              const FieldColumns &metrics,
              const double        tolerance)
  {
    const unsigned int m = fields.n();
    FieldColumns       gram(m, m);
    fields.Tmmult(gram, metrics);
    gram.set_property(LAPACKSupport::symmetric);
    Vector             eigenvalues;
    FullMatrix<double> eigenvectors;
    const double       all = 2. * gram.frobenius_norm() + 1.;
    gram.compute_eigenvalues_symmetric(
      -all, all, 0., eigenvalues, eigenvectors);

    const double largest = std::max(eigenvalues[eigenvalues.size() - 1], 1.);
    std::vector<unsigned int> taken;
    for (unsigned int j = eigenvalues.size(); j-- > 0;)
      if (eigenvalues[j] > tolerance * tolerance * largest)
        taken.push_back(j);
    FieldColumns combine(m, taken.size()), result(fields.m(), taken.size());
    for (unsigned int j = 0; j < taken.size(); ++j)
      for (unsigned int i = 0; i < m; ++i)
        combine(i, j) =
          eigenvectors(i, taken[j]) / std::sqrt(eigenvalues[taken[j]]);
    if (!taken.empty())
      fields.mmult(result, combine);
    return result;
  }



  Vector
  column_of(const FieldColumns &columns, const unsigned int j)
  {
    return Vector(&columns(0, j), &columns(0, j) + columns.m());
  }



  FieldColumns
  selected_columns(const FieldColumns              &columns,
                   const std::vector<unsigned int> &numbers)
  {
    FieldColumns result(columns.m(), numbers.size());
    for (unsigned int j = 0; j < numbers.size(); ++j)
      std::copy_n(&columns(0, numbers[j]), columns.m(), &result(0, j));
    return result;
  }



  FieldColumns
  beside(const FieldColumns &a, const FieldColumns &b)
  {
    // A matrix without columns has no rows either.
    if (a.n() == 0 || b.n() == 0)
      return a.n() == 0 ? b : a;
    AssertDimension(a.m(), b.m());
    FieldColumns result(a.m(), a.n() + b.n());
    for (unsigned int j = 0; j < result.n(); ++j)
      std::copy_n(j < a.n() ? &a(0, j) : &b(0, j - a.n()),
                  a.m(),
                  &result(0, j));
    return result;
  }



  bool
  have_same_cells(const Section &a, const Section &b)
  {
    if (a.n_cells() != b.n_cells())
      return false;
    constexpr double rounding = arithmetic::same_position;
    const double     size     = a.extents().second;
    const Point<2>   middle(0.5, 0.5);
    for (unsigned int cell = 0; cell < a.n_cells(); ++cell)
      {
        const Point<2> p      = a.evaluate(cell, middle).position,
                       q      = b.evaluate(cell, middle).position;
        const ElasticTensor C = a.law(cell, p).stiffness();
        if (p.distance(q) > rounding * size ||
            (C - b.law(cell, q).stiffness()).norm() > rounding * C.norm())
          return false;
      }
    return true;
  }



  std::vector<Vector>
  embedded(const FieldColumns &fields, const Section &from, const Section &to)
  {
    Matrix              mass(to.S(0, 0).get_sparsity_pattern());
    std::vector<Vector> columns(fields.n(), Vector(to.n_fields()));
    to.for_each_point([&](const SectionPoint &point, const double weight) {
      const auto &numbers = *point.fields;
      const auto  wanted =
        displacements(from.evaluate(point.cell, point.unit), fields);
      for (unsigned int a = 0; a < numbers.size(); ++a)
        {
          const Tensor<1, 3> value = weight * point.value[a];
          for (unsigned int b = 0; b < numbers.size(); ++b)
            mass.add(numbers[a], numbers[b], value * point.value[b]);
          for (unsigned int j = 0; j < fields.n(); ++j)
            columns[j][numbers[a]] += value * wanted[j];
        }
    });
    factorize(mass, "the fields of a section")->solve_all(columns);
    return columns;
  }
} // namespace lamella
