// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_gauss_lobatto_basis_h
#define lamella_base_gauss_lobatto_basis_h

#include <vector>

namespace lamella
{
  /// Lagrange polynomials on [0, 1] at the Gauss-Lobatto points x_i,
  ///   L_i(x) = prod_{j != i} (x - x_j) / (x_i - x_j).
  /// This class equals deal.II's Polynomials::Lagrange, but evaluates all
  /// functions together, with derivatives and without allocation. The points
  /// include both ends, so neighboring elements share nodes. Products L_i(s)
  /// L_j(t) on the unit square are the shape functions of surface facets.
  class GaussLobattoBasis
  {
  public:
    /// Largest number of functions of a basis, for arrays of fixed size.
    static constexpr unsigned int max_size = 64;

    /// Constructs @p degree + 1 functions; 1 <= degree < max_size. Throws
    /// ExcNotImplemented for a higher degree.
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

    /// Evaluates all functions at @p x, and their first and second derivatives
    /// if these pointers are not null. Each array has room for size() numbers.
    /// @p x may be a node or outside of [0, 1]. Takes size()^2 operations.
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
