// SPDX-License-Identifier: LGPL-2.1-or-later

// Surpluses: what the highest functions of a model do, against models that are
// solved without them; and bars that are made of two levels.

#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/body/beam.h>
#include <lamella/body/beam_surplus.h>
#include <lamella/estimate/comparison.h>
#include <lamella/estimate/error_bar.h>
#include <lamella/estimate/surpluses.h>

#include "quantities.h"
#include "solved_scene.h"
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>

BOOST_AUTO_TEST_SUITE(surpluses)

using namespace lamella;

namespace
{
  using Solved = SolvedScene;



  Solved
  laminate(const std::string &theory, const std::string &axis = "4, 3")
  {
    return {"/tests/scenes/clamped_laminate.prm",
            {"Theory=" + theory,
             "Body beam/Kinematics/Axis elements=" + axis,
             "Body beam/Kinematics/Axis breaks=9",
             "Load patch/Pressure=1 + x + 0.1 * y"}};
  }



  /// Numbers for the fields of a beam's nodes, none of them small.
  Vector
  anything(const Beam &beam)
  {
    std::mt19937                           random(3);
    std::uniform_real_distribution<double> number(-1., 1.);
    Vector                                 u(beam.n_dofs());
    for (double &value : u)
      value = number(random);
    return u;
  }
} // namespace

BOOST_AUTO_TEST_CASE(nothing_is_left_at_the_points_of_the_poorer_space)
{
  const Solved      model = laminate("LE-4");
  const Beam       &beam  = model.beam();
  const BeamSurplus surplus(beam);
  BOOST_TEST(surplus.section_degree() == 4u);
  const Vector u = anything(beam);
  for (unsigned int q = 1; q < 4; ++q)
    {
      const Vector beyond = surplus.in_section(u, q);
      BOOST_TEST(beyond.l2_norm() > 0.1);
      // A projection: what is left has nothing of the poorer space.
      Vector twice = surplus.in_section(beyond, q);
      twice -= beyond;
      BOOST_TEST(twice.l2_norm() < 1e-10 * beyond.l2_norm());
      // At its points the displacement vanishes.
      const auto grid    = grid_points(GaussLobattoBasis::of_degree(q),
                                    GaussLobattoBasis::of_degree(q));
      double     largest = 0.;
      for (unsigned int cell = 0; cell < beam.section().n_cells(); ++cell)
        for (const auto &unit : grid)
          {
            const SectionPoint   point = beam.section().evaluate(cell, unit);
            dealii::Tensor<1, 3> sum;
            for (unsigned int k = 0; k < point.fields->size(); ++k)
              sum += beyond[beam.dofs().first(2) + (*point.fields)[k]] *
                     point.value[k];
            largest = std::max(largest, sum.norm());
          }
      BOOST_TEST(largest < 1e-11);
    }
  for (const unsigned int times : {1, 2})
    {
      const auto   spans  = coarser_spans(model.axis(), times);
      const Vector beyond = surplus.along_axis(u, spans);
      Vector       twice  = surplus.along_axis(beyond, spans);
      twice -= beyond;
      BOOST_TEST(beyond.l2_norm() > 0.1);
      BOOST_TEST(twice.l2_norm() < 1e-12 * beyond.l2_norm());
    }
}



BOOST_AUTO_TEST_CASE(displacements_of_poorer_models_have_no_surplus)
{
  // Rigid motions, which every space holds.
  const Solved      model = laminate("LE-3");
  const Beam       &beam  = model.beam();
  const BeamSurplus surplus(beam);
  for (const Vector &motion : beam.rigid_motions(undisplaced))
    {
      BOOST_TEST(surplus.in_section(motion, 1).linfty_norm() <
                 1e-11 * motion.linfty_norm());
      BOOST_TEST(surplus.along_axis(motion, coarser_spans(model.axis(), 2))
                   .linfty_norm() < 1e-11 * motion.linfty_norm());
    }
}



BOOST_AUTO_TEST_CASE(the_energy_s_surplus_bounds_its_change)
{
  // With z = u, J = 2 energies: J(u_p) - J(u_(p-1)) is the energy of u_p -
  // u_(p-1), the best approximation, and that of the interpolation is larger.
  for (const unsigned int p : {3, 4})
    {
      const Solved rich = laminate("LE-" + std::to_string(p));
      const Solved poor = laminate("LE-" + std::to_string(p - 1));
      const auto   work = [](const Solved &model) {
        return model.run.model().structure().load(1.) *
               model.run.results().last().state.u;
      };
      const double  change = work(rich) - work(poor);
      const Surplus surplus =
        Surpluses(rich.run).of(rich.run.results().last().state.u).section;
      BOOST_TEST_CONTEXT("LE-" << p << ": " << change << ' ' << surplus.last)
      {
        BOOST_TEST(change > 0.);
        BOOST_TEST(surplus.last >= change);
        BOOST_TEST(surplus.last < 3. * change);
      }
    }
}



BOOST_AUTO_TEST_CASE(a_goal_s_surplus_is_about_its_change)
{
  const Solved    rich = laminate("LE-3"), poor = laminate("LE-2");
  const GoalDual  dual(rich.run);
  const Surpluses surpluses(rich.run);
  const auto look = [&](const char *const probe, const char *const column) {
    const NamedQuantity goal =
      quantity_of(NamedQuantity::ObjectKind::probe, probe, column);
    return std::make_pair(
      std::abs(rich.value(goal) - poor.value(goal)),
      surpluses.of(dual.solve(*dual.derivative(goal)).u).section);
  };
  const auto [of_deflection, deflection] = look("middle", "uz");
  BOOST_TEST(std::abs(deflection.last) > 0.5 * of_deflection);
  BOOST_TEST(std::abs(deflection.last) < 2. * of_deflection);
}



BOOST_AUTO_TEST_CASE(a_contact_force_s_surplus_is_about_its_change)
{
  const auto pressed = [](const std::string &theory) {
    return Solved("/prm/sandwich.prm",
                  {"Theory=" + theory,
                   "Section sandwich/Cells per ply=1",
                   "Section sandwich/Cells across=1",
                   "Body beam/Kinematics/Axis elements=2, 1, 2, 1, 2"});
  };
  const Solved        rich = pressed("LE-3"), poor = pressed("LE-2");
  const NamedQuantity force =
    quantity_of(NamedQuantity::ObjectKind::contact, "indentation", "fz");
  const GoalDual dual(rich.run);
  const double   change = rich.value(force) - poor.value(force);
  const Surplus  surplus =
    Surpluses(rich.run).of(dual.solve(*dual.derivative(force)).u).section;
  BOOST_TEST_CONTEXT(change << ' ' << surplus.last)
  {
    BOOST_TEST(surplus.last / change > 0.5);
    BOOST_TEST(surplus.last / change < 2.);
  }
}



BOOST_AUTO_TEST_CASE(who_has_none_says_why)
{
  BOOST_TEST(Surpluses::unavailable_reason(laminate("LE-3").run, 3).empty());
  for (const char *const theory : {"LE-2", "TE-4", "SV", "EBBT"})
    {
      const Solved model = laminate(theory);
      BOOST_TEST(!Surpluses::unavailable_reason(model.run, 3).empty());
      BOOST_TEST(!coarser_model_recipe(model.run).unavailable.empty());
    }
}



BOOST_AUTO_TEST_CASE(bars_from_below_hold_of_what_converges)
{
  // Changes c q, c q^2, ...: what is left is c q^2 / (1 - q).
  for (const double c : {1., -0.1, 1e-4})
    for (const double q : {0.01, 0.1, 0.3, 0.6, -0.3, -0.6})
      {
        const ErrorBar bar = coarser_model_bar({{c * q, c, 0.}}, 1.);
        BOOST_TEST(bar.trusted);
        BOOST_TEST(bar.bar >= std::abs(c * q * q / (1. - q)));
      }
}



BOOST_AUTO_TEST_CASE(a_ratio_that_is_small_by_accident_is_not_believed)
{
  // A value that passes its limit: the last change says nothing of what is
  // left.
  BOOST_TEST(coarser_model_bar({{1e-9, 0.08, 0.01}}, 1.).bar >= 0.01);
  // Where the change before is large the bar is no less than the last one.
  BOOST_TEST(coarser_model_bar({{0.01, 10., 0.}}, 1.).bar >= 0.01);
}



BOOST_AUTO_TEST_CASE(sources_that_cancel_count_each)
{
  BOOST_TEST(coarser_model_bar({{0.03, 0.1, 0.}, {-0.03, 0.1, 0.}}, 1.).bar >=
             0.06);
}



BOOST_AUTO_TEST_CASE(odd_and_even_degrees_have_no_bar)
{
  // Nothing, then all of it: 1.3 and then 7 %.
  BOOST_TEST(!coarser_model_bar({{0.07, 0.013, 0.}}, 1.).trusted);
  // What is small anyway has twice of all that it does.
  const ErrorBar little = coarser_model_bar({{0.004, 0.002, 0.}}, 1.);
  BOOST_TEST(little.trusted);
  BOOST_TEST(little.bar == 0.008);
  // Neither has changed: rounding.
  const ErrorBar nothing = coarser_model_bar({{0., 0., 0.}}, 1.);
  BOOST_TEST(nothing.trusted);
  BOOST_TEST(nothing.bar == 1e-8);
}

BOOST_AUTO_TEST_SUITE_END()
