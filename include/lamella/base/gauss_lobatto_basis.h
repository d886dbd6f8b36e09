// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_gauss_lobatto_basis_h
#define lamella_base_gauss_lobatto_basis_h

#include <vector>

namespace lamella
{
  /// Lagrange polynomials on [0, 1] at the Gauss-Lobatto points x_i,
  ///   L_i(x) = prod_{j != i} (x - x_j) / (x_i - x_j).
  /// They equal deal.II's Polynomials::Lagrange, but are evaluated together,
  /// with derivatives and without allocation. The points include both ends, so
  /// neighbors share nodes; they are equidistant up to degree 2. Products on
  /// the unit square are the trace functions phi_k of facets.
  class GaussLobattoBasis
  {
  public:
    /// Largest number of functions, for arrays of fixed size.
    static constexpr unsigned int max_size = 64;

    /// Constructs @p degree + 1 functions; 1 <= degree < max_size. Throws
    /// ExcNotImplemented for more.
    explicit GaussLobattoBasis(const unsigned int degree);

    /// Returns the cached basis of @p degree. Not thread-safe.
    static const GaussLobattoBasis &
    of_degree(const unsigned int degree);

    /// Returns the number of functions, degree + 1.
    unsigned int
    size() const
    {
      return points.size();
    }

    /// Returns x_i in [0, 1], ascending: L_i(x_j) = delta_ij.
    double
    point(const unsigned int i) const
    {
      return points[i];
    }

    /// Evaluates the functions at @p x and, unless null, their first and second
    /// derivatives. Arrays have room for size() numbers. Nodes and points
    /// outside of [0, 1] are permitted. n^2 operations for n functions.
    void
    evaluate(const double x,
             double      *values,
             double      *derivatives,
             double      *second_derivatives = nullptr) const;

  private:
    std::vector<double> points;
    /// 1 / prod_j (x_i - x_j).
    std::vector<double> scales;
  };
} // namespace lamella

#endif
