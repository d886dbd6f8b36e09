// SPDX-License-Identifier: LGPL-2.1-or-later

// Convergence against a smooth exact solution. With phi harmonic,
//   phi = exp(sqrt(2) k y) sin(k x + 0.3) sin(k z + 0.7),
// u = grad phi has div u = 0 and laplace u = 0, so it satisfies the equations
// of an isotropic body without body forces, whatever its constants. It is
// prescribed on the whole surface; inside, elements of degree p must converge
// with h^(p+1) in displacements and h^p in strains.

#include "fixtures.h"

#include <lamella/report/recovery.h>

#include <boost/test/unit_test.hpp>

using namespace lamella;
using dealii::Point;
using dealii::Tensor;

namespace
{
  constexpr double k = 1.2;

  /// The derivatives of the factors of phi: order a in x, b in y, c in z.
  double
  derivative(const Point<3> &x, const int a, const int b, const int c)
  {
    const auto sine = [](const double angle, const int order) {
      return std::pow(k, order) *
             std::sin(angle + order * dealii::numbers::PI_2);
    };
    return sine(k * x[0] + 0.3, a) * sine(k * x[2] + 0.7, c) *
           std::pow(std::sqrt(2.) * k, b) * std::exp(std::sqrt(2.) * k * x[1]);
  }



  Tensor<1, 3>
  exact(const Point<3> &x)
  {
    return Point<3>(derivative(x, 1, 0, 0),
                    derivative(x, 0, 1, 0),
                    derivative(x, 0, 0, 1));
  }



  Voigt
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
      solve_prescribed(beam, prescribe_on_surface(beam, exact), 0);

    std::array<double, 2> sums{{0., 0.}};
    unsigned int          n = 0;
    for (const OutputCell &cell : beam.output_cells(5, u))
      for (unsigned int i = 0; i < cell.samples.size(); ++i, ++n)
        {
          const Point<3> &x = cell.positions[i];
          sums[0] += (cell.samples[i].displacement - exact(x)).norm_square();
          sums[1] += (cell.samples[i].strain - exact_strain(x)).norm_square();
        }
    return {{std::sqrt(sums[0] / n), std::sqrt(sums[1] / n)}};
  }



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
      solve_prescribed(beam, prescribe_on_surface(beam, exact), 0);

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
                    exact_strain(locations[0].position))
                     .norm_square();
          return std::sqrt(sum / points.size());
        };
        errors[kind] = {{error(surface), error(inside)}};
      }
    return errors;
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

BOOST_AUTO_TEST_SUITE(rates)

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
          // One order more at the surface, where averages are one-sided.
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
