// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_gauss_lobatto_basis_h
#define lamella_base_gauss_lobatto_basis_h

#include <vector>

namespace lamella
{
  /**
   * Polynomials in [0, 1] given by their values at the Gauss-Lobatto points:
   *   L_i(x) = prod_{j != i} (x - x_j) / (x_i - x_j).
   * (deal.II's Polynomials::Lagrange are the same functions; these take all at
   * once, with derivatives and without memory, for the millions of points that
   * contact asks for.)
   *
   * Products of these in the coordinates of the unit square are the trace
   * functions phi_k of facets: fields on a side of an element are known by
   * their values at its grid of nodes. Gauss-Lobatto points include both ends,
   * so that neighbours share the nodes between them, and keep the interpolation
   * well conditioned at high degrees; up to degree 2 they are equidistant.
   */
  class GaussLobattoBasis
  {
  public:
    /// As many functions as anybody may keep room for.
    static constexpr unsigned int max_size = 64;

    /// Throws ExcNotImplemented for degrees of max_size and more. @p degree + 1
    /// functions; the degree is at least 1.
    explicit GaussLobattoBasis(const unsigned int degree);

    /// That of @p degree, made once and kept. The reference stays valid to the
    /// end of the program. Not for several threads at once.
    static const GaussLobattoBasis &
    of_degree(const unsigned int degree);

    /// The number of functions, degree + 1.
    unsigned int
    size() const
    {
      return points.size();
    }

    /// x_i in [0, 1], ascending with i: L_i(x_j) is 1 for i = j and else 0.
    double
    point(const unsigned int i) const
    {
      return points[i];
    }

    /// The functions at @p x in @p values and, unless null, their first and
    /// second derivatives. All have room for size() numbers; @p x is in [0, 1]
    /// as a rule.
    /// Products of differences and no barycentric quotient: nothing is divided
    /// by zero at a node, and outside of [0, 1] the polynomials go on. n^2
    /// operations for n functions.
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
