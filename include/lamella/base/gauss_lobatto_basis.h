// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_gauss_lobatto_basis_h
#define lamella_base_gauss_lobatto_basis_h

#include <deal.II/base/point.h>
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

  /// Lagrange polynomials on [0, 1] at the Gauss-Lobatto points x_i,
  ///   L_i(x) = prod_{j != i} (x - x_j) / (x_i - x_j).
  /// Equals deal.II's Polynomials::Lagrange, but evaluates all functions
  /// together, with derivatives and without allocation. The points include 0
  /// and 1, so neighboring elements share nodes. Products L_i(s) L_j(t) on the
  /// unit square are the shape functions of surface facets.
  class GaussLobattoBasis
  {
  public:
    /// Largest number of polynomials of a basis, for arrays of fixed size.
    static constexpr unsigned int max_size = 64;

    /// Constructs the @p degree + 1 polynomials of degree @p degree. Throws
    /// ExcNotImplemented unless 1 <= degree < max_size.
    explicit GaussLobattoBasis(const unsigned int degree);

    /// Returns the cached basis of polynomials of @p degree. Not thread-safe.
    static const GaussLobattoBasis &
    of_degree(const unsigned int degree);

    /// Returns the number of polynomials, degree + 1.
    unsigned int
    size() const
    {
      return points.size();
    }

    /// Returns Gauss-Lobatto point number @p i in [0, 1], ascending, where
    /// polynomial number i is 1 and the others are 0.
    double
    point(const unsigned int i) const
    {
      return points[i];
    }

    /// Evaluates all polynomials at @p x, also outside of [0, 1], and their
    /// first and second derivatives if these pointers are not null. Each array
    /// must have size() elements. Takes size()^2 operations.
    void
    evaluate(const double x,
             double      *values,
             double      *derivatives,
             double      *second_derivatives = nullptr) const;

  private:
    std::vector<double> points;
    /// Factors 1 / prod_j (x_i - x_j) of the polynomials, j != i.
    std::vector<double> scales;
  };

  /// Returns the points (s_i, t_j) of the tensor-product grid of the bases @p s
  /// and @p t on the unit square. The first index varies fastest.
  std::vector<dealii::Point<2>>
  grid_points(const GaussLobattoBasis &s, const GaussLobattoBasis &t);

  /// Evaluates the products L_i(s) L_j(t) of the polynomials @p s and @p t at
  /// the point @p st, and stores them in @p values, ordered as by
  /// grid_points().
  void
  evaluate_on_grid(const GaussLobattoBasis &s,
                   const GaussLobattoBasis &t,
                   const dealii::Point<2>  &st,
                   std::vector<double>     &values);
} // namespace lamella

#endif
