// SPDX-License-Identifier: LGPL-2.1-or-later

// Elements for pictures: the fields on their grids, and how VTK numbers their
// points.

#include "fixtures.h"

#include <lamella/adapt/node_fields.h>
#include <lamella/body/fields.h>
#include <lamella/body/parameters.h>
#include <lamella/report/vtu.h>

#include <boost/test/unit_test.hpp>

#include <random>
#include <set>

BOOST_AUTO_TEST_SUITE(pictures)

using namespace lamella;
using dealii::Point;
using dealii::Tensor;

namespace
{
  /// A turned strip of two plies that couple everything.
  Bodies
  made(const std::string &theory, const unsigned int axis_degree)
  {
    Material material =
      EngineeringConstants{165., 9., 8., 5.6, 5.2, 2.8, 0.34, 0.3, 0.45};
    material.expansion = Tensor<1, 3>({1e-3, 3e-2, 2e-2});
    BodyDescription body;
    body.name                 = "beam";
    body.section              = "strip";
    body.theory               = Theory::parse({"Theory", theory});
    body.theory.section_order = 2;
    body.axis.length          = 6.;
    body.axis.elements        = {theory == "SV-4" ? 12u : 3u};
    body.axis.degree          = axis_degree;
    body.axis.assumed_shear   = axis_degree < 3;
    body.placement            = Placement::from_directions({0.2, -0.1, 0.4},
                                                Point<3>(1., 2., 0.5),
                                                Point<3>(-0.3, 0.2, 1.));
    const std::vector<BodyDescription> descriptions{body};

    Bodies bodies =
      make_bodies(descriptions,
                  {{"strip",
                    make_section_mesh(rectangle(2., 1., {30., -45.}, 2),
                                      {{"material", material}})}});
    if (has_fields_to_choose(descriptions))
      choose_fields(bodies, descriptions, {clamp("start")}, {}, {});
    // What TE-1 makes of heat is not known at a point.
    if (theory != "TE-1")
      bodies[0]->heat([](const Point<3> &x) { return 1. + x[0] * x[2]; });
    return bodies;
  }
} // namespace

BOOST_AUTO_TEST_CASE(elements_have_the_samples_of_their_points)
{
  const GridIntervals n{{2, 3, 1}};
  for (const unsigned int axis_degree : {3, 1})
    for (const std::string theory :
         {"EBBT", "TBT", "TE-1", "TE-3", "LE-2", "SV-4", "solid-2"})
      BOOST_TEST_CONTEXT(theory << ", degree " << axis_degree)
      {
        if (axis_degree == 1 && (theory == "EBBT" || theory == "solid-2"))
          continue;
        const Bodies bodies = made(theory, axis_degree);
        const Body  &body   = *bodies[0];
        Vector       u(body.n_dofs());
        std::mt19937 generator(1);
        for (double &x : u)
          x = std::uniform_real_distribution<double>(-1., 1.)(generator);

        std::set<unsigned int> numbers;
        double                 worst   = 0.;
        const auto             compare = [&](const auto &a, const auto &b) {
          worst = std::max(worst, (a - b).norm() / (1. + b.norm()));
        };
        body.for_each_output_cell(
          n, u, [&](const unsigned int number, const OutputCell &cell) {
            numbers.insert(number);
            for (unsigned int at = 0; at < cell.samples.size(); ++at)
              {
                const Point<3>     unit(at % 3 / 2., at / 3 % 4 / 3., at / 12);
                const Location     location{cell.positions[at],
                                        cell.ply,
                                        {{number, unit}}};
                const FieldSample &found = cell.samples[at],
                                  due    = body.sample(location, u);
                compare(found.displacement, due.displacement);
                compare(found.strain, due.strain);
                compare(found.stress, due.stress);
                compare(found.ply_stress, due.ply_stress);
                compare(cell.positions[at], body.position(location.places[0]));
              }
          });
        BOOST_TEST(worst < 1e-11);
        // Each element once, and the other way to ask for them.
        BOOST_TEST(*numbers.rbegin() + 1 == numbers.size());
        BOOST_TEST(output_cells(body, 1, u).size() == numbers.size());
      }
}



BOOST_AUTO_TEST_CASE(degrees_of_elements)
{
  const auto degrees = [](const std::string &theory) {
    return made(theory, 3)[0]->cells().output_degrees;
  };
  BOOST_TEST((degrees("LE-2") == GridIntervals{{2, 3, 2}}));
  BOOST_TEST((degrees("TBT") == GridIntervals{{1, 3, 1}}));
  BOOST_TEST((degrees("SV-4") == GridIntervals{{2, 3, 2}}));
  BOOST_TEST((degrees("solid-2") == GridIntervals{{2, 2, 2}}));
}



BOOST_AUTO_TEST_CASE(points_of_a_lagrange_hexahedron)
{
  // vtkHigherOrderHexahedron::PointIndexFromIJK() of VTK 9.1, the first
  // coordinate fastest.
  const std::vector<unsigned int> due{0,  8,  1,  12, 50, 9,  13, 51, 10, 3,
                                      11, 2,  20, 44, 23, 32, 54, 38, 33, 55,
                                      39, 29, 47, 26, 21, 45, 24, 34, 56, 40,
                                      35, 57, 41, 30, 48, 27, 22, 46, 25, 36,
                                      58, 42, 37, 59, 43, 31, 49, 28, 4,  14,
                                      5,  18, 52, 15, 19, 53, 16, 7,  17, 6};
  std::vector<unsigned int>       found;
  for (unsigned int k = 0; k <= 4; ++k)
    for (unsigned int j = 0; j <= 3; ++j)
      for (unsigned int i = 0; i <= 2; ++i)
        found.push_back(vtk_hexahedron_point({{2, 3, 4}}, i, j, k));
  BOOST_TEST(found == due, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
