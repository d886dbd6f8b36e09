// SPDX-License-Identifier: LGPL-2.1-or-later

// What is told of a section as a beam: the expansion chosen for it, its mass,
// and the numbers as text and as JSON. That they are right: saint_venant.cc.

#include "fixtures.h"

#include <lamella/report/section_stiffness.h>
#include <lamella/report/validation.h>

#include <boost/test/unit_test.hpp>

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <sstream>

BOOST_AUTO_TEST_SUITE(section_output)

using namespace lamella;
using Force = SaintVenant::Force;
using Json  = nlohmann::ordered_json;

namespace
{
  const Materials materials{
    {"material",
     EngineeringConstants{165., 9., 8., 5.6, 5.2, 2.8, 0.34, 0.3, 0.45}}};



  Units
  millimeters()
  {
    return Units::parse({"Units", "mm, N"});
  }



  unsigned int
  degree_of_grid(const unsigned int n)
  {
    return expansion_degree(
      *make_section_mesh(rectangle(1., 1., {0.}, n, n), materials));
  }



  std::string
  printed(const SectionStiffness &section)
  {
    std::ostringstream text;
    print_stiffness(text, "strip", section, millimeters());
    return text.str();
  }



  /// A material of the density @p density.
  Material
  material_with_density(const double density)
  {
    Material material = EngineeringConstants::isotropic(210., 0.3);
    material.density  = density;
    return material;
  }



  /// A Gmsh file of two plies of the width @p b and the height @p h in all,
  /// whose lower side is at z = @p bottom.
  std::string
  gmsh_of_two_plies(const double b, const double h, const double bottom)
  {
    std::ostringstream file;
    file << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n"
            "2 1 \"light\"\n2 2 \"heavy\"\n$EndPhysicalNames\n"
            "$Entities\n0 0 2 0\n1 0 0 0 1 1 0 1 1 0\n2 0 0 0 1 1 0 1 2 0\n"
            "$EndEntities\n$Nodes\n1 6 1 6\n2 1 0 6\n1\n2\n3\n4\n5\n6\n";
    for (const double z : {0., 0.5, 1.})
      for (const double x : {0., 1.})
        file << x * b << " " << bottom + z * h << " 0\n";
    file << "$EndNodes\n$Elements\n2 2 1 2\n2 1 3 1\n1 1 2 4 3\n"
            "2 2 3 1\n2 3 4 6 5\n$EndElements\n";
    return file.str();
  }



  /// Checks the mass matrix of two plies of the densities 2 and 6 on each
  /// other, of the width @p b and the height @p h in all.
  // About the middle of the area: int rho = 4 b h, int rho z = (6 - 2) b h^2 /
  // 8, int rho z^2 = 4 b h^3 / 12, int rho x^2 = 4 b^3 h / 12. The center of
  // mass is above the reference, so a turn about y takes it to +x, one about x
  // to -y.
  void
  check_mass_of_two_plies(const SectionStiffness &section,
                          const double            b,
                          const double            h)
  {
    BOOST_TEST_REQUIRE(section.mass.has_value());
    SectionTensor wanted;
    for (const unsigned int i : {Force::F_x, Force::F_y, Force::F_z})
      wanted[i][i] = 4. * b * h;
    wanted[Force::M_x][Force::M_x] = 4. * b * h * h * h / 12.;
    wanted[Force::M_z][Force::M_z] = 4. * b * b * b * h / 12.;
    wanted[Force::M_y][Force::M_y] =
      wanted[Force::M_x][Force::M_x] + wanted[Force::M_z][Force::M_z];
    const double moment            = 4. * b * h * h / 8.;
    wanted[Force::F_x][Force::M_y] = wanted[Force::M_y][Force::F_x] = moment;
    wanted[Force::F_y][Force::M_x] = wanted[Force::M_x][Force::F_y] = -moment;
    for (unsigned int i = 0; i < 6; ++i)
      for (unsigned int j = 0; j < 6; ++j)
        BOOST_TEST(std::abs((*section.mass)[i][j] - wanted[i][j]) <
                     1e-12 * std::sqrt(wanted[i][i] * wanted[j][j]),
                   i << ", " << j);
    BOOST_TEST(
      Json::parse(section_json("two", section, Units())).count("mass") == 1u);
  }
} // namespace

BOOST_AUTO_TEST_CASE(degree)
{
  // n x n cells have 3 (N n + 1)^2 DoFs: 18723 and 20172 in LE-3, 59643 and
  // 61347 in LE-2.
  BOOST_TEST(degree_of_grid(1) == 3u);
  BOOST_TEST(degree_of_grid(26) == 3u);
  BOOST_TEST(degree_of_grid(27) == 2u);
  BOOST_TEST(degree_of_grid(70) == 2u);
  BOOST_TEST(degree_of_grid(71) == 1u);
}



BOOST_AUTO_TEST_CASE(mass)
{
  const double    b = 0.6, h = 0.2;
  const Materials two{{"light", material_with_density(2.)},
                      {"heavy", material_with_density(6.)}};
  const Laminate  laminate{
    b, {0., 0.}, {0.5 * h, 0.5 * h}, {"light", "heavy"}, {1}, {2}};
  check_mass_of_two_plies(section_stiffness(make_section_mesh(laminate, two)),
                          b,
                          h);
  // The reference point is the centroid, wherever the origin is: at the
  // bottom, in the middle, and at the top.
  const char *const path = "section_output.msh";
  for (const double bottom : {0., -0.5 * h, -h})
    {
      std::ofstream(path) << gmsh_of_two_plies(b, h, bottom);
      const auto section = section_stiffness(
        make_section_mesh(SectionFile{path, 1., {}, "Section s"}, two));
      BOOST_TEST(std::abs(section.reference_point[1] - bottom - 0.5 * h) <
                 1e-12 * h);
      check_mass_of_two_plies(section, b, h);
    }

  const auto one_is_unknown = section_stiffness(
    make_section_mesh(laminate,
                      {{"light", material_with_density(2.)},
                       {"heavy", EngineeringConstants::isotropic(1., 0.)}}));
  BOOST_TEST(!one_is_unknown.mass.has_value());
  BOOST_TEST(one_is_unknown.fault.empty());
}



BOOST_AUTO_TEST_CASE(json)
{
  // A symmetric laminate has no coupling, an unsymmetric one bends when pulled.
  for (const double last : {0., 90.})
    {
      const auto section = section_stiffness(
        make_section_mesh(rectangle(0.6, 0.3, {0., 90., last}, 4), materials));
      const Json json =
        Json::parse(section_json("strip", section, millimeters()));
      BOOST_TEST(json.at("section") == "strip");
      BOOST_TEST(json.at("expansion") == "LE-3");
      BOOST_TEST(json.at("units").dump() == R"({"length":"mm","force":"N"})");
      BOOST_TEST(json.at("order").dump() ==
                 R"(["F_x","F_y","F_z","M_x","M_y","M_z"])");
      for (const char *key : {"EA", "EI_1", "EI_2", "GJ", "kGA_x", "kGA_z"})
        BOOST_TEST(json.at(key).get<double>() > 0., key);
      BOOST_TEST(json.at("EI_1") > json.at("EI_2"));
      // The larger about z.
      BOOST_TEST(std::abs(json.at("angle_deg").get<double>() - 90.) < 1e-9);
      for (const char *key :
           {"reference_point", "tension_center", "shear_center"})
        BOOST_TEST(json.at(key).size() == 2u, key);
      BOOST_TEST(json.count("mass") == 0u);
      const Json &k = json.at("stiffness"), &c = json.at("compliance");
      for (unsigned int i = 0; i < 6; ++i)
        for (unsigned int j = 0; j < 6; ++j)
          {
            double product = 0.;
            for (unsigned int m = 0; m < 6; ++m)
              product += k[i][m].get<double>() * c[m][j].get<double>();
            const double scale =
              std::sqrt(k[i][i].get<double>() / k[j][j].get<double>());
            BOOST_TEST(std::abs(product - (i == j)) < 1e-8 * scale);
            if (last == 0. && i != j)
              BOOST_TEST(k[i][j] == 0., i << ", " << j);
          }
      BOOST_TEST((k[Force::F_y][Force::M_x] == 0.) == (last == 0.));
    }
}



BOOST_AUTO_TEST_CASE(text)
{
  const auto section = section_stiffness(
    make_section_mesh(rectangle(0.6, 0.3, {0., 90., 0.}, 4), materials));
  const std::string text = printed(section);
  for (const std::string part :
       {"Section strip as a beam, by Saint-Venant's states in LE-3:",
        "about the axis at 90 deg from x towards z",
        "tension center (0.3, 0.15), shear center (0.3, 0.15)",
        "stiffness about (0.3, 0.15): forces [N], couplings of forces and "
        "moments [N mm], moments [N mm^2]"})
    BOOST_TEST((text.find(part) != std::string::npos), part << "\n" << text);
  BOOST_TEST((text.find("mass") == std::string::npos));
}



BOOST_AUTO_TEST_CASE(fault)
{
  SectionStiffness section;
  section.expansion = "LE-1";
  section.fault     = "Too thin.";
  const Json json   = Json::parse(section_json("foil", section, Units()));
  BOOST_TEST(json.at("fault") == "Too thin.");
  BOOST_TEST(json.at("section") == "foil");
  BOOST_TEST(json.count("stiffness") == 0u);
  BOOST_TEST(
    (printed(section).find("not computed: Too thin.") != std::string::npos));
}

BOOST_AUTO_TEST_SUITE_END()
