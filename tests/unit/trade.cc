// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/solve/results.h>
#include <lamella/trade/ladder.h>
#include <lamella/trade/trade_picture.h>
#include <lamella/trade/trade_table.h>

#include <boost/test/unit_test.hpp>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace lamella;

namespace
{
  /// A rung with one or more values.
  RungResult
  rung(const std::string         &name,
       const std::string         &theory,
       const double               seconds,
       const unsigned int         dofs,
       const std::vector<double> &values)
  {
    RungResult result;
    result.name    = name;
    result.theory  = theory;
    result.seconds = seconds;
    result.dofs    = dofs;
    result.values  = values;
    for (const std::string &phase : phase_names())
      result.phases[phase] = 0.;
    return result;
  }



  RungResult
  failed(const std::string &name, const std::string &theory)
  {
    RungResult result = rung(name, theory, 1., 0, {});
    result.failure    = "It does not fit. Buy memory.";
    return result;
  }



  NamedQuantity
  quantity(const std::string &column, const std::optional<double> &given = {})
  {
    return {NamedQuantity::Of::probe, "tip", 0, column, given};
  }



  /// Errors 10 %, 3 %, 5 %, 0.5 %, 0.2 % and the reference.
  std::vector<RungResult>
  ladder()
  {
    return {rung("EBBT", "EBBT", 1., 10, {0.9}),
            rung("TE-2", "TE-2", 2., 30, {1.03}),
            failed("LE-1", "LE-1"),
            rung("LE-2", "LE-2", 3., 20, {0.95}),
            rung("LE-2, axis 2", "LE-2", 4., 100, {1.005}),
            rung("solid-2", "solid-2", 9., 90, {0.998}),
            rung("LE-3", "LE-3", 20., 500, {1.})};
  }

  using Cost    = TradeTable::Cost;
  using Numbers = std::vector<unsigned int>;
} // namespace



BOOST_AUTO_TEST_SUITE(trade)

BOOST_AUTO_TEST_CASE(errors_and_fronts)
{
  const TradeTable table(ladder(), {quantity("uz")}, "finest", {0.01});
  BOOST_TEST(table.reference_rung() == 6);
  BOOST_TEST(!table.has_error(2, 0));
  BOOST_TEST(!table.has_error(6, 0));
  BOOST_TEST(std::abs(table.error(3, 0) - 0.05) < 1e-15);
  // LE-2 is beaten in seconds, TE-2 in neither; in DoFs solid-2 beats LE-2,
  // axis 2.
  BOOST_TEST((table.front(0, Cost::seconds) == Numbers{0, 1, 4, 5}));
  BOOST_TEST((table.front(0, Cost::dofs) == Numbers{0, 3, 1, 5}));
}



BOOST_AUTO_TEST_CASE(references)
{
  const TradeTable solid(ladder(), {quantity("uz")}, "solid", {0.01});
  BOOST_TEST(solid.reference_rung() == 5);
  BOOST_TEST(std::abs(solid.error(6, 0) - 0.002 / 0.998) < 1e-15);

  const TradeTable given(ladder(), {quantity("uz", 2.)}, "given", {0.01});
  BOOST_TEST(given.reference_rung() == -1);
  BOOST_TEST(std::abs(given.error(6, 0) - 0.5) < 1e-15);

  const TradeTable named(ladder(), {quantity("uz")}, "TE-2", {0.01});
  BOOST_TEST(named.reference_rung() == 1);
  BOOST_CHECK_THROW(TradeTable(ladder(), {quantity("uz")}, "LE-1", {0.01}),
                    NumericsError);

  // The finest is the last that succeeded.
  auto rungs = ladder();
  rungs.push_back(failed("LE-4", "LE-4"));
  BOOST_TEST(
    TradeTable(rungs, {quantity("uz")}, "finest", {0.01}).reference_rung() ==
    6);
  BOOST_CHECK_THROW(
    TradeTable({failed("LE-1", "LE-1")}, {quantity("uz")}, "finest", {0.01}),
    NumericsError);

  // No error is relative to zero.
  for (RungResult &each : rungs)
    if (each.failure.empty())
      each.values = {0.};
  const TradeTable zero(rungs, {quantity("uz")}, "finest", {0.01});
  BOOST_TEST(!zero.has_error(0, 0));
  BOOST_TEST(zero.front(0, Cost::seconds).empty());
  BOOST_TEST(zero.sentence(0, 0.01).find("the reference is zero") !=
             std::string::npos);
}



BOOST_AUTO_TEST_CASE(sentences)
{
  const TradeTable table(ladder(), {quantity("uz")}, "finest", {0.01});
  BOOST_TEST(table.sentence(0, 0.01) ==
             "For 1 % in tip: uz the cheapest is LE-2, axis 2: 100 DoFs, 4 s "
             "(off by 0.5 %).");
  BOOST_TEST(
    table.sentence(0, 0.001) ==
    "For 0.1 % in tip: uz no rung is enough but the reference itself.");

  // The richer of a family being further off, the poorer was lucky.
  auto rungs      = ladder();
  rungs[0].values = {1.001};
  BOOST_TEST(
    TradeTable(rungs, {quantity("uz")}, "finest", {0.01}).sentence(0, 0.01) ==
    "For 1 % in tip: uz the cheapest is EBBT: 10 DoFs, 1 s (off by "
    "0.1 %). Do not count on it: TE-2, which is richer, is off by 3 "
    "%.");

  // A coarser mesh is not richer, whichever the theory; nor is another scene.
  rungs[1].axis = 0.5;
  BOOST_TEST(TradeTable(rungs, {quantity("uz")}, "finest", {0.01})
               .sentence(0, 0.01)
               .find("count on") == std::string::npos);
  rungs[1].axis       = 1.;
  rungs[1].overridden = true;
  BOOST_TEST(TradeTable(rungs, {quantity("uz")}, "finest", {0.01})
               .sentence(0, 0.01)
               .find("count on") == std::string::npos);

  // Seconds that noise can make: the fewer DoFs decide.
  rungs            = ladder();
  rungs[5].seconds = 4.25;
  BOOST_TEST(
    TradeTable(rungs, {quantity("uz")}, "finest", {0.01}).cheapest(0, 0.01) ==
    5);
  rungs[5].seconds = 4.35;
  BOOST_TEST(
    TradeTable(rungs, {quantity("uz")}, "finest", {0.01}).cheapest(0, 0.01) ==
    4);
}



BOOST_AUTO_TEST_CASE(picture)
{
  const TradeTable table(ladder(), {quantity("uz")}, "finest", {0.01});
  const std::filesystem::path folder =
    std::filesystem::temp_directory_path() /
    ("lamella_picture_" + std::to_string(getpid()));
  std::filesystem::create_directory(folder);
  write_trade_csv(table, (folder / "trade.csv").string());
  const std::string no_picture =
    draw_trade(table, "It's a `title` $a_b", folder.string());
  std::ifstream     file(folder / "trade.py");
  const std::string script((std::istreambuf_iterator<char>(file)),
                           std::istreambuf_iterator<char>());
  BOOST_TEST(script.find("TITLE = \"It's a `title` $a_b\"\n") !=
             std::string::npos);
  BOOST_TEST(script.find("TOLERANCES = [1.0]") != std::string::npos);
  for (const char *name : {"trade.png", "trade.svg"})
    BOOST_TEST((std::filesystem::exists(folder / name) || !no_picture.empty()),
               no_picture);
  std::filesystem::remove_all(folder);
}



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
    LadderEntry entry;
    entry.name = entry.theory = "LE-2";
    entry.axis                = axis;
    entry.section             = section;
    entry.overrides           = {"Contact c/Penalty=7"};
    return make_rung(entry, scene_with(shape)).overrides;
  }

  using Texts = std::vector<std::string>;
} // namespace



BOOST_AUTO_TEST_CASE(meshes_of_rungs)
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
  BOOST_CHECK_THROW(overrides(file, 1., 2.), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
