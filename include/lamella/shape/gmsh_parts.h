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
  /// Iterator over the nonblank lines of a Gmsh file, for parsing with the line
  /// number in error messages. The text must outlive this object.
  struct GmshLines
  {
    /// Advice at the end of most error messages: how to write the file again.
    static constexpr const char *anew =
      "Write the file anew with 'gmsh -2 NAME.geo -format msh41 -o NAME.msh'.";

    /// Reads @p text, the contents of the file named in @p entry.
    GmshLines(const std::string_view text, const Entry &entry)
      : rest(text)
      , entry(entry)
    {}

    /// Returns @p word as shown in messages: quoted, short and printable.
    static std::string
    shown(const std::string_view word);

    /// Advances to the next nonblank line. Returns false if there is none.
    bool
    next();

    /// Throws InputError with the number of the current line: @p rule says what
    /// is wrong, @p remedy what the user can do.
    [[noreturn]] void
    fault(const std::string &rule, const std::string &remedy = anew) const;

    /// Throws InputError unless the current line has @p n words, separated by
    /// blanks. @p meaning describes these words in the message.
    void
    expect(const std::size_t n, const std::string &meaning) const;

    /// Returns word @p i of the current line as an integer from @p lowest to @p
    /// highest. Throws InputError for other text, with @p meaning as its name.
    std::int64_t
    integer(const std::size_t  i,
            const std::string &meaning,
            const std::int64_t lowest,
            const std::int64_t highest =
              std::numeric_limits<std::int64_t>::max()) const;

    /// Returns word @p i of the current line as a finite number. Throws
    /// InputError for other text, with @p meaning as its name.
    double
    number(const std::size_t i, const std::string &meaning) const;

    std::string_view rest;    ///< Text after the current line.
    const Entry     &entry;   ///< Entry whose text is the file name.
    std::string_view current; ///< Current line, without outer blanks.
    std::vector<std::string_view> words; ///< Words of the current line.
    unsigned int line = 0; ///< Number of the current line, from 1.
  };



  /// A section of a Gmsh file, from `$NAME` to `$EndNAME`.
  struct GmshPart
  {
    /// Returns word @p i of the current line as the number of items that
    /// follow, named @p things in messages (e.g. nodes). Throws InputError if
    /// the section has fewer than @p lines_each lines per item.
    std::int64_t
    announced(const std::size_t  i,
              const std::string &things,
              const unsigned int lines_each = 1) const;

    /// Advances to the next line. Throws InputError if the section has no more
    /// lines; @p due names the missing item in the message.
    void
    next_line(const std::string &due);

    /// Throws InputError if this section has further lines.
    void
    expect_end();

    /// Iterator over the lines after `$NAME` up to the end of the section.
    GmshLines    lines;
    unsigned int n_lines = 0; ///< Number of nonblank lines of the section.
  };



  /// The sections `$NAME ... $EndNAME` of a Gmsh file, in any order.
  class GmshParts
  {
  public:
    /// Splits @p text into sections. Both arguments must outlive this object.
    /// Throws InputError for @p entry unless the text has the ASCII format 4.1
    /// and each section is complete and occurs only once.
    GmshParts(const std::string &text, const Entry &entry);

    /// Returns true if the file has the section `$NAME` with @p name.
    bool
    has(const std::string &name) const
    {
      return parts.count(name) == 1;
    }

    /// Returns the section `$NAME` with @p name, which must exist.
    GmshPart &
    part(const std::string &name);

  private:
    void
    read_format();

    /// Finds the start and end of each section.
    void
    find_parts();

    void
    add_part();

    /// Throws InputError if a section @p name has already been found.
    void
    expect_first(const std::string &name) const;

    /// Returns the section @p name, which begins at the current line, and
    /// advances to its end. If @p wanted is false, it may have any text.
    GmshPart
    part_to_end(const std::string &name, const bool wanted);

    GmshLines                       all;
    std::map<std::string, GmshPart> parts;
  };
} // namespace lamella

#endif
