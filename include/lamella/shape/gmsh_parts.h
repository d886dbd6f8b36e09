// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_gmsh_parts_h
#define lamella_shape_gmsh_parts_h

#include <lamella/base/entry.h>

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace lamella
{
  /**
   * The lines of a text from some place on, one after the other; those of
   * white space are left out. It also judges the words of the line that it
   * stands at, and says where that is. Refers to the text.
   */
  struct GmshLines
  {
    /// Helps against most faults.
    static constexpr const char *anew =
      "Write the file anew with 'gmsh -2 NAME.geo -format msh41 -o NAME.msh'.";

    GmshLines(const std::string_view text, const Entry &entry)
      : rest(text)
      , entry(entry)
    {}

    /// @p word between quotes, short and without bytes that no console shows.
    static std::string
    shown(const std::string_view word);

    /// Goes on to the next line; false if there is none.
    bool
    next();

    /// Throws InputError, of this line.
    [[noreturn]] void
    fault(const std::string &rule, const std::string &remedy = anew) const;

    /// Throws unless there are @p n words; @p meaning says which.
    void
    expect(const std::size_t n, const std::string &meaning) const;

    /// Word @p i, a whole number.
    std::int64_t
    integer(const std::size_t  i,
            const std::string &meaning,
            const std::int64_t lowest,
            const std::int64_t highest =
              std::numeric_limits<std::int64_t>::max()) const;

    /// Word @p i, a finite number.
    double
    number(const std::size_t i, const std::string &meaning) const;

    std::string_view rest;
    /// Names the file.
    const Entry                  &entry;
    std::string_view              current;
    std::vector<std::string_view> words;
    /// Counted from 1.
    unsigned int line = 0;
  };



  /// A part of the file between `$NAME` and `$EndNAME`.
  struct GmshPart
  {
    /// A number of @p things that word @p i of the line announces, each in
    /// @p lines_each lines.
    std::int64_t
    announced(const std::size_t  i,
              const std::string &things,
              const unsigned int lines_each = 1) const;

    /// Goes on to the next line, which a count announced.
    void
    go_on(const std::string &due);

    /// Throws if anything follows.
    void
    expect_end();

    /// Stands at `$NAME`; what follows ends with the part.
    GmshLines lines;
    /// That are not of white space.
    unsigned int n_lines = 0;
  };



  /// What a mesh by Gmsh is cut into, whatever the order of its parts. Those
  /// that a section has no use for are passed over.
  class GmshParts
  {
  public:
    /// Throws InputError of @p entry unless @p text is a file of format 4.1 or
    /// 2.2 as text, each of whose parts ends and comes once. Refers to both.
    GmshParts(const std::string &text, const Entry &entry);

    /// As nodes and elements stand in version 4.1; in 2.2 each by itself.
    bool
    in_blocks() const
    {
      return is_in_blocks;
    }

    bool
    has(const std::string &name) const
    {
      return parts.count(name) == 1;
    }

    /// The part @p name, which must be there.
    GmshPart &
    part(const std::string &name);

  private:
    void
    read_format();

    /// Looks where each part begins and ends.
    void
    find_parts();

    void
    add_part();

    /// Throws if there is a part @p name already.
    void
    expect_first(const std::string &name) const;

    /// The part @p name, at whose `$NAME` the lines stand; they go on to its
    /// end. Parts that are not @p wanted may hold anything.
    GmshPart
    part_to_end(const std::string &name, const bool wanted);

    GmshLines                       all;
    bool                            is_in_blocks = false;
    std::map<std::string, GmshPart> parts;
  };
} // namespace lamella

#endif
