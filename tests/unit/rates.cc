// SPDX-License-Identifier: LGPL-2.1-or-later

// Convergence against a smooth exact solution (harmonic.h), prescribed on the
// whole surface: inside, elements of degree p must converge with h^(p+1) in
// displacements and h^p in strains.

#include "harmonic.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(rates)

using namespace lamella;
using dealii::Point;

namespace
{
  /// Root mean square errors of displacement and strain over sampled points.
  std::array<double, 2>
  errors(const unsigned int section_degree,
         const unsigned int cells,
         const unsigned int axis_degree,
         const unsigned int elements,
         const bool         assumed_shear = false)
  {
    const auto   section = make_section(rectangle(1., 1., {0.}, cells, cells),
                                      EngineeringConstants::isotropic(1., 0.3),
                                      section_degree);
    Beam         beam("beam",
              section,
              make_axis(1., elements, axis_degree, assumed_shear),
              Placement());
    const Vector u =
      solve_prescribed(beam, prescribe_on_surface(beam, harmonic::exact), 0);

    return harmonic::errors(beam, u, 5);
  }



  void
  check_rates(const std::string           &what,
              const std::array<double, 2> &coarse,
              const std::array<double, 2> &fine,
              const unsigned int           degree)
  {
    const double displacement = std::log2(coarse[0] / fine[0]),
                 strain       = std::log2(coarse[1] / fine[1]);
    BOOST_TEST_MESSAGE(what << ", degree " << degree << ": rates "
                            << displacement << " and " << strain);
    BOOST_TEST(displacement > degree + 1 - 0.15);
    BOOST_TEST(displacement < degree + 1 + 0.6);
    BOOST_TEST(strain > degree - 0.15);
    BOOST_TEST(strain < degree + 0.6);
  }
} // namespace

BOOST_AUTO_TEST_CASE(section)
{
  // Six B4 along the axis leave an error below that of the section meshes.
  check_rates("section", errors(1, 2, 3, 3), errors(1, 4, 3, 3), 1);
  check_rates("section", errors(2, 2, 3, 6), errors(2, 4, 3, 6), 2);
  check_rates("section", errors(3, 1, 3, 6), errors(3, 2, 3, 6), 3);
}



BOOST_AUTO_TEST_CASE(axis)
{
  // One cell of degree 6 leaves an error below that of the axis meshes.
  for (const unsigned int degree : {1, 2, 3})
    check_rates("axis",
                errors(6, 1, degree, 2),
                errors(6, 1, degree, 4),
                degree);
}



BOOST_AUTO_TEST_CASE(axis_with_assumed_shear)
{
  // The projection of shear strains is off by h^p and orthogonal to what their
  // work sees: the same rates.
  for (const unsigned int degree : {1, 2})
    check_rates("axis, assumed shear",
                errors(6, 1, degree, 2, true),
                errors(6, 1, degree, 4, true),
                degree);
}

BOOST_AUTO_TEST_SUITE_END()
