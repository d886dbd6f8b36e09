// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/base/linear_functional.h>
#include <lamella/recover/recovery.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Of a term's values at the points: what must be left of it beside the
    // terms before. In regular patches it is 0.3 or more, in one layer of
    // distorted elements what their distortion amounts to.
    constexpr double seen = 0.1;



    double
    product(const std::vector<double> &a, const std::vector<double> &b)
    {
      double sum = 0.;
      for (unsigned int i = 0; i < a.size(); ++i)
        sum += a[i] * b[i];
      return sum;
    }



    /// Takes the part along the unit vector @p vector off the values @p rest at
    /// the points, and returns it.
    FieldValues
    subtract_assumed_strain(const std::vector<double> &vector,
                            std::vector<FieldValues>  &rest)
    {
      FieldValues amount;
      for (unsigned int i = 0; i < rest.size(); ++i)
        amount += vector[i] * rest[i];
      for (unsigned int i = 0; i < rest.size(); ++i)
        rest[i] -= vector[i] * amount;
      return amount;
    }
  } // namespace



  PatchFit::PatchFit(const FieldValues &values)
    : constant(values)
  {}



  PatchFit::PatchFit(const std::vector<PatchPoint>     &points,
                     const std::vector<Tensor<2, 3>>   &frames,
                     const std::array<unsigned int, 3> &degrees)
    : n_terms(std::numeric_limits<unsigned int>::max())
  {
    for (const Tensor<2, 3> &frame : frames)
      {
        polynomials.push_back(in_frame(points, frame, degrees));
        n_terms = std::min(n_terms, polynomials.back().fit(points));
      }
  }



  std::vector<PatchFit::Term>
  PatchFit::terms_of(const std::array<unsigned int, 3> &degrees)
  {
    std::vector<Term> terms;
    for (unsigned int a = 0; a <= degrees[0]; ++a)
      for (unsigned int b = 0; b <= degrees[1]; ++b)
        for (unsigned int c = 0; c <= degrees[2]; ++c)
          terms.push_back({{a, b, c}});
    std::stable_sort(terms.begin(),
                     terms.end(),
                     [](const Term &s, const Term &t) {
                       return s[0] + s[1] + s[2] < t[0] + t[1] + t[2];
                     });
    return terms;
  }



  PatchFit::Polynomial
  PatchFit::in_frame(const std::vector<PatchPoint>     &points,
                     const Tensor<2, 3>                &frame,
                     const std::array<unsigned int, 3> &degrees)
  {
    const Tensor<2, 3>                     to_local = invert(frame);
    std::vector<std::pair<double, double>> range(
      3,
      {std::numeric_limits<double>::max(),
       std::numeric_limits<double>::lowest()});
    for (const PatchPoint &point : points)
      {
        const Tensor<1, 3> local = to_local * point.position;
        for (unsigned int d = 0; d < 3; ++d)
          range[d] = {std::min(range[d].first, local[d]),
                      std::max(range[d].second, local[d])};
      }

    Polynomial   result;
    Tensor<1, 3> middle;
    for (unsigned int d = 0; d < 3; ++d)
      {
        middle[d] = 0.5 * (range[d].first + range[d].second);
        // Where no term varies, points may lie in one plane.
        const double half =
          degrees[d] == 0 || range[d].second == range[d].first ?
            1. :
            0.5 * (range[d].second - range[d].first);
        result.to_box[d] = to_local[d] / half;
      }
    result.center = Point<3>(frame * middle);

    result.terms = terms_of(degrees);
    result.coefficients.resize(result.terms.size());
    return result;
  }



  std::vector<double>
  PatchFit::Polynomial::basis(const Point<3> &x) const
  {
    const Tensor<1, 3>                 t    = to_box * (x - center);
    const Term                         most = terms.back();
    std::array<std::vector<double>, 3> P;
    for (unsigned int d = 0; d < 3; ++d)
      P[d] = legendre(most[d], t[d]);
    std::vector<double> values;
    for (const Term &term : terms)
      values.push_back(P[0][term[0]] * P[1][term[1]] * P[2][term[2]]);
    return values;
  }



  unsigned int
  PatchFit::Polynomial::fit(const std::vector<PatchPoint> &points)
  {
    // Orthonormalized values of the terms at the points, with coefficients.
    std::vector<std::vector<double>> of_points, vectors, expansions;
    std::vector<FieldValues>         rest;
    for (const PatchPoint &point : points)
      {
        of_points.push_back(basis(point.position));
        rest.push_back(point.values);
      }
    for (unsigned int k = 0; k < terms.size(); ++k)
      {
        std::vector<double> vector, expansion(terms.size(), 0.);
        for (const std::vector<double> &values : of_points)
          vector.push_back(values[k]);
        expansion[k]                   = 1.;
        const double              size = std::sqrt(product(vector, vector));
        const std::vector<double> parts =
          make_orthogonal(vector, vectors, product);
        for (unsigned int j = 0; j < vectors.size(); ++j)
          for (unsigned int i = 0; i < terms.size(); ++i)
            expansion[i] -= parts[j] * expansions[j][i];
        const double left = std::sqrt(product(vector, vector));
        if (!(left > seen * size))
          continue;
        for (double &value : vector)
          value /= left;
        for (double &value : expansion)
          value /= left;

        const FieldValues amount = subtract_assumed_strain(vector, rest);
        for (unsigned int j = 0; j <= k; ++j)
          coefficients[j] += expansion[j] * amount;
        vectors.push_back(std::move(vector));
        expansions.push_back(std::move(expansion));
      }
    return vectors.size();
  }



  FieldValues
  PatchFit::operator()(const Point<3> &x) const
  {
    FieldValues sum = constant;
    for (const Polynomial &polynomial : polynomials)
      {
        const std::vector<double> values = polynomial.basis(x);
        for (unsigned int k = 0; k < values.size(); ++k)
          sum += values[k] / polynomials.size() * polynomial.coefficients[k];
      }
    return sum;
  }
} // namespace lamella
