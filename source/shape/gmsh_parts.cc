// SPDX-License-Identifier: LGPL-2.1-or-later

// GridIn of deal.II trusts these files word by word: a missing coordinate
// shifts all that follows; a node number of -1 or a count of 4e9 ends the
// program. Gmsh's own library is no safer. This reader checks each line.

#include <lamella/base/text.h>
#include <lamella/shape/gmsh_file.h>
#include <lamella/shape/gmsh_parts.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <set>

namespace lamella
{
  namespace
  {
    /// Largest length: fourth powers, and their products, stay within doubles.
    constexpr double longest = 1e30;
  } // namespace



  // ---- lines and their words

  std::string
  GmshLines::shown(const std::string_view word)
  {
    constexpr std::size_t most = 30;
    std::string           text;
    for (const char c : word.substr(0, most))
      text += c >= ' ' && c <= '~' ? c : '?';
    return "'" + text + (word.size() > most ? "..." : "") + "'";
  }



  bool
  GmshLines::next()
  {
    constexpr std::string_view white = " \t\r\v\f";
    while (!rest.empty())
      {
        const auto             end   = std::min(rest.find('\n'), rest.size());
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
            at =
              std::min(current.find_first_not_of(white, stop), current.size());
          }
        return true;
      }
    return false;
  }



  void
  GmshLines::fault(const std::string &rule, const std::string &remedy) const
  {
    refuse_line(entry,
                line,
                "shape.mesh-malformed: this line of the mesh file "
                "is not as Gmsh writes it: " +
                  rule,
                remedy);
  }



  void
  GmshLines::expect(const std::size_t n, const std::string &meaning) const
  {
    if (words.size() != n)
      fault(std::to_string(words.size()) +
            (words.size() == 1 ? " word" : " words") + " instead of " +
            std::to_string(n) + " (" + meaning + ")");
  }



  std::int64_t
  GmshLines::integer(const std::size_t  i,
                     const std::string &meaning,
                     const std::int64_t lowest,
                     const std::int64_t highest) const
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



  double
  GmshLines::number(const std::size_t i, const std::string &meaning) const
  {
    // strtod knows more: nan, inf, 0x1p3.
    const std::string word(words.at(i));
    char             *end   = nullptr;
    const double      value = std::strtod(word.c_str(), &end);
    if (word.find_first_not_of("0123456789+-.eE") != std::string::npos ||
        *end != '\0' || !(std::abs(value) <= longest))
      fault(shown(word) + " is not " + meaning);
    return value;
  }



  // ---- a part

  std::int64_t
  GmshPart::announced(const std::size_t  i,
                      const std::string &things,
                      const unsigned int lines_each) const
  {
    const std::int64_t n = lines.integer(i, "a count of " + things, 0);
    if (n > n_lines / lines_each)
      lines.fault(std::to_string(n) + " " + things +
                  " are announced, more than the section has lines (" +
                  std::to_string(n_lines) + ")");
    return n;
  }



  void
  GmshPart::next_line(const std::string &due)
  {
    if (!lines.next())
      lines.fault("the section ends after this line, where " + due + " is due");
  }



  void
  GmshPart::expect_end()
  {
    if (lines.next())
      lines.fault(lines.shown(lines.current) +
                  " stands after what the section's counts announce");
  }



  // ---- all parts

  GmshParts::GmshParts(const std::string &text, const Entry &entry)
    : all(text, entry)
  {
    read_format();
    find_parts();
  }



  void
  GmshParts::read_format()
  {
    if (all.rest.substr(0, 3) == "\xEF\xBB\xBF")
      refuse_line(all.entry,
                  1,
                  "shape.byte-order-mark: a byte order mark (EF BB BF) is at "
                  "the beginning of the mesh file",
                  "Save the file as plain ASCII, without a byte order mark.");
    if (!all.next() || (all.current != "$MeshFormat" && all.current != "$NOD"))
      all.entry.refuse("shape.not-a-mesh: this file is not a mesh file of Gmsh",
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
    if (binary || version != "4.1")
      refuse_line(all.entry,
                  all.line,
                  "shape.mesh-version: the mesh file is " +
                    (binary ? "binary" : "of version " + version) +
                    "; only text files of version 4.1 can be read",
                  "Write the mesh again with 'gmsh " + all.entry.text() +
                    " -save -format msh41 -o NEW.msh', or in Gmsh with the "
                    "option Mesh.MshFileVersion = 4.1.");
    all.integer(2, "8, the bytes of a number", 1);
    if (!all.next())
      all.fault("the file is cut off: it ends before $EndMeshFormat");
    if (all.current != "$EndMeshFormat")
      all.fault(all.shown(all.current) + " instead of $EndMeshFormat");
  }



  void
  GmshParts::find_parts()
  {
    while (all.next())
      {
        if (all.current[0] != '$')
          all.fault(all.shown(all.current) +
                    " stands between the sections of the file");
        if (all.current.substr(0, 4) == "$End")
          all.fault(all.shown(all.current) + " ends what does not begin");
        add_part();
      }
  }



  void
  GmshParts::add_part()
  {
    static const std::set<std::string> once{
      "MeshFormat", "PhysicalNames", "Entities", "Nodes", "Elements"};
    const std::string name(all.current.substr(1));
    if (name == "PartitionedEntities")
      all.fault("the mesh has partitions, and a section has none");
    const bool wanted = once.count(name) == 1;
    if (wanted)
      expect_first(name);
    GmshPart part = part_to_end(name, wanted);
    if (wanted)
      parts.emplace(name, std::move(part));
  }



  void
  GmshParts::expect_first(const std::string &name) const
  {
    const auto found = parts.find(name);
    if (found != parts.end())
      all.fault("a second $" + name + "; the first is in line " +
                std::to_string(found->second.lines.line));
    if (name == "MeshFormat")
      all.fault("a second $MeshFormat");
  }



  GmshPart
  GmshParts::part_to_end(const std::string &name, const bool wanted)
  {
    GmshPart          part{all, 0};
    const std::string end = "$End" + name;
    const std::string cut_off =
      "the file is cut off: it ends before " + all.shown(end);
    const char *const from = all.rest.data();
    while (true)
      {
        const char *const to = all.rest.data();
        if (!all.next())
          all.fault(cut_off);
        if (all.current == end)
          {
            part.lines.rest = std::string_view(from, to - from);
            return part;
          }
        if (all.rest.empty() && end.find(all.current) == 0)
          all.fault(cut_off);
        // Sections of other programs may have any text.
        if (wanted && all.current[0] == '$')
          all.fault(all.shown(all.current) + " stands inside $" + name +
                    ", which has no " + end + " before it");
        ++part.n_lines;
      }
  }



  GmshPart &
  GmshParts::part(const std::string &name)
  {
    const auto found = parts.find(name);
    if (found == parts.end())
      all.fault("the file ends without $" + name +
                ": it is cut off, or nothing is meshed");
    return found->second;
  }
} // namespace lamella
