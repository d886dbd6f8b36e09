// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/trade/trade.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(trade)

using namespace lamella;

namespace
{
  NamedQuantity
  quantity(const std::string &column)
  {
    return {NamedQuantity::ObjectKind::probe, "tip", 0, column, {}};
  }
} // namespace



namespace
{
  Scene
  scene_with(const SectionShape &shape)
  {
    Scene scene;
    scene.sections["s"] = shape;
    for (const char *name : {"a", "b"})
      {
        BodyDescription body;
        body.name          = name;
        body.section       = "s";
        body.axis.elements = {1, 5, 2};
        scene.bodies.push_back(body);
      }
    scene.trade.bodies = {"b"};
    return scene;
  }



  std::vector<std::string>
  overrides(const SectionShape &shape, const double axis, const double section)
  {
    TradeVariant entry;
    entry.name = entry.theory = "LE-2";
    entry.axis                = axis;
    entry.section             = section;
    entry.overrides           = {"Contact c/Penalty=7"};
    return overrides_of(entry, scene_with(shape));
  }

  using Texts = std::vector<std::string>;



  /// The hierarchy that `Trade/Variants` = @p text means.
  std::vector<TradeVariant>
  parsed(const std::string &text)
  {
    dealii::ParameterHandler prm;
    prm.enter_subsection("Trade");
    TradeParameters::declare(prm);
    prm.set("Variants", text);
    return TradeParameters::parse(Entries(prm, "Trade"), {}).variants;
  }
} // namespace



BOOST_AUTO_TEST_CASE(meshes_of_variants)
{
  Laminate laminate;
  laminate.cells_per_ply = {1, 4};
  laminate.cells_across  = {3};
  BOOST_TEST((overrides(laminate, 0.5, 2.) ==
              Texts{"Body b/Kinematics/Theory=LE-2",
                    "Body b/Kinematics/Axis elements=1, 3, 1",
                    "Section s/Cells per ply=2, 8",
                    "Section s/Cells across=6",
                    "Contact c/Penalty=7"}));

  HalfDisc disc;
  disc.finest_cell = 0.5;
  disc.sectors     = 12;
  BOOST_TEST((overrides(disc, 1., 0.5) == Texts{"Body b/Kinematics/Theory=LE-2",
                                                "Section s/Finest cell=1",
                                                "Section s/Sectors=8",
                                                "Contact c/Penalty=7"}));

  Ellipse ellipse;
  ellipse.refinements = 1;
  BOOST_TEST(overrides(ellipse, 1., 4.)[1] == "Section s/Refinements=3");
  BOOST_TEST(overrides(ellipse, 1., 0.25)[1] == "Section s/Refinements=0");

  ThinWalled walls;
  walls.cells_per_wall   = 1;
  walls.cells_along_wall = 6;
  BOOST_TEST(overrides(walls, 1., 1.5)[1] == "Section s/Cells per wall=2");
  BOOST_TEST(overrides(walls, 1., 1.5)[2] == "Section s/Cells along wall=9");

  SectionFile file;
  file.what = "Section s";
  BOOST_TEST(overrides(file, 2., 1.).size() == 3u);
  // A mesh's own cells divided in four; nothing makes it coarser.
  BOOST_TEST(overrides(file, 1., 2.)[1] == "Section s/Cells divided=1");
  BOOST_TEST(overrides(file, 1., 4.)[1] == "Section s/Cells divided=2");
  BOOST_CHECK_THROW(overrides(file, 1., 0.5), InputError);
}



BOOST_AUTO_TEST_CASE(tolerances_in_hierarchies)
{
  const auto hierarchy =
    parsed("TBT | tolerance  0.50, Goals/Budget DoFs = 1000 | tolerance 100");
  BOOST_TEST(!hierarchy[0].tolerance.has_value());
  BOOST_TEST(hierarchy[1].theory == "tolerance 0.5");
  BOOST_TEST(hierarchy[1].tolerance.value() == 0.005);
  BOOST_TEST((hierarchy[1].overrides == Texts{"Goals/Budget DoFs = 1000"}));
  BOOST_TEST(hierarchy[2].tolerance.value() == 1.);
  for (const char *bad : {"tolerance",
                          "tolerance 0",
                          "tolerance -1",
                          "tolerance 101",
                          "tolerance x",
                          "tolerance 1 2",
                          "tolerances 1",
                          "tolerance 1, axis 2",
                          "tolerance 1, section 0.5"})
    BOOST_CHECK_THROW(parsed(std::string("TBT | ") + bad), InputError);
}



BOOST_AUTO_TEST_CASE(runs_to_tolerances)
{
  TradeVariant entry     = parsed("TBT | tolerance 0.5, Theory = LE-1").back();
  Scene        scene     = scene_with(Laminate());
  scene.trade.quantities = {quantity("uz"), quantity("syy")};
  scene.bodies[0].theory = Theory::parse({"Theory", "LE-2"});
  const Texts begin{"Goals/Quantities=tip: uz | tip: syy",
                    "Goals/Tolerance=0.5",
                    "Goals/Error bars=auto",
                    "Theory=auto"};
  const Texts end{"Body b/Kinematics/Theory=auto",
                  "Body b/Kinematics/Axis elements=auto",
                  "Body b/Kinematics/Axis breaks=",
                  "Theory = LE-1"};
  // The body that the trade leaves alone keeps its theory.
  Texts all = begin;
  all.push_back("Body a/Kinematics/Theory=LE-2");
  all.insert(all.end(), end.begin(), end.end());
  BOOST_TEST((overrides_of(entry, scene) == all));
  // Bars of other variants change nothing of it.
  scene.trade.error_bars = true;
  BOOST_TEST((overrides_of(entry, scene) == all));
  // Which columns of a whole probe are meant is not known beforehand.
  scene.trade.probes_as_goals = {"root"};
  BOOST_TEST(overrides_of(entry, scene)[0] == "Goals/Quantities=");
}



BOOST_AUTO_TEST_CASE(bars_of_variants)
{
  const TradeVariant entry = parsed("TBT | LE-2").back();
  Scene              scene = scene_with(Laminate());
  scene.trade.quantities   = {quantity("uz")};
  scene.trade.error_bars   = true;
  BOOST_TEST((goals_of(entry, scene) ==
              Texts{"Goals/Quantities=tip: uz", "Goals/Error bars=true"}));
  // None is a run to a tolerance.
  scene.trade.error_bars = false;
  scene.goals.tolerances = {{0.02}};
  BOOST_TEST((goals_of(entry, scene) == Texts{"Goals/Quantities=tip: uz",
                                              "Goals/Error bars=false",
                                              "Goals/Tolerance=",
                                              "Goals/Budget DoFs=0",
                                              "Goals/Budget seconds=0"}));
  // Quantities with References are the goals without being named.
  scene.trade.quantities[0].path = references_path;
  BOOST_TEST(goals_of(entry, scene)[0] == "Goals/Quantities=");
}

BOOST_AUTO_TEST_SUITE_END()
