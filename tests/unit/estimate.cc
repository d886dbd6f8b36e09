// SPDX-License-Identifier: LGPL-2.1-or-later

// Bars of errors as arithmetic, and the richer models that they come from.

#include <lamella/estimate/comparison_models.h>
#include <lamella/estimate/enrichment.h>
#include <lamella/estimate/error_bar.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <functional>
#include <set>

BOOST_AUTO_TEST_SUITE(estimate)

using namespace lamella;

namespace
{
  /// The values 1 + c q^k, k = 0, 1, 2, of a quantity whose limit is 1.
  Refinements
  geometric(const double c, const double q)
  {
    Refinements values;
    values.run     = 1. + c;
    values.richer  = 1. + c * q;
    values.richest = 1. + c * q * q;
    values.shares  = std::abs(values.richer - values.run);
    values.scale   = 1.;
    return values;
  }
} // namespace

BOOST_AUTO_TEST_CASE(bars_hold_of_what_converges)
{
  // The estimate is c (q^2 - 1): short of the error by the share q^2 of it.
  for (const double c : {1., -0.3, 1e-4, -1e-7})
    for (const double q : {0., 0.1, 0.25, 0.6})
      {
        const ErrorBar bar = error_bar(geometric(c, q));
        BOOST_TEST(bar.trusted);
        BOOST_TEST(std::abs(bar.estimate - c * (q * q - 1.)) <
                   1e-15 * (1. + std::abs(c)));
        BOOST_TEST(bar.bar >= std::abs(c));
        BOOST_TEST(bar.bar <= 2. * std::abs(c) * (1. + 1e-9) + 1e-15);
      }
}



BOOST_AUTO_TEST_CASE(no_bar_for_what_grows_or_wavers)
{
  // A logarithm: as much again at each refinement.
  Refinements grows{1., 1.1, 1.2, 0.1, 1., 0.};
  const auto  bar = error_bar(grows);
  BOOST_TEST(!bar.trusted);
  BOOST_TEST(bar.why.find("more in each refinement") != std::string::npos);

  const auto wavers = error_bar({1., 1.2, 1.02, 0.2, 1., 0.});
  BOOST_TEST(!wavers.trusted);
  BOOST_TEST(wavers.why.find("do not agree") != std::string::npos);

  // The same within a share of the scale that is small anyway has a bar of
  // twice all that it does.
  const auto little = error_bar({1., 1.002, 1.0002, 0.002, 1., 0.});
  BOOST_TEST(little.trusted);
  BOOST_TEST(std::abs(little.bar - 0.004) < 1e-12);
}



BOOST_AUTO_TEST_CASE(opposite_shares_count)
{
  // Two errors that cancel: the estimate is 0, the bar is not.
  const auto bar = error_bar({1., 1., 1., 0.2, 1., 1e-12});
  BOOST_TEST(bar.estimate == 0.);
  BOOST_TEST(std::abs(bar.bar - 0.1) < 1e-15);
}



BOOST_AUTO_TEST_CASE(rounding_is_no_refinement)
{
  const auto bar = error_bar({1., 1. + 1e-13, 1. - 2e-13, 1e-13, 1., 1e-12});
  BOOST_TEST(bar.trusted);
  // Nobody keeps count of more than eight digits,
  BOOST_TEST(bar.bar == 1e-8);
  // and of fewer where the solution has settled on fewer.
  const auto settled = error_bar({1., 1. + 1e-9, 1. - 2e-9, 1e-9, 1., 1e-7});
  BOOST_TEST(settled.trusted);
  BOOST_TEST(settled.bar == 1e-7);
}



namespace
{
  Scene
  scene_of(const std::string &theory)
  {
    Scene           scene;
    BodyDescription body;
    body.name          = "beam";
    body.section       = "strip";
    body.theory        = Theory::parse({"Theory", theory});
    body.axis.elements = {3, 4};
    body.axis.breaks   = {1.};
    body.axis.length   = 2.;
    scene.bodies       = {body};
    return scene;
  }



  /// A body of 1,000 DoFs on 100 nodes, whose section has 100 cells.
  const std::vector<BodySize> large{BodySize{1000, 100, 1000, 100}},
    small{BodySize{1000, 10, 300, 10}};

  std::string
  enriched_theory(const std::string           &theory,
                  const Source                 source,
                  const double                 max_dofs = 1e9,
                  const std::vector<BodySize> &sizes    = large)
  {
    PlanRules rules;
    rules.max_layerwise_dofs = max_dofs;
    return enriched(scene_of(theory), source, sizes, rules)
      .bodies[0]
      .theory.name();
  }
} // namespace

BOOST_AUTO_TEST_CASE(keys_of_models)
{
  Scene base = scene_of("LE-2");
  base.contacts.resize(1);
  base.bodies[0].pieces = {{Theory::layerwise(2), Theory::layerwise(1)}, {1.}};
  base.bodies[0].refinement.balls = {{{}, 1., 1}};
  const std::vector<std::function<void(Scene &)>> changes{
    [](Scene &s) { s.bodies[0].theory.order = 3; },
    [](Scene &s) { s.bodies[0].theory = Theory::taylor(2); },
    [](Scene &s) { s.bodies[0].theory.section_order = 4; },
    [](Scene &s) { s.bodies[0].theory.hierarchical = true; },
    [](Scene &s) { s.bodies[0].theory.poisson_correction = false; },
    [](Scene &s) { s.bodies[0].theory.shear_factor = 5. / 6.; },
    [](Scene &s) { s.bodies[0].pieces.theories[1].order = 3; },
    [](Scene &s) { s.bodies[0].pieces.breaks[0] += 1e-15; },
    [](Scene &s) { s.bodies[0].axis.elements[1] = 5; },
    [](Scene &s) { s.bodies[0].axis.breaks[0] += 1e-9; },
    [](Scene &s) { s.bodies[0].axis.degree = 2; },
    [](Scene &s) { s.bodies[0].axis.length = 3.; },
    [](Scene &s) { s.bodies[0].axis.refinement_factor = 1.; },
    [](Scene &s) { s.bodies[0].axis.assumed_shear = true; },
    [](Scene &s) { s.bodies[0].axis.equidistant_nodes = true; },
    [](Scene &s) { s.bodies[0].stabilization = 1e-6; },
    [](Scene &s) { s.bodies[0].is_held = true; },
    [](Scene &s) { s.bodies[0].refinement.everywhere = 1; },
    [](Scene &s) { s.bodies[0].refinement.balls[0].radius = 2.; },
    [](Scene &s) { s.divisions["strip"] = 1; },
    [](Scene &s) { s.corner_layers["strip"] = 1; },
    [](Scene &s) { s.contacts[0].enforcement = Enforcement::exact; },
    [](Scene &s) { s.contacts[0].penalty.value = 7.; },
    [](Scene &s) { s.contacts[0].slave_side = SlaveSide::second; },
    [](Scene &s) { s.contacts[0].tolerance = 1e-3; },
    [](Scene &s) { s.contacts[0].search_distance = 1.; },
    [](Scene &s) { s.resolved += "set u = 0, 0, 1"; }};
  std::set<std::string> keys{key_of(base)};
  for (const auto &change : changes)
    {
      Scene other = base;
      change(other);
      keys.insert(key_of(other));
    }
  BOOST_TEST(keys.size() == changes.size() + 1);

  // No divisions are what was not said, and pictures are no model; nor is it
  // another one that says the ends of its elements in another way, which are
  // sums of lengths.
  Scene same                 = base;
  same.bodies[0].axis.breaks = {1. / 3., 2. / 3., 1., 1.25, 1.5, 1.75};
  same.bodies[0].axis.elements.assign(7, 1);
  same.divisions["strip"] = 0;
  same.write_vtu          = false;
  BOOST_TEST(key_of(same) == key_of(base));
}



BOOST_AUTO_TEST_CASE(richer_models)
{
  BOOST_TEST(enriched_theory("EBBT", Source::fields) == "SV-10 (of LE-3)");
  BOOST_TEST(enriched_theory("TE-4", Source::fields) == "SV-10 (of LE-3)");
  BOOST_TEST(enriched_theory("SV", Source::fields) == "SV-6 (of LE-3)");
  BOOST_TEST(enriched_theory("SV-6", Source::fields) == "SV-10 (of LE-3)");
  BOOST_TEST(enriched_theory("LE-2", Source::section) == "LE-3 (L16)");
  BOOST_TEST(enriched_theory("LE-2", Source::section, 2000.) ==
             "SV-10 (of LE-3)");
  // Where layers are few, making responses would cost more, and there would be
  // more of them than the section has fields.
  BOOST_TEST(enriched_theory("TE-4", Source::fields, 1e9, small) ==
             "LE-2 (L9)");
  BOOST_TEST(enriched_theory("SV", Source::fields, 1e9, small) == "LE-2 (L9)");
  BOOST_TEST(enriched_theory("LE-2", Source::section, 2000., small) ==
             "LE-3 (L16)");
  BOOST_TEST(enriched_theory("solid-1", Source::section) == "solid-2");
  BOOST_TEST(enriched_theory("LE-2", Source::axis) == "LE-2 (L9)");

  const Scene finer = enriched(scene_of("SV-6"), Source::axis, large);
  BOOST_TEST(finer.bodies[0].axis.elements[0] == 6);
  BOOST_TEST(finer.bodies[0].axis.elements[1] == 8);
  const Scene higher = enriched(scene_of("SV-6"), Source::section, large);
  BOOST_TEST(higher.bodies[0].theory.section_order == 4);

  // Degrees first, then cells: there is always something that gets richer.
  BOOST_TEST(higher.divisions.empty());
  const Scene divided = enriched(scene_of("LE-8"), Source::section, large);
  BOOST_TEST(divided.bodies[0].theory.name() ==
             scene_of("LE-8").bodies[0].theory.name());
  BOOST_TEST(divided.divisions.at("strip") == 1u);
  BOOST_TEST(enriched(divided, Source::section, large).divisions.at("strip") ==
             2u);
  BOOST_TEST(enriched(scene_of("LE-8"), Source::axis, large).divisions.empty());

  // Sections with corners get layers there: at once where degrees stall, and
  // as many as a section may have.
  std::vector<BodySize> cornered = large;
  for (BodySize &size : cornered)
    size.corners = 4;
  PlanRules stalled;
  stalled.corner_degree = 3;
  Scene layered         = scene_of("LE-3");
  for (unsigned int layers = 1; layers <= 6; ++layers)
    {
      layered = enriched(layered, Source::section, cornered, stalled);
      BOOST_TEST(layered.bodies[0].theory.order == 3u);
      BOOST_TEST(layered.corner_layers.at("strip") == layers);
    }
  BOOST_TEST(enriched(layered, Source::section, cornered, stalled)
               .bodies[0]
               .theory.order == 4u);
  const Scene plain =
    enriched(scene_of("LE-3"), Source::section, large, stalled);
  BOOST_TEST(plain.bodies[0].theory.order == 4u);
  BOOST_TEST(plain.corner_layers.empty());

  BOOST_TEST(!has_source(scene_of("LE-2"), Source::fields));
  BOOST_TEST(!has_source(scene_of("EBBT"), Source::section));
  BOOST_TEST(!has_source(scene_of("solid-2"), Source::axis));
  BOOST_TEST(!has_source(scene_of("LE-2"), Source::contact));
}

BOOST_AUTO_TEST_SUITE_END()
