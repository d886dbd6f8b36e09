// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_lagrange_h
#define lamella_base_lagrange_h

#include <deal.II/base/quadrature_lib.h>

#include <vector>

namespace lamella
{
  /// Returns the value at @p t of the Lagrange polynomial that is 1 at point
  /// number @p i of @p points and 0 at the other points.
  inline double
  lagrange(const std::vector<double> &points,
           const unsigned int         i,
           const double               t)
  {
    double value = 1.;
    for (unsigned int j = 0; j < points.size(); ++j)
      if (j != i)
        value *= (t - points[j]) / (points[i] - points[j]);
    return value;
  }

  /// Returns the values of the Legendre polynomials P_0(t) ... P_n(t).
  inline std::vector<double>
  legendre(const unsigned int n, const double t)
  {
    std::vector<double> P(n + 1, 1.);
    for (unsigned int k = 1; k <= n; ++k)
      P[k] =
        k == 1 ? t : ((2. * k - 1.) * t * P[k - 1] - (k - 1.) * P[k - 2]) / k;
    return P;
  }

  /// Returns the weights that extrapolate values at @p n_points Gauss points
  /// t_k of [0, 1] to @p t by the least-squares polynomial of @p degree,
  ///   w_k sum_n (2 n + 1) P_n(2 t_k - 1) P_n(2 t - 1),   w_k Gauss weights.
  /// The polynomial interpolates the values if the degree is n_points - 1.
  inline std::vector<double>
  gauss_projection(const unsigned int n_points,
                   const unsigned int degree,
                   const double       t)
  {
    const dealii::QGauss<1>   rule(n_points);
    const std::vector<double> P = legendre(degree, 2. * t - 1.);
    std::vector<double>       weights(n_points, 0.);
    for (unsigned int k = 0; k < n_points; ++k)
      {
        const std::vector<double> at =
          legendre(degree, 2. * rule.point(k)[0] - 1.);
        for (unsigned int n = 0; n <= degree; ++n)
          weights[k] += rule.weight(k) * (2. * n + 1.) * at[n] * P[n];
      }
    return weights;
  }
} // namespace lamella

#endif
