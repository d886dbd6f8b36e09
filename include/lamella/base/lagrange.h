// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_lagrange_h
#define lamella_base_lagrange_h

#include <vector>

namespace lamella
{
  /// The Lagrange polynomial of @p points that is one at point @p i, at @p t.
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
} // namespace lamella

#endif
