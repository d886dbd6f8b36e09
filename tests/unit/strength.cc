// SPDX-License-Identifier: LGPL-2.1-or-later

// Failure criteria against states of stress worked out by hand, and what holds
// of all of them: stresses times the reserve factor fail, none before do.
//
// By hand, with the strengths Xt, Xc = 1000, 800, Yt, Yc = 50, 200, Zt, Zc =
// 40, 160, S12, S13, S23 = 100, 80, 60: each expected index is the formula of
// doc/theory/strength.md with these numbers put in. Puck in plane stress has
// the closed forms of its modes A, B and C (Puck and Schuermann, Compos. Sci.
// Technol. 58 (1998) 1045-1067); C holds where p_pp = p_pl R_A / S12.

#include <lamella/strength/criterion.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>

BOOST_AUTO_TEST_SUITE(strength)

using namespace lamella;

namespace
{
  constexpr double pi = 3.14159265358979323846;



  Material
  ply()
  {
    Material material(
      EngineeringConstants{1e5, 1e4, 8e3, 5e3, 4e3, 2e3, 0.3, 0.25, 0.4});
    material.strengths = {1000., 800., 50., 200., 40., 160., 100., 80., 60.};
    material.ultimate_strains = {
      0.01, 0.008, 0.005, 0.02, 0.004, 0.016, 0.02, 0.02, 0.03};
    material.yield = 250.;
    material.core  = CoreStrengths{2., 1.5, 1.};
    return material;
  }



  /// One whose modes B and C have closed forms: R_A = 250/3.
  Material
  puck_ply()
  {
    Material material      = ply();
    material.strengths->Yc = 2. * 1.25 * 250. / 3.;
    return material;
  }



  Voigt
  stress(const double (&values)[6])
  {
    Voigt result;
    for (unsigned int i = 0; i < 6; ++i)
      result[i] = values[i];
    return result;
  }



  struct State
  {
    double      stress[6];
    double      index;
    std::string mode;
  };



  void
  check_states(const Criterion           criterion,
               const std::vector<State> &states,
               const Material           &material  = ply(),
               const WrinklingStresses  &wrinkling = {})
  {
    const FailureSurface surface(criterion, material, wrinkling);
    BOOST_TEST(states.size() >= 5u);
    for (const State &state : states)
      {
        const Assessment found = surface.assess(stress(state.stress));
        BOOST_TEST_CONTEXT(name_of(criterion) << " " << stress(state.stress))
        {
          BOOST_TEST(std::abs(found.index - state.index) < 1e-12);
          BOOST_TEST(std::string(found.mode) == state.mode);
        }
      }
  }



  Voigt
  random_stress(std::mt19937 &random, const double size)
  {
    std::normal_distribution<double> normal;
    Voigt                            result;
    for (unsigned int i = 0; i < 6; ++i)
      result[i] = size * normal(random) * (i == 0 ? 10. : 1.);
    return result;
  }
} // namespace



BOOST_AUTO_TEST_CASE(maximum_stress_by_hand)
{
  check_states(Criterion::maximum_stress,
               {{{500, 0, 0, 0, 0, 0}, 0.5, "tension 1"},
                {{-400, 10, 0, 0, 0, 0}, 0.5, "compression 1"},
                {{500, 40, 0, 0, 0, 0}, 0.8, "tension 2"},
                {{0, -50, 0, 10, 0, 0}, 0.25, "compression 2"},
                {{0, 0, -80, 0, -20, 0}, 0.5, "compression 3"},
                {{0, 0, 30, 0, 0, 0}, 0.75, "tension 3"},
                {{100, 10, 0, -70, 0, 0}, 0.7, "shear 12"},
                {{0, 0, 0, 0, 88, 0}, 1.1, "shear 13"},
                {{0, 0, 0, 0, 0, -90}, 1.5, "shear 23"}});
}



BOOST_AUTO_TEST_CASE(maximum_strain_by_hand)
{
  // e11 = s11/1e5 - 0.3 s22/1e5 - 0.25 s33/1e5, and so on.
  check_states(Criterion::maximum_strain,
               {{{500, 0, 0, 0, 0, 0}, 0.5, "tension 1"},
                {{-400, 0, 0, 0, 0, 0}, 0.5, "compression 1"},
                {{0, 40, 0, 0, 0, 0}, 0.8, "tension 2"},
                {{0, -100, 0, 0, 0, 0}, 1., "tension 3"},
                {{0, 0, -64, 0, 0, 0}, 0.512, "tension 2"},
                {{0, 0, 0, -70, 0, 0}, 0.7, "shear 12"},
                {{0, 0, 0, 0, 72, 0}, 0.9, "shear 13"},
                {{100, 20, 0, 0, 0, -54}, 0.9, "shear 23"}});
}



BOOST_AUTO_TEST_CASE(tsai_hill_by_hand)
{
  check_states(Criterion::tsai_hill,
               {{{500, 0, 0, 0, 0, 0}, 0.25, "quadratic"},
                {{-400, 0, 0, 50, 0, 0}, 0.5, "quadratic"},
                {{0, 25, 0, 0, 40, 0}, 0.5, "quadratic"},
                {{0, -100, 0, 0, 0, 30}, 0.5, "quadratic"},
                // 1/4 + 1/4 - (1e-6 + 1/2500 - 1/1600) 500 25
                {{500, 25, 0, 0, 0, 0},
                 0.5 - (1e-6 + 4e-4 - 6.25e-4) * 12500.,
                 "quadratic"},
                // 1/4 + 1/4 - (1/640000 + 1/40000 - 1/1600) 400 100
                {{-400, -100, 0, 0, 0, 0},
                 0.5 - (1.5625e-6 + 2.5e-5 - 6.25e-4) * 40000.,
                 "quadratic"},
                // 1/4 + 1/4 + (1/2500 + 1/25600 - 1e-6) 25 80
                {{0, 25, -80, 0, 0, 0},
                 0.5 + (4e-4 + 3.90625e-5 - 1e-6) * 2000.,
                 "quadratic"}});
}



BOOST_AUTO_TEST_CASE(tsai_wu_by_hand)
{
  // F1 = 1/1000 - 1/800, F11 = 1/8e5, F2 = 1/50 - 1/200, F22 = 1e-4, F3 =
  // 1/40 - 1/160, F33 = 1/6400.
  check_states(Criterion::tsai_wu,
               {{{1000, 0, 0, 0, 0, 0}, 1., "quadratic"},
                {{-800, 0, 0, 0, 0, 0}, 1., "quadratic"},
                {{0, 50, 0, 0, 0, 0}, 1., "quadratic"},
                {{0, -100, 0, 0, 0, 0}, -1.5 + 1., "quadratic"},
                {{0, 0, 20, 50, 0, 0}, 0.375 + 0.0625 + 0.25, "quadratic"},
                {{400, 20, 0, 0, 0, 0},
                 -0.1 + 0.2 + 0.3 + 0.04 - std::sqrt(1.25e-10) * 8000.,
                 "quadratic"},
                {{0, 20, -80, 0, 40, 30},
                 0.3 + 0.04 - 1.5 + 1. + std::sqrt(1e-4 / 6400.) * 1600. +
                   0.25 + 0.25,
                 "quadratic"}});
}



BOOST_AUTO_TEST_CASE(hoffman_by_hand)
{
  check_states(
    Criterion::hoffman,
    {{{1000, 0, 0, 0, 0, 0}, 1., "quadratic"},
     {{-800, 0, 0, 0, 0, 0}, 1., "quadratic"},
     {{0, -200, 0, 0, 0, 0}, 1., "quadratic"},
     {{0, 0, 40, 0, 0, 0}, 1., "quadratic"},
     {{0, 20, 0, 50, 0, 0}, 0.3 + 0.04 + 0.25, "quadratic"},
     // 1/(Xt Xc) + 1/(Yt Yc) - 1/(Zt Zc) = 1.25e-6 + 1e-4 - 1.5625e-4
     {{400, 20, 0, 0, 0, 0},
      -0.1 + 0.2 + 0.3 + 0.04 + 5.5e-5 * 8000.,
      "quadratic"},
     // 1/(Yt Yc) + 1/(Zt Zc) - 1/(Xt Xc) = 2.55e-4
     {{0, 20, -80, 0, 0, 30},
      0.3 + 0.04 - 1.5 + 1. + 2.55e-4 * 1600. + 0.25,
      "quadratic"}});
}



BOOST_AUTO_TEST_CASE(hashin_by_hand)
{
  // (Yc / (2 S23))^2 - 1 = (5/3)^2 - 1 = 16/9.
  check_states(
    Criterion::hashin,
    {{{500, 0, 0, 60, 0, 0}, 0.25 + 0.36, "fiber tension"},
     {{-600, 0, 0, 0, 0, 0}, 0.75, "fiber compression"},
     {{0, 25, 0, 50, 0, 0}, 0.25 + 0.25, "matrix tension"},
     {{0, 10, 20, 0, 0, 0}, 900. / 2500. - 200. / 3600., "matrix tension"},
     {{0, -200, 0, 0, 0, 0}, -16. / 9. + 40000. / 14400., "matrix compression"},
     {{0, -60, 30, 10, 0, 12},
      -16. / 9. * 30. / 200. + 900. / 14400. + (144. + 1800.) / 3600. + 0.01,
      "matrix compression"}});
}



BOOST_AUTO_TEST_CASE(puck_by_hand)
{
  const double Yc = 625. / 3., Ra = 250. / 3.;
  // Mode A: p = 0.35; B and C: p = 0.3, with p_pp = 0.25 = 0.3 Ra / 100.
  const auto A = [](const double s, const double t) {
    return std::sqrt(std::pow((1. - 0.35 * 50. / 100.) * s / 50., 2) +
                     t * t / 1e4) +
           0.35 * s / 100.;
  };
  const auto B = [](const double s, const double t) {
    return (std::sqrt(t * t + std::pow(0.3 * s, 2)) + 0.3 * s) / 100.;
  };
  const auto C = [Yc](const double s, const double t) {
    return (std::pow(t / (2. * 1.25 * 100.), 2) + std::pow(s / Yc, 2)) * Yc /
           -s;
  };
  check_states(
    Criterion::puck,
    {{{500, 0, 0, 0, 0, 0}, 0.5, "fiber tension"},
     {{-400, 10, 0, 0, 0, 0}, 0.5, "fiber compression"},
     {{0, 25, 0, 0, 0, 0}, 0.5, "inter-fiber tension"},
     {{0, 20, 0, -60, 0, 0}, A(20, 60), "inter-fiber tension"},
     {{0, -20, 0, 60, 0, 0}, B(-20, 60), "inter-fiber compression"},
     {{0, -150, 0, 60, 0, 0}, C(-150, 60), "inter-fiber compression"},
     {{0, -Yc, 0, 0, 0, 0}, 1., "inter-fiber compression"},
     {{0, 0, 0, 0, 0, 20}, 0.4, "inter-fiber tension"}},
    puck_ply());

  // Angles: 0, acos sqrt(1 / (2 (1 + 0.25))) and 45 degrees; of mode C
  // cos^2 = f Ra / -s2 where f = 1 (there s_n = -R_A).
  const FailureSurface surface(Criterion::puck, puck_ply());
  const auto           angle = [&surface](const double(&s)[6]) {
    return std::abs(*surface.assess(stress(s)).angle) * pi / 180.;
  };
  BOOST_TEST(angle({0, 25, 0, 0, 0, 0}) < 1e-7);
  BOOST_TEST(angle({0, 0, 0, 30, 0, 0}) < 1e-7);
  BOOST_TEST(std::abs(angle({0, 0, 0, 0, 0, -20}) - pi / 4.) < 1e-7);
  BOOST_TEST(std::abs(angle({0, 0, 25, 0, 0, 0}) - pi / 2.) < 1e-7);
  BOOST_TEST(
    std::abs(angle({0, -100, 0, 0, 0, 0}) - std::acos(std::sqrt(0.4))) < 1e-7);
  const double f = C(-150, 60);
  BOOST_TEST(std::abs(angle({0, -150, 0, 60, 0, 0}) -
                      std::acos(std::sqrt(f * Ra / 150.))) < 1e-6);
}



BOOST_AUTO_TEST_CASE(von_mises_by_hand)
{
  check_states(Criterion::von_mises,
               {{{250, 0, 0, 0, 0, 0}, 1., "yield"},
                {{0, -125, 0, 0, 0, 0}, 0.25, "yield"},
                {{0, 0, 0, 50, 0, 0}, 0.12, "yield"},
                {{0, 0, 0, 0, -100, 0}, 0.48, "yield"},
                {{70, 70, 70, 0, 0, 0}, 0., "yield"},
                {{100, -100, 0, 0, 0, 0}, 0.48, "yield"}});
}



BOOST_AUTO_TEST_CASE(von_mises_is_isotropic)
{
  // Principal stresses 200, -50, 30, turned: the same.
  const FailureSurface surface(Criterion::von_mises, ply());
  const double         expected =
    0.5 * (250. * 250. + 80. * 80. + 170. * 170.) / (250. * 250.);
  for (const double degrees : {0., 17., 45., 120.})
    {
      const ElasticTensor T =
        strain_rotation(dealii::transpose(ply_axes(degrees)));
      const Voigt principal = stress({200, -50, 30, 0, 0, 0});
      const Voigt turned    = dealii::transpose(T) * principal;
      BOOST_TEST(std::abs(surface.assess(turned).index - expected) < 1e-12);
    }
  // Tsai-Hill of equal strengths, shear the root of a third, is von Mises.
  Material equal      = ply();
  equal.strengths->Xt = equal.strengths->Xc = equal.strengths->Yt =
    equal.strengths->Yc = equal.strengths->Zt = equal.strengths->Zc = 250.;
  equal.strengths->S12 = equal.strengths->S13 = equal.strengths->S23 =
    250. / std::sqrt(3.);
  std::mt19937 random(7);
  for (const Criterion criterion : {Criterion::tsai_hill, Criterion::hoffman})
    for (unsigned int k = 0; k < 100; ++k)
      {
        const Voigt s = random_stress(random, 30.);
        BOOST_TEST(std::abs(FailureSurface(criterion, equal).assess(s).index -
                            surface.assess(s).index) < 1e-12);
      }
}



BOOST_AUTO_TEST_CASE(interlaminar_and_core_by_hand)
{
  check_states(Criterion::interlaminar,
               {{{900, 40, 20, 90, 0, 0}, 0.25, "delamination"},
                {{0, 0, -100, 0, 40, 0}, 0.25, "delamination"},
                {{0, 0, 0, 0, -80, 0}, 1., "delamination"},
                {{0, 0, 20, 0, 40, -30}, 0.75, "delamination"},
                {{0, 0, -20, 0, 0, 45}, 0.5625, "delamination"}});
  check_states(Criterion::core_shear,
               {{{0, 0, 0, 0, 0.75, 0}, 0.5, "core shear 13"},
                {{0, 0, 0, 0, -1.5, 0}, 1., "core shear 13"},
                {{0, 0, 0, 0, 0.75, 0.8}, 0.8, "core shear 23"},
                {{0, 0, 9, 0, 0, -0.3}, 0.3, "core shear 23"},
                {{1, 1, 1, 1, 3, 1}, 2., "core shear 13"}});
  check_states(Criterion::core_crushing,
               {{{0, 0, -1, 0, 0, 0}, 0.5, "core crushing"},
                {{0, 0, -2, 0, 0, 0}, 1., "core crushing"},
                {{5, 5, -3, 5, 5, 5}, 1.5, "core crushing"},
                {{-5, -5, 0, 5, 5, 5}, 0., "core crushing"},
                {{0, 0, 4, 0, 0, 0}, -2., "core crushing"}});
  BOOST_TEST(!FailureSurface(Criterion::core_crushing, ply())
                .assess(stress({0, 0, 4, 0, 0, 0}))
                .reserve);
}



BOOST_AUTO_TEST_CASE(wrinkling_by_hand)
{
  // 1/2 (8000 10 100)^(1/3) = 100 along the ribbon, with G23 = 800 across it
  // 200; at 45 degrees G = 450.
  const EngineeringConstants face{8000., 8000., 1., 1., 1., 1., 0., 0., 0.};
  const EngineeringConstants core{1., 1., 10., 1., 100., 800., 0., 0., 0.};
  const auto                 along = wrinkling_stresses(face, core, 0., 0.);
  BOOST_TEST(std::abs(along.along_1 - 100.) < 1e-12);
  BOOST_TEST(std::abs(along.along_2 - 200.) < 1e-12);
  const auto across = wrinkling_stresses(face, core, 60., -30.);
  BOOST_TEST(std::abs(across.along_1 - 200.) < 1e-12);
  const auto skew = wrinkling_stresses(face, core, 45., 0.);
  BOOST_TEST(std::abs(skew.along_1 - 0.5 * std::cbrt(3.6e7)) < 1e-12);
  check_states(Criterion::face_wrinkling,
               {{{-50, 0, 0, 0, 0, 0}, 0.5, "wrinkling 1"},
                {{-150, 20, 0, 0, 0, 0}, 1.5, "wrinkling 1"},
                {{0, -20, 0, 0, 0, 0}, 0.1, "wrinkling 2"},
                {{-10, -100, 0, 9, 9, 9}, 0.5, "wrinkling 2"},
                {{40, 0, 0, 0, 0, 0}, 0., "wrinkling 2"}},
               ply(),
               along);
}



BOOST_AUTO_TEST_CASE(reserve_factors_bring_failure)
{
  // Jumps are allowed where a criterion has them, along a ray that does not
  // begin at zero.
  std::mt19937 random(1);
  unsigned int reached = 0, jumps = 0;
  for (const auto &criterion : Names<Criterion>::all)
    {
      const FailureSurface surface(criterion.value, ply(), {300., 70.});
      const bool has_jumps = criterion.value == Criterion::tsai_hill ||
                             criterion.value == Criterion::hashin;
      for (unsigned int k = 0; k < 1000; ++k)
        for (const bool has_residual : {false, true})
          {
            const Voigt m = random_stress(random, 20.);
            Voigt       r = random_stress(random, has_residual ? 15. : 0.);
            while (surface.assess(r).index > 0.8)
              r *= 0.5;
            const Assessment found = surface.assess(m, r);
            const double     R     = found.reserve.value_or(1e3);
            for (unsigned int i = 0; i < 40; ++i)
              BOOST_TEST(surface.assess(R * i / 40. * m + r).index <
                         1. + 1e-10);
            if (!found.reserve)
              continue;
            ++reached;
            const double at = surface.assess(R * m + r).index;
            if (has_residual && has_jumps && std::abs(at - 1.) > 1e-10)
              {
                ++jumps;
                BOOST_TEST(surface.assess(R * (1. - 1e-9) * m + r).index < 1.);
                BOOST_TEST(surface.assess(R * (1. + 1e-9) * m + r).index > 1.);
              }
            else
              BOOST_TEST(std::abs(at - 1.) < 1e-10,
                         criterion.name << ": " << at - 1.);
          }
    }
  BOOST_TEST_MESSAGE(reached << " reserve factors, " << jumps << " at jumps");
  BOOST_TEST(reached > 15000u);
}



BOOST_AUTO_TEST_CASE(residual_stress_stays)
{
  // 25 of 50 is residual: the mechanical 5 may grow to 25, not to 50.
  const FailureSurface surface(Criterion::maximum_stress, ply());
  const Voigt          r = stress({0, 25, 0, 0, 0, 0});
  BOOST_TEST(std::abs(*surface.assess(stress({0, 5, 0, 0, 0, 0}), r).reserve -
                      5.) < 1e-12);
  // Compression must first take it away: 225 / 5.
  BOOST_TEST(std::abs(*surface.assess(stress({0, -5, 0, 0, 0, 0}), r).reserve -
                      45.) < 1e-12);
  BOOST_TEST(*surface.assess(stress({1, 0, 0, 0, 0, 0}), 2.5 * r).reserve ==
             0.);
  BOOST_TEST(!surface.assess(Voigt()).reserve);
  BOOST_TEST(!FailureSurface(Criterion::von_mises, ply())
                .assess(stress({9, 9, 9, 0, 0, 0}))
                .reserve);
}



BOOST_AUTO_TEST_CASE(action_plane_against_all_planes)
{
  // Puck's exposure, written down anew, on 18,000 planes.
  const Strengths        s        = *ply().strengths;
  const PuckInclinations p        = ply().inclinations;
  const double           Ra       = s.Yc / (2. * (1. + p.pt_compression));
  const auto             of_plane = [&](const Voigt &q, const double a) {
    const double n[2] = {std::cos(a), std::sin(a)};
    const double t2 = q[1] * n[0] + q[5] * n[1], t3 = q[5] * n[0] + q[2] * n[1];
    const double sn  = t2 * n[0] + t3 * n[1];
    const double tnt = -t2 * n[1] + t3 * n[0];
    const double tn1 = q[3] * n[0] + q[4] * n[1];
    const double psi = std::atan2(tn1, tnt);
    const double slope = (sn < 0. ? p.pt_compression : p.pt_tension) / Ra *
                           std::pow(std::cos(psi), 2) +
                         (sn < 0. ? p.pl_compression : p.pl_tension) / s.S12 *
                           std::pow(std::sin(psi), 2);
    return std::hypot(std::hypot(tnt / Ra, tn1 / s.S12),
                      (sn < 0. ? slope : 1. / s.Yt - slope) * sn) +
           slope * sn;
  };
  const FailureSurface surface(Criterion::puck, ply());
  std::mt19937         random(3);
  for (unsigned int k = 0; k < 200; ++k)
    {
      Voigt q        = random_stress(random, 20.);
      q[0]           = 0.;
      double largest = 0.;
      for (unsigned int i = 0; i < 18000; ++i)
        largest = std::max(largest, of_plane(q, i * pi / 18000.));
      const Assessment found = surface.assess(q);
      BOOST_TEST(found.index > largest * (1. - 1e-12));
      BOOST_TEST(found.index < largest * (1. + 1e-5));
      BOOST_TEST(std::abs(of_plane(q, *found.angle * pi / 180.) - found.index) <
                 1e-9);
    }
}



BOOST_AUTO_TEST_CASE(pieces_are_continuous)
{
  // Across sigma_22 + sigma_33 = 0 of Hashin, across sigma_22 = 0 of Puck.
  std::mt19937 random(5);
  for (unsigned int k = 0; k < 100; ++k)
    {
      Voigt q = random_stress(random, 20.);
      q[0]    = 0.;
      Voigt a = q, b = q;
      a[2] = -q[1] - 1e-9;
      b[2] = -q[1] + 1e-9;
      const FailureSurface hashin(Criterion::hashin, ply());
      BOOST_TEST(std::abs(hashin.assess(a).index - hashin.assess(b).index) <
                 1e-9);
      const FailureSurface puck(Criterion::puck, ply());
      a = b = q;
      a[1]  = -1e-9;
      b[1]  = 1e-9;
      BOOST_TEST(std::abs(puck.assess(a).index - puck.assess(b).index) < 1e-9);
    }
}



BOOST_AUTO_TEST_CASE(what_is_missing_is_named)
{
  const Material bare(EngineeringConstants::isotropic(1., 0.3));
  BOOST_TEST(missing_entry(Criterion::puck, bare) == "Strengths");
  BOOST_TEST(missing_entry(Criterion::maximum_strain, bare) ==
             "Ultimate strains");
  BOOST_TEST(missing_entry(Criterion::von_mises, bare) == "Yield");
  BOOST_TEST(missing_entry(Criterion::core_shear, bare) == "Core strengths");
  BOOST_TEST(missing_entry(Criterion::face_wrinkling, bare) == "");
  for (const auto &criterion : Names<Criterion>::all)
    BOOST_TEST(missing_entry(criterion.value, ply()) == "");
}

BOOST_AUTO_TEST_SUITE_END()
