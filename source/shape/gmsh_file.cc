// SPDX-License-Identifier: LGPL-2.1-or-later

// Reads names, entities, nodes and elements of a Gmsh mesh (gmsh_parts.h).

#include <lamella/shape/gmsh_file.h>
#include <lamella/shape/gmsh_parts.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

namespace lamella
{
  void
  refuse_line(const Entry       &entry,
              const unsigned int line,
              const std::string &rule,
              const std::string &remedy)
  {
    const Message message(rule);
    entry.refuse(message.identifier + ": line " + std::to_string(line) + ": " +
                   message.text,
                 remedy);
  }



  namespace
  {
    constexpr int tags_end = std::numeric_limits<int>::max();



    /// Of dimension 0, 1, ..., in words.
    std::string
    entity_name(const std::int64_t dimension)
    {
      return std::array<const char *, 4>{
        {"point", "curve", "surface", "volume"}}
        .at(dimension);
    }



    class MeshReader
    {
    public:
      MeshReader(const std::string &text, const Entry &entry)
        : parts(text, entry)
      {}

      GmshFile
      read()
      {
        // Whatever their order in the file.
        read_names();
        read_entities();
        read_blocks("Nodes",
                    "nodes",
                    file.nodes,
                    &MeshReader::add_block_of_nodes);
        read_blocks("Elements",
                    "elements",
                    file.elements,
                    &MeshReader::add_block_of_elements);
        return std::move(file);
      }

    private:
      void
      read_names()
      {
        if (!parts.has("PhysicalNames"))
          return;
        GmshPart  &part  = parts.part("PhysicalNames");
        GmshLines &lines = part.lines;
        part.next_line("the count of names");
        lines.expect(1, "the count of names");
        const auto n = part.announced(0, "names");
        for (std::int64_t i = 0; i < n; ++i)
          {
            part.next_line("name " + std::to_string(i + 1));
            const auto open = lines.current.find('"');
            if (lines.words.size() < 3 || open == std::string_view::npos ||
                lines.words[2][0] != '"' || lines.current.back() != '"' ||
                lines.current.size() < open + 2)
              lines.fault(lines.shown(lines.current) +
                          " is not a dimension, a tag and a name in quotes");
            if (std::any_of(lines.current.begin(),
                            lines.current.end(),
                            [](const unsigned char c) {
                              return c < ' ' || c == 127;
                            }))
              lines.fault(lines.shown(lines.current) +
                          " has bytes that are no letters ('?')");
            const int dimension =
              lines.integer(0, "a dimension (0 to 3)", 0, 3);
            const int tag = lines.integer(1, "a physical tag", 1, tags_end);
            const auto [it, is_new] =
              file.names.insert({{dimension, tag},
                                 {std::string(lines.current.substr(
                                    open + 1, lines.current.size() - open - 2)),
                                  lines.line}});
            if (!is_new)
              lines.fault("the physical " + entity_name(dimension) + " " +
                          std::to_string(tag) + " has a name in line " +
                          std::to_string(it->second.line) + " already");
          }
        part.expect_end();
      }

      void
      read_entities()
      {
        if (!parts.has("Entities"))
          return;
        GmshPart &part = parts.part("Entities");
        part.next_line("four counts");
        part.lines.expect(4, "counts of points, curves, surfaces, volumes");
        std::array<std::int64_t, 4> n{};
        for (int d = 0; d < 4; ++d)
          n[d] = part.announced(d, entity_name(d) + "s");
        for (int d = 0; d < 4; ++d)
          for (std::int64_t i = 0; i < n[d]; ++i)
            {
              part.next_line(entity_name(d) + " " + std::to_string(i + 1));
              read_entity(part.lines, d);
            }
        part.expect_end();
      }

      /// Reads a line: tag, box (for points the place), count of physical
      /// groups, their tags; except for points, count and tags of the bounding
      /// entities.
      void
      read_entity(const GmshLines &at, const int dimension)
      {
        const std::string  name = entity_name(dimension);
        const std::size_t  head = dimension == 0 ? 4 : 7;
        const std::int64_t tag =
          at.integer(0, "the tag of a " + name, -tags_end);
        const std::int64_t n =
          at.integer(head, "a count of physical groups", 0, at.words.size());
        int group = 0;
        for (std::int64_t k = 0; k < n; ++k)
          {
            group = std::abs(
              at.integer(head + 1 + k, "a physical tag", -tags_end, tags_end));
            if (group == 0)
              at.fault("'0' is not a physical tag");
          }
        std::size_t words = head + 1 + n;
        if (dimension > 0)
          words += 1 + at.integer(words,
                                  "a count of what bounds the " + name,
                                  0,
                                  at.words.size());
        at.expect(words, "as its counts say");
        // A point or volume makes no part of a section.
        if (n > 1 && (dimension == 1 || dimension == 2))
          refuse_line(
            at.entry,
            at.line,
            "shape.several-groups: the " + name + " " + std::to_string(tag) +
              " is in " + std::to_string(n) + " physical groups",
            "Put each curve and each surface into one physical group only.");
        if (!group_of_entity.insert({{dimension, tag}, group}).second)
          at.fault("a second " + name + " " + std::to_string(tag));
      }

      void
      add_node(const GmshLines &at, const std::int64_t number)
      {
        const auto [it, is_new] =
          cell_of_node.insert({number, file.nodes.size()});
        if (!is_new)
          at.fault("a second node " + std::to_string(number) +
                   "; the first is in line " +
                   std::to_string(file.nodes[it->second].line));
        GmshFile::Node node;
        for (unsigned int d = 0; d < 3; ++d)
          node.position[d] = at.number(d, "a coordinate");
        node.line = at.line;
        file.nodes.push_back(node);
      }

      /// Adds the element of @p type in line @p at.
      void
      add_element(const GmshLines &at, const int type, const int group)
      {
        static const std::map<int, std::size_t> sizes{{GmshFile::line_type, 2},
                                                      {GmshFile::triangle, 3},
                                                      {GmshFile::quadrilateral,
                                                       4},
                                                      {GmshFile::point, 1}};
        const std::int64_t number = at.integer(0, "an element's number", 1);
        if (!numbers_of_elements.insert(number).second)
          at.fault("a second element " + std::to_string(number));
        GmshFile::Element element;
        element.type    = type;
        element.group   = group;
        element.line    = at.line;
        const auto size = sizes.find(type);
        if (size != sizes.end())
          {
            at.expect(1 + size->second,
                      std::to_string(size->second) +
                        " of them nodes, as elements of type " +
                        std::to_string(type) + " have");
            element.nodes = nodes_of_element(at, size->second);
          }
        file.elements.push_back(element);
      }

      /// Nodes of the element in line @p at: the @p n words after its number.
      std::array<unsigned int, 4>
      nodes_of_element(const GmshLines &at, const std::size_t n) const
      {
        const std::string element =
          "element " + std::to_string(at.integer(0, "an element's number", 1));
        std::array<unsigned int, 4> nodes{};
        for (std::size_t i = 0; i < n; ++i)
          {
            const std::int64_t node  = at.integer(1 + i, "a node's number", 1);
            const auto         found = cell_of_node.find(node);
            if (found == cell_of_node.end())
              at.fault(element + " has node " + std::to_string(node) +
                       ", which is not in $Nodes");
            const auto end = nodes.begin() + i;
            if (std::find(nodes.begin(), end, found->second) != end)
              at.fault(element + " has node " + std::to_string(node) +
                       " twice");
            nodes[i] = found->second;
          }
        return nodes;
      }

      /// Reads the section `$NAME` with @p name: its first line announces
      /// blocks of @p things, each of which @p add_block adds to @p found.
      template <typename Thing>
      void
      read_blocks(const std::string        &name,
                  const std::string        &things,
                  const std::vector<Thing> &found,
                  void (MeshReader::*add_block)(GmshPart &))
      {
        GmshPart &part = parts.part(name);
        part.next_line("the count of " + things);
        const GmshLines head = part.lines;
        head.expect(4, "counts of blocks and " + things);
        const auto n_blocks = part.announced(0, "blocks"),
                   n        = part.announced(1, things);
        for (std::int64_t block = 0; block < n_blocks; ++block)
          {
            part.next_line("block " + std::to_string(block + 1));
            (this->*add_block)(part);
          }
        if (found.size() != static_cast<std::size_t>(n))
          head.fault(std::to_string(n) + " " + things +
                     " are announced, but the blocks have " +
                     std::to_string(found.size()));
        part.expect_end();
      }

      void
      add_block_of_nodes(GmshPart &part)
      {
        GmshLines &lines = part.lines;
        lines.expect(4, "a block's dimension, tag, 0 or 1, count of nodes");
        const auto dimension = lines.integer(0, "a dimension (0 to 3)", 0, 3);
        lines.integer(1, "a tag", -tags_end, tags_end);
        // Parameters, one for each dimension, may stand behind coordinates.
        const auto parameters =
          dimension * lines.integer(2, "0 or 1 (with parameters)", 0, 1);
        const auto                count = part.announced(3, "nodes", 2);
        std::vector<std::int64_t> numbers;
        for (std::int64_t i = 0; i < count; ++i)
          {
            part.next_line("a node's number");
            lines.expect(1, "a node's number");
            numbers.push_back(lines.integer(0, "a node's number", 1));
          }
        for (const std::int64_t number : numbers)
          {
            part.next_line("a node");
            lines.expect(3 + parameters,
                         "x, y, z, and parameters if announced");
            add_node(lines, number);
          }
      }

      void
      add_block_of_elements(GmshPart &part)
      {
        static const std::map<int, int> dimensions{{GmshFile::line_type, 1},
                                                   {GmshFile::triangle, 2},
                                                   {GmshFile::quadrilateral, 2},
                                                   {GmshFile::point, 0}};
        GmshLines                      &lines = part.lines;
        lines.expect(4, "a block's dimension, tag, type, count of elements");
        const int  dimension = lines.integer(0, "a dimension (0 to 3)", 0, 3);
        const auto tag       = lines.integer(1, "a tag", -tags_end, tags_end);
        const int  type  = lines.integer(2, "a type of element", 1, tags_end);
        const auto count = part.announced(3, "elements");
        const auto fits  = dimensions.find(type);
        if (fits != dimensions.end() && fits->second != dimension)
          lines.fault("a " + entity_name(dimension) +
                      " has no elements of type " + std::to_string(type));
        const auto group = group_of_entity.find({dimension, tag});
        if (group == group_of_entity.end() && parts.has("Entities"))
          lines.fault("$Entities has no " + entity_name(dimension) + " " +
                      std::to_string(tag));
        for (std::int64_t i = 0; i < count; ++i)
          {
            part.next_line("an element");
            add_element(lines,
                        type,
                        group == group_of_entity.end() ? 0 : group->second);
          }
      }

      GmshParts parts;
      GmshFile  file;
      /// Number of a node -> its place.
      std::unordered_map<std::int64_t, unsigned int> cell_of_node;
      std::unordered_set<std::int64_t>               numbers_of_elements;
      /// (dimension, tag) of what is drawn -> tag of its physical group.
      std::map<std::pair<int, std::int64_t>, int> group_of_entity;
    };
  } // namespace



  GmshFile
  read_gmsh_file(const std::string &text, const Entry &entry)
  {
    return MeshReader(text, entry).read();
  }
} // namespace lamella
