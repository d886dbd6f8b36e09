// SPDX-License-Identifier: LGPL-2.1-or-later

// Classical lamination theory against sums worked out by hand, and the mesh of
// a laminate: cells, plies, names of the boundaries.

#include "entries.h"
#include "fixtures.h"

#include <lamella/base/exceptions.h>
#include <lamella/shape/parameters.h>

#include <boost/test/unit_test.hpp>

#include <cmath>

BOOST_AUTO_TEST_SUITE(laminate)

using namespace lamella;
using dealii::Tensor;

namespace
{
  const EngineeringConstants
    orthotropic{165., 9., 8., 5.6, 5.2, 2.8, 0.34, 0.3, 0.45};

  // The reduced stiffnesses of its plane stress:
  // nu21 = 0.34 9/165, Q11 = E1/(1 - nu12 nu21), Q12 = nu12 E2/(1 - ...).
  const double denominator = 1. - 0.34 * 0.34 * 9. / 165.;
  const double Q11 = 165. / denominator, Q22 = 9. / denominator,
               Q12 = 0.34 * 9. / denominator, Q66 = 5.6;

  constexpr double t     = 0.4;
  constexpr double width = 3.;



  LaminateStiffness
  stiffness_of(const std::vector<double> &angles,
               const Material            &material = orthotropic)
  {
    const Laminate laminate = rectangle(width, t * angles.size(), angles);
    return laminate_stiffness(laminate.plies({{"material", material}}), width);
  }



  /// Compares with the upper triangle {11, 12, 16, 22, 26, 66}, where 1 is y
  /// (along the beam), 2 is x, 6 is xy.
  void
  check_matrix(const Tensor<2, 3>        &M,
               const std::vector<double> &expected,
               const std::string         &name)
  {
    double scale = 0.;
    for (const double e : expected)
      scale = std::max(scale, std::abs(e));
    for (unsigned int i = 0, k = 0; i < 3; ++i)
      for (unsigned int j = i; j < 3; ++j, ++k)
        {
          BOOST_TEST(std::abs(M[i][j] - expected[k]) <= 1e-13 * (scale + 1.),
                     name << i << j << " = " << M[i][j] << ", not "
                          << expected[k]);
          BOOST_TEST(std::abs(M[j][i] - M[i][j]) <= 1e-13 * (scale + 1.));
        }
  }



  double
  relative(const double value, const double expected)
  {
    return std::abs(value / expected - 1.);
  }
} // namespace

BOOST_AUTO_TEST_CASE(symmetric_cross_ply)
{
  // [0/90/0], z from -3t/2 to 3t/2. int z^2 over the outer plies
  // 2/3 ((3/2)^3 - (1/2)^3) t^3 = 26/12 t^3, over the middle one t^3/12.
  const LaminateStiffness s  = stiffness_of({0., 90., 0.});
  const double            t3 = t * t * t;
  check_matrix(s.A,
               {(2. * Q11 + Q22) * t,
                3. * Q12 * t,
                0.,
                (2. * Q22 + Q11) * t,
                0.,
                3. * Q66 * t},
               "A");
  check_matrix(s.B, {0., 0., 0., 0., 0., 0.}, "B");
  check_matrix(s.D,
               {(26. * Q11 + Q22) * t3 / 12.,
                27. * Q12 * t3 / 12.,
                0.,
                (26. * Q22 + Q11) * t3 / 12.,
                0.,
                27. * Q66 * t3 / 12.},
               "D");

  // Free to contract: EA = b (A11 - A12^2/A22), EI likewise, as B = 0 and
  // nothing couples to shear.
  const double A11 = (2. * Q11 + Q22) * t, A12 = 3. * Q12 * t,
               A22 = (2. * Q22 + Q11) * t;
  BOOST_TEST(relative(s.EA, width * (A11 - A12 * A12 / A22)) < 1e-13);
  const double D11 = (26. * Q11 + Q22) * t3 / 12., D12 = 27. * Q12 * t3 / 12.,
               D22 = (26. * Q22 + Q11) * t3 / 12.;
  BOOST_TEST(relative(s.EI, width * (D11 - D12 * D12 / D22)) < 1e-13);

  // G_yz is G13 = 5.2 at 0 degrees and G23 = 2.8 at 90.
  BOOST_TEST(relative(s.GA, width * t * (2. * 5.2 + 2.8)) < 1e-13);
}



BOOST_AUTO_TEST_CASE(unsymmetric_cross_ply)
{
  // [0/90], the 0 below: int z is -t^2/2 there and t^2/2 above; int z^2 is
  // t^3/3 in each.
  const LaminateStiffness s  = stiffness_of({0., 90.});
  const double            t3 = t * t * t;
  check_matrix(
    s.A,
    {(Q11 + Q22) * t, 2. * Q12 * t, 0., (Q11 + Q22) * t, 0., 2. * Q66 * t},
    "A");
  const double b = (Q22 - Q11) * t * t / 2.;
  check_matrix(s.B, {b, 0., 0., -b, 0., 0.}, "B");
  check_matrix(s.D,
               {(Q11 + Q22) * t3 / 3.,
                2. * Q12 * t3 / 3.,
                0.,
                (Q11 + Q22) * t3 / 3.,
                0.,
                2. * Q66 * t3 / 3.},
               "D");
}



BOOST_AUTO_TEST_CASE(two_bars_glued_together)
{
  // E = 3 below, E = 1 above, no contraction, b = 3, t = 0.4. About the
  // mid-plane A = (3 + 1) t, B = (1 - 3) t^2/2 = -t^2, D = (3 + 1) t^3/3; the
  // strip under tension bends freely, so EA = b (A - B^2/D) = b 13/4 t, and
  // under a moment stretches freely: EI = b (D - B^2/A) = b 13/12 t^3.
  const LaminateStiffness s =
    stiffness_of({0., 90.},
                 EngineeringConstants{3., 1., 1., 1., 1., 1., 0., 0., 0.});
  BOOST_TEST(relative(s.EA, width * 13. / 4. * t) < 1e-13);
  BOOST_TEST(relative(s.EI, width * 13. / 12. * t * t * t) < 1e-13);
}



BOOST_AUTO_TEST_CASE(angle_ply)
{
  // [45/-45], the +45 below. Qbar at +-45 degrees (the usual
  // transformation with c = s): 11 = 22 = (Q11 + Q22 + 2 Q12)/4 + Q66, 12 = 11
  // - 2 Q66, 66 = (Q11 + Q22 - 2 Q12)/4, 16 = 26 = +-(Q11 - Q22)/4. Then A16 =
  // D16 = 0 and B16 = -t^2/2 Qbar16(45) + t^2/2 Qbar16(-45) = -t^2 (Q11 -
  // Q22)/4.
  const LaminateStiffness s  = stiffness_of({45., -45.});
  const double            t3 = t * t * t;
  const double q11 = (Q11 + Q22 + 2. * Q12) / 4. + Q66, q12 = q11 - 2. * Q66,
               q66 = (Q11 + Q22 - 2. * Q12) / 4., q16 = (Q11 - Q22) / 4.;
  check_matrix(s.A,
               {2. * t * q11, 2. * t * q12, 0., 2. * t * q11, 0., 2. * t * q66},
               "A");
  check_matrix(s.B, {0., 0., -t * t * q16, 0., -t * t * q16, 0.}, "B");
  const double f = 2. * t3 / 3.;
  check_matrix(s.D, {f * q11, f * q12, 0., f * q11, 0., f * q66}, "D");
  // (G13 + G23)/2 = 4 in both plies.
  BOOST_TEST(relative(s.GA, width * 2. * t * 4.) < 1e-13);
}



BOOST_AUTO_TEST_CASE(off_axis_ply)
{
  // One ply, free to contract and to shear or twist: E_y from
  // 1/E_y = c^4/E1 + (1/G12 - 2 nu12/E1) s^2 c^2 + s^4/E2; at 30 degrees
  // c^2 = 3/4, s^2 = 1/4.
  const double E =
    1. / (9. / 16. / 165. + (1. / 5.6 - 2. * 0.34 / 165.) * 3. / 16. +
          1. / 16. / 9.);
  for (const double angle : {30., -30., 150.})
    {
      const LaminateStiffness s = stiffness_of({angle});
      BOOST_TEST(relative(s.EA, E * width * t) < 1e-12);
      BOOST_TEST(relative(s.EI, E * width * t * t * t / 12.) < 1e-12);
    }
}



BOOST_AUTO_TEST_CASE(symmetric_layups_do_not_couple)
{
  for (const std::vector<double> &angles :
       {std::vector<double>{0., 45., -45., 90., 90., -45., 45., 0.},
        std::vector<double>{30., 60., 30.}})
    {
      const LaminateStiffness s = stiffness_of(angles);
      BOOST_TEST(s.B.norm() < 1e-14 * s.A.norm());
    }
  // And one that is not symmetric does.
  BOOST_TEST(stiffness_of({30., 60.}).B.norm() > 1.);
}



BOOST_AUTO_TEST_CASE(isotropic_strip)
{
  // E = 10, nu = 0.25, G = 4; b = 3, h = 5 t = 2: EA = 60, EI = 10 3 8/12 = 20,
  // GA = 24, however many plies it is cut into.
  const auto material = EngineeringConstants::isotropic(10., 0.25);
  for (const Laminate &l :
       {rectangle(3., 2., {0.}), rectangle(3., 2., {0., 90., 45., 10., -70.})})
    {
      const LaminateStiffness s =
        laminate_stiffness(l.plies({{"material", material}}), l.width);
      BOOST_TEST(relative(s.EA, 60.) < 1e-13);
      BOOST_TEST(relative(s.EI, 20.) < 1e-13);
      BOOST_TEST(relative(s.GA, 24.) < 1e-13);
    }
}



BOOST_AUTO_TEST_CASE(mesh_of_plies_of_unequal_thickness)
{
  // Four plies of 0.1, 0.4, 0.2, 0.05, two cells each, three across: 24 cells.
  const Laminate             laminate{0.6,
                          {0., 90., 45., -30.},
                          {0.1, 0.4, 0.2, 0.05},
                          {"a", "b", "a", "b"},
                          {2},
                          {3}};
  const EngineeringConstants a = orthotropic,
                             b = EngineeringConstants::isotropic(10., 0.25);
  const auto section = make_section_mesh(laminate, {{"a", a}, {"b", b}});
  BOOST_TEST(std::abs(laminate.height() - 0.75) < 1e-15);
  BOOST_TEST(section->mesh.n_active_cells() == 24);

  const std::vector<double> bottoms{0., 0.1, 0.5, 0.7},
    tops{0.1, 0.5, 0.7, 0.75};
  BOOST_TEST_REQUIRE(section->plies.size() == 4);
  for (unsigned int i = 0; i < 4; ++i)
    {
      const Ply &ply = section->plies[i];
      BOOST_TEST(std::abs(ply.bottom - bottoms[i]) < 1e-15);
      BOOST_TEST(std::abs(ply.top - tops[i]) < 1e-15);
      BOOST_TEST(ply.angle == laminate.angles[i]);
      BOOST_TEST(ply.material == laminate.materials[i]);
      BOOST_TEST(ply.properties.elastic.E1 == (i % 2 == 0 ? 165. : 10.));
    }

  // Each cell lies in its ply, is 0.2 wide and half a ply thick.
  std::vector<unsigned int> cells_of_ply(4, 0);
  for (const auto &cell : section->mesh.active_cell_iterators())
    {
      const unsigned int ply = cell->material_id();
      BOOST_TEST_REQUIRE(ply < 4);
      ++cells_of_ply[ply];
      const auto low = cell->vertex(0), high = cell->vertex(3);
      BOOST_TEST(low[1] > bottoms[ply] - 1e-14);
      BOOST_TEST(high[1] < tops[ply] + 1e-14);
      BOOST_TEST(std::abs(high[0] - low[0] - 0.2) < 1e-14);
      BOOST_TEST(std::abs(high[1] - low[1] - 0.5 * laminate.thicknesses[ply]) <
                 1e-14);
    }
  for (const unsigned int n : cells_of_ply)
    BOOST_TEST(n == 6);

  // The names of the sides: where, how many, how long.
  std::map<std::string, unsigned int> faces;
  std::map<std::string, double>       lengths;
  for (const auto &face : section->mesh.active_face_iterators())
    if (face->at_boundary())
      {
        const std::string name = section->boundaries.at(face->boundary_id());
        const auto        at   = face->center();
        const double      off  = name == "left"   ? at[0] :
                                 name == "right"  ? at[0] - 0.6 :
                                 name == "bottom" ? at[1] :
                                 name == "top"    ? at[1] - 0.75 :
                                                    1.;
        BOOST_TEST(std::abs(off) < 1e-14);
        ++faces[name];
        lengths[name] += face->measure();
      }
  BOOST_TEST(faces.size() == 4);
  for (const char *name : {"left", "right"})
    {
      BOOST_TEST(faces[name] == 8);
      BOOST_TEST(std::abs(lengths[name] - 0.75) < 1e-14);
    }
  for (const char *name : {"bottom", "top"})
    {
      BOOST_TEST(faces[name] == 3);
      BOOST_TEST(std::abs(lengths[name] - 0.6) < 1e-14);
    }
}



BOOST_AUTO_TEST_CASE(thin_plies_beside_a_thick_one)
{
  // A foil of 1e-7 on a core of 1: each cell still finds its ply.
  const Laminate foil{
    1., {0., 0., 0.}, {1e-7, 1., 1e-7}, {"m", "m", "m"}, {2}, {1}};
  const auto section = make_section_mesh(foil, {{"m", orthotropic}});
  std::vector<unsigned int> cells(3, 0);
  for (const auto &cell : section->mesh.active_cell_iterators())
    ++cells.at(cell->material_id());
  BOOST_TEST(cells == std::vector<unsigned int>(3, 2),
             boost::test_tools::per_element());
}



BOOST_AUTO_TEST_CASE(entries_of_a_laminate)
{
  const std::vector<std::string> materials{"skin", "core"};
  const Settings                 given{{"Width", "0.1"},
                       {"Layup", "0/90/0"},
                       {"Ply thickness", "0.001, 0.02, 0.003"},
                       {"Ply materials", "skin, core, skin"},
                       {"Cells per ply", "2"},
                       {"Cells across", "5, 1"},
                       {"Across breaks", "0.04"}};
  const auto                     read = [](const Settings                 &settings,
                       const std::vector<std::string> &names) {
    return std::get<Laminate>(
      parsed<SectionParameters>("Section s", settings, names, ""));
  };
  const Laminate l = read(given, materials);
  BOOST_TEST(l.width == 0.1);
  BOOST_TEST(l.thicknesses == (std::vector<double>{0.001, 0.02, 0.003}),
             boost::test_tools::per_element());
  BOOST_TEST(l.materials == (std::vector<std::string>{"skin", "core", "skin"}),
             boost::test_tools::per_element());
  BOOST_TEST(l.cells_per_ply == std::vector<unsigned int>(3, 2),
             boost::test_tools::per_element());
  BOOST_TEST(l.cells_across == (std::vector<unsigned int>{5, 1}),
             boost::test_tools::per_element());
  BOOST_TEST(l.across_breaks == std::vector<double>{0.04},
             boost::test_tools::per_element());

  // One value stands for all plies; a single material need not be named.
  Settings one = given;
  one.emplace_back("Ply thickness", "0.5");
  one.emplace_back("Ply materials", "");
  const Laminate same = read(one, {"only"});
  BOOST_TEST(same.thicknesses == std::vector<double>(3, 0.5),
             boost::test_tools::per_element());
  BOOST_TEST(same.materials == std::vector<std::string>(3, "only"),
             boost::test_tools::per_element());
  BOOST_CHECK_THROW(read(one, materials), InputError);

  // A whole number is one however it is spelled.
  Settings spelled = given;
  spelled.emplace_back("Cells per ply", "2e0");
  spelled.emplace_back("Cells across", "5.0, 1");
  BOOST_TEST(read(spelled, materials).cells_per_ply ==
               std::vector<unsigned int>(3, 2),
             boost::test_tools::per_element());

  // What is refused, each with the entry that is wrong.
  for (const auto &[entry, value] : Settings{{"Shape", "disc"},
                                             {"Width", "0"},
                                             {"Width", "-1"},
                                             {"Width", ""},
                                             {"Width", "wide"},
                                             {"Ply thickness", "0.1, 0.2"},
                                             {"Ply thickness", "0.1, 0, 0.1"},
                                             {"Ply thickness", "0.1,, 0.1"},
                                             {"Ply thickness", ""},
                                             {"Ply materials", "skin, core"},
                                             {"Ply materials", "wood"},
                                             {"Cells per ply", "0"},
                                             {"Cells per ply", "1.5"},
                                             {"Cells per ply", "1, 2"},
                                             {"Cells across", "-2, 1"},
                                             {"Cells across", "5"},
                                             {"Cells across", "5, 1, 1"},
                                             {"Across breaks", "0.1"},
                                             {"Across breaks", "0"},
                                             {"Radius", "1"},
                                             {"Layup", "0/x"}})
    {
      Settings bad = given;
      bad.emplace_back(entry, value);
      BOOST_TEST_INFO(entry << " = " << value);
      BOOST_CHECK_EXCEPTION(read(bad, materials),
                            InputError,
                            [path =
                               "Section s/" + entry](const InputError &error) {
                              return error.path() == path;
                            });
    }
}

BOOST_AUTO_TEST_SUITE_END()
