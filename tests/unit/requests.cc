// SPDX-License-Identifier: LGPL-2.1-or-later

// What a scene asks to be reported: the entries of probes, lines and cuts.

#include "entries.h"

#include <lamella/base/exceptions.h>
#include <lamella/recover/requests.h>

#include <boost/test/unit_test.hpp>

#include <functional>

BOOST_AUTO_TEST_SUITE(requests)

using namespace lamella;

namespace
{
  const std::vector<std::string> bodies{"upper", "lower"};

  const std::string name = "r";

  /// Whether an error is of the entry or subsection @p path.
  std::function<bool(const InputError &)>
  of(const std::string &path)
  {
    return [path](const InputError &error) { return error.path() == path; };
  }
} // namespace

BOOST_AUTO_TEST_CASE(entries_of_a_probe)
{
  const auto read = [](const Settings &settings) {
    return parsed<ProbeParameters>("Probe r", settings, name, bodies);
  };
  const Probe probe =
    read({{"At", "lower: 0.05, 0.5, 0.1"},
          {"Stress", "recovered"},
          {"References", "uz: -1e-3: by hand: twice | syy: 2: a table"}});
  BOOST_TEST(probe.name == name);
  BOOST_TEST(probe.body == 1);
  BOOST_TEST(probe.position.distance({0.05, 0.5, 0.1}) == 0.);
  BOOST_TEST((probe.stress == StressValues::recovered));
  BOOST_TEST_REQUIRE(probe.references.size() == 2);
  BOOST_TEST(probe.references[0].quantity == "uz");
  BOOST_TEST(probe.references[0].value == -1e-3);
  BOOST_TEST(probe.references[0].source == "by hand: twice");
  BOOST_TEST(read({{"At", "upper: 0, 0, 0"}}).references.empty());

  for (const std::string at :
       {"", "0, 0, 0", "uper: 0, 0, 0", "upper: 0, 0", "upper: 0, 0, top"})
    BOOST_CHECK_EXCEPTION(read({{"At", at}}), InputError, of("Probe r/At"));
  BOOST_CHECK_EXCEPTION(read({{"At", "upper: 0, 0, 0"}, {"Stress", "nodes"}}),
                        InputError,
                        of("Probe r/Stress"));
  for (const std::string references : {"uz: 1", "uu: 1: hand", "uz: one: hand"})
    BOOST_CHECK_EXCEPTION(read({{"At", "upper: 0, 0, 0"},
                                {"References", references}}),
                          InputError,
                          of("Probe r/References"));
}



BOOST_AUTO_TEST_CASE(entries_of_a_line)
{
  const auto read = [](const Settings &changes) {
    Settings settings{{"From", "lower: 0, 0, 0"}, {"To", "lower: 0, 0, 1"}};
    settings.insert(settings.end(), changes.begin(), changes.end());
    return parsed<LineParameters>("Line r", settings, name, bodies);
  };
  const Line line = read({});
  BOOST_TEST(line.body == 1);
  BOOST_TEST(line.to[2] == 1.);
  BOOST_TEST(line.samples == 10);
  BOOST_TEST((line.stress == StressValues::element));
  // However the number is written.
  BOOST_TEST(read({{"Samples", "1e2"}}).samples == 100);

  for (const std::string samples : {"1", "2.5", "100001", "many", ""})
    BOOST_CHECK_EXCEPTION(read({{"Samples", samples}}),
                          InputError,
                          of("Line r/Samples"));
  BOOST_CHECK_EXCEPTION(read({{"To", ""}}), InputError, of("Line r/To"));
  for (const std::string to : {"upper: 0, 0, 1", "lower: 0, 0, 0"})
    BOOST_CHECK_EXCEPTION(read({{"To", to}}), InputError, of("Line r"));
}



BOOST_AUTO_TEST_CASE(entries_of_a_cut)
{
  const auto read = [](const Settings &settings) {
    return parsed<CutParameters>("Cut r", settings, name, bodies);
  };
  const Cut cut = read({{"At", "upper: 0.25"}, {"Samples", "3"}});
  BOOST_TEST(cut.body == 0);
  BOOST_TEST(cut.position == 0.25);
  BOOST_TEST(cut.samples == 3);

  for (const std::string at : {"", "0.25", "upper", "upper: middle"})
    BOOST_CHECK_EXCEPTION(read({{"At", at}}), InputError, of("Cut r/At"));
  for (const std::string samples : {"0", "101"})
    BOOST_CHECK_EXCEPTION(read({{"At", "upper: 0.25"}, {"Samples", samples}}),
                          InputError,
                          of("Cut r/Samples"));
}

BOOST_AUTO_TEST_SUITE_END()
