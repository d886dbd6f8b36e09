// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/handout/csv_table.h>
#include <lamella/handout/handout.h>
#include <lamella/handout/html.h>

#include <boost/test/unit_test.hpp>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

BOOST_AUTO_TEST_SUITE(handout)

using namespace lamella;

namespace
{
  /// A folder of its own that goes with the object.
  class Folder
  {
  public:
    Folder()
      : path(std::filesystem::temp_directory_path() /
             ("lamella-handout-" + std::to_string(getpid())))
    {
      std::filesystem::create_directories(path);
    }
    ~Folder()
    {
      std::filesystem::remove_all(path);
    }
    std::string
    write(const std::string &name, const std::string &text) const
    {
      std::ofstream(path / name) << text;
      return (path / name).string();
    }

    const std::filesystem::path path;
  };
} // namespace



BOOST_AUTO_TEST_CASE(text_is_escaped)
{
  BOOST_TEST(escaped("a < b & \"c\" > 'd'") ==
             "a &lt; b &amp; &quot;c&quot; &gt; &#39;d&#39;");
  BOOST_TEST(escaped("Gerüst, 5 µm") == "Gerüst, 5 µm");
  BOOST_TEST(escaped("</style><script>") == "&lt;/style&gt;&lt;script&gt;");
  // Half a character of UTF-8, and one that rings a bell.
  BOOST_TEST(escaped("a\xc3") == "a\xef\xbf\xbd");
  BOOST_TEST(escaped("a\x07"
                     "b") == "a\xef\xbf\xbd"
                             "b");
  BOOST_TEST(escaped("a\nb\tc") == "a\nb\tc");
}



BOOST_AUTO_TEST_CASE(numbers_keep_their_digits)
{
  BOOST_TEST(readable(-133963123.) == "−1.3396·10⁸");
  BOOST_TEST(readable(2.5e-11) == "2.5·10⁻¹¹");
  BOOST_TEST(readable(0.) == "0");
  BOOST_TEST(readable(-0.125) == "−0.125");
  BOOST_TEST(readable(std::numeric_limits<double>::infinity()) == "infinite");
  BOOST_TEST(number("-0.123456789012345") ==
             "<data value=\"-0.123456789012345\">−0.12346</data>");
  // An empty cell, and words where a number is looked for.
  BOOST_TEST(number("") == "–");
  BOOST_TEST(number("<none>") == "&lt;none&gt;");
  // Rounding beside its neighbours is 0, and keeps its digits.
  BOOST_TEST(number("-1e-17", 1.) == "<data value=\"-1e-17\">0</data>");
  BOOST_TEST(number("-1e-17") == "<data value=\"-1e-17\">−1·10⁻¹⁷</data>");
}



BOOST_AUTO_TEST_CASE(columns_are_formulas)
{
  BOOST_TEST(symbol("uz") == "<i>u</i><sub>z</sub>");
  BOOST_TEST(symbol("sxy") == "<i>σ</i><sub>xy</sub>");
  BOOST_TEST(symbol("gyz") == "<i>γ</i><sub>yz</sub>");
  BOOST_TEST(symbol("fx") == "<i>F</i><sub>x</sub>");
  BOOST_TEST(symbol("x") == "<i>x</i>");
  BOOST_TEST(symbol("") == "");
  BOOST_TEST(symbol("step") == "step");
  BOOST_TEST(in_brackets("mm", "length") == "[mm]");
  BOOST_TEST(in_brackets("", "length") == "[length]");
}



BOOST_AUTO_TEST_CASE(tables_of_html)
{
  HtmlTable table;
  table.id     = "t";
  table.header = {"what", "value"};
  table.rows   = {{"words", number("1")},
                  {number("1") + " of " + number("2"), "–"}};
  table.marked = {1};
  BOOST_TEST(to_html(table) ==
             "<div class=\"wide\"><table id=\"table-t\">\n"
             "<thead><tr><th scope=\"col\">what</th><th "
             "scope=\"col\">value</th></tr></thead>\n<tbody>\n"
             "<tr><td>words</td><td class=\"number\"><data "
             "value=\"1\">1</data></td></tr>\n"
             "<tr class=\"marked\"><td><data value=\"1\">1</data> of <data "
             "value=\"2\">2</data></td><td class=\"number\">–</td></tr>\n"
             "</tbody></table></div>\n");
  BOOST_TEST(lamella::list({}) == "");
  // RFC 4648: f, fo, foo.
  BOOST_TEST(data_uri("text/plain", "f") == "data:text/plain;base64,Zg==");
  BOOST_TEST(data_uri("text/plain", "fo") == "data:text/plain;base64,Zm8=");
  BOOST_TEST(data_uri("text/plain", "foo") == "data:text/plain;base64,Zm9v");
}



BOOST_AUTO_TEST_CASE(tables_of_csv)
{
  const Folder      folder;
  const std::string path  = folder.write("t.csv",
                                        "step,goal,bar\n"
                                         "1,\"c: fz in y 1, 2\",0.125\n"
                                         "2,tip,\n"
                                         "2,\"end\",-3e-5\n");
  const CsvTable    table = CsvTable::read(path);
  BOOST_TEST(table.rows.size() == 3);
  BOOST_TEST(table.cell(0, "goal") == "c: fz in y 1, 2");
  BOOST_TEST(table.value(0, "bar") == 0.125);
  BOOST_TEST(std::isnan(table.value(1, "bar")));
  BOOST_TEST(table.cell(0, "no such column") == "");
  BOOST_TEST(table.last_step().rows.size() == 2);
  BOOST_TEST(table.last_step().cell(1, "bar") == "-3e-5");

  // A table that a scene need not have.
  const CsvTable none = CsvTable::read(folder.path / "missing.csv");
  BOOST_TEST(none.empty());
  BOOST_TEST(none.last_step().empty());

  const std::string cut_off = folder.write("cut.csv", "a,b\n1,2\n3\n");
  BOOST_CHECK_EXCEPTION(CsvTable::read(cut_off),
                        InputError,
                        [](const InputError &error) {
                          const std::string what = error.what();
                          return what.find("cut.csv: line 3 has 1 cells where "
                                           "the first line has 2") !=
                                 std::string::npos;
                        });
}



BOOST_AUTO_TEST_CASE(a_run_that_left_the_least)
{
  const Folder folder;
  folder.write("summary.json", "{}");
  folder.write("scene.prm", "set Title = <i>\n");
  const std::string page = handout_text(folder.path, "No <pictures>.");
  for (const char *words : {"The scene has no contact.",
                            "The scene names no goals",
                            "No failure criterion was asked for",
                            "did not come to its end",
                            "No &lt;pictures&gt;.",
                            "set Title = &lt;i&gt;"})
    BOOST_TEST((page.find(words) != std::string::npos), words);

  folder.write("summary.json", "[1, 2]");
  BOOST_CHECK_THROW(handout_text(folder.path, ""), InputError);
  folder.write("summary.json", "{\"units\": 3}");
  BOOST_CHECK_THROW(handout_text(folder.path, ""), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
