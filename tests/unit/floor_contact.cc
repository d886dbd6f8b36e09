// SPDX-License-Identifier: LGPL-2.1-or-later

// Beams that meet floors and stops, against closed forms of beam theory; gap
// rows made by hand.
//
// A beam of length l and stiffness EI, clamped at both ends at a height g above
// a rigid floor, is pressed down by a line load q. Where it lies on the floor
// it is straight and the floor carries q; the piece of length c from a clamp
// has w = w' = 0 there and w = g, w' = w'' = 0 where it touches down, which
// needs a point force q c / 3 there and
//   c = (72 E I g / q)^(1/4),
// so the floor carries q (l - 2 c) + 2 q c / 3 = q (l - 4 c / 3) in all.

#include "contact_scene.h"

#include <lamella/solve/checks.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(floor_contact)


using namespace lamella;
using dealii::Point;

namespace
{
  /// One meter and one newton in the units of a scene.
  struct UnitSystem
  {
    double length = 1., force = 1.;
  };

  Theory
  theory(const char *const name)
  {
    return Theory::parse({"Theory", name});
  }



  constexpr double l = 3., height = 0.01, width = 0.02, E = 2e5, c = 1.;
  constexpr double EI = E * width * height * height * height / 12., q = 0.7,
                   g = q * c * c * c * c / (72. * EI);

  /// The beam over the floor, a row at each end of its elements.
  ContactScene
  beam_over_floor(const char *const  kinematics,
                  const unsigned int elements,
                  const Enforcement  enforcement,
                  const Strategy     strategy,
                  const UnitSystem  &units    = UnitSystem(),
                  const double       hardness = 1000.)
  {
    const double L = units.length, F = units.force, modulus = E * F / L / L;
    const auto   section = make_section(
      make_section_mesh(rectangle(width * L, height * L),
                        {{"material",
                            EngineeringConstants::isotropic(modulus, 0.)}}),
      theory(kinematics));
    Bodies bodies;
    bodies.push_back(std::make_unique<Beam>(
      "beam", section, make_axis(l * L, elements), Placement()));
    ContactScene contact;
    const double h = l * L / elements;
    for (unsigned int k = 0; k <= elements; ++k)
      contact.rows.push_back(
        above_floor(bodies,
                    {0.5 * width * L, std::min(k * h, l * L), 0.},
                    g * L,
                    enforcement,
                    hardness * modulus * width * L * h / (height * L)));
    contact.structure = std::make_unique<Structure>(
      std::move(bodies),
      std::vector<Support>{clamp("ends")},
      std::vector<Load>{
        traction("top", "0", "0", digits(-q / width * F / L / L))});
    contact.prepare(strategy);
    return contact;
  }

} // namespace

BOOST_AUTO_TEST_CASE(a_beam_pressed_on_a_floor)
{
  // c from the moment of the floor's forces about the clamps:
  //   q c / 3 c + q (l/2 - c) (l/2 + c) / 2 = q (l^2/8 - c^2/6) in each half.
  for (const char *kinematics : {"EBBT", "TBT", "LE-1"})
    for (const Enforcement enforcement :
         {Enforcement::penalty, Enforcement::exact})
      {
        const unsigned int n = 300;
        const ContactScene scene =
          beam_over_floor(kinematics, n, enforcement, Strategy::condensed);
        const State state  = scene.solve();
        double      moment = 0.;
        for (unsigned int k = 0; k <= n; ++k)
          moment += state.force[k] * std::min(k, n - k) * l / n;
        const double total   = sum(state.force),
                     c_found = std::sqrt(6. * (l * l / 8. - 0.5 * moment / q));
        BOOST_TEST_MESSAGE(kinematics << ": force off by "
                                      << total / (q * (l - 4. * c / 3.)) - 1.
                                      << ", c by " << c_found / c - 1. << ", "
                                      << state.iterations << " iterations, KKT "
                                      << scene.violation(state));
        BOOST_TEST(std::abs(total / (q * (l - 4. * c / 3.)) - 1.) < 1e-3);
        BOOST_TEST(std::abs(c_found / c - 1.) < 1e-2);
        if (enforcement == Enforcement::exact)
          BOOST_TEST(scene.violation(state) < 1e-9);
      }
}



BOOST_AUTO_TEST_CASE(iterations_do_not_grow)
{
  for (const char *kinematics : {"EBBT", "TBT"})
    for (const Strategy strategy : {Strategy::condensed, Strategy::full})
      for (const unsigned int n : {40, 80, 160})
        {
          const ContactScene scene =
            beam_over_floor(kinematics, n, Enforcement::penalty, strategy);
          const State state = scene.solve();
          BOOST_TEST_MESSAGE(
            kinematics << (strategy == Strategy::full ? " full " :
                                                        " condensed ")
                       << n << ": " << state.iterations << " iterations, "
                       << state.active.size() << " active, force off by "
                       << sum(state.force) / (q * (l - 4. * c / 3.)) - 1.);
          BOOST_TEST(state.iterations <= 30);
        }
}



BOOST_AUTO_TEST_CASE(enforcements_agree)
{
  for (const Strategy strategy : {Strategy::condensed, Strategy::full})
    {
      std::vector<double> force;
      for (const Enforcement enforcement : {Enforcement::exact,
                                            Enforcement::augmented_lagrangian,
                                            Enforcement::penalty})
        {
          const ContactScene scene =
            beam_over_floor("TBT",
                            60,
                            enforcement,
                            strategy,
                            {},
                            enforcement == Enforcement::penalty ? 1e6 : 1000.);
          const State state = scene.solve();
          BOOST_TEST_MESSAGE("KKT " << scene.violation(state) << " in "
                                    << state.iterations);
          if (enforcement != Enforcement::penalty)
            BOOST_TEST(scene.violation(state) < 1e-9);
          force.push_back(sum(state.force));
        }
      BOOST_TEST(std::abs(force[1] / force[0] - 1.) < 1e-6);
      BOOST_TEST(std::abs(force[2] / force[0] - 1.) < 1e-6);
    }
}



BOOST_AUTO_TEST_CASE(units_do_not_matter)
{
  for (const Enforcement enforcement : {Enforcement::penalty,
                                        Enforcement::exact,
                                        Enforcement::augmented_lagrangian})
    {
      std::vector<State>            states;
      const std::vector<UnitSystem> units{{1., 1.},
                                          {1e-3, 1.},
                                          {1e6, 1.},
                                          {1., 1e6}};
      for (const UnitSystem &unit : units)
        states.push_back(
          beam_over_floor("TBT", 80, enforcement, Strategy::condensed, unit)
            .solve());
      for (unsigned int k = 1; k < units.size(); ++k)
        {
          BOOST_TEST(states[k].iterations == states[0].iterations);
          BOOST_TEST(states[k].active == states[0].active);
          for (unsigned int r = 0; r < states[0].force.size(); ++r)
            BOOST_TEST(std::abs(states[k].force[r] / units[k].force -
                                states[0].force[r]) < 1e-8 * q);
        }
    }
}



BOOST_AUTO_TEST_CASE(a_symmetric_scene_gives_symmetric_forces)
{
  for (const Enforcement enforcement : {Enforcement::penalty,
                                        Enforcement::exact,
                                        Enforcement::augmented_lagrangian})
    {
      const State state =
        beam_over_floor("TBT", 80, enforcement, Strategy::condensed).solve();
      double worst = 0.;
      for (unsigned int k = 0; k <= 80; ++k)
        worst = std::max(worst, std::abs(state.force[k] - state.force[80 - k]));
      BOOST_TEST_MESSAGE("asymmetry " << worst / sum(state.force));
      BOOST_TEST(worst < 1e-9 * sum(state.force));
    }
}

BOOST_AUTO_TEST_SUITE_END()
