// SPDX-License-Identifier: LGPL-2.1-or-later

// What recovered strains gain, on the exact solution of harmonic.h: on the
// surface, where averages are one-sided, elements of degree p converge with
// h^p, recovered strains with h^(p+1).

#include "harmonic.h"

#include <lamella/recover/recovery.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(recovery_rates)

using namespace lamella;
using dealii::Point;

namespace
{
  using ErrorsByKind = std::map<StressValues, std::array<double, 2>>;

  /// Root mean square errors of strains, by how they are reported, at corners
  /// of elements on the surface and inside of elements, @p n elements a
  /// direction.
  ErrorsByKind
  strain_errors(const unsigned int degree, const unsigned int n)
  {
    const auto   section = make_section(rectangle(1., 1., {0.}, n, n),
                                      EngineeringConstants::isotropic(1., 0.3),
                                      degree);
    Beam         beam("beam", section, make_axis(1., n, degree), Placement());
    const Vector u =
      solve_prescribed(beam, prescribe_on_surface(beam, harmonic::exact), 0);

    std::vector<Point<3>> surface, inside;
    for (const double s : {0., 0.5, 1.})
      for (const double t : {0., 0.5, 1.})
        surface.insert(surface.end(), {{s, t, 0.}, {s, t, 1.}, {0., s, t}});
    for (const double s : {0.07, 0.45})
      for (const double t : {0.12, 0.7, 0.95})
        inside.insert(inside.end(), {{s, t, 0.6}, {0.8, s, t}});

    ErrorsByKind errors;
    for (const StressValues kind :
         {StressValues::element, StressValues::nodal, StressValues::recovered})
      {
        StressRecovery recovery(beam, u, kind);
        const auto     error = [&](const std::vector<Point<3>> &points) {
          double sum = 0.;
          for (const auto &locations : beam.locate(points))
            sum += (recovery.sample(locations[0]).strain -
                    harmonic::exact_strain(locations[0].position))
                     .norm_square();
          return std::sqrt(sum / points.size());
        };
        errors[kind] = {{error(surface), error(inside)}};
      }
    return errors;
  }
} // namespace

BOOST_AUTO_TEST_CASE(recovered_strains)
{
  for (const auto &[degree, n] :
       {std::make_pair(1, 4), std::make_pair(2, 3), std::make_pair(3, 2)})
    {
      ErrorsByKind coarse = strain_errors(degree, n),
                   fine   = strain_errors(degree, 2 * n);
      for (const auto &[kind, name] :
           {std::make_pair(StressValues::element, "element"),
            std::make_pair(StressValues::nodal, "nodal"),
            std::make_pair(StressValues::recovered, "recovered")})
        {
          const double surface = std::log2(coarse[kind][0] / fine[kind][0]);
          BOOST_TEST_MESSAGE(
            "degree " << degree << ", " << name << ": at the surface "
                      << coarse[kind][0] << ", " << fine[kind][0] << ", rate "
                      << surface << "; inside " << coarse[kind][1] << ", "
                      << fine[kind][1] << ", rate "
                      << std::log2(coarse[kind][1] / fine[kind][1]));
          const double order =
            degree + (kind == StressValues::recovered ? 1. : 0.);
          BOOST_TEST(surface > order - 0.4);
          BOOST_TEST(surface < order + 0.4);
        }
      BOOST_TEST(fine[StressValues::recovered][1] <
                 0.7 * fine[StressValues::element][1]);
    }
}

BOOST_AUTO_TEST_SUITE_END()
