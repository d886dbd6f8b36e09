// SPDX-License-Identifier: LGPL-2.1-or-later

// Errors with fields, entries that are read with their rules, and patterns that
// say what they want.

#include <lamella/base/patterns.h>
#include <lamella/contact/gap_constraints.h>
#include <lamella/linear/linear_solver.h>
#include <lamella/recover/results.h>
#include <lamella/solve/parameters.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(entry)

using namespace lamella;

namespace
{
  /// What @p act refuses.
  template <typename Act>
  InputError
  refused(const Act &act)
  {
    try
      {
        act();
      }
    catch (const InputError &error)
      {
        return error;
      }
    BOOST_FAIL("nothing was refused");
    return InputError("");
  }



  template <typename E>
  void
  check_names()
  {
    std::set<std::string> seen;
    for (const NameOf<E> &entry : Names<E>::all)
      {
        BOOST_TEST(name_of(entry.value) == entry.name);
        BOOST_TEST((named<E>(entry.name) == entry.value));
        BOOST_TEST(selection<E>().match(entry.name));
        BOOST_TEST(seen.insert(entry.name).second);
      }
    BOOST_TEST(!named<E>("nobody").has_value());
  }
} // namespace

BOOST_AUTO_TEST_CASE(fields_of_an_error)
{
  const InputError error("Body b/Length", "-1", "must be positive", "Turn it.");
  BOOST_TEST(error.what() ==
             std::string("Body b/Length = -1: must be positive. Turn it."));
  BOOST_TEST(error.path() == "Body b/Length");
  BOOST_TEST(error.value() == "-1");
  BOOST_TEST(error.rule() == "must be positive");
  BOOST_TEST(error.remedy() == "Turn it.");
  BOOST_TEST(!error.has_place());

  const InputError placed = error.at("a.prm:3: ");
  BOOST_TEST(placed.what() == "a.prm:3: " + std::string(error.what()));
  BOOST_TEST(placed.path() == error.path());
  BOOST_TEST(placed.has_place());

  const InputError missing = InputError::missing("Body b/Length", "give one.");
  BOOST_TEST(missing.what() ==
             std::string("Body b/Length is missing: give one."));
  BOOST_TEST(missing.path() == "Body b/Length");
  BOOST_TEST(InputError("Load p", "", "is odd", "").what() ==
             std::string("Load p: is odd."));

  // What nobody reads is abridged, wherever it stands; the field keeps it.
  const std::string long_value(1000, 'x');
  const InputError  abridged("Title",
                            long_value,
                            "'" + long_value + "' is long",
                            "");
  BOOST_TEST(std::string(abridged.what()).size() < 400);
  BOOST_TEST(abridged.value() == long_value);
}



BOOST_AUTO_TEST_CASE(values_of_an_entry)
{
  BOOST_TEST(Entry("e", " 2.5 ").number() == 2.5);
  BOOST_TEST(Entry("e", "0").number() == 0.);
  BOOST_TEST(Entry("e", "3").whole(1, 5) == 3);
  BOOST_TEST((Entry("e", "1, 2, 3").whole_numbers(1, 3) ==
              std::vector<unsigned int>{1, 2, 3}));
  BOOST_TEST(Entry("e", "").numbers().empty());
  BOOST_TEST(Entry("e", "1, 2, 3").point()[2] == 3.);
  BOOST_TEST(Entry("e", "true").boolean());
  BOOST_TEST((Entry("e", "full").choice<Strategy>() == Strategy::full));
  BOOST_TEST(Entry("e", "top").among({"top"}, "side", "Sides") == "top");

  for (const auto &[text, rule] :
       std::vector<std::pair<std::string, std::string>>{
         {"1 mm", "'1 mm' is not a number"},
         {"", "'' is not a number"},
         {"0x10", "'0x10' is not a number"},
         {"nan", "'nan' is not a number"},
         {"1e40", "'1e40' is out of range"}})
    BOOST_TEST(
      refused([text = text] { Entry("e", text).number(); }).rule().find(rule) ==
      0);
  BOOST_TEST(refused([] { Entry("e", "-1").positive(); }).rule() ==
             "the value must be positive");
  BOOST_TEST(refused([] { Entry("e", "").positive(); }).rule() == "is missing");
  BOOST_TEST(refused([] { Entry("e", "1.5").whole(1, 3); }).rule() ==
             "write whole numbers only, from 1 to 3, as in 4");
  BOOST_TEST(refused([] { Entry("e", "1, 2").whole(1, 3); }).rule() ==
             "write one whole number, as in 4");
  BOOST_TEST(
    refused([] { Entry("e", "1, 2").point(); }).rule() ==
    "the value must be three numbers x, y, z with commas, as in 0, 1, 0.1");
  BOOST_TEST(refused([] { Entry("e", "yes").boolean(); }).rule() ==
             "the value must be true or false");
  BOOST_TEST(refused([] { Entry("e", "fast").choice<Strategy>(); }).rule() ==
             "the value must be one of the words auto, condensed or full");
  const InputError nearest = refused([] {
    Entry("e", "tpo").among({"left", "top"}, "side", "Sides");
  });
  BOOST_TEST(nearest.rule() == "there is no side 'tpo'");
  BOOST_TEST(nearest.remedy() ==
             "Check the spelling: the most similar name in Sides is 'top'.");
}



BOOST_AUTO_TEST_CASE(patterns_in_words)
{
  dealii::ParameterHandler prm;
  prm.enter_subsection("Body a b");
  prm.declare_entry("number", "0", patterns::number());
  prm.declare_entry("positive", "1", patterns::positive());
  prm.declare_entry("maybe", "", patterns::optional(patterns::positive()));
  prm.declare_entry("auto",
                    "auto",
                    patterns::WordOrPattern("auto", patterns::positive()));
  prm.declare_entry("three", "0, 0, 1", patterns::numbers(3));
  prm.declare_entry("two", "0, 0", patterns::numbers(2));
  prm.declare_entry("share", "0", dealii::Patterns::Double(0., 0.5));
  prm.declare_entry("whole", "3", dealii::Patterns::Integer(1, 9));
  prm.declare_entry("truth", "true", dealii::Patterns::Bool());
  prm.declare_entry("choice", "full", selection<Strategy>());
  const auto set = [&prm](const std::string &name, const std::string &value) {
    try
      {
        prm.set(name, value);
      }
    catch (const dealii::ParameterHandler::ExcValueDoesNotMatchPattern &)
      {
        patterns::refuse(Entry("Body a b/" + name, value), prm);
      }
  };
  set("number", "-3e5");
  set("maybe", "");
  set("maybe", "2");
  set("auto", "auto");
  set("auto", "7");
  set("two", "1, 2");

  for (const auto &[name, value, rule] :
       std::vector<std::array<std::string, 3>>{
         {{"number", "1 mm", "'1 mm' is not a number"}},
         {{"number", "1e31", "'1e31' is out of range"}},
         {{"positive", "-1", "the value must be positive"}},
         {{"positive", "0", "the value must be positive"}},
         {{"maybe", "0", "the value must be positive"}},
         {{"auto", "-1", "the value must be positive, or auto"}},
         {{"auto", "some", "'some' is not a number"}},
         {{"three", "1, 2", "the value must be three numbers"}},
         {{"three", "1, 2, x", "'x' is not a number"}},
         {{"two", "1", "there are 1 values"}},
         {{"share", "0.7", "the value must lie between 0 and 0.5"}},
         {{"whole", "0", "the value must be a whole number from 1 to 9"}},
         {{"whole", "1.5", "the value must be a whole number from 1 to 9"}},
         {{"truth", "no", "the value must be true or false"}},
         {{"choice", "fast", "the value must be one of the words auto"}}})
    {
      const InputError error = refused([&] { set(name, value); });
      BOOST_TEST(error.rule().find(rule) == 0,
                 name << " = " << value << ": " << error.rule());
      BOOST_TEST(error.path() == "Body a b/" + name);
      BOOST_TEST(error.value() == value);
    }
}



BOOST_AUTO_TEST_CASE(names_of_enumerations)
{
  check_names<Strategy>();
  check_names<SolverKind>();
  check_names<Enforcement>();
  check_names<Discretization>();
  check_names<Overclosure>();
  check_names<SlaveSide>();
  check_names<Phase>();
  BOOST_TEST(name_of(Strategy::undefined).empty());
}

BOOST_AUTO_TEST_SUITE_END()
