// SPDX-License-Identifier: LGPL-2.1-or-later

// Elastic tensors, ply angles, the built-in materials and the laminate code,
// against the closed formulas of Jones, Mechanics of Composite Materials, and
// numbers worked out by hand.

#include "entries.h"

#include <lamella/base/exceptions.h>
#include <lamella/base/units.h>
#include <lamella/material/elasticity.h>
#include <lamella/material/material.h>
#include <lamella/material/parameters.h>

#include <boost/test/unit_test.hpp>

#include <cmath>

BOOST_AUTO_TEST_SUITE(material)

using namespace lamella;
using dealii::Tensor;

namespace
{
  // Nine constants of which no two are equal, so that no two can be mixed up.
  const EngineeringConstants
    orthotropic{165., 9., 8., 5.6, 5.2, 2.8, 0.34, 0.3, 0.45};

  // The paper's Table 3, in GPa.
  const EngineeringConstants im7{165., 9., 9., 5.6, 5.6, 2.8, 0.34, 0.34, 0.5};

  constexpr unsigned int xx = 0, yy = 1, zz = 2, xy = 3, xz = 4, yz = 5;



  double
  distance(const ElasticTensor &a, const ElasticTensor &b)
  {
    return (a - b).norm();
  }



  /// C by the closed formulas of Jones, chapter 2 (nu_ij as here).
  ElasticTensor
  closed_stiffness(const EngineeringConstants &c)
  {
    const double nu21 = c.nu12 * c.E2 / c.E1, nu31 = c.nu13 * c.E3 / c.E1,
                 nu32 = c.nu23 * c.E3 / c.E2;
    const double d    = 1. - c.nu12 * nu21 - c.nu23 * nu32 - c.nu13 * nu31 -
                     2. * nu21 * nu32 * c.nu13;
    ElasticTensor C;
    C[0][0] = c.E1 * (1. - c.nu23 * nu32) / d;
    C[1][1] = c.E2 * (1. - c.nu13 * nu31) / d;
    C[2][2] = c.E3 * (1. - c.nu12 * nu21) / d;
    C[0][1] = C[1][0] = c.E1 * (nu21 + nu31 * c.nu23) / d;
    C[0][2] = C[2][0] = c.E1 * (nu31 + nu21 * nu32) / d;
    C[1][2] = C[2][1] = c.E2 * (nu32 + c.nu12 * nu31) / d;
    C[3][3]           = c.G12;
    C[4][4]           = c.G13;
    C[5][5]           = c.G23;
    return C;
  }



  Voigt
  strain_of(const Tensor<2, 3> &e)
  {
    Voigt v;
    v[xx] = e[0][0];
    v[yy] = e[1][1];
    v[zz] = e[2][2];
    v[xy] = 2. * e[0][1];
    v[xz] = 2. * e[0][2];
    v[yz] = 2. * e[1][2];
    return v;
  }



  /// A triad along no axis: (1, 2, 2)/3, (2, 1, -2)/3, (-2, 2, -1)/3, which is
  /// right-handed.
  Triad
  skew_triad()
  {
    constexpr double rows[3][3] = {{1., 2., 2.}, {2., 1., -2.}, {-2., 2., -1.}};
    Triad            triad;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        triad[i][j] = rows[i][j] / 3.;
    return triad;
  }



  void
  check_layup(const std::string &code, const std::vector<double> &plies)
  {
    const std::vector<double> found = parse_layup({"Layup", code});
    BOOST_TEST_CONTEXT(code)
    BOOST_TEST(found == plies, boost::test_tools::per_element());
  }



  /// Whether @p call throws an InputError whose message has all @p fragments.
  template <typename Call>
  void
  check_refused(const Call &call, const std::vector<std::string> &fragments)
  {
    try
      {
        call();
        BOOST_ERROR("not refused: " + fragments.back());
      }
    catch (const InputError &error)
      {
        const std::string message = error.what();
        for (const std::string &fragment : fragments)
          BOOST_TEST((message.find(fragment) != std::string::npos),
                     "'" << message << "' does not say '" << fragment << "'");
      }
  }
} // namespace

BOOST_AUTO_TEST_CASE(stiffness_is_the_inverse_of_the_compliance)
{
  // The compliance in the order {11, 22, 33, 12, 13, 23}, row by row.
  const double compliance[6][6] = {
    {1. / 165., -0.34 / 165., -0.3 / 165., 0., 0., 0.},
    {-0.34 / 165., 1. / 9., -0.45 / 9., 0., 0., 0.},
    {-0.3 / 165., -0.45 / 9., 1. / 8., 0., 0., 0.},
    {0., 0., 0., 1. / 5.6, 0., 0.},
    {0., 0., 0., 0., 1. / 5.2, 0.},
    {0., 0., 0., 0., 0., 1. / 2.8}};
  ElasticTensor S, one;
  for (unsigned int i = 0; i < 6; ++i)
    {
      one[i][i] = 1.;
      for (unsigned int j = 0; j < 6; ++j)
        S[i][j] = compliance[i][j];
    }
  BOOST_TEST(distance(S * orthotropic.stiffness(), one) < 1e-13);
}



BOOST_AUTO_TEST_CASE(isotropic_constants_of_lame)
{
  // E = 10, nu = 0.25: G = 10 / 2.5 = 4, lambda = 2.5 / (1.25 0.5) = 4, so
  // lambda + 2 G = 12.
  const ElasticTensor C =
    EngineeringConstants::isotropic(10., 0.25).stiffness();
  for (unsigned int i = 0; i < 6; ++i)
    for (unsigned int j = 0; j < 6; ++j)
      BOOST_TEST(std::abs(C[i][j] - (i == j         ? (i < 3 ? 12. : 4.) :
                                     i < 3 && j < 3 ? 4. :
                                                      0.)) < 1e-13);
}



BOOST_AUTO_TEST_CASE(plies_at_0_and_90_degrees)
{
  const ElasticTensor C = closed_stiffness(orthotropic);

  // At 90 degrees e_1 = +x, e_2 = +y, e_3 = +z: nothing moves.
  BOOST_TEST(distance(rotated(orthotropic.stiffness(), ply_axes(90.)), C) <
             1e-12);

  // At 0 degrees e_1 = +y, e_2 = -x: 1 and 2 swap, and 13 with 23.
  constexpr unsigned int place[6] = {1, 0, 2, 3, 5, 4};
  ElasticTensor          swapped;
  for (unsigned int i = 0; i < 6; ++i)
    for (unsigned int j = 0; j < 6; ++j)
      swapped[place[i]][place[j]] = C[i][j];
  const ElasticTensor at_0 = rotated(orthotropic.stiffness(), ply_axes(0.));
  BOOST_TEST(distance(at_0, swapped) < 1e-12);
  // What this says in numbers: stiff along y, G13 = 5.2 in yz, G23 in xz.
  BOOST_TEST(at_0[yy][yy] > 165.);
  BOOST_TEST(at_0[yz][yz] == 5.2);
  BOOST_TEST(at_0[xz][xz] == 2.8);

  // A cross-ply has exact zeros, also after several turns.
  for (const double angle : {0., 90., -90., 180., 270.})
    {
      const ElasticTensor turned =
        rotated(orthotropic.stiffness(), ply_axes(angle));
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 3; j < 6; ++j)
          BOOST_TEST(turned[i][j] == 0.);
      BOOST_TEST(turned[xz][yz] == 0.);
    }
}



BOOST_AUTO_TEST_CASE(ply_at_45_degrees)
{
  // s = c = sqrt(1/2). With eps_11 = (eps_yy + eps_xx + gamma_xy) / 2,
  // eps_22 = (eps_yy + eps_xx - gamma_xy) / 2, gamma_12 = eps_yy - eps_xx:
  // C_yyyy = (C11 + C22 + 2 C12)/4 + G12, C_xyxy = (C11 + C22 - 2 C12)/4,
  // C_yyxx = C_yyyy - 2 G12, C_yyxy = C_xxxy = (C11 - C22)/4, and with
  // gamma_13 = (gamma_xz + gamma_yz) s, gamma_23 = (gamma_yz - gamma_xz) s:
  // C_yzyz = C_xzxz = (G13 + G23)/2, C_xzyz = (G13 - G23)/2.
  const ElasticTensor C  = closed_stiffness(im7);
  const ElasticTensor at = rotated(im7.stiffness(), ply_axes(45.));

  const double C_yyyy = (C[0][0] + C[1][1] + 2. * C[0][1]) / 4. + 5.6;
  BOOST_TEST(std::abs(at[yy][yy] - C_yyyy) < 1e-12);
  BOOST_TEST(std::abs(at[xx][xx] - C_yyyy) < 1e-12);
  BOOST_TEST(std::abs(at[xx][yy] - (C_yyyy - 11.2)) < 1e-12);
  BOOST_TEST(std::abs(at[xy][xy] - (C[0][0] + C[1][1] - 2. * C[0][1]) / 4.) <
             1e-12);
  BOOST_TEST(std::abs(at[yy][xy] - (C[0][0] - C[1][1]) / 4.) < 1e-12);
  BOOST_TEST(std::abs(at[xx][xy] - (C[0][0] - C[1][1]) / 4.) < 1e-12);
  BOOST_TEST(std::abs(at[zz][zz] - C[2][2]) < 1e-12);
  BOOST_TEST(std::abs(at[zz][yy] - (C[0][2] + C[1][2]) / 2.) < 1e-12);
  BOOST_TEST(std::abs(at[zz][xy] - (C[0][2] - C[1][2]) / 2.) < 1e-12);

  // (5.6 + 2.8)/2 and (5.6 - 2.8)/2.
  BOOST_TEST(std::abs(at[yz][yz] - 4.2) < 1e-13);
  BOOST_TEST(std::abs(at[xz][xz] - 4.2) < 1e-13);
  BOOST_TEST(std::abs(at[xz][yz] - 1.4) < 1e-13);
  for (const unsigned int i : {xx, yy, zz, xy})
    for (const unsigned int j : {xz, yz})
      BOOST_TEST(std::abs(at[i][j]) < 1e-13);
}



BOOST_AUTO_TEST_CASE(condensed_shear_modulus_at_45_degrees)
{
  // With sigma_xx = sigma_zz = sigma_xz = 0 only xz couples to yz, and
  // 4.2 - 1.4^2 / 4.2 = 56/15 = 3.7333, the series of springs
  // 2 G13 G23 / (G13 + G23). Here all three are condensed out as a block.
  const ElasticTensor    C      = rotated(im7.stiffness(), ply_axes(45.));
  constexpr unsigned int out[3] = {xx, zz, xz};
  Tensor<2, 3>           block;
  Tensor<1, 3>           coupling;
  for (unsigned int i = 0; i < 3; ++i)
    {
      coupling[i] = C[out[i]][yz];
      for (unsigned int j = 0; j < 3; ++j)
        block[i][j] = C[out[i]][out[j]];
    }
  const double reduced = C[yz][yz] - coupling * (invert(block) * coupling);
  BOOST_TEST(std::abs(reduced - 56. / 15.) < 1e-12);
}



BOOST_AUTO_TEST_CASE(sign_of_the_ply_angle)
{
  // +30 degrees from +y towards +x: the fiber points to (sin 30, cos 30, 0).
  const Triad  axes = ply_axes(30.);
  const double s = 0.5, c = std::sqrt(0.75);
  BOOST_TEST(std::abs(axes[0][0] - s) < 1e-15);
  BOOST_TEST(std::abs(axes[0][1] - c) < 1e-15);
  BOOST_TEST(axes[0][2] == 0.);
  BOOST_TEST(axes[2][2] == 1.);
  // A right-handed triad of unit vectors.
  BOOST_TEST((cross_product_3d(axes[0], axes[1]) - axes[2]).norm() < 1e-15);
  BOOST_TEST(std::abs(axes[0] * axes[1]) < 1e-15);
  BOOST_TEST(std::abs(axes[1].norm() - 1.) < 1e-15);

  // A stretch eps_yy alone: eps_11 = c^2, eps_22 = s^2, gamma_12 = 2 s c (from
  // e_2 = (-c, s, 0)), and sigma_xy = s c sigma_11 - s c sigma_22 +
  // (s^2 - c^2) sigma_12, so
  // C_yyxy = s c (c^2 C11 - s^2 C22 - (c^2 - s^2) (C12 + 2 G12)).
  // Positive: the tension of the fiber pulls towards +x.
  const ElasticTensor C  = closed_stiffness(im7);
  const ElasticTensor at = rotated(im7.stiffness(), axes);
  const double        coupling =
    s * c * (0.75 * C[0][0] - 0.25 * C[1][1] - 0.5 * (C[0][1] + 2. * im7.G12));
  BOOST_TEST(coupling > 0.);
  BOOST_TEST(std::abs(at[yy][xy] - coupling) < 1e-12);
  // At -30 degrees the other way.
  const ElasticTensor other = rotated(im7.stiffness(), ply_axes(-30.));
  BOOST_TEST(std::abs(other[yy][xy] + coupling) < 1e-12);
}



BOOST_AUTO_TEST_CASE(energy_does_not_depend_on_the_axes)
{
  // The strain as a matrix turned with the triad, R E R^T, has the same energy
  // in the material's axes as E has in the frame.
  Tensor<2, 3> E;
  E[0][0] = 0.3;
  E[1][1] = -0.7;
  E[2][2] = 1.1;
  E[0][1] = E[1][0] = 0.45;
  E[0][2] = E[2][0] = -0.25;
  E[1][2] = E[2][1] = 0.6;

  for (const Triad &R : {skew_triad(), ply_axes(37.), unit_triad()})
    {
      const Tensor<2, 3> local = R * E * transpose(R);
      // strain_rotation() is this turn in Voigt's order.
      BOOST_TEST((strain_rotation(R) * strain_of(E) - strain_of(local)).norm() <
                 1e-14);

      const ElasticTensor C = rotated(orthotropic.stiffness(), R);
      const double        inside =
        strain_of(local) * (closed_stiffness(orthotropic) * strain_of(local));
      const double outside = strain_of(E) * (C * strain_of(E));
      BOOST_TEST(std::abs(inside - outside) < 1e-12 * inside);
      BOOST_TEST(distance(C, ElasticTensor(transpose(C))) < 1e-12);
    }

  // And an isotropic material does not know its axes.
  const ElasticTensor C = EngineeringConstants::isotropic(7., 0.3).stiffness();
  BOOST_TEST(distance(rotated(C, skew_triad()), C) < 1e-13);
}



BOOST_AUTO_TEST_CASE(violated_conditions_are_named)
{
  BOOST_TEST(orthotropic.violated_condition() == "");
  BOOST_TEST(im7.violated_condition() == "");

  const auto says = [](const EngineeringConstants &c, const std::string &text) {
    const std::string found = c.violated_condition();
    BOOST_TEST((found.compare(0, text.size(), text) == 0),
               "'" << found << "' does not begin with '" << text << "'");
  };
  EngineeringConstants                                         c = orthotropic;
  const std::pair<double EngineeringConstants::*, std::string> moduli[6] = {
    {&EngineeringConstants::E1, "E1"},
    {&EngineeringConstants::E2, "E2"},
    {&EngineeringConstants::E3, "E3"},
    {&EngineeringConstants::G12, "G12"},
    {&EngineeringConstants::G13, "G13"},
    {&EngineeringConstants::G23, "G23"}};
  for (const auto &[member, name] : moduli)
    for (const double value : {0., -1.})
      {
        c         = orthotropic;
        c.*member = value;
        says(c,
             name + " = " + (value == 0. ? "0" : "-1") + " must be positive");
      }

  // nu12^2 < E1/E2 = 4/1: 2 is on the border and out, 1.99 is in.
  c = {4., 1., 1., 1., 1., 1., 2., 0., 0.};
  says(c, "nu12^2 = 4 must be below E1 / E2 = 4");
  c.nu12 = 1.99;
  BOOST_TEST(c.violated_condition() == "");
  // nu13^2 < E1/E3 = 4/16.
  c = {4., 4., 16., 1., 1., 1., 0., -0.5, 0.};
  says(c, "nu13^2 = 0.25 must be below E1 / E3 = 0.25");
  // nu23^2 < E2/E3 = 1/4.
  c = {4., 1., 4., 1., 1., 1., 0., 0., 0.6};
  says(c, "nu23^2 = 0.36 must be below E2 / E3 = 0.25");

  // Isotropic: 1 - 3 nu^2 - 2 nu^3, which is 1 - 0.75 - 0.25 = 0 for nu = 0.5
  // and 1 - 1.08 - 0.432 = -0.512 for nu = 0.6, where each nu^2 is below one.
  const std::string determinant =
    "1 - nu12 nu21 - nu23 nu32 - nu13 nu31 - 2 nu21 nu32 nu13 = ";
  says({1., 1., 1., 1., 1., 1., 0.5, 0.5, 0.5}, determinant + "0 must");
  says({1., 1., 1., 1., 1., 1., 0.6, 0.6, 0.6}, determinant + "-0.512 must");
  // nu = -0.6 is one that a material may have: 1 - 1.08 + 0.432 > 0.
  BOOST_TEST((EngineeringConstants{1., 1., 1., 1., 1., 1., -0.6, -0.6, -0.6})
               .violated_condition() == "");
}



BOOST_AUTO_TEST_CASE(built_in_materials_convert)
{
  const Units m    = Units::parse({"Units", "m, N"}),
              mm   = Units::parse({"Units", "mm,N"}),
              none = Units::parse({"Units", "none"});

  // Table 3 of the paper: 165 GPa = 165e9 Pa = 165000 MPa.
  for (const auto &[units, scale] : {std::make_pair(m, 1e9),
                                     std::make_pair(mm, 1e3),
                                     std::make_pair(none, 1e9)})
    {
      const EngineeringConstants c =
        library_material("IM7-8552", units).elastic;
      BOOST_TEST(std::abs(c.E1 / scale - 165.) < 1e-10);
      BOOST_TEST(std::abs(c.E2 / scale - 9.) < 1e-11);
      BOOST_TEST(std::abs(c.E3 / scale - 9.) < 1e-11);
      BOOST_TEST(std::abs(c.G12 / scale - 5.6) < 1e-11);
      BOOST_TEST(std::abs(c.G13 / scale - 5.6) < 1e-11);
      BOOST_TEST(std::abs(c.G23 / scale - 2.8) < 1e-11);
      BOOST_TEST(c.nu12 == 0.34);
      BOOST_TEST(c.nu13 == 0.34);
      BOOST_TEST(c.nu23 == 0.5);
    }

  // Table 7, and the core: 35 MPa with nu = 0.4, so G = 35 / 2.8 = 12.5 MPa.
  const EngineeringConstants skin =
    library_material("glass-polyester", mm).elastic;
  BOOST_TEST(std::abs(skin.E1 - 25800.) < 1e-8);
  BOOST_TEST(std::abs(skin.E2 - 8700.) < 1e-8);
  BOOST_TEST(std::abs(skin.G12 - 3500.) < 1e-8);
  BOOST_TEST(std::abs(skin.G23 - 2400.) < 1e-8);
  BOOST_TEST(skin.nu23 == 0.47);
  const EngineeringConstants core = library_material("foam-35", mm).elastic;
  BOOST_TEST(std::abs(core.E2 - 35.) < 1e-12);
  BOOST_TEST(std::abs(core.G13 - 12.5) < 1e-12);

  // A modulus without a unit stays.
  BOOST_TEST(library_material("hertz-200", mm).elastic.E1 == 200.);
  BOOST_TEST(library_material("hertz-200", m).elastic.E1 == 200.);

  for (const std::string &name : library_materials())
    BOOST_TEST(library_material(name, m).elastic.violated_condition() == "");

  // What is known beside constants: G23 = 11 GPa / 2.8, S23 by the plane of 53
  // degrees, 7850 kg/m^3 = 7.85e-9 t/mm^3.
  const Material AS4   = library_material("AS4-3501-6", mm),
                 steel = library_material("steel-S355", mm),
                 comb  = library_material("Nomex-48", mm);
  BOOST_TEST(std::abs(AS4.elastic.G23 - 11000. / 2.8) < 1e-8);
  BOOST_TEST(std::abs(AS4.strengths->Xc - 1480.) < 1e-9);
  BOOST_TEST(std::abs(AS4.strengths->S23 - 75.36) < 0.01);
  BOOST_TEST((*AS4.expansion)[1] == 26e-6);
  BOOST_TEST(!AS4.density);
  BOOST_TEST(std::abs(*steel.yield - 355.) < 1e-9);
  BOOST_TEST(std::abs(*steel.density - 7.85e-9) < 1e-20);
  BOOST_TEST(*library_material("steel-S355", m).density == 7850.);
  BOOST_TEST(std::abs(comb.core->shear_13 - 1.25) < 1e-12);
  check_refused([&] { library_material("im7/8552", m); },
                {"im7/8552", "'IM7-8552'"});
  check_refused(
    [] {
      Units::parse({"Units", "cm, N"});
    },
    {"Units = cm, N", "mm, N"});
}



BOOST_AUTO_TEST_CASE(moduli_in_other_units)
{
  const Units m    = Units::parse({"Units", "m, N"}),
              mm   = Units::parse({"Units", "mm, N"}),
              none = Units::parse({"Units", "none"});
  const Material megapascals(EngineeringConstants::isotropic(70000., 0.3)),
    pascals(EngineeringConstants::isotropic(70e9, 0.3));
  BOOST_TEST(moduli_warning("a", megapascals, mm) == "");
  BOOST_TEST(moduli_warning("a", pascals, m) == "");
  BOOST_TEST(moduli_warning("a", megapascals, none) == "");
  BOOST_TEST(
    moduli_warning("a", megapascals, m).find("E1 = 70000 Pa, E2 = 70000 Pa") !=
    std::string::npos);
  BOOST_TEST(moduli_warning("a", pascals, mm) != "");
  for (const std::string &name : library_materials())
    if (name != "hertz-200")
      BOOST_TEST(moduli_warning(name, library_material(name, mm), mm) == "");
}



BOOST_AUTO_TEST_CASE(strength_entries)
{
  const Units mm   = Units::parse({"Units", "mm, N"});
  const auto  read = [&mm](Settings settings) {
    settings.emplace_back("Isotropic", "1000, 0.25");
    return parsed<MaterialParameters>("Material a", settings, mm);
  };
  const Material bare = read({});
  BOOST_TEST(!bare.strengths);
  BOOST_TEST(!bare.ultimate_strains);
  BOOST_TEST(!bare.yield);
  BOOST_TEST(!bare.core);
  BOOST_TEST(bare.inclinations.pl_tension == 0.35);

  const Material full =
    read({{"Strengths", "1, 2, 3, 4, 5, 6, 7, 8, 9"},
          {"Ultimate strains", ".1, .2, .3, .4, .5, .6, .7, .8, .9"},
          {"Yield", "250"},
          {"Core strengths", "3, 2, 1"},
          {"Puck inclinations", "glass"}});
  BOOST_TEST(full.strengths->Xc == 2.);
  BOOST_TEST(full.strengths->Zt == 5.);
  BOOST_TEST(full.strengths->S13 == 8.);
  BOOST_TEST(full.ultimate_strains->Yt == 0.3);
  BOOST_TEST(*full.yield == 250.);
  BOOST_TEST(full.core->crushing == 3.);
  BOOST_TEST(full.core->shear_23 == 1.);
  BOOST_TEST(full.inclinations.pl_compression == 0.25);
  BOOST_TEST(read({{"Puck inclinations", "0.1, 0.2, 0.3, 0.4"}})
               .inclinations.pt_compression == 0.4);

  // 2326.2 MPa in a scene in mm and N; S23 = Yc cos a (sin a + cos a / tan 2a)
  // with a = 53 degrees.
  const Strengths im7 = *library_material("IM7-8552", mm).strengths;
  BOOST_TEST(std::abs(im7.Xt - 2326.2) < 1e-9);
  BOOST_TEST(std::abs(im7.Zc - 199.8) < 1e-9);
  const double a = 53. * 3.14159265358979 / 180.;
  BOOST_TEST(std::abs(im7.S23 -
                      199.8 * std::cos(a) *
                        (std::sin(a) + std::cos(a) / std::tan(2. * a))) < 0.05);
  for (const char *name : {"glass-polyester", "foam-35", "hertz-200"})
    BOOST_TEST(!library_material(name, mm).strengths);

  check_refused(
    [&] {
      read({{"Strengths", "1, -2, 3, 4, 5, 6, 7, 8, 9"}});
    },
    {"Material a/Strengths",
     "Xc = -2 must be positive",
     "[material.strength-not-positive]"});
  check_refused(
    [&] {
      read({{"Strengths", "1, 2, 3, 4, 5, 6, 7, 8"}});
    },
    {"must be 9 numbers, Xt, Xc", "there are 8"});
  check_refused(
    [&] {
      read({{"Core strengths", "1, 2"}});
    },
    {"must be 3 numbers, crushing", "there are 2"});
  check_refused([&] { read({{"Yield", "-1"}}); }, {"Material a/Yield = -1"});
  check_refused(
    [&] {
      read({{"Puck inclinations", "0.3, 0.3, 0.3, 1"}});
    },
    {"[material.inclination-out-of-range]"});
  check_refused(
    [&] {
      parsed<MaterialParameters>(
        "Material a", Settings{{"Library", "IM7-8552"}, {"Yield", "3"}}, mm);
    },
    {"Material a/Yield = 3: ", "[material.yield-not-isotropic]"});
}



BOOST_AUTO_TEST_CASE(material_entries)
{
  const Units m    = Units::parse({"Units", "m, N"});
  const auto  read = [&m](const Settings &settings) {
    return parsed<MaterialParameters>("Material a", settings, m);
  };
  BOOST_TEST(read({{"Isotropic", "10, 0.25"}}).elastic.G12 == 4.);
  BOOST_TEST(
    read({{"Engineering constants", "1,2,3,4,5,6, 0.1,0.2,0.3"}}).elastic.G13 ==
    5.);
  BOOST_TEST(read({{"Library", "foam-35"}}).elastic.E1 == 35e6);
  check_refused([&] { read({}); },
                {"Material a: ", "[material.not-one-source]"});
  check_refused(
    [&] {
      read({{"Library", "foam-35"}, {"Isotropic", "1, 0"}});
    },
    {"Material a: ", "[material.not-one-source]"});
  check_refused(
    [&] {
      read({{"Library", "foam"}});
    },
    {"Material a/Library = foam: ", "'foam-35'"});
  check_refused(
    [&] {
      read({{"Engineering constants", "1,2,3"}});
    },
    {"Material a/Engineering constants = 1,2,3: ", "[material.wrong-count]"});
  for (const std::string numbers : {"10, 0.5", "10, -1", "10, 0.7"})
    check_refused(
      [&] {
        read({{"Isotropic", numbers}});
      },
      {"Material a/Isotropic = " + numbers, "nu must lie between -1 and 0.5"});
  check_refused(
    [&] {
      read({{"Isotropic", "10"}});
    },
    {"[material.wrong-count]"});
  check_refused(
    [&] {
      read({{"Isotropic", "10, nu"}});
    },
    {"Material a/Isotropic = 10, nu: 'nu' is not a number"});
  check_refused(
    [&] {
      read({{"Isotropic", "0, 0.3"}});
    },
    {"Material a/Isotropic = 0, 0.3", "E1 = 0 must be positive"});

  // Those of the library have units.
  const Units none = Units::parse({"Units", "none"});
  check_refused(
    [&] {
      parsed<MaterialParameters>("Material a", {{"Library", "IM7-8552"}}, none);
    },
    {"Material a/Library = IM7-8552: ", "[material.library-without-units]"});
  BOOST_TEST(
    parsed<MaterialParameters>("Material a", {{"Library", "hertz-200"}}, none)
      .elastic.E1 == 200.);
}



BOOST_AUTO_TEST_CASE(layups)
{
  check_layup("0/90/0", {0., 90., 0.});
  check_layup("0", {0.});
  check_layup("[0/90]s", {0., 90., 90., 0.});
  check_layup("[0/90]2s", {0., 90., 0., 90., 90., 0., 90., 0.});
  // Four plies, twice, and all that in reverse.
  check_layup("[0/+-45/90]2s",
              {0.,
               45.,
               -45.,
               90.,
               0.,
               45.,
               -45.,
               90.,
               90.,
               -45.,
               45.,
               0.,
               90.,
               -45.,
               45.,
               0.});
  check_layup("[45/-45]3", {45., -45., 45., -45., 45., -45.});
  check_layup("-+30/60", {-30., 30., 60.});
  check_layup("[+45/22.5]", {45., 22.5});
  check_layup("  [ 0 / +- 45 ]s ", {0., 45., -45., -45., 45., 0.});
  check_layup(" 0 /  90\t/0", {0., 90., 0.});
  check_layup("[0]1000", std::vector<double>(1000, 0.));
}



BOOST_AUTO_TEST_CASE(layups_that_are_refused)
{
  for (const std::string code : {"",
                                 "  ",
                                 "0//90",
                                 "0/90/",
                                 "/0",
                                 "[0/90",
                                 "0/90]",
                                 "[[0/90]]",
                                 "[0/90]x",
                                 "[0/90]0",
                                 "[0]1001",
                                 "[0/90]-2",
                                 "[0/90]10000",
                                 "[0/90]s2",
                                 "[0/90]ss",
                                 "0/90s",
                                 "[]",
                                 "[]2s",
                                 "0;90",
                                 "0,90",
                                 "0/9O",
                                 "nan",
                                 "inf",
                                 "1e400",
                                 "+-",
                                 "+-4.5.6",
                                 "+--45",
                                 "0/90 deg",
                                 "[0]99999999999999999999",
                                 "[0/90]2.5",
                                 "[0/90][0/90]",
                                 "0/[90]s",
                                 "0/(90/0)"})
    BOOST_CHECK_THROW(parse_layup({"Layup", code}), InputError);

  // The message begins with the entry, gives the code and says what is wrong.
  check_refused(
    [] {
      parse_layup({"Section strip/Layup", "0/9x/0"});
    },
    {"Section strip/Layup = 0/9x/0", "'9x' is not an angle"});
  check_refused(
    [] {
      parse_layup({"Section strip/Layup", "[0/90"});
    },
    {"Section strip/Layup = [0/90", "brackets must pair"});
  check_refused(
    [] {
      parse_layup({"Section strip/Layup", "[0]0"});
    },
    {"repetition must be from 1 to 1000"});
}

BOOST_AUTO_TEST_SUITE_END()
