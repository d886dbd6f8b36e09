// SPDX-License-Identifier: LGPL-2.1-or-later

// Theories at the extremes: from a square to a sheet, from compressible to
// nearly incompressible; see hair.cc for slender beams and units.cc for soft
// cores in any units. Any drift that beam theory does not explain is lost
// digits. The table of doc/theory/stable-basis.md is what this prints with
// --log_level=message, lines that begin with a bar.

#include "strip.h"

#include <lamella/material/material.h>
#include <lamella/section/lagrange_element.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <iomanip>

BOOST_AUTO_TEST_SUITE(stability)

using namespace lamella;
using dealii::Point;

BOOST_AUTO_TEST_CASE(from_a_square_to_a_sheet)
{
  // A plate of length and width W clamped at one side. As h/W vanishes its
  // deflection times E h^3 tends to that of a thin plate, with shear of the
  // order (h/W)^2 and edge layers of the order h/W; from 1e4 to 1e5 the change
  // must be a tenth of that from 1e3 to 1e4, or rounding. A nodal basis loses
  // the digits that the columns keep.
  const auto carbon =
    library_material("IM7-8552", Units::parse({"Units", "mm, N"}));
  const auto stiffness_times_deflection = [&](const double       aspect,
                                              const std::string &theory,
                                              const double       columns) {
    const double   W = aspect;
    const Laminate laminate{
      W, {0., 90., 0.}, {0.3, 0.4, 0.3}, {"m", "m", "m"}, {1}, {4}};
    const auto   mesh = make_section_mesh(laminate, {{"m", carbon}});
    const Theory kind = Theory::parse({"Theory", theory});
    const auto   section =
      kind.kind == Theory::Kind::LE ?
          std::make_shared<const Section>(
          std::make_unique<LagrangeElement>(mesh, kind.order, columns), kind) :
          make_section(mesh, kind);
    const Solved solved = solve_linear(
      std::make_unique<Beam>("plate", section, make_axis(W, 4), Placement()),
      {clamp("start")},
      {traction("end", "0", "0", digits(1. / W))});
    const double value =
      solved.at(Point<3>(W / 2., W, 0.5)).displacement[2] / (W * W) * 1e3;
    const auto &corrections = solved.state.free_corrections;
    BOOST_TEST_MESSAGE(
      "| " << theory << (columns > 1e9 ? ", nodal" : "") << " | " << aspect
           << std::setprecision(9) << " | " << value << std::setprecision(2)
           << " | " << corrections.front() << " | " << corrections.back()
           << " | " << solved.condition << " |");
    return std::make_pair(value, corrections.front());
  };

  BOOST_TEST_MESSAGE("| basis | W/h | deflection | first correction | last "
                     "correction | condition |");
  for (const char *theory : {"TE-3", "LE-2"})
    {
      std::map<double, double> value;
      for (const double aspect : {1., 1e1, 1e2, 1e3, 1e4, 1e5})
        value[aspect] = stiffness_times_deflection(aspect, theory, 100.).first;
      BOOST_TEST(std::abs(value[1e4] / value[1e3] - 1.) < 1e-4);
      BOOST_TEST(std::abs(value[1e5] - value[1e4]) <
                 0.11 * std::abs(value[1e4] - value[1e3]) + 1e-8 * value[1e5]);
    }
  const double columns = stiffness_times_deflection(1e3, "LE-2", 100.).second,
               nodal   = stiffness_times_deflection(1e3, "LE-2", 1e99).second;
  BOOST_TEST(columns < 0.1 * nodal);
}



BOOST_AUTO_TEST_CASE(nearly_incompressible)
{
  // A free bar in tension: sigma = E eps whatever nu, exactly, though
  // lambda / mu grows to 5e3. Three supports hold its rigid motions.
  for (const double nu : {0.3, 0.4999})
    for (const char *theory :
         {"EBBT", "TBT", "TE-1", "TE-2", "TE-5", "LE-1", "LE-2"})
      {
        const Strip strip{"bar",
                          {1., {0.}, {1.}, {"m"}, {2}, {2}},
                          {{"m", EngineeringConstants::isotropic(1., nu)}}};
        Support     axial{"axial",
                      {{0, Region::Kind::surface, "start", {}}},
                      {{{}, 0., {}}}};
        Support     corner{"corner",
                       {{0, Region::Kind::point, "", {Point<3>(0., 0., 0.)}}},
                       {{0., {}, 0.}}};
        Support     no_rotation{
          "no turn",
          {{0, Region::Kind::point, "", {Point<3>(1., 0., 0.)}}},
          {{{}, {}, 0.}}};
        const Solved solved =
          solve_linear(std::make_unique<Beam>("bar",
                                              strip.section(theory),
                                              make_axis(4., 2),
                                              Placement()),
                       {axial, corner, no_rotation},
                       {traction("end", "0", "1", "0")});
        const FieldSample at = solved.at(Point<3>(0.3, 1.7, 0.8));
        // C comes out of the inverse of a nearly singular compliance, and then
        // acts on strains that nearly cancel: eps (lambda / mu)^2.
        const double tolerance = nu < 0.4 ? 1e-12 : 2e-8;
        BOOST_TEST(std::abs(at.strain[1] - 1.) < tolerance);
        BOOST_TEST(std::abs(at.strain[0] + nu) < tolerance);
        BOOST_TEST(std::abs(at.stress[1] - 1.) < tolerance);
        BOOST_TEST(std::abs(at.stress[0]) < tolerance);
      }
}



BOOST_AUTO_TEST_CASE(nearly_incompressible_at_a_clamp)
{
  // A clamp that holds the contraction of a nearly incompressible section makes
  // an end layer. On an axis that resolves it the deflection comes within 3 %
  // of that of free contraction, F L^3/(3 E I) + F L/(G A), in even degrees and
  // layer-wise; four equal elements spread the layer over a quarter of the
  // beam. That is no locking: finer elements along the axis mend it, whatever
  // the section.
  constexpr double nu = 0.4999, E = 1., L = 10.;
  const Strip      strip{"bar",
                    {1., {0.}, {1.}, {"m"}, {2}, {2}},
                    {{"m", EngineeringConstants::isotropic(E, nu)}}};
  const double     free = 4. * L * L * L / E + L * 2. * (1. + nu) / E;
  BOOST_TEST_MESSAGE("| theory | four equal B4 | graded to the clamp |");
  for (const char *theory : {"TE-2", "TE-4", "LE-2"})
    {
      const auto deflection = [&](const AxisMesh &axis) {
        return solve_linear(std::make_unique<Beam>("bar",
                                                   strip.section(theory),
                                                   std::make_shared<Axis>(axis),
                                                   Placement()),
                            {clamp("start")},
                            {traction("end", "0", "0", "1")})
                 .at(Point<3>(0.5, L, 0.5))
                 .displacement[2] /
               free;
      };
      AxisMesh equal, graded;
      equal.length = graded.length = L;
      equal.elements               = {4};
      graded.elements              = {3, 3, 4};
      graded.breaks                = {0.3, 1.5};
      const double coarse = deflection(equal), fine = deflection(graded);
      BOOST_TEST_MESSAGE("| " << theory << " | " << std::setprecision(4)
                              << coarse << " | " << fine << " |");
      BOOST_TEST(fine > 0.97);
      BOOST_TEST(fine < 1.);
      BOOST_TEST(coarse < fine);
    }
}

BOOST_AUTO_TEST_SUITE_END()
