// SPDX-License-Identifier: LGPL-2.1-or-later

// GridIn of deal.II reads these files, too, word by word, and trusts them: a
// coordinate that is missing shifts all that follows, a node number of -1 or a
// count of four billion ends the program. Gmsh's own library is no better a
// judge. Hence this reader, which goes line by line, as Gmsh writes, and
// believes nothing.

#include <lamella/shape/gmsh_file.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <set>
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
    entry.refuse("line " + std::to_string(line) + ": " + rule, remedy);
  }



  namespace
  {
    const std::string anew =
      "Write the file anew with 'gmsh -2 NAME.geo -format msh41 -o NAME.msh'.";

    /// Fourth powers of lengths, and what they are multiplied with, stay within
    /// doubles.
    constexpr double longest = 1e30;

    constexpr int tags_end = std::numeric_limits<int>::max();



    /// @p word between quotes, short and without bytes that no console shows.
    std::string
    shown(const std::string_view word)
    {
      constexpr std::size_t most = 30;
      std::string           text;
      for (const char c : word.substr(0, most))
        text += c >= ' ' && c <= '~' ? c : '?';
      return "'" + text + (word.size() > most ? "..." : "") + "'";
    }



    /**
     * The lines of a text from some place on, one after the other; those of
     * white space are left out. It also judges the words of the line that it
     * stands at, and says where that is.
     */
    struct Lines
    {
      Lines(const std::string_view text, const Entry &entry)
        : rest(text)
        , entry(entry)
      {}

      /// Goes on to the next line; false if there is none.
      bool
      next()
      {
        constexpr std::string_view white = " \t\r\v\f";
        while (!rest.empty())
          {
            const auto             end = std::min(rest.find('\n'), rest.size());
            const std::string_view whole = rest.substr(0, end);
            rest.remove_prefix(std::min(end + 1, rest.size()));
            ++line;
            const auto begin = whole.find_first_not_of(white);
            if (begin == std::string_view::npos)
              continue;
            current =
              whole.substr(begin, whole.find_last_not_of(white) - begin + 1);
            words.clear();
            for (std::size_t at = 0; at < current.size();)
              {
                const auto stop =
                  std::min(current.find_first_of(white, at), current.size());
                words.push_back(current.substr(at, stop - at));
                at = std::min(current.find_first_not_of(white, stop),
                              current.size());
              }
            return true;
          }
        return false;
      }

      [[noreturn]] void
      fault(const std::string &rule, const std::string &remedy = anew) const
      {
        refuse_line(entry, line, rule, remedy);
      }

      /// Throws unless there are @p n words; @p meaning says which.
      void
      expect(const std::size_t n, const std::string &meaning) const
      {
        if (words.size() != n)
          fault(std::to_string(words.size()) +
                (words.size() == 1 ? " word" : " words") + " instead of " +
                std::to_string(n) + " (" + meaning + ")");
      }

      /// Word @p i, a whole number.
      std::int64_t
      integer(const std::size_t  i,
              const std::string &meaning,
              const std::int64_t lowest,
              const std::int64_t highest =
                std::numeric_limits<std::int64_t>::max()) const
      {
        std::int64_t     value = 0;
        std::string_view word  = i < words.size() ? words[i] : "";
        const auto [end, error] =
          std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc() || end != word.data() + word.size() ||
            value < lowest || value > highest)
          fault(word.empty() ? "the line ends before " + meaning :
                               shown(word) + " is not " + meaning);
        return value;
      }

      /// Word @p i, a finite number. (strtod knows more: nan, inf, 0x1p3.)
      double
      number(const std::size_t i, const std::string &meaning) const
      {
        const std::string word(words.at(i));
        char             *end   = nullptr;
        const double      value = std::strtod(word.c_str(), &end);
        if (word.find_first_not_of("0123456789+-.eE") != std::string::npos ||
            *end != '\0' || !(std::abs(value) <= longest))
          fault(shown(word) + " is not " + meaning);
        return value;
      }

      std::string_view rest;
      /// Names the file.
      const Entry                  &entry;
      std::string_view              current;
      std::vector<std::string_view> words;
      /// Counted from 1.
      unsigned int line = 0;
    };



    /// A part of the file between `$NAME` and `$EndNAME`.
    struct Part
    {
      /// Stands at `$NAME`; what follows ends with the part.
      Lines lines;
      /// That are not of white space.
      unsigned int n_lines = 0;
    };



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
        : all(text, entry)
      {}

      GmshFile
      read();

    private:
      void
      read_format();

      /// Looks where each part begins and ends.
      void
      find_parts();

      void
      add_part();

      /// The part @p name, which must be there.
      Part &
      part(const std::string &name);

      void
      read_names();

      void
      read_entities();

      void
      read_entity(const Lines &at, const int dimension);

      void
      read_nodes();

      void
      add_node(const Lines       &at,
               const std::int64_t number,
               const std::size_t  first_word);

      void
      read_nodes_in_blocks(Part &part);

      void
      read_elements();

      void
      read_elements_in_blocks(Part &part);

      /// The line @p at is an element of @p type whose nodes begin with the
      /// word @p first_word.
      void
      add_element(const Lines      &at,
                  const int         type,
                  const int         group,
                  const std::size_t first_word);

      /// A number of @p things that word @p i of the head announces, each in
      /// @p lines_each lines.
      static std::int64_t
      announced(const Part        &part,
                const std::size_t  i,
                const std::string &things,
                const unsigned int lines_each = 1);

      /// Goes on to the next line, which a count announced.
      static void
      go_on(Part &part, const std::string &due);

      static void
      expect_end(Part &part);

      Lines all;
      /// As nodes and elements stand in version 4.1; in 2.2 each by itself.
      bool                        in_blocks = false;
      std::map<std::string, Part> parts;
      GmshFile                    file;
      /// Number of a node -> its place.
      std::unordered_map<std::int64_t, unsigned int> place_of_node;
      std::unordered_set<std::int64_t>               numbers_of_elements;
      /// (dimension, tag) of what is drawn -> tag of its physical group.
      std::map<std::pair<int, std::int64_t>, int> group_of_entity;
    };



    GmshFile
    MeshReader::read()
    {
      read_format();
      find_parts();
      // Whatever their order in the file.
      read_names();
      read_entities();
      read_nodes();
      read_elements();
      return std::move(file);
    }



    void
    MeshReader::read_format()
    {
      if (all.rest.substr(0, 3) == "\xEF\xBB\xBF")
        refuse_line(
          all.entry,
          1,
          "before $MeshFormat stands a byte order mark (EF BB BF), which some "
          "editors put there",
          "Save the file without it, as plain ASCII.");
      if (!all.next() ||
          (all.current != "$MeshFormat" && all.current != "$NOD"))
        all.entry.refuse("this is not a mesh by Gmsh",
                         "Write one with 'gmsh -2 NAME.geo -o NAME.msh'.");
      std::string version = "1";
      bool        binary  = false;
      if (all.current == "$MeshFormat")
        {
          if (!all.next())
            all.fault("the file is cut off: it ends before $EndMeshFormat");
          all.expect(3, "the format's version, 0 for text, 8");
          version = to_text(all.number(0, "a version of the format"));
          binary  = all.integer(1, "0 (text) or 1 (binary)", 0, 1);
        }
      in_blocks = version == "4.1";
      if (binary || !(in_blocks || version == "2.2"))
        all.fault("the mesh is " +
                    (binary ? "binary" : "of version " + version) +
                    "; text of 4.1 and of 2.2 is read",
                  "Have Gmsh write it anew: 'gmsh " + all.entry.text() +
                    " -save -format msh41 -o NEW.msh'.");
      all.integer(2, "8, the bytes of a number", 1);
      if (!all.next())
        all.fault("the file is cut off: it ends before $EndMeshFormat");
      if (all.current != "$EndMeshFormat")
        all.fault(shown(all.current) + " instead of $EndMeshFormat");
    }



    void
    MeshReader::find_parts()
    {
      while (all.next())
        {
          if (all.current[0] != '$')
            all.fault(shown(all.current) +
                      " stands between the sections of the file");
          if (all.current.substr(0, 4) == "$End")
            all.fault(shown(all.current) + " ends what does not begin");
          add_part();
        }
    }



    void
    MeshReader::add_part()
    {
      static const std::set<std::string> once{
        "MeshFormat", "PhysicalNames", "Entities", "Nodes", "Elements"};
      const std::string name(all.current.substr(1));
      if (name == "PartitionedEntities")
        all.fault("the mesh is cut into partitions; a section has none");
      const bool wanted = once.count(name) == 1;
      const auto found  = parts.find(name);
      if (wanted && (found != parts.end() || name == "MeshFormat"))
        all.fault("a second $" + name +
                  (found == parts.end() ?
                     "" :
                     "; the first is in line " +
                       std::to_string(found->second.lines.line)));
      Part              part{all, 0};
      const std::string end = "$End" + name;
      const std::string cut_off =
        "the file is cut off: it ends before " + shown(end);
      const char *const from = all.rest.data();
      while (true)
        {
          const char *const to = all.rest.data();
          if (!all.next())
            all.fault(cut_off);
          if (all.current == end)
            {
              part.lines.rest = std::string_view(from, to - from);
              break;
            }
          if (all.rest.empty() && end.find(all.current) == 0)
            all.fault(cut_off);
          // What others write into sections of their own is theirs.
          if (wanted && all.current[0] == '$')
            all.fault(shown(all.current) + " stands inside $" + name +
                      ", which has no " + end + " before it");
          ++part.n_lines;
        }
      if (wanted)
        parts.emplace(name, std::move(part));
    }



    Part &
    MeshReader::part(const std::string &name)
    {
      const auto found = parts.find(name);
      if (found == parts.end())
        all.fault("the file ends without $" + name +
                  ": it is cut off, or nothing is meshed");
      return found->second;
    }



    std::int64_t
    MeshReader::announced(const Part        &part,
                          const std::size_t  i,
                          const std::string &things,
                          const unsigned int lines_each)
    {
      const std::int64_t n = part.lines.integer(i, "a count of " + things, 0);
      if (n > part.n_lines / lines_each)
        part.lines.fault(std::to_string(n) + " " + things +
                         " are announced, more than the section has lines (" +
                         std::to_string(part.n_lines) + ")");
      return n;
    }



    void
    MeshReader::go_on(Part &part, const std::string &due)
    {
      if (!part.lines.next())
        part.lines.fault("the section ends after this line, where " + due +
                         " is due");
    }



    void
    MeshReader::expect_end(Part &part)
    {
      if (part.lines.next())
        part.lines.fault(shown(part.lines.current) +
                         " stands after what the section's counts announce");
    }



    void
    MeshReader::read_names()
    {
      if (parts.count("PhysicalNames") == 0)
        return;
      Part  &part  = this->part("PhysicalNames");
      Lines &lines = part.lines;
      go_on(part, "the count of names");
      lines.expect(1, "the count of names");
      const auto n = announced(part, 0, "names");
      for (std::int64_t i = 0; i < n; ++i)
        {
          go_on(part, "name " + std::to_string(i + 1));
          const auto open = lines.current.find('"');
          if (lines.words.size() < 3 || open == std::string_view::npos ||
              lines.words[2][0] != '"' || lines.current.back() != '"' ||
              lines.current.size() < open + 2)
            lines.fault(shown(lines.current) +
                        " is not a dimension, a tag and a name in quotes");
          if (std::any_of(lines.current.begin(),
                          lines.current.end(),
                          [](const unsigned char c) {
                            return c < ' ' || c == 127;
                          }))
            lines.fault(shown(lines.current) +
                        " has bytes that are no letters ('?')");
          const int dimension = lines.integer(0, "a dimension (0 to 3)", 0, 3);
          const int tag       = lines.integer(1, "a physical tag", 1, tags_end);
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
      expect_end(part);
    }



    void
    MeshReader::read_entities()
    {
      if (!in_blocks || parts.count("Entities") == 0)
        return;
      Part &part = this->part("Entities");
      go_on(part, "four counts");
      part.lines.expect(4, "counts of points, curves, surfaces, volumes");
      std::array<std::int64_t, 4> n{};
      for (int d = 0; d < 4; ++d)
        n[d] = announced(part, d, entity_name(d) + "s");
      for (int d = 0; d < 4; ++d)
        for (std::int64_t i = 0; i < n[d]; ++i)
          {
            go_on(part, entity_name(d) + " " + std::to_string(i + 1));
            read_entity(part.lines, d);
          }
      expect_end(part);
    }



    /// A line is the tag, a box (of points their place), a count of
    /// physical groups, their tags, and but for points a count of what bounds
    /// it, and the tags of these.
    void
    MeshReader::read_entity(const Lines &at, const int dimension)
    {
      const std::string  name = entity_name(dimension);
      const std::size_t  head = dimension == 0 ? 4 : 7;
      const std::int64_t tag = at.integer(0, "the tag of a " + name, -tags_end);
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
        at.fault("the " + name + " " + std::to_string(tag) + " is in " +
                   std::to_string(n) + " physical groups",
                 "Let each curve and surface be in one.");
      if (!group_of_entity.insert({{dimension, tag}, group}).second)
        at.fault("a second " + name + " " + std::to_string(tag));
    }



    void
    MeshReader::add_node(const Lines       &at,
                         const std::int64_t number,
                         const std::size_t  first_word)
    {
      const auto [it, is_new] =
        place_of_node.insert({number, file.nodes.size()});
      if (!is_new)
        at.fault("a second node " + std::to_string(number) +
                 "; the first is in line " +
                 std::to_string(file.nodes[it->second].line));
      GmshFile::Node node;
      for (unsigned int d = 0; d < 3; ++d)
        node.position[d] = at.number(first_word + d, "a coordinate");
      node.line = at.line;
      file.nodes.push_back(node);
    }



    void
    MeshReader::read_nodes()
    {
      Part &part = this->part("Nodes");
      go_on(part, "the count of nodes");
      if (in_blocks)
        {
          read_nodes_in_blocks(part);
          return;
        }
      part.lines.expect(1, "the count of nodes");
      const auto n = announced(part, 0, "nodes");
      for (std::int64_t i = 0; i < n; ++i)
        {
          go_on(part, "node " + std::to_string(i + 1));
          part.lines.expect(4, "a node's number, x, y, z");
          add_node(part.lines, part.lines.integer(0, "a node's number", 1), 1);
        }
      expect_end(part);
    }



    void
    MeshReader::read_nodes_in_blocks(Part &part)
    {
      Lines      &lines = part.lines;
      const Lines head  = lines;
      lines.expect(4, "counts of blocks and nodes");
      const auto n_blocks = announced(part, 0, "blocks"),
                 n        = announced(part, 1, "nodes");
      for (std::int64_t block = 0; block < n_blocks; ++block)
        {
          go_on(part, "block " + std::to_string(block + 1));
          lines.expect(4, "a block's dimension, tag, 0 or 1, count of nodes");
          const auto dimension = lines.integer(0, "a dimension (0 to 3)", 0, 3);
          lines.integer(1, "a tag", -tags_end, tags_end);
          // Parameters, one for each dimension, may stand behind coordinates.
          const auto parameters =
            dimension * lines.integer(2, "0 or 1 (with parameters)", 0, 1);
          const auto                count = announced(part, 3, "nodes", 2);
          std::vector<std::int64_t> numbers;
          for (std::int64_t i = 0; i < count; ++i)
            {
              go_on(part, "a node's number");
              lines.expect(1, "a node's number");
              numbers.push_back(lines.integer(0, "a node's number", 1));
            }
          for (const std::int64_t number : numbers)
            {
              go_on(part, "a node");
              lines.expect(3 + parameters,
                           "x, y, z, and parameters if announced");
              add_node(lines, number, 0);
            }
        }
      if (file.nodes.size() != static_cast<std::size_t>(n))
        head.fault(std::to_string(n) +
                   " nodes are announced, but the blocks "
                   "have " +
                   std::to_string(file.nodes.size()));
      expect_end(part);
    }



    void
    MeshReader::add_element(const Lines      &at,
                            const int         type,
                            const int         group,
                            const std::size_t first_word)
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
          at.expect(first_word + size->second,
                    std::to_string(size->second) +
                      " of them nodes, as elements of type " +
                      std::to_string(type) + " have");
          for (std::size_t i = 0; i < size->second; ++i)
            {
              const std::int64_t node =
                at.integer(first_word + i, "a node's number", 1);
              const auto found = place_of_node.find(node);
              if (found == place_of_node.end())
                at.fault("element " + std::to_string(number) + " has node " +
                         std::to_string(node) + ", which $Nodes has not");
              const auto end = element.nodes.begin() + i;
              if (std::find(element.nodes.begin(), end, found->second) != end)
                at.fault("element " + std::to_string(number) + " has node " +
                         std::to_string(node) + " twice");
              element.nodes[i] = found->second;
            }
        }
      file.elements.push_back(element);
    }



    void
    MeshReader::read_elements()
    {
      Part  &part  = this->part("Elements");
      Lines &lines = part.lines;
      go_on(part, "the count of elements");
      if (in_blocks)
        {
          read_elements_in_blocks(part);
          return;
        }
      lines.expect(1, "the count of elements");
      const auto n = announced(part, 0, "elements");
      for (std::int64_t i = 0; i < n; ++i)
        {
          go_on(part, "element " + std::to_string(i + 1));
          const int  type = lines.integer(1, "a type of element", 1, tags_end);
          const auto tags =
            lines.integer(2, "a count of tags", 0, lines.words.size());
          // The first tag is the physical one; the others are not ours.
          const int group =
            tags == 0 ?
              0 :
              std::abs(lines.integer(3, "a physical tag", -tags_end, tags_end));
          for (std::int64_t k = 1; k < tags; ++k)
            lines.integer(3 + k, "a tag", -tags_end, tags_end);
          add_element(lines, type, group, 3 + tags);
        }
      expect_end(part);
    }



    void
    MeshReader::read_elements_in_blocks(Part &part)
    {
      static const std::map<int, int> dimensions{{GmshFile::line_type, 1},
                                                 {GmshFile::triangle, 2},
                                                 {GmshFile::quadrilateral, 2},
                                                 {GmshFile::point, 0}};
      Lines                          &lines = part.lines;
      const Lines                     head  = lines;
      lines.expect(4, "counts of blocks and elements");
      const auto n_blocks = announced(part, 0, "blocks"),
                 n        = announced(part, 1, "elements");
      for (std::int64_t block = 0; block < n_blocks; ++block)
        {
          go_on(part, "block " + std::to_string(block + 1));
          lines.expect(4, "a block's dimension, tag, type, count of elements");
          const int  dimension = lines.integer(0, "a dimension (0 to 3)", 0, 3);
          const auto tag       = lines.integer(1, "a tag", -tags_end, tags_end);
          const int  type  = lines.integer(2, "a type of element", 1, tags_end);
          const auto count = announced(part, 3, "elements");
          const auto fits  = dimensions.find(type);
          if (fits != dimensions.end() && fits->second != dimension)
            lines.fault("a " + entity_name(dimension) +
                        " has no elements of type " + std::to_string(type));
          const auto group = group_of_entity.find({dimension, tag});
          if (group == group_of_entity.end() && parts.count("Entities") == 1)
            lines.fault("$Entities has no " + entity_name(dimension) + " " +
                        std::to_string(tag));
          for (std::int64_t i = 0; i < count; ++i)
            {
              go_on(part, "an element");
              add_element(lines,
                          type,
                          group == group_of_entity.end() ? 0 : group->second,
                          1);
            }
        }
      if (file.elements.size() != static_cast<std::size_t>(n))
        head.fault(std::to_string(n) +
                   " elements are announced, but the "
                   "blocks have " +
                   std::to_string(file.elements.size()));
      expect_end(part);
    }
  } // namespace



  GmshFile
  read_gmsh_file(const std::string &text, const Entry &entry)
  {
    return MeshReader(text, entry).read();
  }
} // namespace lamella
