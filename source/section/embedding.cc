// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/linear/factorization.h>
#include <lamella/section/embedding.h>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// What @p columns move the point @p point by, one after the other.
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
