// SPDX-License-Identifier: LGPL-2.1-or-later

// What each theory of the cross-section promises: closed forms of EBBT and TBT,
// convergence of the others to one value, contraction with and without the
// Poisson correction, bounds that follow from nested spaces, elements of lower
// degree with assumed shear strains, what the classical theories cannot do. The
// tables are lines that begin with a bar, with --log_level=message.

#include "entries.h"
#include "fixtures.h"

#include <lamella/material/material.h>
#include <lamella/shape/shapes.h>
#include <lamella/solve/checks.h>

#include <deal.II/lac/full_matrix.h>

#include <boost/test/unit_test.hpp>

#include <iomanip>
#include <numeric>

BOOST_AUTO_TEST_SUITE(theories)

using namespace lamella;
using dealii::Point;
using dealii::Tensor;

namespace
{
  const std::nullopt_t free_ = std::nullopt;

  /// What @p text spells.
  Theory
  theory_of(const std::string &text,
            const bool         poisson_correction = true,
            const double       shear_factor       = 1.)
  {
    Theory theory             = Theory::parse({"Theory", text});
    theory.poisson_correction = poisson_correction;
    theory.shear_factor       = shear_factor;
    return theory;
  }



  std::shared_ptr<const Section>
  section_of(const Laminate &laminate,
             const Material &material,
             const Theory   &theory)
  {
    return make_section(make_section_mesh(laminate, {{"material", material}}),
                        theory);
  }



  double
  off(const double value, const double expected)
  {
    return std::abs(value / expected - 1.);
  }



  Support
  at_points(const std::string           &name,
            const std::vector<Point<3>> &points,
            const std::optional<double>  x,
            const std::optional<double>  y,
            const std::optional<double>  z)
  {
    return {name, {{0, Region::Kind::point, "", points}}, {{x, y, z}}};
  }



  Load
  point_force(const Point<3> &at, const Tensor<1, 3> &force)
  {
    return {"force",
            {{0, Region::Kind::point, "", {at}}},
            {{digits(force[0]), digits(force[1]), digits(force[2])}},
            ""};
  }



  Solved
  cantilever(std::shared_ptr<const Section> section,
             std::shared_ptr<const Axis>    axis,
             const std::vector<Load>       &loads)
  {
    return solve_linear(
      std::make_unique<Beam>("beam", section, axis, Placement()),
      {clamp("start")},
      loads);
  }



  // ---- the square cantilever of tests' reference values: L = 1 m, 0.1 x 0.1,
  // E = 70 GPa, nu = 0.3, 1000 N at the tip. By hand I = 1e-4 / 12,
  //   F L^3 / 3 E I = 5.714286e-4,  F L / G A = 1000 / (70e9 / 2.6 / 100)
  //                                           = 3.714286e-6.
  constexpr double side = 0.1, E = 70e9, nu = 0.3, F = 1000.,
                   bending = F / (3. * E * side * side * side * side / 12.),
                   shear   = F / (E / (2. + 2. * nu) * side * side);

  // What is left of a deflection where the section cannot contract:
  // E (1 - nu) / ((1 + nu) (1 - 2 nu)) stands for E, 1.3 * 0.4 / 0.7 =
  // 0.742857.
  constexpr double locked = (1. + nu) * (1. - 2. * nu) / (1. - nu);



  struct Tip
  {
    DofIndex n_dofs = 0;
    /// Of the middle of the end face.
    double middle = 0.;
    /// The mean over the end face, which the force does work on: 2 U / F. By
    /// the principle of least potential energy a larger space bends more.
    double mean = 0.;
  };



  /// LE with @p cells > 1 on half of the section, whose plane of symmetry keeps
  /// u_x = 0: the same space and half of the force.
  Tip
  square_cantilever(const Theory                     &theory,
                    const unsigned int                cells = 1,
                    const std::shared_ptr<const Axis> axis  = make_axis(1., 2))
  {
    const unsigned int   halves = cells > 1 ? 2 : 1;
    std::vector<Support> supports{clamp("start")};
    if (halves == 2)
      supports.push_back({"symmetry",
                          {{0, Region::Kind::surface, "left", {}}},
                          {{0., free_, free_}}});
    const Solved solved = solve_linear(
      std::make_unique<Beam>(
        "beam",
        section_of(rectangle(side / halves, side, {0.}, cells / halves, cells),
                   EngineeringConstants::isotropic(E, nu),
                   theory),
        axis,
        Placement()),
      supports,
      {traction("end", "0", "0", digits(F / (side * side)))});
    return {solved.structure->n_dofs(),
            solved.at({side / 2., 1., side / 2.}).displacement[2],
            2. * halves * solved.strain_energy() / F};
  }
} // namespace

BOOST_AUTO_TEST_CASE(classical_deflections_of_a_square_cantilever)
{
  // Cubic deflection, quadratic rotation: two B4 hold both exactly.
  const double factor = 5. / 6.;
  const Tip    ebbt   = square_cantilever(theory_of("EBBT")),
            tbt       = square_cantilever(theory_of("TBT")),
            corrected = square_cantilever(theory_of("TBT", true, factor));
  for (const auto &[tip, expected, printed] :
       {std::make_tuple(ebbt, bending, 5.7143e-4),
        std::make_tuple(tbt, bending + shear, 5.7514e-4),
        std::make_tuple(corrected, bending + shear / factor, 5.7589e-4)})
    {
      BOOST_TEST(off(tip.middle, expected) < 1e-11);
      BOOST_TEST(off(tip.mean, expected) < 1e-11);
      // Half a unit of the last digit.
      BOOST_TEST(std::abs(tip.middle - printed) < 0.5e-8);
    }
}



BOOST_AUTO_TEST_CASE(sections_that_cannot_contract_lock)
{
  // u_y is linear over the section and quadratic contraction is not in TE-1:
  // all three bend with the modulus of a bar held on all sides. Shear is as
  // before. With the correction EBBT and TBT have E; so has TE-1, since its
  // quadratic modes contain the exact contraction u_x = -nu kappa x z, u_z =
  // -nu kappa (z^2 - x^2) / 2, and its own in-plane fields stay at zero.
  const double stiff = locked * bending;
  BOOST_TEST(off(square_cantilever(theory_of("EBBT", false)).middle, stiff) <
             1e-11);
  for (const char *theory : {"TBT", "TE-1"})
    {
      BOOST_TEST(off(square_cantilever(theory_of(theory, false)).middle,
                     stiff + shear) < 1e-11);
      BOOST_TEST(off(square_cantilever(theory_of(theory)).middle,
                     bending + shear) < 1e-11);
    }
  // Only TBT has a shear factor, and only the three have a correction.
  BOOST_TEST(square_cantilever(theory_of("TE-1", true, 0.5)).middle ==
             square_cantilever(theory_of("TE-1")).middle);
  for (const char *theory : {"TE-2", "LE-1"})
    BOOST_TEST(square_cantilever(theory_of(theory, false)).middle ==
               square_cantilever(theory_of(theory, true)).middle);
}



BOOST_AUTO_TEST_CASE(expansions_converge_to_one_value)
{
  // Graded to the clamp: within about h of it the section cannot contract, and
  // its edges there have singular stresses, so that convergence is algebraic.
  AxisMesh mesh;
  mesh.length     = 1.;
  mesh.elements   = {3, 3, 3};
  mesh.breaks     = {0.02, 0.2};
  const auto axis = std::make_shared<Axis>(mesh);

  struct Entry
  {
    std::string name;
    Tip         tip;
  };
  std::vector<Entry> table;
  const auto         add = [&](const std::string &theory,
                       const unsigned int cells = 1) {
    table.push_back({theory + (cells > 1 ? ", 2 x 2" : ""),
                     square_cantilever(theory_of(theory), cells, axis)});
    return table.back().tip.mean;
  };
  add("EBBT");
  add("TBT");
  add("TE-1");
  std::vector<double> taylor, one_cell, four_cells;
  for (const char *theory : {"TE-2", "TE-3", "TE-4", "TE-5", "TE-6"})
    taylor.push_back(add(theory));
  for (const char *theory : {"LE-1", "LE-2", "LE-3", "LE-4"})
    {
      one_cell.push_back(add(theory));
      four_cells.push_back(add(theory, 2));
    }
  const double converged = std::max(taylor.back(), four_cells.back());
  BOOST_TEST_MESSAGE("| theory | DoFs | tip deflection | error |");
  for (const Entry &entry : table)
    BOOST_TEST_MESSAGE("| " << entry.name << " | " << entry.tip.n_dofs << " | "
                            << std::setprecision(7) << entry.tip.mean << " | "
                            << std::setprecision(2)
                            << entry.tip.mean / converged - 1. << " |");

  // Larger spaces bend more.
  for (const auto &family : {taylor, one_cell, four_cells})
    for (unsigned int k = 1; k < family.size(); ++k)
      BOOST_TEST(family[k] > family[k - 1] * (1. - 1e-10));
  for (unsigned int k = 0; k < 4; ++k)
    BOOST_TEST(four_cells[k] > one_cell[k] * (1. - 1e-10));
  // One value: all are within a thousandth, a fifth of what TBT, which knows
  // nothing of the clamp's grip, is off by, and the last of either kind within
  // a fifth of that.
  for (const double value : {taylor[2],
                             taylor[3],
                             taylor[4],
                             one_cell[2],
                             one_cell[3],
                             four_cells[1],
                             four_cells[2]})
    BOOST_TEST(off(value, converged) < 1e-3);
  BOOST_TEST(off(bending + shear, converged) > 5e-3);
  BOOST_TEST(off(taylor.back(), four_cells.back()) < 2e-4);
  // Each family's steps become smaller.
  BOOST_TEST(taylor[4] - taylor[2] < 0.5 * (taylor[2] - taylor[0]));
  BOOST_TEST(four_cells[3] - four_cells[2] <
             0.5 * (four_cells[2] - four_cells[1]));
}



namespace
{
  const EngineeringConstants carbon =
    library_material("IM7-8552", Units::parse({"Units", "mm, N"})).elastic;

  /// The law of @p ply between {sigma_yy, sigma_xy} and {eps_yy, gamma_xy}
  /// where all other stresses vanish, and G_yz there: from the compliance.
  struct ReducedLaw
  {
    double q11, q16, q66, G_yz;

    explicit ReducedLaw(const Ply &ply)
    {
      dealii::FullMatrix<double> S(6);
      const ElasticTensor        C = ply.stiffness();
      for (unsigned int i = 0; i < 6; ++i)
        for (unsigned int j = 0; j < 6; ++j)
          S(i, j) = C[i][j];
      S.gauss_jordan();
      const double det = S(1, 1) * S(3, 3) - S(1, 3) * S(1, 3);
      q11              = S(3, 3) / det;
      q16              = -S(1, 3) / det;
      q66              = S(1, 1) / det;
      G_yz             = 1. / S(5, 5);
    }
  };



  /// M / kappa of a long strip under end moments, at mid-span.
  double
  bending_stiffness(const Laminate &laminate, const Theory &theory)
  {
    const double W = laminate.width, H = laminate.height(), L = 20. * W,
                 I = W * H * H * H / 12., d = 0.05 * L;
    // What the ends disturb decays within a few widths, if elements resolve it;
    // 1e-5 may be left of it.
    AxisMesh mesh;
    mesh.length   = L;
    mesh.elements = {2, 3, 2, 3, 2};
    mesh.breaks   = {0.5 * W, 3. * W, L - 3. * W, L - 0.5 * W};
    const Solved solved =
      cantilever(section_of(laminate, carbon, theory),
                 std::make_shared<Axis>(mesh),
                 {traction("end",
                           "0",
                           digits(1. / I) + " * (z - " + digits(H / 2.) + ")",
                           "0")});
    const auto w = [&](const double y) {
      return solved.at({W / 2., y, H / 2.}).displacement[2];
    };
    return -d * d / (w(L / 2. - d) - 2. * w(L / 2.) + w(L / 2. + d));
  }



  /**
   * TBT's: its strains are eps_yy = e + kappa z and a constant gamma_xy = g,
   * since it cannot twist, with the reduced law point by point. Without forces
   * but the moment e and g follow,
   *   EI = W (d - b^T a^-1 b),  a, b, d = int {1, z, z^2} {q11, q16, q66},
   * where only yy bends.
   */
  double
  tbt_stiffness(const std::vector<Ply> &plies, const double width)
  {
    double       a11 = 0., a16 = 0., a66 = 0., b11 = 0., b16 = 0., d11 = 0.;
    const double middle = 0.5 * plies.back().top;
    for (const Ply &ply : plies)
      {
        const ReducedLaw q(ply);
        const double     s = ply.bottom - middle, t = ply.top - middle;
        a11 += q.q11 * (t - s);
        a16 += q.q16 * (t - s);
        a66 += q.q66 * (t - s);
        b11 += q.q11 * (t * t - s * s) / 2.;
        b16 += q.q16 * (t * t - s * s) / 2.;
        d11 += q.q11 * (t * t * t - s * s * s) / 3.;
      }
    const double det = a11 * a66 - a16 * a16;
    return width *
           (d11 -
            (b11 * b11 * a66 - 2. * b11 * b16 * a16 + b16 * b16 * a11) / det);
  }
} // namespace



BOOST_AUTO_TEST_CASE(contraction_modes_leave_constant_strains_alone)
{
  // A constant in-plane strain of a homogeneous section, whatever its shape, is
  // an equilibrium: TE-1's own stiffness in xx, zz and xz (its fields 6 to 8)
  // must be that without the modes.
  const OrientedMaterial oriented_material{"m", 0.};
  for (const SectionShape &shape :
       {SectionShape(HalfDisc{0.5, 90., 0.1, 8, oriented_material}),
        SectionShape(ThinWalled{
          ShapeKind::angle, 0.7, 0.5, {0.1}, {0.1}, 1, 1, oriented_material}),
        SectionShape(ThinWalled{
          ShapeKind::t, 0.7, 0.5, {0.1}, {0.1}, 1, 1, oriented_material})})
    {
      const auto mesh =
        make_section_mesh(shape,
                          {{"m", EngineeringConstants::isotropic(1., 0.3)}});
      Theory     theory         = Theory::parse({"Theory", "TE-1"});
      const auto corrected      = make_section(mesh, theory);
      theory.poisson_correction = false;
      const auto plain          = make_section(mesh, theory);
      for (unsigned int f = 6; f < 9; ++f)
        BOOST_TEST(std::abs(corrected->S(0, 0)(f, f) / plain->S(0, 0)(f, f) -
                            1.) < 1e-10);
    }
}



BOOST_AUTO_TEST_CASE(bending_stiffness_of_laminates)
{
  // Against EI of lamination theory, free to contract and to twist with one
  // curvature each for the whole section. TBT lets each ply contract for
  // itself, which is softer, and does not twist, which is stiffer where bending
  // and twisting couple. All strains of TE-1 are linear in x and z, of which
  // the part even in x is of lamination theory's form, and normal stresses
  // beside sigma_yy are only made the better or worse of: never softer.
  BOOST_TEST_MESSAGE("| laminate | theory | EI / EI of lamination theory |");
  for (const std::vector<double> &angles : {std::vector<double>{0.},
                                            {45.},
                                            {0., 90.},
                                            {0., 90., 0.},
                                            {30., -45.},
                                            {45., -45., -45., 45.}})
    {
      const Laminate laminate = rectangle(5., 1., angles);
      const auto     plies    = laminate.plies({{"material", carbon}});
      const double   EI       = laminate_stiffness(plies, 5.).EI;
      std::string    name;
      const auto     ratio = [&](const Theory &theory) {
        const double value = bending_stiffness(laminate, theory) / EI;
        BOOST_TEST_MESSAGE("| " << name << " | " << theory.name()
                                << (theory.poisson_correction ? "" : ", locked")
                                << " | " << std::setprecision(6) << value
                                << " |");
        return value;
      };
      for (const double angle : angles)
        name += (name.empty() ? "[" : "/") + std::to_string(int(angle));
      name += "]";
      const double ebbt = ratio(theory_of("EBBT")),
                   tbt  = ratio(theory_of("TBT")),
                   te_1 = ratio(theory_of("TE-1")),
                   hard = ratio(theory_of("TE-1", false)),
                   le_2 = ratio(theory_of("LE-2"));
      BOOST_TEST(off(tbt, tbt_stiffness(plies, 5.) / EI) < 1e-9);
      BOOST_TEST(ebbt > tbt * (1. - 1e-9));
      BOOST_TEST(te_1 > 1. - 1e-6);
      BOOST_TEST(hard > 1.001 * te_1);
      BOOST_TEST(te_1 > le_2 * (1. - 1e-5));
      // Free edges, which lamination theory does not have: of the order of the
      // differences between plies times h / W.
      BOOST_TEST(std::abs(le_2 - 1.) < 0.1);
      if (angles[0] == 0.)
        BOOST_TEST(tbt < 1. + 1e-9);
      else if (std::abs(angles.front()) == std::abs(angles.back()))
        // All plies contract alike, so that only the twist is left.
        BOOST_TEST(tbt > 1.01);
    }
}



BOOST_AUTO_TEST_CASE(one_ply_off_axis_bends_as_derived)
{
  // One ply at 45 degrees. Without twist q11 stands for E, which is more than
  // 1 / S_11 = (q11 - q16^2 / q66). TE-1 twists with phi' but does not warp:
  // gamma_xy = phi' z, gamma_yz = -phi' x, energy
  //   q11 kappa^2 I_z + 2 q16 kappa phi' I_z + (q66 I_z + G_yz I_x) phi'^2,
  // so EI = I_z (q11 - q16^2 I_z / (q66 I_z + G_yz I_x)): sigma_xz vanishes by
  // the mode u_z = x^2. In a wide strip that is as good as no twist.
  for (const double W : {1., 5.})
    {
      const Laminate   laminate = rectangle(W, 1., {45.});
      const auto       plies    = laminate.plies({{"material", carbon}});
      const ReducedLaw q(plies[0]);
      const double     I_z = W / 12., I_x = W * W * W / 12.;
      const double     twisting =
        I_z * (q.q11 - q.q16 * q.q16 * I_z / (q.q66 * I_z + q.G_yz * I_x));
      BOOST_TEST(
        off(bending_stiffness(laminate, theory_of("TBT")), I_z * q.q11) < 1e-9);
      // The field of in-plane shear (z, x) dies out as exp(-y sqrt(48 / (W^2 +
      // H^2))): by 4e-7 three widths from an end.
      BOOST_TEST(off(bending_stiffness(laminate, theory_of("TE-1")), twisting) <
                 1e-6);
      BOOST_TEST(off(laminate_stiffness(plies, W).EI,
                     I_z * (q.q11 - q.q16 * q.q16 / q.q66)) < 1e-12);
    }
}



BOOST_AUTO_TEST_CASE(the_reduced_law_off_axis)
{
  // gamma_yz = c gamma_13 - s gamma_23 and the like for xz, so that without
  // sigma_xz the compliances add: 1/G_yz = c^2 / G13 + s^2 / G23, at 45 degrees
  // 2 G13 G23 / (G13 + G23) = 2 * 5.6 * 2.8 / 8.4 = 3.7333 GPa, where C_yz,yz
  // is the mean 4.2. The third field is the deflection: its derivative is
  // gamma_yz.
  const double   W = 0.7, H = 0.4, reduced = 5.6e3 / 1.5, mean = 4.2e3;
  const Laminate laminate        = rectangle(W, H, {45.}, 2);
  const auto     shear_stiffness = [&](const Theory &theory) {
    return section_of(laminate, carbon, theory)
      ->S(1, 1)(RigidField::translation_z, RigidField::translation_z);
  };
  BOOST_TEST(off(shear_stiffness(theory_of("TBT")), reduced * W * H) < 1e-12);
  BOOST_TEST(off(shear_stiffness(theory_of("TBT", false)), mean * W * H) <
             1e-12);
  BOOST_TEST(off(shear_stiffness(theory_of("TBT", true, 0.7)),
                 0.7 * reduced * W * H) < 1e-12);

  // What a beam makes of it, half as long as high: F L / G A is most of it.
  const double     L = 0.5 * H;
  const ReducedLaw q(laminate.plies({{"material", carbon}})[0]);
  BOOST_TEST(off(q.G_yz, reduced) < 1e-12);
  for (const char *theory : {"TBT", "EBBT"})
    {
      const Solved solved =
        cantilever(section_of(laminate, carbon, theory_of(theory)),
                   make_axis(L, 2),
                   {traction("end", "0.3", "2", digits(1. / (W * H)))});
      if (std::string(theory) == "TBT")
        BOOST_TEST(off(solved.at({W / 2., L, H / 2.}).displacement[2],
                       4. * L * L * L / (q.q11 * W * H * H * H) +
                         L / (reduced * W * H)) < 1e-11);
      for (const Point<3> &x :
           {Point<3>(0., 0.1, 0.), Point<3>(0.6, 0.03, 0.3)})
        {
          const FieldSample s = solved.at(x);
          for (const unsigned int c : {0, 2, 4})
            {
              BOOST_TEST(std::abs(s.stress[c]) < 1e-12 * s.stress.norm());
              // The strains are there.
              BOOST_TEST((c == 4 && theory[0] == 'E' ?
                            true :
                            std::abs(s.strain[c]) > 1e-3 * s.strain.norm()));
            }
        }
    }
}



BOOST_AUTO_TEST_CASE(nested_spaces)
{
  // Spaces of displacements that hold each other, the same law (no corrections,
  // full shear) and the same forces: the larger space has the larger energy. A
  // polynomial of degree p is in LE-p on cells with straight sides, one cell
  // across and one a ply.
  const double W = 1.2, H = 0.9, L = 4.;
  const Load   load      = traction("end",
                             "0.3 - 2 * (z - 0.45)",
                             "1 + 0.5 * (z - 0.45) - 0.7 * (x - 0.6)",
                             "0.2 + 2 * (x - 0.6)");
  const auto   axis      = make_axis(L, 2);
  const auto   isotropic = EngineeringConstants::isotropic(70e3, 0.3);
  for (const auto &[angles, material, n_layer_wise] :
       {std::make_tuple(std::vector<double>{0.}, isotropic, 4u),
        std::make_tuple(std::vector<double>{0., 90., 0.}, carbon, 3u),
        std::make_tuple(std::vector<double>{45., 0.}, carbon, 3u)})
    {
      const auto energy =
        [&, angles = angles, material = material](const std::string &theory) {
          return cantilever(section_of(rectangle(W, H, angles),
                                       material,
                                       theory_of(theory, false)),
                            axis,
                            {load})
            .strain_energy();
        };
      std::vector<double> taylor{energy("EBBT"), energy("TBT")}, layer_wise{0.};
      for (unsigned int p = 1; p <= n_layer_wise + 2; ++p)
        taylor.push_back(energy("TE-" + std::to_string(p)));
      for (unsigned int p = 1; p <= n_layer_wise; ++p)
        layer_wise.push_back(energy("LE-" + std::to_string(p)));
      const double rounding = 1. - 1e-10;
      for (unsigned int k = 1; k < taylor.size(); ++k)
        BOOST_TEST(taylor[k] > taylor[k - 1] * rounding);
      for (unsigned int p = 1; p <= n_layer_wise; ++p)
        {
          BOOST_TEST(layer_wise[p] > layer_wise[p - 1] * rounding);
          BOOST_TEST(layer_wise[p] > taylor[p + 1] * rounding);
        }
      std::ostringstream line;
      line << std::setprecision(7);
      for (const double value : taylor)
        line << " " << value;
      line << " |";
      for (unsigned int p = 1; p <= n_layer_wise; ++p)
        line << " " << layer_wise[p];
      BOOST_TEST_MESSAGE("| " << angles.size() << " plies |" << line.str()
                              << " |");
      // Shear, torsion, warping: none of the steps is only rounding where the
      // theory sees something new. EBBT -> TBT -> TE-1 always do.
      BOOST_TEST(taylor[1] > 1.001 * taylor[0]);
      BOOST_TEST(taylor[2] > 1.001 * taylor[1]);
    }
}



namespace
{
  constexpr double slender = 100.;

  /// The tip deflection of a cantilever of height 1 and length 100 under a unit
  /// force, whose clamp leaves the contraction of its face free: it holds u_y,
  /// and what it must of the rest at points that contraction does not move.
  double
  slender_tip(const std::string &theory, const std::shared_ptr<const Axis> axis)
  {
    const Support axial{"clamp",
                        {{0, Region::Kind::surface, "start", {}}},
                        {{free_, 0., free_}}};
    const Solved  solved = solve_linear(
      std::make_unique<Beam>("beam",
                             section_of(rectangle(1., 1.),
                                        EngineeringConstants::isotropic(E, nu),
                                        theory_of(theory)),
                             axis,
                             Placement()),
      {axial,
        at_points("middle", {{0.5, 0., 0.5}}, free_, free_, 0.),
        at_points("no turn", {{0.5, 0., 0.}, {0.5, 0., 1.}}, 0., free_, free_)},
      {traction("end", "0", "0", "1")});
    return solved.at({0.5, slender, 0.5}).displacement[2];
  }



  /// The deflection at mid-span, y = 0, of a beam on two supports under a
  /// pressure cos(pi y / 2 L), of which half is modeled: all fields are
  /// cosines and sines, without any layer at its ends.
  double
  cosine_deflection(const std::string                &theory,
                    const std::shared_ptr<const Axis> axis)
  {
    const Support mid_span{"mid-span",
                           {{0, Region::Kind::surface, "start", {}}},
                           {{free_, 0., free_}}},
      support{"support",
              {{0, Region::Kind::surface, "end", {}}},
              {{0., free_, 0.}}};
    const Solved solved = solve_linear(
      std::make_unique<Beam>("beam",
                             section_of(rectangle(1., 1.),
                                        EngineeringConstants::isotropic(E, nu),
                                        theory_of(theory)),
                             axis,
                             Placement()),
      {mid_span, support},
      {traction(
        "top", "0", "0", "cos(pi * y / " + digits(2. * slender) + ")")});
    return solved.at({0.5, 0., 0.5}).displacement[2];
  }
} // namespace



BOOST_AUTO_TEST_CASE(assumed_shear_frees_slender_beams)
{
  // Eight elements, L/h = 100. B2 with full shear is stiffer in bending by
  // 1 + G A l^2 / 12 E I = 1 + (12.5)^2 / 2.6 = 61. With assumed shear its
  // curvature is that of the moment at the middle of each element: the midpoint
  // rule for int (L - y)^2 is off by l^2 / 4 L^2 = 1 / (4 * 64) = 0.39 %, of
  // TBT exactly. B3's curvature is linear, as the moment; what contraction adds
  // is of the order (h/L)^2.
  const double w_b = 4. * slender * slender * slender / E,
               w_s = slender * 2. * (1. + nu) / E;
  BOOST_TEST_MESSAGE("| theory | element | full shear | assumed shear |");
  for (const char *theory : {"TBT", "TE-2", "LE-2"})
    {
      const double exact = slender_tip(theory, make_axis(slender, 8));
      if (theory == std::string("TBT"))
        BOOST_TEST(off(exact, w_b + w_s) < 1e-9);
      for (const unsigned int degree : {1, 2, 3})
        {
          const auto error = [&](const bool assumed, const unsigned int n) {
            return slender_tip(theory, make_axis(slender, n, degree, assumed)) /
                     exact -
                   1.;
          };
          const double full = error(false, 8), assumed = error(true, 8);
          BOOST_TEST_MESSAGE("| " << theory << " | 8 B" << degree + 1 << " | "
                                  << std::setprecision(3) << full << " | "
                                  << assumed << " |");
          if (degree == 1)
            {
              BOOST_TEST(full < -0.9);
              BOOST_TEST(std::abs(assumed) < 0.01);
              if (theory == std::string("TBT"))
                for (const unsigned int n : {1, 3, 8})
                  BOOST_TEST(std::abs(error(true, n) +
                                      w_b / (w_b + w_s) / 4. / (n * n)) < 1e-9);
            }
          else
            BOOST_TEST(std::abs(assumed) < 1e-4);
        }
    }
}



BOOST_AUTO_TEST_CASE(assumed_shear_converges)
{
  // A deflection is a functional of the solution: twice the degree.
  for (const char *theory : {"TBT", "TE-2", "LE-2"})
    {
      const double exact = cosine_deflection(theory, make_axis(slender, 8));
      for (const unsigned int degree : {1, 2})
        {
          std::vector<double> error;
          for (const unsigned int n : {2, 4, 8})
            error.push_back(off(
              cosine_deflection(theory, make_axis(slender, n, degree, true)),
              exact));
          for (unsigned int k = 1; k < error.size(); ++k)
            {
              const double rate = std::log2(error[k - 1] / error[k]);
              BOOST_TEST_MESSAGE("| " << theory << " | B" << degree + 1 << " | "
                                      << error[k] << " | " << rate << " |");
              BOOST_TEST(std::abs(rate - 2. * degree) < 0.1 * 2. * degree);
            }
        }
    }
}



namespace
{
  // ---- EBBT: a square rod of unit side, elements of unequal lengths with
  // nodes at 0, 3, 6.5, 10.
  constexpr double rod = 10., EI = E / 12.;
  const Point<3>   origin_of_rod(0.5, 0., 0.5);

  std::shared_ptr<const Axis>
  uneven_axis()
  {
    AxisMesh mesh;
    mesh.length   = rod;
    mesh.elements = {1, 2};
    mesh.breaks   = {3.};
    return std::make_shared<Axis>(mesh);
  }



  /// The bounds of its element that holds y, a node to the element below.
  std::pair<double, double>
  element_of(const double y)
  {
    return y <= 3.  ? std::make_pair(0., 3.) :
           y <= 6.5 ? std::make_pair(3., 6.5) :
                      std::make_pair(6.5, 10.);
  }



  /// Of a rod from 0 to l held at both ends, at x under a unit force at a.
  double
  built_in(const double l, double a, double x)
  {
    if (x > a)
      {
        x = l - x;
        a = l - a;
      }
    const double b = l - a;
    return b * b * x * x * (3. * a * l - x * (3. * a + b)) /
           (6. * EI * l * l * l);
  }



  /// Of a rod held at 0.
  double
  fixed_at_start(const double a, const double x)
  {
    return x < a ? x * x * (3. * a - x) / (6. * EI) :
                   a * a * (3. * x - a) / (6. * EI);
  }



  /// What elements with a cubic deflection lose: their nodal values are exact,
  /// so at x under a unit force at a the deflection of the element held at both
  /// ends is missing, if it holds both.
  double
  lost(const double a, const double x)
  {
    const auto [begin, end] = element_of(a);
    return x > begin && x < end ? built_in(end - begin, a - begin, x - begin) :
                                  0.;
  }



  Solved
  solve_rod(const Placement            &placement,
            std::shared_ptr<const Axis> axis,
            const std::vector<Support> &supports,
            const std::vector<Load>    &loads)
  {
    return solve_linear(
      std::make_unique<Beam>("rod",
                             section_of(rectangle(1., 1.),
                                        EngineeringConstants::isotropic(E, nu),
                                        theory_of("EBBT")),
                             axis,
                             placement),
      supports,
      loads);
  }



  /// In the rod's own axes, on its middle line.
  Tensor<1, 3>
  displacement(const Solved &solved, const Placement &placement, const double y)
  {
    return placement.vector_to_body(
      solved.at(placement.to_scene({0.5, y, 0.5})).displacement);
  }



  const Placement turned  = Placement::from_directions({0.2, -0.1, 0.4},
                                                      Point<3>(1., 2., 0.5),
                                                      Point<3>(-0.3, 0.2, 1.)),
                  along_x = Placement::from_directions({1., 2., 3.},
                                                       Point<3>(1., 0., 0.),
                                                       Point<3>(0., 0., 1.));
} // namespace



BOOST_AUTO_TEST_CASE(ebbt_under_point_loads)
{
  // Both ways of bending and stretching at once, forces of sizes that make
  // them alike; a at a node and inside of an element.
  const std::array<double, 7> places{{0., 1.7, 3., 4., 5., 6.5, 10.}};
  for (const Placement &placement : {Placement(), turned})
    for (const char *held : {"start", "ends"})
      for (const double a : {6.5, 5.})
        {
          const Tensor<1, 3> force = Point<3>(-0.7 * E, 50. * E, E);
          const Solved       solved =
            solve_rod(placement,
                      uneven_axis(),
                      {clamp(held)},
                      {point_force(placement.to_scene({0.5, a, 0.5}),
                                   placement.vector_to_scene(force))});
          const bool one_end = held == std::string("start");
          for (const double y : places)
            {
              const double w =
                (one_end ? fixed_at_start(a, y) : built_in(rod, a, y)) -
                lost(a, y);
              const auto   u     = displacement(solved, placement, y);
              const double scale = 1e-11 * rod * rod * rod;
              BOOST_TEST(std::abs(u[0] - force[0] * w) < scale);
              BOOST_TEST(std::abs(u[2] - force[2] * w) < scale);
              // Stretching is cubic, too, with a kink at the force: what is
              // exact there are the nodes.
              if (y <= 3. || y >= 6.5)
                BOOST_TEST(std::abs(u[1] - force[1] / E *
                                             (one_end ? std::min(a, y) :
                                              y < a   ? y * (rod - a) / rod :
                                                        a * (rod - y) / rod)) <
                           scale);
            }
        }
}



BOOST_AUTO_TEST_CASE(ebbt_under_uniform_load)
{
  // q y^2 (6 L^2 - 4 L y + y^2) / 24 E I held at one end, q y^2 (L - y)^2 / 24
  // E I at both, which is also what an element between its nodes loses.
  const auto both = [](const double l, const double y) {
    return y * y * (l - y) * (l - y) / (24. * EI);
  };
  for (const Placement &placement : {Placement(), turned})
    for (const char *held : {"start", "ends"})
      {
        const Tensor<1, 3> q = placement.vector_to_scene(Point<3>(0., 0., E));
        const Solved       solved = solve_rod(
          placement,
          uneven_axis(),
          {clamp(held)},
          {traction("top", digits(q[0]), digits(q[1]), digits(q[2]))});
        for (const double y : {0., 1.7, 3., 5., 6.5, 8., 10.})
          {
            const auto [begin, end] = element_of(y);
            const double exact =
              held == std::string("ends") ?
                both(rod, y) :
                y * y * (6. * rod * rod - 4. * rod * y + y * y) / (24. * EI);
            const auto u = displacement(solved, placement, y);
            BOOST_TEST(
              std::abs(u[2] - E * (exact - both(end - begin, y - begin))) <
              1e-10 * std::pow(rod, 4));
            BOOST_TEST(std::abs(u[0]) < 1e-10 * std::pow(rod, 4));
          }
      }
}



BOOST_AUTO_TEST_CASE(ebbt_propped_anywhere)
{
  // A cantilever under a tip force F, propped at a: the prop takes
  // R = F f(a, L) / f(a, a). Inside of an element f(a, a) lacks what the
  // element loses, and u = 0 at a is a row of several DoFs; across the width
  // it is one row said several times.
  for (const Placement &placement : {Placement(), along_x})
    for (const double a : {6.5, 5., 9.9})
      for (const bool line : {false, true})
        {
          Support prop = at_points(
            "prop", {placement.to_scene({0.5, a, 0.5})}, free_, free_, 0.);
          if (line)
            prop.on = {{0,
                        Region::Kind::line,
                        "",
                        {placement.to_scene({0., a, 0.}),
                         placement.to_scene({1., a, 0.})}}};
          const Solved solved =
            solve_rod(placement,
                      uneven_axis(),
                      {clamp("start"), prop},
                      {point_force(placement.to_scene({0.5, rod, 0.5}),
                                   Point<3>(0., 0., E))});
          const double f_aa = fixed_at_start(a, a) - lost(a, a),
                       R    = E * fixed_at_start(rod, a) / f_aa;
          const auto checks =
            check_state(TangentOperator(*solved.structure, solved.state.u),
                        {},
                        2,
                        solved.state,
                        1.);
          BOOST_TEST(std::abs(checks.reactions[1].force[2] + R) < 1e-9 * R);
          BOOST_TEST(std::abs(checks.reactions[0].force[2] + E - R) < 1e-9 * R);
          BOOST_TEST(std::abs(displacement(solved, placement, a)[2]) <
                     1e-9 * rod);
          BOOST_TEST(off(displacement(solved, placement, rod)[2],
                         E * fixed_at_start(rod, rod) -
                           R * fixed_at_start(a, rod)) < 1e-9);
        }
}



BOOST_AUTO_TEST_CASE(ebbt_pushed_in_the_middle)
{
  // Held at both ends and moved by w_0 in the middle: with a node there
  // w = w_0 (3 s^2 - 2 s^3), s = 2 y / L, and 192 E I w_0 / L^3; in the middle
  // of one of three elements of length l the flexibility L^3 / 192 E I lacks
  // l^3 / 192 E I.
  const double w_0 = 0.3;
  for (const unsigned int elements : {2, 3})
    {
      const Solved solved =
        solve_rod(along_x,
                  make_axis(rod, elements),
                  {clamp("ends"),
                   at_points("push",
                             {along_x.to_scene({0.5, rod / 2., 0.5})},
                             free_,
                             free_,
                             w_0)},
                  {});
      const double l = elements == 2 ? 0. : rod / 3.,
                   R = 192. * EI * w_0 / (std::pow(rod, 3) - std::pow(l, 3));
      const auto reactions =
        check_state(TangentOperator(*solved.structure, solved.state.u),
                    {},
                    2,
                    solved.state,
                    1.)
          .reactions;
      BOOST_TEST(off(reactions[1].force[2], R) < 1e-9);
      BOOST_TEST(off(-reactions[0].force[2], R) < 1e-9);
      for (const double s : {0.3, 0.6, 1.})
        {
          const double exact =
            elements == 2 || s < 0.67 ?
              R / (192. * EI / std::pow(rod, 3)) * s * s * (3. - 2. * s) :
              w_0;
          BOOST_TEST(
            off(displacement(solved, along_x, 0.5 * rod * s)[2], exact) < 1e-9);
        }
    }
}



BOOST_AUTO_TEST_CASE(classical_theories_do_not_turn_about_their_axis)
{
  const double W = 0.2, H = 0.1, L = 2.;
  const auto   material = EngineeringConstants::isotropic(E, nu);
  const auto   free_of  = [&](const std::string          &theory,
                           const std::vector<Support> &supports) {
    Bodies bodies;
    bodies.push_back(std::make_unique<Beam>(
      "beam",
      section_of(rectangle(W, H), material, theory_of(theory)),
      make_axis(L, 2),
      Placement()));
    std::vector<std::string> words;
    for (const FreeMotion &motion : free_rigid_motions(
           *bodies[0], 0, prescribed_functionals(supports, bodies)))
      words.push_back(motion.words);
    return words;
  };
  const Support pins =
    at_points("pins", {{W / 2., 0., H / 2.}, {W / 2., L, H / 2.}}, 0., 0., 0.);
  for (const char *theory : {"EBBT", "TBT"})
    {
      BOOST_TEST(free_of(theory, {pins}).empty());
      BOOST_TEST(free_of(theory, {}).size() == 5);
    }
  const auto motions = free_of("TE-1", {pins});
  BOOST_TEST_REQUIRE(motions.size() == 1);
  BOOST_TEST(motions[0] == "rotation about y");
  BOOST_TEST(free_of("TE-1", {}).size() == 6);

  // Five motions held are a scene that solves.
  const auto tip = [&](const std::string &theory, const double x) {
    const Solved solved =
      cantilever(section_of(rectangle(W, H), material, theory_of(theory)),
                 make_axis(L, 2),
                 {point_force({x, L, H / 2.}, Point<3>(0., 0., F))});
    return std::make_pair(solved.at({0., L, 0.}).displacement[2],
                          solved.at({W, L, H}).displacement[2]);
  };
  // Their known failure: an eccentric force bends as a central one does.
  for (const char *theory : {"EBBT", "TBT"})
    {
      const auto [central, right] = tip(theory, W / 2.);
      BOOST_TEST(off(right, central) < 1e-12);
      BOOST_TEST(off(tip(theory, W).first, central) < 1e-12);
      BOOST_TEST(off(tip(theory, W).second, central) < 1e-12);
    }
  // The others twist: by F W / 2 L / G I_p at least, I_p the polar moment, so
  // that right and left differ by W times that.
  const double polar = W * H * (W * W + H * H) / 12., G = E / (2. + 2. * nu);
  for (const char *theory : {"TE-1", "LE-2"})
    {
      const auto [left, right] = tip(theory, W);
      BOOST_TEST(right - left > 0.99 * F * W * W / 2. * L / (G * polar));
    }
}



BOOST_AUTO_TEST_CASE(entries_of_a_theory)
{
  const Entry scene("Theory", "TE-3");
  const auto  read = [&scene](const Settings &settings) {
    return parsed<TheoryParameters>("Body b/Kinematics", settings, scene);
  };
  const Theory given = read({});
  BOOST_TEST((given.kind == Theory::Kind::TE));
  BOOST_TEST(given.order == 3);
  BOOST_TEST(given.poisson_correction);
  BOOST_TEST(given.shear_factor == 1.);
  const Theory own = read({{"Theory", "TBT"},
                           {"Poisson correction", "false"},
                           {"Shear factor", "0.8333"}});
  BOOST_TEST((own.kind == Theory::Kind::TBT));
  BOOST_TEST(own.order == 1);
  BOOST_TEST(!own.poisson_correction);
  BOOST_TEST(own.shear_factor == 0.8333);

  // As a user reads them: the name is what parse() takes, but for the
  // literature's name of LE-N.
  for (const std::string name : {"EBBT", "TBT", "TE-20", "solid-2"})
    BOOST_TEST(theory_of(name).name() == name);
  BOOST_TEST(theory_of("LE-2").name() == "LE-2 (L9)");
  BOOST_TEST(Theory().name() == "undefined");

  for (const std::string text :
       {"", "FEM", "TE", "TE-0", "TE-21", "LE-9", "solid-3", "TBT-1", "te-1"})
    BOOST_CHECK_THROW(Theory::parse({"Theory", text}), InputError);
  for (const auto &[name, value] : Settings{{"Theory", "LE-0"},
                                            {"Poisson correction", "no"},
                                            {"Shear factor", "0"},
                                            {"Shear factor", "1.1"},
                                            {"Shear factor", ""}})
    BOOST_CHECK_EXCEPTION(read({{name, value}}),
                          InputError,
                          [path = "Body b/Kinematics/" +
                                  name](const InputError &error) {
                            return error.path() == path;
                          });
}

BOOST_AUTO_TEST_SUITE_END()
