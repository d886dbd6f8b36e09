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
  /// Iterator over the nonblank lines of a text. Parses the words of the
  /// current line and reports errors with its number. Refers to the text.
  struct GmshLines
  {
    /// Remedy for most errors.
    static constexpr const char *anew =
      "Write the file anew with 'gmsh -2 NAME.geo -format msh41 -o NAME.msh'.";

    GmshLines(const std::string_view text, const Entry &entry)
      : rest(text)
      , entry(entry)
    {}

    /// Returns @p word in quotes, shortened and without unprintable bytes.
    static std::string
    shown(const std::string_view word);

    /// Advances to the next line. Returns false if there is none.
    bool
    next();

    /// Throws InputError for this line.
    [[noreturn]] void
    fault(const std::string &rule, const std::string &remedy = anew) const;

    /// Throws InputError unless there are @p n words, described by @p meaning.
    void
    expect(const std::size_t n, const std::string &meaning) const;

    /// Returns word @p i, a whole number. Throws InputError otherwise.
    std::int64_t
    integer(const std::size_t  i,
            const std::string &meaning,
            const std::int64_t lowest,
            const std::int64_t highest =
              std::numeric_limits<std::int64_t>::max()) const;

    /// Returns word @p i, a finite number. Throws InputError otherwise.
    double
    number(const std::size_t i, const std::string &meaning) const;

    std::string_view rest;
    /// Entry that names the file.
    const Entry                  &entry;
    std::string_view              current;
    std::vector<std::string_view> words;
    /// Number of the line, from 1.
    unsigned int line = 0;
  };



  /// A part of the file between `$NAME` and `$EndNAME`.
  struct GmshPart
  {
    /// Returns the number of @p things in word @p i, @p lines_each lines each.
    std::int64_t
    announced(const std::size_t  i,
              const std::string &things,
              const unsigned int lines_each = 1) const;

    /// Advances to the next line, which a count announced.
    void
    next_line(const std::string &due);

    /// Throws InputError if there is another line.
    void
    expect_end();

    /// Lines of the part, starting at `$NAME` and ending with it.
    GmshLines lines;
    /// Number of lines that are not blank.
    unsigned int n_lines = 0;
  };



  /// Parts of a Gmsh file, in any order. Unused parts are skipped.
  class GmshParts
  {
  public:
    /// Splits @p text, referring to both arguments. Throws InputError of
    /// @p entry unless the format is text, 4.1 or 2.2, with closed and unique
    /// parts.
    GmshParts(const std::string &text, const Entry &entry);

    /// Returns whether nodes and elements are in blocks (version 4.1).
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

    /// Returns the part @p name, which must exist.
    GmshPart &
    part(const std::string &name);

  private:
    void
    read_format();

    /// Finds the start and end of each part.
    void
    find_parts();

    void
    add_part();

    /// Throws InputError if there is already a part @p name.
    void
    expect_first(const std::string &name) const;

    /// Returns the part @p name, which begins at the current line, and advances
    /// to its end. Parts that are not @p wanted are not checked.
    GmshPart
    part_to_end(const std::string &name, const bool wanted);

    GmshLines                       all;
    bool                            is_in_blocks = false;
    std::map<std::string, GmshPart> parts;
  };
} // namespace lamella

#endif
