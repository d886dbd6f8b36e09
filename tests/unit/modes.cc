// SPDX-License-Identifier: LGPL-2.1-or-later

// Mass matrices against closed forms and against the integral of displacement
// functionals, rigid motions of free bodies, multiple eigenvalues.

#include "solved_scene.h"

#include <lamella/body/body_solver.h>
#include <lamella/solve/small_motions.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <complex>
#include <map>
#include <random>

BOOST_AUTO_TEST_SUITE(modes)

using namespace lamella;

namespace
{
  /// The laminated beam of theory @p theory, clamped, without modes.
  SolvedScene
  clamped_beam(const std::string &theory)
  {
    return {"/prm/modes_laminated.prm",
            {"Theory=" + theory,
             "Find=modes",
             "Modes=1",
             "Supports=left",
             "Support left/u=0, 0, 0"}};
  }



  /// M @p w of the blocks of @p for_each_block.
  template <typename ForEachBlock>
  Vector
  product(const ForEachBlock &for_each_block, const Vector &w)
  {
    Vector f(w.size());
    for_each_block(
      [&](const StiffnessBlock &block) { block.add_product(w, f); });
    return f;
  }
} // namespace

BOOST_AUTO_TEST_CASE(rigid_motions_have_the_mass_of_the_body)
{
  const double m = 1.6e-5, b = 5., h = 20., L = 100.;
  for (const std::string theory :
       {"EBBT", "TBT", "TE-3", "LE-2", "SV-4", "solid-2"})
    BOOST_TEST_CONTEXT(theory)
    {
      const SolvedScene scene     = clamped_beam(theory);
      const Structure  &structure = scene.run.model().structure();
      const MassMatrix  mass(structure, structure.zero());
      const auto rigid = structure.bodies()[0]->rigid_motions(undisplaced);
      std::array<BlockVector, 6> r, Mr;
      for (unsigned int d = 0; d < 6; ++d)
        {
          r[d]          = structure.zero();
          r[d].block(0) = rigid[d];
          Mr[d]         = mass(r[d]);
        }
      for (unsigned int c = 0; c < 3; ++c)
        for (unsigned int d = 0; d < 3; ++d)
          BOOST_TEST(std::abs(r[c] * Mr[d] - (c == d ? m : 0.)) < 1e-12 * m);
      BOOST_TEST(std::abs(r[3] * Mr[3] / (m * (L * L + h * h) / 12.) - 1.) <
                 1e-12);
      BOOST_TEST(std::abs(r[5] * Mr[5] / (m * (L * L + b * b) / 12.) - 1.) <
                 1e-12);
      // Rotation about the axis is no motion of EBBT and TBT.
      if (theory != "EBBT" && theory != "TBT")
        BOOST_TEST(std::abs(r[4] * Mr[4] / (m * (b * b + h * h) / 12.) - 1.) <
                   1e-12);
    }
}



BOOST_AUTO_TEST_CASE(products_are_integrals_of_displacements)
{
  for (const std::string theory : {"TBT", "TE-2", "LE-2", "SV-4", "solid-2"})
    BOOST_TEST_CONTEXT(theory)
    {
      const SolvedScene scene = clamped_beam(theory);
      const Body       &body  = *scene.run.model().structure().bodies()[0];
      std::mt19937      random(3);
      std::uniform_real_distribution<double> number(-1., 1.);
      Vector                                 w(body.n_dofs());
      for (double &value : w)
        value = number(random);
      const Vector fast = product(
        [&](const BlockCallback &use) {
          body.for_each_mass_block(undisplaced, true, use);
        },
        w);
      Vector difference = product(
        [&](const BlockCallback &use) {
          body.Body::for_each_mass_block(undisplaced, true, use);
        },
        w);
      difference -= fast;
      BOOST_TEST(fast.linfty_norm() > 0.);
      BOOST_TEST(difference.linfty_norm() < 1e-11 * fast.linfty_norm());
    }
}



BOOST_AUTO_TEST_CASE(free_bodies_have_six_rigid_motions_each)
{
  const SolvedScene  scene("/tests/scenes/modes_bar.prm",
                          {"Supports=", "Loads=", "Theory=LE-2", "Modes=1"});
  const Structure   &structure = scene.run.model().structure();
  const MassMatrix   mass(structure, structure.zero());
  const SmallMotions motions(scene.run.linear_system(),
                             scene.run.results().last().state,
                             [&](const BlockVector &v) { return mass(v); });
  BOOST_TEST(motions.rigid_motions().size() == 12u);
  const double lowest =
    std::pow(2. * dealii::numbers::PI *
               scene.run.results().natural_modes->modes[0].value,
             2);
  for (const BlockVector &r : motions.rigid_motions())
    {
      BOOST_TEST(std::abs(r * mass(r) - 1.) < 1e-9);
      BOOST_TEST(std::abs(r * motions.times_stiffness(r)) < 1e-9 * lowest);
    }
}



BOOST_AUTO_TEST_CASE(multiple_eigenvalues_are_found_as_often_as_they_occur)
{
  const unsigned int n = 80;
  BlockVector        like(1, n);
  const auto         value = [](const unsigned int k) {
    return k < 3 ? 5. : k < 5 ? 4. : 3. / (k - 3.);
  };
  const Operator     same = [](const BlockVector &v) { return v; };
  const Eigenproblem problem{[&](const BlockVector &v) {
                               BlockVector f(v);
                               for (unsigned int k = 0; k < n; ++k)
                                 f[k] *= value(k);
                               return f;
                             },
                             same,
                             same};
  const BlockVector  start = random_vector(like);
  Eigenpairs         pairs = largest_eigenpairs(problem, start, 6);
  add_missing_eigenpairs(problem, start, {}, pairs);
  BOOST_REQUIRE(pairs.values.size() == 6u);
  for (unsigned int k = 0; k < 6; ++k)
    BOOST_TEST(std::abs(pairs.values[k] - value(k)) < 1e-9);
}



// A of rank two: its two eigenvectors span all that the method can find.
BOOST_AUTO_TEST_CASE(an_exhausted_space_gives_its_eigenpairs)
{
  const unsigned int n = 30;
  BlockVector        like(1, n);
  const Operator     same = [](const BlockVector &v) { return v; };
  const Operator     low  = [&](const BlockVector &v) {
    BlockVector f(1, n);
    f[3] = 7. * v[3];
    f[8] = 2. * v[8];
    return f;
  };
  const Eigenpairs pairs = largest_eigenpairs({low, same, same},
                                              random_vector(like),
                                              1,
                                              {1e-6, 10, 20});
  BOOST_REQUIRE(pairs.values.size() >= 1u);
  BOOST_TEST(std::abs(pairs.values[0] - 7.) < 1e-9);
}


namespace
{
  using Complex = std::complex<double>;

  /// Complex amplitudes of column @p c of the first probe, by frequency.
  std::map<double, Complex>
  response(const std::vector<std::string> &overrides, const unsigned int c = 2)
  {
    const SolvedScene         scene("/prm/harmonic_response.prm", overrides);
    std::map<double, Complex> values;
    for (const HarmonicRow &row : scene.run.results().response)
      values[row.frequency] = row.values[c];
    return values;
  }



  double
  circular(const double frequency)
  {
    return 2. * dealii::numbers::PI * frequency;
  }
} // namespace

BOOST_AUTO_TEST_CASE(harmonic_response_is_that_of_a_damped_euler_beam)
{
  // Modal series with rotary inertia, damping ratio 0.02 in each mode.
  const double EI = 210e3 * 1e4 / 12., mass = 7.85e-7, L = 200., F = -100.;
  const auto   exact = [&](const double f) {
    Complex sum = 0.;
    for (unsigned int n = 1; n < 400; ++n)
      {
        const double k     = n * dealii::numbers::PI / L;
        const double modal = mass * L / 2. * (1. + 100. / 12. * k * k);
        const double own   = std::sqrt(EI * L / 2. / modal) * k * k;
        const double omega = circular(f);
        sum += F * std::sin(80. * k) * std::sin(120. * k) /
               (modal * Complex(own * own - omega * omega, 0.04 * own * omega));
      }
    return sum;
  };
  for (const std::string modes : {"10", "12"})
    for (const auto &[f, value] : response({"Modes=" + modes}))
      BOOST_TEST(std::abs(value - exact(f)) < 1e-3 * std::abs(exact(f)),
                 f << " Hz: " << value << ", exact " << exact(f));
}



BOOST_AUTO_TEST_CASE(harmonic_response_at_rest_is_static)
{
  const SolvedScene statics("/prm/harmonic_response.prm",
                            {"Load force/Factors=", "Find="});
  const double  u = statics.run.results().probe("probe").sample.displacement[2];
  const Complex still = response({"Harmonic response/Frequencies=0, 1"})[0.];
  BOOST_TEST(std::abs(still - u) < 1e-6 * std::abs(u));
}



BOOST_AUTO_TEST_CASE(accelerated_and_moved_supports_agree)
{
  const std::string given = "Harmonic response/Frequencies=10 to 2000 in 10";
  const auto        relative =
    response({"Loads=", given, "Harmonic response/Base acceleration=0, 0, 1"});
  const auto moved = response({"Loads=",
                               given,
                               "Support left/u=0, free, 1",
                               "Support right/u=0, 0, 1",
                               "Support left/Factors=harmonic",
                               "Support right/Factors=harmonic"});
  BOOST_TEST(moved.size() == relative.size());
  for (const auto &[f, value] : moved)
    {
      const Complex scaled = -circular(f) * circular(f) * relative.at(f);
      BOOST_TEST(std::abs(value - 1. - scaled) < 1e-6 * std::abs(scaled));
    }
}



BOOST_AUTO_TEST_CASE(undamped_resonance_is_refused)
{
  const SolvedScene modes("/prm/harmonic_response.prm",
                          {"Find=modes", "Loads="});
  const double      own = modes.run.results().natural_modes->modes[0].value;
  BOOST_CHECK_THROW(response(
                      {"Harmonic response/Damping=0",
                       "Harmonic response/Frequencies=" + to_text(own, 17)}),
                    InputError);
}



BOOST_AUTO_TEST_CASE(free_bar_vibrates_about_its_rigid_motion)
{
  const double EA = 210e5, L = 200.;
  for (const auto &[f, value] :
       response({"Supports=",
                 "Modes=40",
                 "Load force/At=5, 0, 5",
                 "Load force/Force=0, 1000, 0",
                 "Harmonic response/Damping=0",
                 "Harmonic response/Frequencies=1, 500, 3000, 7000, 12000"},
                1))
    {
      const double k = circular(f) * std::sqrt(7.85e-9 / 210e3);
      const double exact =
        -1000. * std::cos(80. * k) / (EA * k * std::sin(L * k));
      BOOST_TEST(std::abs(value - exact) < 1e-3 * std::abs(exact), f << " Hz");
    }
}



BOOST_AUTO_TEST_CASE(harmonic_response_with_large_rotations_agrees_at_rest)
{
  // Two discretizations of the same beam, with other elements along the axis.
  const std::string given  = "Harmonic response/Frequencies=10 to 1500 in 6";
  const auto        linear = response({given}),
             large         = response({given, "Rotations=large"});
  unsigned int n_compared  = 0;
  for (const auto &[f, value] : linear)
    if (const auto other = large.find(f); other != large.end())
      {
        ++n_compared;
        BOOST_TEST(std::abs(value - other->second) < 1e-4 * std::abs(value),
                   f << " Hz");
      }
  BOOST_TEST(n_compared >= 7u);
}

BOOST_AUTO_TEST_SUITE_END()
