// SPDX-License-Identifier: LGPL-2.1-or-later

// Meshes by Gmsh as text: what is read, each fault found with its line, and
// whatever stands in a file, a section or one message.

#include <lamella/base/exceptions.h>
#include <lamella/shape/gmsh_file.h>
#include <lamella/shape/shapes.h>

#include <boost/test/unit_test.hpp>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

BOOST_AUTO_TEST_SUITE(gmsh_file)

using namespace lamella;

namespace
{
  /// Two cells side by side, their lower side called `low`; the groups
  /// backwards and the nodes with parameters, where they have any.
  const std::string two_cells = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
2
1 2 "low"
2 1 "carbon"
$EndPhysicalNames
$Entities
0 1 1 0
7 0 0 0 2 0 0 1 -2 0
8 0 0 0 2 1 0 1 -1 1 7
$EndEntities
$Nodes
2 6 10 60
1 7 1 3
10
20
30
0 0 0 0
1 0 0 0.5
2 0 0 1
2 8 1 3
40
50
60
0 1 0 0 1
1 1 0 1 1
2 1 0 2 1
$EndNodes
$Elements
2 4 1 4
1 7 1 2
1 10 20
2 20 30
2 8 3 2
3 10 20 50 40
4 20 30 60 50
$EndElements
)";



  /// @p text with the first @p from replaced by @p to.
  std::string
  changed(std::string text, const std::string &from, const std::string &to)
  {
    const auto at = text.find(from);
    BOOST_TEST_REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
  }



  /// The message about @p text; empty if there is none.
  std::string
  fault_of(const std::string &text)
  {
    try
      {
        read_gmsh_file(text, {"Section s/File", "s.msh"});
        return "";
      }
    catch (const InputError &error)
      {
        return error.what();
      }
  }



  /// Whether the message about @p text names @p line and says @p fragment.
  bool
  finds(const std::string &text,
        const unsigned int line,
        const std::string &fragment)
  {
    const std::string message = fault_of(text);
    BOOST_TEST_MESSAGE(message);
    return message.find("Section s/File = s.msh: line " + std::to_string(line) +
                        ": ") == 0 &&
           message.find(fragment) != std::string::npos;
  }



  /// A file as long as it lives.
  struct TemporaryFile
  {
    TemporaryFile()
      : path((std::filesystem::temp_directory_path() /
              ("lamella_gmsh_file_" + std::to_string(std::random_device{}()) +
               ".msh"))
               .string())
    {}

    ~TemporaryFile()
    {
      std::error_code ignored;
      std::filesystem::remove(path, ignored);
    }

    const std::string path;
  };



  std::vector<std::string>
  lines_of(const std::string &text)
  {
    std::istringstream       in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);)
      lines.push_back(line);
    return lines;
  }



  /// @p text damaged in one place, as @p random has it.
  std::string
  damaged(const std::string &text, std::mt19937 &random)
  {
    const auto below = [&random](const std::size_t n) { return random() % n; };
    const std::vector<std::string> words{"-1",
                                         "0",
                                         "7",
                                         "4294967297",
                                         "99999999999999999999",
                                         "nan",
                                         "1e300",
                                         "x",
                                         "$End",
                                         "",
                                         "\"",
                                         std::string(1, '\0')};
    std::vector<std::string>       lines = lines_of(text);
    const std::size_t              at    = below(lines.size());
    switch (below(6))
      {
        case 0:
          lines.erase(lines.begin() + at);
          break;
        case 1:
          lines.insert(lines.begin() + at, lines[at]);
          break;
        case 2:
          std::swap(lines[at], lines[below(lines.size())]);
          break;
        case 3:
          return text.substr(0, below(text.size()));
        case 4:
          {
            std::string bytes          = text;
            bytes[below(bytes.size())] = static_cast<char>(below(256));
            return bytes;
          }
        default:
          {
            // A word becomes another.
            std::string      &line  = lines[at];
            const std::size_t begin = line.rfind(' ', below(line.size() + 1)),
                              from = begin == std::string::npos ? 0 : begin + 1;
            line.replace(from,
                         std::min(line.find(' ', from), line.size()) - from,
                         words[below(words.size())]);
          }
      }
    std::string result;
    for (const std::string &line : lines)
      result += line + "\n";
    return result;
  }
} // namespace

BOOST_AUTO_TEST_CASE(names_nodes_and_elements)
{
  const GmshFile file = read_gmsh_file(two_cells, {"Section s/File", "s.msh"});
  BOOST_TEST(file.names.size() == 2);
  BOOST_TEST(file.names.at({1, 2}).name == "low");
  BOOST_TEST(file.names.at({2, 1}).name == "carbon");
  BOOST_TEST(file.names.at({2, 1}).line == 7);
  BOOST_TEST_REQUIRE(file.nodes.size() == 6);
  BOOST_TEST(file.nodes[5].position.distance({2., 1., 0.}) == 0.);
  BOOST_TEST_REQUIRE(file.elements.size() == 4);
  BOOST_TEST(file.elements[1].type == GmshFile::line_type);
  BOOST_TEST(file.elements[1].group == 2);
  const GmshFile::Element &last = file.elements[3];
  BOOST_TEST(last.type == GmshFile::quadrilateral);
  BOOST_TEST(last.group == 1);
  BOOST_TEST(last.nodes == (std::array<unsigned int, 4>{{1, 2, 5, 4}}),
             boost::test_tools::per_element());
  // The last but one.
  BOOST_TEST(last.line == lines_of(two_cells).size() - 1);
}



BOOST_AUTO_TEST_CASE(what_may_stand_in_a_file)
{
  // Lines' ends of other systems, empty lines, sections of others, any order.
  std::string other_ends;
  for (const std::string &line : lines_of(two_cells))
    other_ends += "  " + line + " \r\n\r\n";
  const auto nodes = two_cells.find("$Nodes"),
             rest  = two_cells.find("$Elements");
  for (const std::string &text :
       {other_ends,
        two_cells + "$Periodic\n$1 any\n$EndPeriodic\n",
        changed(two_cells, "$Nodes", "$Comments\n2\n$EndComments\n$Nodes"),
        two_cells.substr(0, nodes) + two_cells.substr(rest) +
          two_cells.substr(nodes, rest - nodes),
        changed(two_cells, "0 1 -2 0", "0 0 0"),
        two_cells.substr(0, two_cells.size() - 1)})
    {
      BOOST_TEST(fault_of(text) == "");
      BOOST_TEST(
        read_gmsh_file(text, {"Section s/File", "s.msh"}).elements.size() == 4);
    }
}



BOOST_AUTO_TEST_CASE(faults_with_their_lines)
{
  const std::string &text = two_cells;
  BOOST_TEST(finds(changed(text, "4.1 0 8", "4.1 1 8"), 2, "binary"));
  // One message for all versions that are not read, with the command.
  for (const std::string version : {"2", "2.2", "3", "4", "5.1"})
    BOOST_TEST(finds(changed(text, "4.1 0 8", version + " 0 8"),
                     2,
                     "of version " + version +
                       "; only text files of version 4.1 can be read. Write "
                       "the mesh again with 'gmsh s.msh -save -format msh41 -o "
                       "NEW.msh'"));
  BOOST_TEST(finds("$NOD\n1\n1 0 0 0\n$ENDNOD\n", 1, "of version 1; only"));
  BOOST_TEST(finds("\xEF\xBB\xBF" + text, 1, "byte order mark"));
  BOOST_TEST(finds(changed(text, "\n2\n1 2", "\n3\n1 2"), 7, "name 3 is due"));
  BOOST_TEST(
    finds(changed(text, "2 1 \"c", "2 -1 \"c"), 7, "'-1' is not a phys"));
  BOOST_TEST(
    finds(changed(text, "2 1 \"carbon\"", "2 1 carbon"), 7, "in quotes"));
  BOOST_TEST(finds(changed(text, "2 1 \"c", "1 2 \"c"), 7, "a name in line 6"));
  BOOST_TEST(
    finds(changed(text, "2 6 10", "2 -6 10"), 15, "'-6' is not a count"));
  BOOST_TEST(
    finds(changed(text, "2 6 10", "1 3 10"), 23, "'2 8 1 3' stands after"));
  BOOST_TEST(finds(changed(text, "2 8 1 3", "2 8 1 4"),
                   27,
                   "5 words instead of 1 (a node's"));
  BOOST_TEST(
    finds(changed(text, "2 6 10", "2 4294967297 10"), 15, "4294967297"));
  BOOST_TEST(
    finds(changed(text, "1 1 0 1 1", "1 1 0 1"), 28, "4 words instead"));
  BOOST_TEST(finds(changed(text, "1 1 0 1 1", "inf 1 0 1 1"),
                   28,
                   "'inf' is not a coor"));
  BOOST_TEST(
    finds(changed(text, "1 1 0 1 1", "0x1 1 0 1 1"), 28, "'0x1' is not a coo"));
  BOOST_TEST(
    finds(changed(text, "1 1 0 1 1", "1e999 1 0 1 1"), 28, "'1e999' is not"));
  BOOST_TEST(finds(changed(text, "\n50\n", "\n20\n"), 28, "is in line 21"));
  BOOST_TEST(
    finds(changed(text, "\n50\n", "\n0\n"), 25, "'0' is not a node's"));
  BOOST_TEST(finds(changed(text, "20 50 40", "20 51 40"),
                   37,
                   "node 51, which is not in $Nodes"));
  BOOST_TEST(finds(changed(text, "20 50 40", "20 20 40"), 37, "node 20 twice"));
  BOOST_TEST(
    finds(changed(text, "20 50 40", "20 50"), 37, "4 words instead of 5"));
  BOOST_TEST(finds(changed(text, "3 10 20", "2 10 20"), 37, "element 2"));
  BOOST_TEST(finds(text + "$Nodes\n0\n$EndNodes\n", 40, "is in line 14"));
  BOOST_TEST(finds(changed(text, "$EndNodes\n", ""), 30, "inside $Nodes"));
  BOOST_TEST(finds(text + "1\n", 40, "'1' stands between"));
  BOOST_TEST(
    finds(text.substr(0, text.find("$Elem")), 30, "without $Elements"));
  BOOST_TEST(finds(text.substr(0, text.size() - 3), 39, "cut off"));
  BOOST_TEST(finds(changed(text, "0 1 1 0", "0 2 1 0"), 12, "surface 1 is"));
  BOOST_TEST(finds(changed(text, "0 1 1 0", "0 1 1"), 10, "3 words instead"));
  BOOST_TEST(
    finds(changed(text, "0 1 -2 0", "0 2 -2 4 0"), 11, "in 2 physical"));
  BOOST_TEST(
    finds(changed(text, "0 1 -2 0", "0 1 0 0"), 11, "'0' is not a phys"));
  BOOST_TEST(finds(changed(text, "1 -1 1 7", "1 -1 9 7"), 12, "instead of 19"));
  BOOST_TEST(finds(changed(text, "2 6 10", "2 7 10"), 15, "the blocks have 6"));
  BOOST_TEST(finds(changed(text, "2 6 10", "3 6 10"), 29, "block 3 is due"));
  BOOST_TEST(
    finds(changed(text, "2 6 10", "-1 6 10"), 15, "'-1' is not a count"));
  BOOST_TEST(
    finds(changed(text, "1 7 1 3", "1 7 1 8"), 16, "8 nodes are announ"));
  BOOST_TEST(finds(changed(text, "1 7 1 3", "1 7 0 3"), 20, "4 words instead"));
  BOOST_TEST(
    finds(changed(text, "1 7 1 3", "4 7 1 3"), 16, "'4' is not a dimen"));
  BOOST_TEST(
    finds(changed(text, "2 8 3 2", "1 7 3 2"), 36, "no elements of type"));
  BOOST_TEST(finds(changed(text, "2 8 3 2", "2 9 3 2"), 36, "no surface 9"));
  BOOST_TEST(
    finds(changed(text, "2 4 1 4", "2 5 1 4"), 32, "the blocks have 4"));
  BOOST_TEST(finds(changed(text, "$Nodes", "$PartitionedEntities\n0\n$Nodes"),
                   14,
                   "partitions"));
}



BOOST_AUTO_TEST_CASE(bytes_of_any_kind_make_one_short_line)
{
  std::string zeros(1000, '\0');
  const auto  message =
    fault_of(changed(two_cells, "1 1 0 1 1", zeros + " 1 0 1 1"));
  BOOST_TEST(message.size() < 300);
  for (const unsigned char c : message)
    BOOST_TEST(std::isprint(c));
  BOOST_TEST(fault_of("") != "");
  BOOST_TEST(fault_of("\n\n") != "");
  BOOST_TEST(fault_of(std::string(100000, '$')) != "");
}



BOOST_AUTO_TEST_CASE(a_damaged_file_is_read_or_refused)
{
  // As many as a second allows; each with the seed that its message names.
  // Those that are read have cells as they are asked of any section.
  const Materials constants{
    {"carbon", EngineeringConstants::isotropic(10., 0.25)}};
  std::ifstream in(
    std::filesystem::path(__FILE__).parent_path().parent_path().parent_path() /
    "prm/sections/hexagon.msh");
  std::ostringstream shipped;
  shipped << in.rdbuf();
  BOOST_TEST_REQUIRE(shipped.str().size() > 1000);
  const TemporaryFile file;
  const SectionFile   section{file.path, 1., {}, "Section s"};
  unsigned int        read = 0, refused = 0;
  for (unsigned int seed = 0; seed < 400; ++seed)
    {
      std::mt19937      random(seed);
      const std::string text =
        damaged(seed % 2 == 0 ? shipped.str() : two_cells, random);
      std::ofstream(file.path, std::ios::binary) << text;
      BOOST_TEST_CONTEXT("seed " << seed)
      try
        {
          const auto mesh = make_section_mesh(section, constants);
          BOOST_TEST(mesh->mesh.n_active_cells() > 0);
          ++read;
        }
      catch (const InputError &error)
        {
          const std::string message = error.what();
          BOOST_TEST(message.find("Section s") == 0);
          BOOST_TEST(message.find('\n') == std::string::npos);
          ++refused;
        }
    }
  BOOST_TEST(read > 20);
  BOOST_TEST(refused > 200);
}

BOOST_AUTO_TEST_SUITE_END()
