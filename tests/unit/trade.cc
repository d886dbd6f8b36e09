// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/recover/results.h>
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

BOOST_AUTO_TEST_SUITE(trade)

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



BOOST_AUTO_TEST_CASE(how_sure_a_reference_is)
{
  // By the nearest rung, and not by the one before; by none that is far off.
  const auto basis = [](const std::string &reference) {
    return TradeTable(ladder(), {quantity("uz")}, reference, {0.01}).basis();
  };
  BOOST_TEST(
    basis("finest") ==
    "Errors are against LE-3. The nearest to it, solid-2, is off by up "
    "to 0.2 %: errors smaller than that say little.");
  BOOST_TEST(
    basis("EBBT") ==
    "Errors are against EBBT. No other rung comes near it in all "
    "quantities (the nearest, LE-2, is off by up to 5.6 %), so nothing "
    "here tells how sure it is.");
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
    "%. The cheapest to count on is LE-2, axis 2: 100 DoFs, 4 s (off by 0.5 "
    "%).");
  // Nothing else is within 0.15 %.
  BOOST_TEST(
    TradeTable(rungs, {quantity("uz")}, "finest", {0.01})
      .sentence(0, 0.0015)
      .find("is off by 3 %. There is none to count on but the reference "
            "itself.") != std::string::npos);

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



BOOST_AUTO_TEST_CASE(cheapest_to_count_on)
{
  // TBT contradicts EBBT, TE-2 contradicts TBT at 1 %; nobody contradicts TE-2
  // at 3 %, nor LE-2, whose own richer rung is within.
  const std::vector<RungResult> rungs{rung("EBBT", "EBBT", 1., 10, {1.001}),
                                      rung("TBT", "TBT", 2., 11, {1.005}),
                                      rung("TE-2", "TE-2", 3., 30, {1.02}),
                                      rung("LE-2", "LE-2", 4., 90, {0.993}),
                                      rung("LE-3", "LE-3", 5., 99, {0.995}),
                                      rung("LE-4", "LE-4", 9., 200, {1.})};
  const TradeTable table(rungs, {quantity("uz")}, "finest", {0.01});
  BOOST_TEST(table.cheapest(0, 0.01) == 0);
  BOOST_TEST(table.cheapest_to_count_on(0, 0.01) == 3);
  BOOST_TEST(table.cheapest_to_count_on(0, 0.03) == 0);
  BOOST_TEST(table.cheapest_to_count_on(0, 0.0015) == -1);
}



BOOST_AUTO_TEST_CASE(accidents)
{
  // Of TBT, off by `poor`, beside TE-2, off by `rich`.
  const auto table = [](const double poor, const double rich) {
    return TradeTable({rung("TBT", "TBT", 1., 10, {1. + poor}),
                       rung("TE-2", "TE-2", 2., 30, {1. - rich}),
                       rung("LE-1", "LE-1", 3., 40, {1. + 0.9 * poor}),
                       rung("LE-3", "LE-3", 9., 90, {1.})},
                      {quantity("uz")},
                      "finest",
                      {0.01});
  };
  // More than twice as much.
  BOOST_TEST(table(1e-3, 2.1e-3).is_accident(0, 0));
  BOOST_TEST(!table(1e-3, 1.9e-3).is_accident(0, 0));
  // More than 0.1 %.
  BOOST_TEST(!table(1e-5, 9e-4).is_accident(0, 0));
  BOOST_TEST(table(1e-5, 1.1e-3).is_accident(0, 0));
  // It stands on no front, and TE-2, which it would have beaten, does.
  BOOST_TEST((table(1e-3, 1.9e-3).front(0, Cost::dofs) == Numbers{0, 2}));
  BOOST_TEST((table(1e-3, 2.1e-3).front(0, Cost::dofs) == Numbers{1, 2}));
  // Whoever is poorer, or of another family, does not make an accident.
  BOOST_TEST(!table(1e-3, 2.1e-3).is_accident(1, 0));
  BOOST_TEST(!table(5e-4, 0.).is_accident(2, 0));
  // Of runs to a tolerance the one to a smaller one is richer.
  std::vector<RungResult> runs{
    rung("tolerance 1", "tolerance 1", 1., 10, {1.}),
    rung("tolerance 0.1", "tolerance 0.1", 2., 20, {1.002}),
    rung("LE-3", "LE-3", 9., 90, {1.})};
  runs[0].tolerance = 0.01;
  runs[1].tolerance = 0.001;
  const TradeTable tolerances(runs, {quantity("uz")}, "finest", {0.01});
  BOOST_TEST(tolerances.is_accident(0, 0));
  BOOST_TEST(!tolerances.is_accident(1, 0));
  BOOST_CHECK_THROW(TradeTable(runs, {quantity("uz")}, "solid", {0.01}),
                    NumericsError);
}



BOOST_AUTO_TEST_CASE(beyond_linear)
{
  std::vector<RungResult> rungs = ladder();
  const auto              said  = [&](std::vector<NamedQuantity> quantities,
                        const std::string         &reference) {
    std::ostringstream text;
    print_trade(text, TradeTable(rungs, std::move(quantities), reference, {}));
    return text.str();
  };
  // The reference counts, and of that what is worth a word.
  rungs[0].stiffening      = 3.;
  rungs[6].stiffening      = 0.005;
  rungs[6].buckling_factor = 12.;
  BOOST_TEST(said({quantity("uz")}, "finest").find("linear") ==
             std::string::npos);
  rungs[6].stiffening        = 0.12;
  rungs[6].buckling_factor   = 3.4;
  const std::string sentence = "By LE-3: stiffening 12 %, buckling factor 3.4";
  BOOST_TEST(said({quantity("uz")}, "finest").find(sentence) !=
             std::string::npos);
  // Without a reference the rung of most DoFs.
  BOOST_TEST(said({quantity("uz", 1.)}, "given").find(sentence) !=
             std::string::npos);
}



BOOST_AUTO_TEST_CASE(own_bars)
{
  // Against the reference -2: errors 9 % and 6 %, and bars of 0.2 and 0.1 in
  // the quantity's unit, 10 % and 5 % of 2. The first one holds.
  auto       rungs = std::vector<RungResult>{rung("A", "TE-1", 1., 10, {-1.82}),
                                             rung("B", "TE-2", 2., 20, {-2.12}),
                                             rung("C", "LE-1", 3., 30, {-2.2}),
                                             failed("D", "LE-2"),
                                             rung("E", "LE-3", 4., 40, {-2.02}),
                                             rung("F", "LE-4", 9., 90, {-2.})};
  const auto table = [&rungs] {
    return TradeTable(rungs, {quantity("uz")}, "finest", {0.01});
  };
  BOOST_TEST(table().count_of_bars() == "");
  rungs[0].bars = {OwnBar{-0.18, 0.2, true}};
  rungs[1].bars = {OwnBar{0.1, 0.1, true}};
  rungs[2].bars = {OwnBar{0.1, 0.1, false}};
  rungs[4].bars = {std::nullopt};
  rungs[5].bars = {OwnBar{0., 0.01, true}};
  BOOST_TEST(std::abs(*table().bar(0, 0) - 0.1) < 1e-15);
  BOOST_TEST(!table().bar(2, 0).has_value());
  BOOST_TEST(table().made_bar(2, 0));
  BOOST_TEST(!table().made_bar(3, 0));
  BOOST_TEST(!table().made_bar(4, 0));
  BOOST_TEST(table().count_of_bars() ==
             "Bars that hold, with the error at most the bar: 1 of 2; values "
             "without a bar: 1.");

  std::ostringstream text;
  print_trade(text, table());
  for (const char *cell :
       {"9 % (bar 10 %)", "6 % (bar 5 %)", "10 % (no bar)", "- (bar 0.5 %)"})
    BOOST_TEST(text.str().find(cell) != std::string::npos, cell);
  BOOST_TEST(text.str().find("Bars that hold") != std::string::npos);

  // B is off by 0.12, its bar 0.1; that of the reference is 0.03 now.
  rungs[5].bars = {OwnBar{0., 0.03, true}};
  BOOST_TEST(table().count_of_bars() ==
             "Bars that hold, with the error at most the bar: 1 of 2 (1 more "
             "with the reference's own bar added); values without a bar: 1.");
}



BOOST_AUTO_TEST_CASE(bars_go_through_a_pipe)
{
  Results results;
  results.steps.emplace_back();
  results.goals.resize(2);
  results.goals[0].name     = "tip: uz";
  results.goals[0].estimate = -1. / 3.;
  results.goals[0].bar      = 2. / 3.;
  results.goals[0].trusted  = true;
  results.goals[1].name     = "clamp: fz";
  const RungValues sent(results);
  const RungValues values(nlohmann::json::parse(sent.to_json().dump()));
  BOOST_TEST(values.has_bars());
  const std::optional<OwnBar> bar = values.bar(quantity("uz"));
  BOOST_TEST(bar.value().estimate == -1. / 3.);
  BOOST_TEST(bar.value().bar == 2. / 3.);
  BOOST_TEST(bar.value().trusted);
  BOOST_TEST(!values.bar(quantity("ux")).has_value());
  BOOST_TEST(!values.bar({NamedQuantity::Of::support, "clamp", 0, "fz", {}})
                .value()
                .trusted);
  results.goals.clear();
  BOOST_TEST(!RungValues(results).has_bars());
}



BOOST_AUTO_TEST_CASE(picture)
{
  auto rungs = ladder();
  rungs.insert(rungs.begin(),
               rung("tolerance 0.5", "tolerance 0.5", 1.5, 15, {1.004}));
  rungs.front().tolerance = 0.005;
  const TradeTable            table(rungs, {quantity("uz")}, "finest", {0.01});
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



  /// The ladder that `Trade/Ladder` = @p text means.
  std::vector<LadderEntry>
  parsed(const std::string &text)
  {
    dealii::ParameterHandler prm;
    prm.enter_subsection("Trade");
    TradeParameters::declare(prm);
    prm.set("Ladder", text);
    return TradeParameters::parse(Entries(prm, "Trade"), {}).ladder;
  }
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
  // A mesh's own cells divided in four; nothing makes it coarser.
  BOOST_TEST(overrides(file, 1., 2.)[1] == "Section s/Cells divided=1");
  BOOST_TEST(overrides(file, 1., 4.)[1] == "Section s/Cells divided=2");
  BOOST_CHECK_THROW(overrides(file, 1., 0.5), InputError);
}



BOOST_AUTO_TEST_CASE(tolerances_in_ladders)
{
  const auto ladder =
    parsed("TBT | tolerance  0.50, Goals/Budget DoFs = 1000 | tolerance 100");
  BOOST_TEST(!ladder[0].tolerance.has_value());
  BOOST_TEST(ladder[1].theory == "tolerance 0.5");
  BOOST_TEST(ladder[1].tolerance.value() == 0.005);
  BOOST_TEST((ladder[1].overrides == Texts{"Goals/Budget DoFs = 1000"}));
  BOOST_TEST(ladder[2].tolerance.value() == 1.);
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
  LadderEntry entry      = parsed("TBT | tolerance 0.5, Theory = LE-1").back();
  Scene       scene      = scene_with(Laminate());
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
  BOOST_TEST((make_rung(entry, scene).overrides == all));
  // Bars of other rungs change nothing of it.
  scene.trade.error_bars = true;
  BOOST_TEST((make_rung(entry, scene).overrides == all));
  // Which columns of a whole probe are meant is not known beforehand.
  scene.trade.whole_probes = {"root"};
  BOOST_TEST(make_rung(entry, scene).overrides[0] == "Goals/Quantities=");
}



BOOST_AUTO_TEST_CASE(bars_of_rungs)
{
  const LadderEntry entry = parsed("TBT | LE-2").back();
  Scene             scene = scene_with(Laminate());
  scene.trade.quantities  = {quantity("uz")};
  scene.trade.error_bars  = true;
  BOOST_TEST(
    (make_rung(entry, scene).overrides == Texts{"Body b/Kinematics/Theory=LE-2",
                                                "Goals/Error bars=true",
                                                "Goals/Quantities=tip: uz"}));
  scene.goals.tolerances = {{0.02}, {0.01}, {0.005, true}};
  BOOST_TEST(make_rung(entry, scene).overrides.back() == "Goals/Tolerance=1");
  scene.goals.tolerances = {{0.005, true}};
  BOOST_TEST(make_rung(entry, scene).overrides.back() == "Goals/Tolerance=");
}

BOOST_AUTO_TEST_SUITE_END()
