// SPDX-License-Identifier: LGPL-2.1-or-later

// Which model a body gets, as a table, and what a clamp is.

#include <lamella/adapt/plan.h>

#include <boost/test/unit_test.hpp>

#include <functional>

BOOST_AUTO_TEST_SUITE(plans)

using namespace lamella;
using namespace dealii;

namespace
{
  /// A slender beam of SV-6 with a large section, of which nothing speaks
  /// against fields of its own.
  PlanInput
  slender()
  {
    PlanInput facts;
    facts.size                    = {60000, 100, 600, 100, false, 0.1, 8.4};
    facts.theory                  = Theory::make_saint_venant(6, 3);
    facts.is_graded_automatically = true;
    facts.held                    = 0.;
    facts.wanted                  = 100;
    return facts;
  }

  struct LinearFunctional
  {
    std::function<void(PlanInput &)> but;
    const char                      *theory;
    unsigned int                     equal_elements;
    bool                             all_fields;
    /// In the reasons; empty: none is given.
    const char *theory_reason, *fields_reason;
  };
} // namespace

BOOST_AUTO_TEST_CASE(facts_make_a_plan)
{
  const auto assumed = [](PlanInput &f) {
    f.is_assumed = f.has_contacts = true;
  };
  const std::vector<LinearFunctional> table{
    {[](PlanInput &) {}, "SV-6 (of LE-3)", 0, false, "", ""},
    // What was asked for stays what it is.
    {[](PlanInput &f) { f.size.loaded = 0.9; },
     "SV-6 (of LE-3)",
     0,
     false,
     "",
     ""},
    {[](PlanInput &f) { f.theory = Theory::layerwise(2); },
     "LE-2 (L9)",
     0,
     true,
     "",
     ""},
    {[](PlanInput &f) {
       f.theory = Theory::make_saint_venant(0, 3);
       f.wanted = 599;
     },
     "SV (of LE-3)",
     0,
     false,
     "",
     ""},
    // An assumed theory.
    {[&](PlanInput &f) { assumed(f); }, "SV-6 (of LE-3)", 0, false, "", ""},
    {[&](PlanInput &f) {
       assumed(f);
       f.size.loaded = 0.51;
     },
     "LE-3 (L16)",
     8,
     true,
     "51 % of its length",
     ""},
    {[&](PlanInput &f) {
       assumed(f);
       f.size.loaded      = 0.51;
       f.size.slenderness = 0.3;
     },
     "LE-3 (L16)",
     2,
     true,
     "51 % of its length",
     ""},
    {[&](PlanInput &f) {
       assumed(f);
       f.size.loaded      = 0.51;
       f.size.slenderness = 80.;
     },
     "LE-3 (L16)",
     10,
     true,
     "51 % of its length",
     ""},
    {[&](PlanInput &f) {
       assumed(f);
       f.size.loaded                 = 0.51;
       f.size.constrained_along_axis = true;
     },
     "LE-3 (L16)",
     1,
     true,
     "51 % of its length",
     ""},
    {[&](PlanInput &f) {
       assumed(f);
       f.size.loaded             = 0.51;
       f.is_graded_automatically = false;
     },
     "LE-3 (L16)",
     0,
     true,
     "51 % of its length",
     ""},
    {[&](PlanInput &f) {
       assumed(f);
       f.size.loaded = 0.5;
     },
     "SV-6 (of LE-3)",
     0,
     false,
     "",
     ""},
    // 3 * 100 * (2 * 3.5 + 1)^2 = 19200.
    {[&](PlanInput &f) {
       assumed(f);
       f.size.cells = 12;
     },
     "LE-3 (L16)",
     0,
     true,
     "LE-2 has some",
     ""},
    {[&](PlanInput &f) {
       assumed(f);
       f.size.cells = 13;
     },
     "SV-6 (of LE-3)",
     0,
     false,
     "",
     ""},
    {[&](PlanInput &f) {
       assumed(f);
       f.has_contacts = false;
       f.size.loaded  = 0.9;
     },
     "SV-6 (of LE-3)",
     0,
     false,
     "",
     ""},
    // Fields, the first rule that speaks.
    {[](PlanInput &f) { f.is_unsolved = f.size.constrained_along_axis = true; },
     "SV-6 (of LE-3)",
     0,
     true,
     "",
     "double precision"},
    {[](PlanInput &f) {
       f.size.constrained_along_axis = true;
       f.size.nodes                  = 10;
     },
     "SV-6 (of LE-3)",
     0,
     true,
     "",
     "along the whole axis"},
    {[](PlanInput &f) {
       f.size.nodes = 15;
       f.held       = 31.;
     },
     "SV-6 (of LE-3)",
     0,
     true,
     "",
     "15 nodes only"},
    {[](PlanInput &f) { f.size.nodes = 16; },
     "SV-6 (of LE-3)",
     0,
     false,
     "",
     ""},
    {[](PlanInput &f) {
       f.held   = 30.9;
       f.wanted = 500;
     },
     "SV-6 (of LE-3)",
     0,
     true,
     "",
     "30 of 600 section functions"},
    {[](PlanInput &f) {
       f.held   = 30.;
       f.wanted = 300;
     },
     "SV-6 (of LE-3)",
     0,
     false,
     "",
     ""},
    {[](PlanInput &f) { f.wanted = 301; },
     "SV-6 (of LE-3)",
     0,
     true,
     "",
     "301 of 600 section functions"},
    // What is not known does not speak, and Theories are taken at their word.
    {[](PlanInput &f) {
       f.held   = {};
       f.wanted = {};
     },
     "SV-6 (of LE-3)",
     0,
     false,
     "",
     ""},
    {[](PlanInput &f) {
       f.wanted     = 600;
       f.size.nodes = 5;
       f.has_pieces = true;
     },
     "SV-6 (of LE-3)",
     0,
     false,
     "",
     ""}};
  for (const LinearFunctional &row : table)
    BOOST_TEST_CONTEXT("row " << &row - table.data())
    {
      PlanInput facts = slender();
      row.but(facts);
      const BodyPlan planned = plan(facts);
      BOOST_TEST(planned.theory.name() == row.theory);
      BOOST_TEST(planned.equal_elements == row.equal_elements);
      BOOST_TEST(planned.all_fields == row.all_fields);
      BOOST_TEST((describe_fields(facts, planned).find("all fields") == 0) ==
                 row.all_fields);
      BOOST_TEST(planned.theory_reason.empty() == (*row.theory_reason == 0));
      BOOST_TEST(planned.fields_reason.empty() == (*row.fields_reason == 0));
      BOOST_TEST(planned.theory_reason.find(row.theory_reason) !=
                 std::string::npos);
      BOOST_TEST(planned.fields_reason.find(row.fields_reason) !=
                 std::string::npos);
    }
}



BOOST_AUTO_TEST_CASE(clamps_are_ends_and_whole_bodies)
{
  const Region start{0, Region::Kind::surface, "start", {}},
    ends{0, Region::Kind::surface, "ends", {}},
    top{0, Region::Kind::surface, "top", {}},
    all{0, Region::Kind::body, "", {}};
  BOOST_TEST(is_clamp(start, 0., 2.));
  BOOST_TEST(!is_clamp(start, 2., 2.));
  BOOST_TEST((is_clamp(ends, 0., 2.) && is_clamp(ends, 2., 2.)));
  BOOST_TEST(!is_clamp(ends, 1., 2.));
  BOOST_TEST(!is_clamp(top, 0., 2.));
  BOOST_TEST(is_clamp(all, 1., 2.));

  const std::vector<Support> supports{{"s", {ends, top}, {{0., 0., 0.}}},
                                      {"t", {all}, {{0., {}, {}}}}};
  BOOST_TEST(is_constrained_along_axis(supports, 0));
  BOOST_TEST(!is_constrained_along_axis(supports, 1));
  BOOST_TEST(!is_constrained_along_axis({supports[0]}, 0));
}



BOOST_AUTO_TEST_SUITE_END()
