// SPDX-License-Identifier: LGPL-2.1-or-later

// Every theory in millimeters and in kilometers, with stiff cores and soft
// ones, in low degrees and in high ones: results must not depend on the units.
// See stability.cc for other extremes.

#include "strip.h"

#include <lamella/material/material.h>

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <iomanip>

BOOST_AUTO_TEST_SUITE(units)

using namespace lamella;
using dealii::Point;

namespace
{
  /// Deflection at the end and stress at mid-span of a cantilever in units of
  /// @p length and @p modulus, in their multiples: they must not depend on the
  /// units.
  std::array<double, 3>
  in_units(const double       length,
           const double       modulus,
           const std::string &theory,
           const double       core_over_skin,
           const double       slenderness,
           const unsigned int elements)
  {
    auto skin = library_material("IM7-8552", Units::parse({"Units", "mm, N"}));
    for (double *constant : {&skin.elastic.E1,
                             &skin.elastic.E2,
                             &skin.elastic.E3,
                             &skin.elastic.G12,
                             &skin.elastic.G13,
                             &skin.elastic.G23})
      *constant *= modulus;
    const auto core =
      EngineeringConstants::isotropic(165e3 * core_over_skin * modulus, 0.4);
    const Strip  strip{"units",
                      {5. * length,
                        {0., 0., 0.},
                        {length, 8. * length, length},
                        {"s", "c", "s"},
                        {1},
                        {1}},
                      {{"s", skin}, {"c", core}}};
    const double L = slenderness * 10. * length;
    const Solved solved =
      solve_linear(std::make_unique<Beam>("strip",
                                          strip.section(theory),
                                          make_axis(L, elements),
                                          Placement()),
                   {clamp("start")},
                   {traction("end", "0", "0", digits(modulus))});
    return {{solved.at(Point<3>(0., L, 0.)).displacement[2] / length,
             solved.at(Point<3>(0., L / 2., 10. * length)).stress[1] / modulus,
             solved.condition}};
  }
} // namespace



BOOST_AUTO_TEST_CASE(soft_cores_in_any_units)
{
  // Millimeters and newtons; meters; a million times both.
  BOOST_TEST_MESSAGE("| theory | core/skin | L/h | condition | change with "
                     "units |");
  for (const char *theory : {"EBBT", "TBT", "TE-1", "TE-4", "LE-2"})
    for (const double ratio : {1., 1e-4, 1e-8})
      for (const double slenderness : {10., 1000.})
        {
          const auto in_mm  = in_units(1., 1., theory, ratio, slenderness, 2);
          double     change = 0.;
          for (const auto &[length, modulus] :
               {std::make_pair(1e-3, 1e6), {1e6, 1.}, {1e6, 1e-6}})
            {
              const auto other =
                in_units(length, modulus, theory, ratio, slenderness, 2);
              for (unsigned int k = 0; k < 2; ++k)
                change = std::max(change, std::abs(other[k] / in_mm[k] - 1.));
            }
          BOOST_TEST_MESSAGE("| " << theory << " | " << ratio << " | "
                                  << slenderness << " | "
                                  << std::setprecision(2) << in_mm[2] << " | "
                                  << change << " |");
          BOOST_TEST(change < 1e-8);
        }
}



BOOST_AUTO_TEST_CASE(taylor_expansions_of_high_degree)
{
  // Orthonormal polynomials: the condition grows slowly with the degree, and a
  // section of a millimeter is one of a kilometer. Degree 20 runs as a scene:
  // scene/taylor_20.
  BOOST_TEST_MESSAGE("| theory | condition | change with units |");
  double previous = 0.;
  for (const char *theory : {"TE-3", "TE-6", "TE-10"})
    {
      const auto   in_mm  = in_units(1., 1., theory, 1., 10., 1);
      const auto   in_km  = in_units(1e6, 1., theory, 1., 10., 1);
      const double change = std::max(std::abs(in_km[0] / in_mm[0] - 1.),
                                     std::abs(in_km[1] / in_mm[1] - 1.));
      BOOST_TEST_MESSAGE("| " << theory << " | " << std::setprecision(2)
                              << in_mm[2] << " | " << change << " |");
      BOOST_TEST(change < 1e-8);
      BOOST_TEST(in_mm[2] < 1e9);
      // More functions, more deflection, and it settles.
      BOOST_TEST(in_mm[0] > previous);
      previous = in_mm[0];
    }
}

BOOST_AUTO_TEST_SUITE_END()
