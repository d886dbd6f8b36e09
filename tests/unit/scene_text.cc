// SPDX-License-Identifier: LGPL-2.1-or-later

// The text of a scene before it is parsed, and the words of text.h.

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/scene/scene.h>
#include <lamella/scene/scene_checks.h>
#include <lamella/scene/scene_text.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(scene_text)

using namespace lamella;
using dealii::ParameterHandler;
using dealii::Point;

namespace
{
  SceneText
  scene(const std::string &text, const std::vector<std::string> &overrides = {})
  {
    return SceneText(text, "a.prm", overrides);
  }



  /// Whether @p call throws an InputError whose message has all @p fragments.
  template <typename Call>
  void
  check_refused(const Call &call, const std::vector<std::string> &fragments)
  {
    try
      {
        call();
        BOOST_ERROR("not refused: " + fragments.front());
      }
    catch (const InputError &error)
      {
        const std::string message = error.what();
        for (const std::string &fragment : fragments)
          BOOST_TEST((message.find(fragment) != std::string::npos),
                     "'" << message << "' does not say '" << fragment << "'");
      }
  }



  /// Two entries, and a subsection with one in a subsection of its own.
  void
  declare(ParameterHandler &prm)
  {
    prm.declare_entry("Title", "none");
    prm.declare_entry("Load factors", "1");
    prm.enter_subsection("Body upper");
    prm.declare_entry("Length", "1");
    prm.enter_subsection("Kinematics");
    prm.declare_entry("Theory", "LE-2");
    prm.leave_subsection();
    prm.leave_subsection();
  }



  /// The entry of @p text after ParameterHandler has read it, too.
  std::string
  parsed(const SceneText &text, const std::vector<std::string> &path)
  {
    ParameterHandler prm;
    declare(prm);
    text.check_declared(prm);
    text.fill(prm);
    return prm.get({path.begin(), path.end() - 1}, path.back());
  }



  const std::vector<std::string> theory{"Body upper", "Kinematics", "Theory"};

  // Line numbers matter below: Length is in line 4, Theory in line 6.
  const std::string valid = "# A comment.\n"
                            "set Title = one # and another\n"
                            "subsection Body upper\n"
                            "  set Length = 2\n"
                            "  subsection Kinematics\n"
                            "    set  Theory=LE-3\n"
                            "  end\n"
                            "end\n";

  /// What is put before the message of an error of the entry @p path.
  std::string
  place_of(const SceneText &text, const std::string &path)
  {
    const InputError  error(path, "", "no", "");
    const std::string message = text.placed(error).what();
    return message.substr(0, message.size() - std::string(error.what()).size());
  }
} // namespace

BOOST_AUTO_TEST_CASE(a_valid_text)
{
  BOOST_TEST(parsed(scene(valid), {"Title"}) == "one");
  BOOST_TEST(parsed(scene(valid), {"Load factors"}) == "1");
  BOOST_TEST(parsed(scene(valid), theory) == "LE-3");
}



BOOST_AUTO_TEST_CASE(repetitions)
{
  check_refused([] { scene("set A = 1\n\nset B = 1\nset  A = 2\n"); },
                {"a.prm:4: ", "entry A", "in line 1"});
  check_refused(
    [] { scene("set A = 1\nsubsection S\nend\nsubsection  S\nend\n"); },
    {"a.prm:4: ", "subsection S", "in line 2"});
  check_refused(
    [] {
      scene("subsection S\nset A = 1\nsubsection T\nset A = 1\nset A = 1\nend\n"
            "end\n");
    },
    {"a.prm:5: ", "entry S/T/A", "in line 4"});
  // The same names in different subsections are none.
  BOOST_CHECK_NO_THROW(
    scene("set A = 1\nsubsection S\nset A = 1\nsubsection T\nset A = 1\nend\n"
          "end\nsubsection T\nset A = 1\nend\n"));
}



BOOST_AUTO_TEST_CASE(lines_that_are_not_understood)
{
  for (const std::string line : {"hello",
                                 "set A",
                                 "set",
                                 "A = 1",
                                 "subsection",
                                 "end",
                                 "end S",
                                 "Set A = 1",
                                 "setA = 1"})
    check_refused([&] { scene("set B = 1\n" + line + "\n"); },
                  {"a.prm:2: '" + line + "' is not understood"});
  check_refused([] { scene("set A = 1\nsubsection S\nsubsection T\nend\n"); },
                {"a.prm:2: ", "subsection S has no 'end'"});
  check_refused([] { scene("set A = 1\nsubsection S\nend\nend\n"); },
                {"a.prm:4: 'end' is not understood"});
  for (const std::string nothing :
       {"", "\n\n", "# set A = 1\n", "subsection S\nend\n"})
    check_refused([&] { scene(nothing); }, {"a.prm: ", "[scene.no-entries]"});
}



BOOST_AUTO_TEST_CASE(continued_lines)
{
  const std::string text = "set Title = a, \\\n"
                           "            b\\\n"
                           "            c\n"
                           "set Load factors = 2\n";
  // ParameterHandler joins them without the white space in front.
  BOOST_TEST(parsed(scene(text), {"Title"}) == "a, bc");
  BOOST_TEST(parsed(scene(text), {"Load factors"}) == "2");
  // Places count the lines of the file; a continued one is where it begins.
  const auto placed = [&text](const std::string &path) {
    const InputError error(path, "", "is wrong", "");
    return std::string(scene(text).placed(error).what());
  };
  BOOST_TEST(placed("Title") == "a.prm:1: Title: is wrong.");
  BOOST_TEST(placed("Load factors") == "a.prm:4: Load factors: is wrong.");
  BOOST_TEST(placed("Units") == "a.prm: Units: is wrong.");
  // What has a place keeps it; what is of no entry gets none.
  BOOST_TEST(
    scene(text).placed(InputError("Title", "", "no", "").at("b: ")).what() ==
    std::string("b: Title: no."));
  BOOST_TEST(scene(text).placed(InputError("no")).what() == std::string("no"));
  // In a comment nobody means it: the next line would be lost without a word.
  check_refused([&] { scene("set Title = a # b \\\nset Nonsense = 1\n"); },
                {"a.prm:1: a comment ends with a backslash"});
}



BOOST_AUTO_TEST_CASE(white_space_behind_a_continuation)
{
  // ParameterHandler reads these as continued, so the two must agree: a blank
  // behind the backslash, and the line ends of Windows.
  BOOST_TEST(parsed(scene("set Title = a, \\ \n b\n"), {"Title"}) == "a, b");
  BOOST_TEST(parsed(scene("set Title = a, \\\r\n b\r\n"), {"Title"}) == "a, b");
}



BOOST_AUTO_TEST_CASE(white_space_in_names)
{
  // Runs of white space are one blank, in names of entries and of subsections,
  // in the file and in --set, for the check and for ParameterHandler alike.
  const std::string text = "set\tLoad   factors = 2\n"
                           "subsection  Body \t upper\n"
                           "  set Length = 3\n"
                           "end\n";
  BOOST_TEST(parsed(scene(text), {"Load factors"}) == "2");
  BOOST_TEST(parsed(scene(text), {"Body upper", "Length"}) == "3");
  BOOST_TEST(parsed(scene(valid, {"Body  upper/Length=3"}),
                    {"Body upper", "Length"}) == "3");
}



BOOST_AUTO_TEST_CASE(line_ends_of_windows)
{
  std::string text;
  for (const char c : valid)
    text += c == '\n' ? "\r\n" : std::string(1, c);
  BOOST_TEST(parsed(scene(text), theory) == "LE-3");
  BOOST_TEST(
    scene(text).placed(InputError("Body upper/Length", "", "no", "")).what() ==
    std::string("a.prm:4: Body upper/Length: no."));
}



BOOST_AUTO_TEST_CASE(unknown_entries)
{
  ParameterHandler prm;
  declare(prm);
  BOOST_CHECK_NO_THROW(scene(valid).check_declared(prm));

  const auto refused = [&prm](const std::string              &text,
                              const std::vector<std::string> &says) {
    check_refused([&] { scene(text).check_declared(prm); }, says);
  };
  refused("set Titel = 1\n", {"a.prm:1: ", "entry 'Titel'", "'Title'"});
  refused("set Title = 1\nset load Factor = 1\n",
          {"a.prm:2: ", "entry 'load Factor'", "'Load factors'"});
  // The nearest within the subsection, not a nearer one elsewhere.
  refused("subsection Body upper\nset Theory = LE-2\nend\n",
          {"a.prm:2: ", "entry 'Theory' in Body upper", "'Length'"});
  refused("subsection Body uper\nset Length = 2\nend\n",
          {"a.prm:1: ", "subsection 'Body uper'", "'Body upper'"});
  refused("subsection Body upper\nsubsection Kinematic\nset Theory = LE-2\n"
          "end\nend\n",
          {"a.prm:2: ", "'Kinematic' in Body upper", "'Kinematics'"});
}



BOOST_AUTO_TEST_CASE(overrides)
{
  const std::string path = "Body upper/Kinematics/Theory";
  BOOST_TEST(parsed(scene(valid, {path + "=LE-1"}), theory) == "LE-1");
  // White space around, an entry that the file does not set, the later of two.
  BOOST_TEST(parsed(scene(valid, {" Body upper / Kinematics/ Theory = LE-1 "}),
                    theory) == "LE-1");
  BOOST_TEST(parsed(scene(valid, {"Load factors=1, 2"}), {"Load factors"}) ==
             "1, 2");
  BOOST_TEST(parsed(scene(valid, {path + "=LE-1", path + "=LE-5"}), theory) ==
             "LE-5");
  // A value may hold an equals sign and a slash; others stay as they were.
  BOOST_TEST(parsed(scene(valid, {"Title=a=b/c"}), {"Title"}) == "a=b/c");
  BOOST_TEST(parsed(scene(valid, {"Title=a=b/c"}), theory) == "LE-3");

  for (const std::string bad : {"Title", "=3", ""})
    check_refused([&] { scene(valid, {bad}); }, {"--set " + bad, "VALUE"});

  ParameterHandler prm;
  declare(prm);
  check_refused([&] { scene(valid, {"Titl=3"}).check_declared(prm); },
                {"--set", "entry 'Titl'", "'Title'"});
  check_refused(
    [&] { scene(valid, {"Body uper/Length=3"}).check_declared(prm); },
    {"--set", "'Body uper'", "'Body upper'"});
}



BOOST_AUTO_TEST_CASE(places)
{
  const SceneText text = scene(valid, {"Body upper/Kinematics/Axis=7"});
  BOOST_TEST(place_of(text, "Title") == "a.prm:2: ");
  BOOST_TEST(place_of(text, "Body upper/Length") == "a.prm:4: ");
  BOOST_TEST(place_of(text, "Body upper/Kinematics/Theory") == "a.prm:6: ");
  // An entry that is not there: its subsection. One of --set.
  BOOST_TEST(place_of(text, "Body upper/Width") == "a.prm:3: ");
  BOOST_TEST(place_of(text, "Body upper/Kinematics/Axis") == "--set: ");
  BOOST_TEST(place_of(text, "Something else") == "a.prm: ");
  // An override takes the place of the entry in the file.
  BOOST_TEST(place_of(scene(valid, {"Title=two"}), "Title") == "--set: ");
}



BOOST_AUTO_TEST_CASE(places_of_names_that_begin_alike)
{
  // Body a2 has no subsection here: that of Body a is not its place.
  const SceneText text = scene("set Bodies = a, a2\nsubsection Body a\nend\n");
  BOOST_TEST(place_of(text, "Body a2/Section") == "a.prm: ");
  BOOST_TEST(place_of(text, "Body a/Section") == "a.prm:2: ");
  BOOST_TEST(place_of(text, "Body a") == "a.prm:2: ");
}



BOOST_AUTO_TEST_CASE(files)
{
  check_refused([] { SceneText::read("no/such/scene.prm", {}); },
                {"no/such/scene.prm: ", "[scene.cannot-read]"});
  // A folder is no scene, either.
  check_refused([] { SceneText::read(".", {}); },
                {".: ", "[scene.cannot-read]"});
}



BOOST_AUTO_TEST_CASE(messages_have_one_place)
{
  // What a whole scene says, with the line of the entry that is at fault.
  const std::string head = "set Materials = m\n"
                           "set Sections = s\n"
                           "set Bodies = b\n";
  check_refused([&] { read_scene(scene("set Title = no names\n")); },
                {"a.prm: Materials is missing"});
  check_refused([&] { read_scene(scene(head + "set Units = inch\n")); },
                {"a.prm:4: Units = inch"});
  check_refused(
    [&] {
      read_scene(scene(head + "subsection Material m\n"
                              "  set Isotropic = 1, 0.5\n"
                              "end\n"));
    },
    {"a.prm:5: Material m/Isotropic = 1, 0.5"});
  check_refused([&] { read_scene(scene(head + "set Loads = 2nd\n")); },
                {"a.prm:4: Loads = 2nd", "'2nd' is not a valid name"});
  check_refused([&] { read_scene(scene(head + "set Loads = a, b, a\n")); },
                {"a.prm:4: Loads = a, b, a", "[scene.repeated-name]"});
  check_refused([&] { read_scene(scene(head, {"Materials=m, m"})); },
                {"--set: Materials = m, m", "twice"});
}



BOOST_AUTO_TEST_CASE(words)
{
  BOOST_TEST(trimmed("  a b\t\r\n") == "a b");
  BOOST_TEST(trimmed(" \t ") == "");

  const auto pieces = [](const std::string &text, const char separator) {
    return joined(split(text, separator), "|");
  };
  BOOST_TEST(pieces(" a , b,c ", ',') == "a|b|c");
  BOOST_TEST(pieces("a", ',') == "a");
  BOOST_TEST(split("", ',').empty());
  BOOST_TEST(split("  ", ',').empty());
  // Empty pieces count, so that a missing one is noticed.
  BOOST_TEST(split("a,,b,", ',').size() == 4);
  BOOST_TEST(split(",", ',').size() == 2);
  // Parentheses hold together.
  BOOST_TEST(pieces("0, if(y>1, (2, 3), 0) ,1", ',') ==
             "0|if(y>1, (2, 3), 0)|1");
  BOOST_TEST(pieces("a;b,c;d", ';') == "a|b,c|d");

  BOOST_TEST(joined({"a", "b", "c"}) == "a, b, c");
  BOOST_TEST(joined({}) == "");
  BOOST_TEST(to_text(0.1) == "0.1");
  BOOST_TEST(to_text(2. / 3., 3) == "0.667");
  BOOST_TEST(to_text(Point<3>(1., 0.25, -3.)) == "(1, 0.25, -3)");
}



BOOST_AUTO_TEST_CASE(numbers)
{
  BOOST_TEST(Entry("A", " 5e-2 ").number() == 0.05);
  BOOST_TEST(Entry("A", "-3").number() == -3.);
  BOOST_TEST(Entry("A", "+.5").number() == 0.5);
  for (const std::string bad : {"",
                                " ",
                                "a",
                                "2 mm",
                                "1 %",
                                "1,5",
                                "nan",
                                "inf",
                                "-inf",
                                "1e999",
                                "1e",
                                "1e-3-",
                                "--1"})
    check_refused([&] { Entry("Section s/Width", bad).number(); },
                  {"Section s/Width",
                   ": '" + trimmed(bad) + "' is not a number"});
  for (const std::string bad : {"1e-31", "-1e31", "1e-400"})
    check_refused([&] { Entry("A", bad).number(); },
                  {"A = " + bad + ": '" + bad + "' is out of range"});

  BOOST_TEST(Entry("A", "1, 2,3e1").numbers() ==
               (std::vector<double>{1., 2., 30.}),
             boost::test_tools::per_element());
  BOOST_TEST(Entry("A", "").numbers().empty());
  check_refused([] { Entry("A", "1,,2").numbers(); }, {"A = 1,,2: ''"});

  BOOST_TEST(
    (Entry("A", "1, -2, 3e0").point() - Point<3>(1., -2., 3.)).norm() == 0.);
  for (const std::string bad : {"1, 2", "1, 2, 3, 4", "", "1 2 3"})
    BOOST_CHECK_THROW(Entry("A", bad).point(), InputError);
}



BOOST_AUTO_TEST_CASE(nearest_names)
{
  const std::vector<std::string> names{"Width", "Layup", "Length"};
  BOOST_TEST(nearest_name("Widht", names) == "Width");
  BOOST_TEST(nearest_name("LAYUP", names) == "Layup");
  BOOST_TEST(nearest_name("Lenght", names) == "Length");
  BOOST_TEST(nearest_name("", names) == "Width"); // the first of the shortest
  BOOST_TEST(nearest_name("a", {}) == "");
}



BOOST_AUTO_TEST_CASE(stacks_are_written_out)
{
  SceneText text("set Bodies = base, leaf, lid\n"
                 "set Supports = clamp\n"
                 "set Contacts = within, below\n"
                 "subsection Body base\n"
                 "  set Length = 9\n"
                 "end\n"
                 "subsection Body leaf\n"
                 "  set Origin = 1, 2, 3\n"
                 "  set Length = 10\n"
                 "  set Copies = 3\n"
                 "  set Origin step = 0, 0.1, 1.5\n"
                 "  set Length step = -2.5\n"
                 "  subsection Kinematics\n"
                 "    set Theory = LE-1\n"
                 "  end\n"
                 "end\n"
                 "subsection Support clamp\n"
                 "  set On = base: ends; leaf: start\n"
                 "end\n"
                 "subsection Contact within\n"
                 "  set First = leaf: top\n"
                 "  set Second = leaf: bottom\n"
                 "end\n"
                 "subsection Contact below\n"
                 "  set First = base: top\n"
                 "  set Second = leaf: bottom\n"
                 "end\n",
                 "s.prm",
                 {});
  expand_stacks(text);
  const auto says = [&text](const std::string &path) {
    return text.says(path).value_or("nothing");
  };
  BOOST_TEST(says("Bodies") == "base, leaf-1, leaf-2, leaf-3, lid");
  BOOST_TEST(says("Body leaf-1/Origin") == "1, 2, 3");
  BOOST_TEST(says("Body leaf-3/Origin") == "1, 2.2, 6");
  BOOST_TEST(says("Body leaf-3/Length") == "5");
  BOOST_TEST(says("Body leaf-2/Kinematics/Theory") == "LE-1");
  BOOST_TEST(says("Body leaf-2/Copies") == "nothing");
  BOOST_TEST(!text.has_subsection("Body leaf"));
  BOOST_TEST(says("Body base/Length") == "9");
  BOOST_TEST(says("Support clamp/On") ==
             "base: ends; leaf-1: start; leaf-2: start; leaf-3: start");
  // Between neighbors; of another body with each.
  BOOST_TEST(says("Contacts") ==
             "within-1, within-2, below-1, below-2, below-3");
  BOOST_TEST(says("Contact within-2/First") == "leaf-2: top");
  BOOST_TEST(says("Contact within-2/Second") == "leaf-3: bottom");
  BOOST_TEST(says("Contact below-3/First") == "base: top");
  BOOST_TEST(says("Contact below-3/Second") == "leaf-3: bottom");
}

BOOST_AUTO_TEST_SUITE_END()
