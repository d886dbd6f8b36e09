// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_tests_unit_harmonic_h
#define lamella_tests_unit_harmonic_h

#include "fixtures.h"

/**
 * A smooth exact solution. With phi harmonic,
 *   phi = exp(sqrt(2) k y) sin(k x + 0.3) sin(k z + 0.7),
 * u = grad phi has div u = 0 and laplace u = 0, so it satisfies the equations
 * of an isotropic body without body forces, whatever its constants.
 */
namespace lamella::harmonic
{
  using dealii::Point;
  using dealii::Tensor;

  constexpr double k = 1.2;

  /// The derivatives of the factors of phi: order a in x, b in y, c in z.
  inline double
  derivative(const Point<3> &x, const int a, const int b, const int c)
  {
    const auto sine = [](const double angle, const int order) {
      return std::pow(k, order) *
             std::sin(angle + order * dealii::numbers::PI_2);
    };
    return sine(k * x[0] + 0.3, a) * sine(k * x[2] + 0.7, c) *
           std::pow(std::sqrt(2.) * k, b) * std::exp(std::sqrt(2.) * k * x[1]);
  }

  inline Tensor<1, 3>
  exact(const Point<3> &x)
  {
    return Point<3>(derivative(x, 1, 0, 0),
                    derivative(x, 0, 1, 0),
                    derivative(x, 0, 0, 1));
  }

  inline Voigt
  exact_strain(const Point<3> &x)
  {
    Voigt strain;
    strain[0] = derivative(x, 2, 0, 0);
    strain[1] = derivative(x, 0, 2, 0);
    strain[2] = derivative(x, 0, 0, 2);
    strain[3] = 2. * derivative(x, 1, 1, 0);
    strain[4] = 2. * derivative(x, 1, 0, 1);
    strain[5] = 2. * derivative(x, 0, 1, 1);
    return strain;
  }

  /// Root mean square errors of displacement and strain over (n + 1)^3 points
  /// of each element.
  inline std::array<double, 2>
  errors(const Body &body, const Vector &u, const unsigned int n)
  {
    std::array<double, 2> sums{{0., 0.}};
    unsigned int          count = 0;
    for (const OutputCell &cell : output_cells(body, n, u))
      for (unsigned int i = 0; i < cell.samples.size(); ++i, ++count)
        {
          const Point<3> &x = cell.positions[i];
          sums[0] += (cell.samples[i].displacement - exact(x)).norm_square();
          sums[1] += (cell.samples[i].strain - exact_strain(x)).norm_square();
        }
    return {{std::sqrt(sums[0] / count), std::sqrt(sums[1] / count)}};
  }
} // namespace lamella::harmonic

#endif
