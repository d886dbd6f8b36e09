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
   */
  class GaussLobattoBasis
  {
  public:
    /// As many functions as anybody may keep room for.
    static constexpr unsigned int max_size = 64;

    /// Throws ExcNotImplemented for degrees of max_size and more.
    explicit GaussLobattoBasis(const unsigned int degree);

    /// That of @p degree, made once and kept.
    static const GaussLobattoBasis &
    of_degree(const unsigned int degree);

    unsigned int
    size() const
    {
      return points.size();
    }

    double
    point(const unsigned int i) const
    {
      return points[i];
    }

    /// The functions at @p x in @p values and, unless null, their derivatives.
    void
    evaluate(const double x, double *values, double *derivatives) const;

  private:
    std::vector<double> points;
    /// 1 / prod_j (x_i - x_j).
    std::vector<double> scales;
  };
} // namespace lamella

#endif
