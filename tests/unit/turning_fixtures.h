// SPDX-License-Identifier: LGPL-2.1-or-later

// What tests of bodies that turn by any angle share.

#ifndef lamella_tests_turning_fixtures_h
#define lamella_tests_turning_fixtures_h

#include "fixtures.h"

#include <random>

namespace lamella
{
  /// Nine constants, all different.
  inline Material
  nine_constants()
  {
    EngineeringConstants c;
    c.E1   = 10.;
    c.E2   = 2.;
    c.E3   = 1.5;
    c.G12  = 0.9;
    c.G13  = 0.8;
    c.G23  = 0.6;
    c.nu12 = 0.3;
    c.nu13 = 0.25;
    c.nu23 = 0.35;
    return c;
  }

  /// @p n numbers between -@p size and @p size, the same for a @p seed.
  inline Vector
  random_vector(const unsigned int n,
                const double       size,
                const unsigned int seed)
  {
    std::mt19937                           generator(seed);
    std::uniform_real_distribution<double> number(-size, size);
    Vector                                 v(n);
    for (double &entry : v)
      entry = number(generator);
    return v;
  }
} // namespace lamella

#endif
