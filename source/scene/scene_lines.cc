// SPDX-License-Identifier: LGPL-2.1-or-later

// Parsing of the lines of a scene (SceneText::scan()).

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/scene/scene_text.h>

#include <algorithm>
#include <sstream>

namespace lamella
{
  std::string
  collapsed(const std::string &text)
  {
    std::istringstream words(text);
    std::string        word, result;
    while (words >> word)
      result += (result.empty() ? "" : " ") + word;
    return result;
  }



  std::string
  line_prefix(const std::string &file, const unsigned int line)
  {
    return file + ":" + std::to_string(line) + ": ";
  }



  namespace
  {
    /// Returns the number of bytes of the UTF-8 character at @p i of @p text; 0
    /// if it is invalid or a terminal control character.
    std::size_t
    length_of_character(const std::string &text, const std::size_t i)
    {
      const auto byte = [&text](const std::size_t k) {
        return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u;
      };
      const unsigned int first = byte(i);
      if (first < 0x80)
        return first >= 0x20 ? first != 0x7f :
                               first == '\t' || first == '\n' || first == '\r';
      const std::size_t n = first >= 0xc2 && first < 0xe0 ? 2 :
                            first >= 0xe0 && first < 0xf0 ? 3 :
                            first >= 0xf0 && first < 0xf5 ? 4 :
                                                            0;
      for (std::size_t k = 1; k < n; ++k)
        if ((byte(i + k) & 0xc0) != 0x80)
          return 0;
      return n;
    }



    /// Returns the position of the comment of @p line (`\#` is none), or npos.
    std::size_t
    begin_of_comment(const std::string &line)
    {
      for (std::size_t i = 0; i < line.size(); ++i)
        if (line[i] == '#' && (i == 0 || line[i - 1] != '\\'))
          return i;
      return std::string::npos;
    }



    /// Appends continuation lines of @p lines to @p line, counts them in @p
    /// number, and removes the comment. Returns whether there was one. Throws
    /// InputError at @p place if the comment ends with a backslash.
    bool
    complete(std::string       &line,
             std::istream      &lines,
             unsigned int      &number,
             const std::string &place)
    {
      line = trimmed(line);
      while (!line.empty() && line.back() == '\\')
        {
          if (begin_of_comment(line) != std::string::npos)
            throw InputError("scene.continued-comment: a comment ends with a "
                             "backslash, which would make the next line a part "
                             "of the comment. Remove the backslash, or write "
                             "text after the backslash.")
              .at(place);
          std::string next;
          std::getline(lines, next);
          ++number;
          next = trimmed(next);
          if ((next.compare(0, 4, "set ") == 0 &&
               next.find('=') != std::string::npos) ||
              next.compare(0, 11, "subsection ") == 0)
            throw InputError("scene.continued-line: the line ends with a "
                             "backslash, which joins the next line, '" +
                             next + "', to this line. Remove the backslash.")
              .at(place);
          line = line.substr(0, line.size() - 1) + next;
        }
      const std::size_t comment = begin_of_comment(line);
      line = replaced(trimmed(line.substr(0, comment)), "\\#", "#");
      return comment != std::string::npos;
    }



    /// Throws InputError if a name in @p rest of @p line has a '/'.
    void
    check_slashes(const std::string &line,
                  const std::string &word,
                  const std::string &rest,
                  const std::string &here)
    {
      if ((word == "subsection" || word == "set") &&
          rest.substr(0, rest.find('=')).find('/') != std::string::npos)
        throw InputError("scene.slash-in-name: '" + line +
                         "' has a '/' in a name. In a file, nest subsections; "
                         "'/' separates subsections in --set only.")
          .at(here);
    }



    /// Throws InputError if a comment hides the value of @p entry.
    void
    check_value(const SceneText::Item &entry,
                const bool             has_comment,
                const std::string     &here)
    {
      if (entry.value.empty() && has_comment)
        throw InputError(entry.path,
                         "",
                         "scene.value-in-comment: no value before '#'",
                         "Write the value before '#', write '\\#' for a '#' "
                         "that is part of the value, or remove the entry.")
          .at(here);
    }



    [[noreturn]] void
    refuse_scene_line(const std::string &line, const std::string &here)
    {
      throw InputError(
        "scene.invalid-line: '" + line +
        "' is not understood. A line is 'subsection NAME', 'set ENTRY = VALUE' "
        "or the 'end' of an open subsection; '#' begins a comment.")
        .at(here);
    }



    /// Open subsections at a line: names, and lines where they were opened.
    struct OpenSubsections
    {
      std::vector<std::string>  names;
      std::vector<unsigned int> lines;

      /// Returns the path of the item @p name in the innermost subsection.
      std::string
      path_of(const std::string &name) const
      {
        return joined(names, "/") + (names.empty() ? "" : "/") + name;
      }

      void
      open(const std::string &name, const unsigned int line)
      {
        names.push_back(name);
        lines.push_back(line);
      }

      void
      close()
      {
        names.pop_back();
        lines.pop_back();
      }

      /// Throws InputError if a subsection is open at the end of @p file.
      void
      check_end(const std::string &file) const
      {
        if (!names.empty())
          throw InputError("scene.missing-end: the subsection " + names.back() +
                           " has no 'end'. Write 'end' after its entries.")
            .at(line_prefix(file, lines.back()));
      }
    };
  } // namespace



  std::string
  checked_bytes(const std::string &text, const std::string &file)
  {
    const auto begins = [&text](const char *mark) {
      return text.rfind(mark, 0) == 0;
    };
    if (begins("\xff\xfe") || begins("\xfe\xff"))
      throw InputError("scene.utf-16: the scene file is text in the encoding "
                       "UTF-16. Save it as UTF-8 (or ASCII).")
        .at(file + ": ");
    std::string result = begins("\xef\xbb\xbf") ? text.substr(3) : text;
    for (std::size_t i = 0; i < result.size();)
      {
        const std::size_t n = length_of_character(result, i);
        if (n == 0)
          throw InputError(
            "scene.not-utf-8: the line has a character that is not valid "
            "UTF-8. Save the file as UTF-8 (or ASCII), or type the line again.")
            .at(line_prefix(
              file, 1 + std::count(result.begin(), result.begin() + i, '\n')));
        i += n;
      }
    return result;
  }



  void
  SceneText::scan(const std::string &text,
                  const std::string &file,
                  std::vector<Item> &entries,
                  std::vector<Item> &subsections)
  {
    std::istringstream lines(text);
    std::string        line;
    OpenSubsections    inside;
    unsigned int       number = 0;
    while (std::getline(lines, line))
      {
        const unsigned int first       = ++number;
        const std::string  here        = line_prefix(file, first);
        const bool         has_comment = complete(line, lines, number, here);
        const std::string  word = line.substr(0, line.find_first_of(" \t"));
        const std::string  rest = collapsed(line.substr(word.size()));
        if (word.empty())
          continue;
        check_slashes(line, word, rest, here);
        if (word == "subsection" && !rest.empty())
          {
            subsections.push_back({inside.path_of(rest), "", first});
            inside.open(rest, first);
          }
        else if (word == "end" && rest.empty() && !inside.names.empty())
          inside.close();
        else if (const auto equals = rest.find('=');
                 word == "set" && equals != std::string::npos &&
                 !trimmed(rest.substr(0, equals)).empty())
          {
            entries.push_back({inside.path_of(trimmed(rest.substr(0, equals))),
                               trimmed(rest.substr(equals + 1)),
                               first});
            check_value(entries.back(), has_comment, here);
          }
        else
          refuse_scene_line(line, here);
      }
    inside.check_end(file);
  }



  std::string
  new_name(const std::string &path)
  {
    constexpr const char *renamed[][3] = {
      {"Body", "Elements", "Kinematics/Axis elements"},
      {"Body", "Hold", "Isostatic support"},
      {"Body", "Isostatic", "Isostatic support"},
      {"Body", "Stabilisation", "Stabilization"},
      {"Contact", "Discretisation", "Discretization"},
      {"Contact", "Points on", "Slave side"},
      {"Load", "Delta T", "Temperature"},
      {"Load", "Moment", "Couple"},
      {"Load", "Torque", "Couple"},
      {"Material", "E", "Isotropic"},
      {"Material", "Expansion", "Thermal expansion"},
      {"Measure", "Of", "Difference"},
      {"Measure", "Over", "Divided by"},
      {"Section", "Fibre angle", "Fiber angle"},
      {"Strength", "Leave out", "Excluded boxes"},
      {"Trade", "Ladder", "Variants"}};
    const std::string kind = path.substr(0, path.find_first_of(" /"));
    for (const auto &[subsection, before, now] : renamed)
      if (kind == subsection && path.substr(path.rfind('/') + 1) == before)
        return now;
    return "";
  }
} // namespace lamella
