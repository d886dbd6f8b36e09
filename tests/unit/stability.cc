// SPDX-License-Identifier: LGPL-2.1-or-later

// Every theory at the extremes: from a block to a hair, from a square to a
// sheet, from stiff cores to soft ones, in millimetres and in kilometres. Any
// drift that beam theory does not explain is lost digits. The tables of
// doc/stable-basis.md are what this prints with --log_level=message, lines
// that begin with a bar.

#include "fixtures.h"

#include <lamella/material/library.h>
#include <lamella/section/lagrange_element.h>
#include <lamella/solve/checks.h>

#include <boost/test/unit_test.hpp>

#include <iomanip>

using namespace lamella;
using dealii::Point;

namespace
{
  using Materials = std::map<std::string, EngineeringConstants>;

  struct Strip
  {
    std::string name;
    Laminate    laminate;
    Materials   materials;

    std::shared_ptr<const Section>
    section(const std::string &theory) const
    {
      return make_section(make_section_mesh(laminate, materials),
                          Theory::parse(theory, "Theory"));
    }
  };



  /// A square of one material, [0/90/0], and stiff skins on a core five
  /// thousand times softer.
  std::vector<Strip>
  strips()
  {
    const auto carbon = library_material("IM7-8552", Units::parse("mm, N"));
    return {{"isotropic",
             {1., {0.}, {1.}, {"m"}, {2}, {2}},
             {{"m", EngineeringConstants::isotropic(70e3, 0.3)}}},
            {"[0/90/0]",
             {10., {0., 90., 0.}, {1., 1., 1.}, {"m", "m", "m"}, {1}, {2}},
             {{"m", carbon}}},
            {"sandwich",
             {5., {0., 0., 0.}, {0.1, 0.8, 0.1}, {"s", "c", "s"}, {1}, {2}},
             {{"s", carbon},
              {"c", EngineeringConstants::isotropic(35., 0.4)}}}};
  }



  struct Result
  {
    /// Deflection over L^3, or twist over L, under a unit force or torque.
    double flexibility      = 0.;
    double first_correction = 0., condition = 0.;
  };

  enum class Loading
  {
    bending,
    torsion
  };



  /// A cantilever of four B4 whose length is @p slenderness times the height of
  /// @p strip, loaded at its end. Few elements on purpose: end effects, of
  /// relative size h/L, are then not resolved, and what is left is beam theory
  /// with shear, a + b (h/L)^2.
  Result
  flexibility(const Strip       &strip,
              const std::string &theory,
              const Loading      loading,
              const double       slenderness,
              const unsigned int refinements = 6)
  {
    const double W = strip.laminate.width, H = strip.laminate.height(),
                 L = slenderness * H;
    Load end       = traction("end", "0", "0", digits(1. / (W * H)));
    if (loading == Loading::torsion)
      {
        // Tractions of a unit torque, as those of a turn of the whole section.
        const double Ip = W * H * (W * W + H * H) / 12.;
        end             = traction("end",
                       digits(-1. / Ip) + " * (z - " + digits(H / 2.) + ")",
                       "0",
                       digits(1. / Ip) + " * (x - " + digits(W / 2.) + ")");
      }
    const Solved solved =
      solve_linear(std::make_unique<Beam>("strip",
                                          strip.section(theory),
                                          make_axis(L, 4),
                                          Placement()),
                   {clamp("start")},
                   {end},
                   refinements);
    const auto u_z = [&](const double x, const double y) {
      return solved.at(Point<3>(x, y, H / 2.)).displacement[2];
    };
    Result result;
    result.condition = solved.condition;
    if (!solved.state.free_corrections.empty())
      result.first_correction = solved.state.free_corrections.front();
    if (loading == Loading::bending)
      result.flexibility = u_z(W / 2., L) / std::pow(L, 3);
    else
      result.flexibility = (u_z(W, 0.75 * L) - u_z(0., 0.75 * L) -
                            u_z(W, 0.25 * L) + u_z(0., 0.25 * L)) /
                           (W * 0.5 * L);
    return result;
  }



  void
  check_slenderness(const Strip       &strip,
                    const std::string &theory,
                    const Loading      loading)
  {
    // What depends on h/L, a + b (h/L)^2, from two lengths where doubles hold
    // it well; then nothing else may be seen up to a hair. (A sandwich has
    // (h/L)^4 terms, too: at L/h = 1e3 they are still 4e-6.)
    const double s1 = 4e3, s2 = 8e3;
    const double r1 = flexibility(strip, theory, loading, s1).flexibility,
                 r2 = flexibility(strip, theory, loading, s2).flexibility;
    const double b  = (r1 - r2) / (1. / (s1 * s1) - 1. / (s2 * s2));
    const double a  = r1 - b / (s1 * s1);
    for (const double s : {1e4, 1e5, 1e6})
      {
        const Result refined  = flexibility(strip, theory, loading, s),
                     plain    = flexibility(strip, theory, loading, s, 0);
        const double expected = a + b / (s * s);
        const double off      = std::abs(refined.flexibility / expected - 1.);
        BOOST_TEST_MESSAGE(
          "| " << strip.name << " | " << theory << " | "
               << (loading == Loading::bending ? "bending" : "torsion") << " | "
               << s << std::setprecision(2) << " | " << off << " | "
               << std::abs(plain.flexibility / refined.flexibility - 1.)
               << " | " << refined.first_correction << " | "
               << refined.condition << " |");
        // The issue is 1e-6; a and b themselves are known to about 1e-8.
        BOOST_TEST(off < 1e-7);
        if (s == 1e4)
          BOOST_TEST(std::abs(plain.flexibility / refined.flexibility - 1.) <
                     1e-5);
      }
  }
} // namespace

BOOST_AUTO_TEST_SUITE(stability)

BOOST_AUTO_TEST_CASE(from_a_block_to_a_hair)
{
  BOOST_TEST_MESSAGE("| section | theory | load | L/h | off | without "
                     "refinement | first correction | condition |");
  for (const Strip &strip : strips())
    for (const char *theory : {"EBBT", "TBT", "TE-1", "TE-2", "LE-2"})
      {
        check_slenderness(strip, theory, Loading::bending);
        // The classical theories cannot twist.
        if (!Theory::parse(theory, "").is_classical())
          check_slenderness(strip, theory, Loading::torsion);
      }
}



BOOST_AUTO_TEST_CASE(stubby_beams_follow_beam_theory_with_shear)
{
  // u L^-3 = 1/(3 E I) (1 + 3 E I / (k G A L^2)) for TBT, from L/h = 2 on, and
  // without the second term for EBBT.
  const Strip  strip = strips()[0];
  const double E = 70e3, G = E / 2.6, I = 1. / 12.;
  for (const double s : {2., 5., 10., 100.})
    {
      const double tbt =
        flexibility(strip, "TBT", Loading::bending, s).flexibility;
      const double ebbt =
        flexibility(strip, "EBBT", Loading::bending, s).flexibility;
      BOOST_TEST(std::abs(3. * E * I * tbt - (1. + 3. * E * I / (G * s * s))) <
                 1e-10);
      BOOST_TEST(std::abs(3. * E * I * ebbt - 1.) < 1e-10);
    }
}



BOOST_AUTO_TEST_CASE(from_a_square_to_a_sheet)
{
  // A plate of length and width W clamped at one side. As h/W vanishes its
  // deflection times E h^3 tends to that of a thin plate, with shear of the
  // order (h/W)^2 and edge layers of the order h/W; from 1e4 to 1e5 the change
  // must be a tenth of that from 1e3 to 1e4, or rounding. A nodal basis loses
  // the digits that the columns keep.
  const auto carbon = library_material("IM7-8552", Units::parse("mm, N"));
  const auto stiffness_times_deflection = [&](const double       aspect,
                                              const std::string &theory,
                                              const double       columns) {
    const double   W = aspect;
    const Laminate laminate{
      W, {0., 90., 0.}, {0.3, 0.4, 0.3}, {"m", "m", "m"}, {1}, {4}};
    const auto   mesh = make_section_mesh(laminate, {{"m", carbon}});
    const Theory kind = Theory::parse(theory, "");
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
    auto skin = library_material("IM7-8552", Units::parse("mm, N"));
    for (double *constant :
         {&skin.E1, &skin.E2, &skin.E3, &skin.G12, &skin.G13, &skin.G23})
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
  // Millimetres and newtons; metres; a million times both.
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
  // section of a millimetre is one of a kilometre. Degree 20 runs as a scene:
  // tests/scenes/taylor_20_mm.expect and taylor_20_km.expect.
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



BOOST_AUTO_TEST_CASE(nearly_incompressible)
{
  // A free bar in tension: sigma = E eps whatever nu, exactly, though
  // lambda / mu grows to 5e3. Three supports hold its rigid motions.
  for (const double nu : {0.3, 0.4999})
    for (const char *theory :
         {"EBBT", "TBT", "TE-1", "TE-2", "TE-5", "LE-1", "LE-2"})
      {
        const Strip  strip{"bar",
                          {1., {0.}, {1.}, {"m"}, {2}, {2}},
                          {{"m", EngineeringConstants::isotropic(1., nu)}}};
        Support      axial{"axial",
                      {{0, Region::Kind::surface, "start", {}}},
                      {{{}, 0., {}}}};
        Support      corner{"corner",
                       {{0, Region::Kind::point, "", {Point<3>(0., 0., 0.)}}},
                       {{0., {}, 0.}}};
        Support      no_turn{"no turn",
                        {{0, Region::Kind::point, "", {Point<3>(1., 0., 0.)}}},
                        {{{}, {}, 0.}}};
        const Solved solved =
          solve_linear(std::make_unique<Beam>("bar",
                                              strip.section(theory),
                                              make_axis(4., 2),
                                              Placement()),
                       {axial, corner, no_turn},
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
