// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/scene/scene_text.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace lamella
{
  namespace
  {
    /// @p text with runs of white space as single spaces.
    std::string
    collapsed(const std::string &text)
    {
      std::istringstream words(text);
      std::string        word, result;
      while (words >> word)
        result += (result.empty() ? "" : " ") + word;
      return result;
    }



    /// Everything up to the last slash: the subsection of an entry.
    std::string
    parent(const std::string &path)
    {
      const auto slash = path.rfind('/');
      return slash == std::string::npos ? "" : path.substr(0, slash);
    }



    std::string
    last_part(const std::string &path)
    {
      const auto slash = path.rfind('/');
      return slash == std::string::npos ? path : path.substr(slash + 1);
    }



    bool
    contains(const std::vector<SceneText::Entry> &items,
             const std::string                   &path)
    {
      return std::any_of(items.begin(), items.end(), [&path](const auto &item) {
        return item.path == path;
      });
    }



    /// The names of those of @p items that stand in the subsection @p path.
    std::vector<std::string>
    children(const std::vector<SceneText::Entry> &items,
             const std::string                   &path)
    {
      std::vector<std::string> names;
      for (const SceneText::Entry &item : items)
        if (parent(item.path) == path)
          names.push_back(last_part(item.path));
      return names;
    }



    void
    refuse_repetition(const std::vector<SceneText::Entry> &items,
                      const std::string                   &kind,
                      const std::string                   &file)
    {
      for (auto a = items.begin(); a != items.end(); ++a)
        for (auto b = std::next(a); b != items.end(); ++b)
          if (a->path == b->path)
            throw InputError(
              file + ":" + std::to_string(b->line) + ": " + kind + " " +
              a->path + " was given already in line " +
              std::to_string(a->line) + ". Keep one of the two.");
    }



    /// The entry that PATH=VALUE of --set means.
    SceneText::Entry
    override_entry(const std::string &assignment)
    {
      const auto equals = assignment.find('=');
      if (equals == std::string::npos || equals == 0)
        throw InputError("--set " + assignment +
                         ": write SUBSECTION/ENTRY=VALUE, as in "
                         "\"Body upper/Kinematics/Theory=LE-3\".");
      std::vector<std::string> parts = split(assignment.substr(0, equals), '/');
      for (std::string &part : parts)
        part = collapsed(part);
      return {joined(parts, "/"), trimmed(assignment.substr(equals + 1)), 0};
    }
  } // namespace



  SceneText::SceneText(const std::string              &text,
                       const std::string              &file,
                       const std::vector<std::string> &overrides)
    : file(file)
  {
    scan(text, file, entries, subsections);
    refuse_repetition(entries, "entry", file);
    refuse_repetition(subsections, "subsection", file);
    if (entries.empty())
      throw InputError(file + ": the scene is empty. `lamella "
                              "--print-parameters` prints what it may say.");
    for (const std::string &assignment : overrides)
      {
        const Entry entry = override_entry(assignment);
        const auto  old   = std::find_if(entries.begin(),
                                      entries.end(),
                                      [&entry](const Entry &e) {
                                        return e.path == entry.path;
                                      });
        if (old != entries.end())
          *old = entry;
        else
          entries.push_back(entry);
        for (std::string path = parent(entry.path); !path.empty();
             path             = parent(path))
          if (!has_subsection(path))
            subsections.push_back({path, "", 0});
      }
  }



  std::string
  SceneText::text() const
  {
    std::string result;
    for (const Entry &entry : entries)
      {
        const std::vector<std::string> parts = split(entry.path, '/');
        for (unsigned int i = 0; i + 1 < parts.size(); ++i)
          result += "subsection " + parts[i] + "\n";
        result += "set " + parts.back() + " = " + entry.value + "\n";
        for (unsigned int i = 0; i + 1 < parts.size(); ++i)
          result += "end\n";
      }
    return result;
  }



  std::string
  SceneText::folder() const
  {
    return std::filesystem::path(file).parent_path().string();
  }



  bool
  SceneText::has_subsection(const std::string &path) const
  {
    return std::any_of(subsections.begin(),
                       subsections.end(),
                       [&path](const Entry &s) { return s.path == path; });
  }



  SceneText
  SceneText::read(const std::string              &file,
                  const std::vector<std::string> &overrides)
  {
    std::ifstream      input(file);
    std::ostringstream text;
    text << input.rdbuf();
    if (!input || std::filesystem::is_directory(file))
      throw InputError(file + ": cannot read this scene file. Check its name "
                              "and that it may be read.");
    return SceneText(text.str(), file, overrides);
  }



  void
  SceneText::scan(const std::string  &text,
                  const std::string  &file,
                  std::vector<Entry> &entries,
                  std::vector<Entry> &subsections)
  {
    std::istringstream        lines(text);
    std::string               line;
    std::vector<std::string>  path;
    std::vector<unsigned int> opened;
    unsigned int              number = 0;
    const auto                full   = [&path](const std::string &name) {
      return joined(path, "/") + (path.empty() ? "" : "/") + name;
    };
    while (std::getline(lines, line))
      {
        const unsigned int first = ++number;
        // A backslash at the end continues the line.
        std::string next;
        line = trimmed(line);
        while (!line.empty() && line.back() == '\\' &&
               std::getline(lines, next))
          {
            ++number;
            line = line.substr(0, line.size() - 1) + trimmed(next);
          }
        line                   = trimmed(line.substr(0, line.find('#')));
        const std::string word = line.substr(0, line.find_first_of(" \t"));
        const std::string rest = collapsed(line.substr(word.size()));
        if (word.empty())
          continue;
        if (word == "subsection" && !rest.empty())
          {
            subsections.push_back({full(rest), "", first});
            path.push_back(rest);
            opened.push_back(first);
          }
        else if (word == "end" && rest.empty() && !path.empty())
          {
            path.pop_back();
            opened.pop_back();
          }
        else if (const auto equals = rest.find('=');
                 word == "set" && equals != std::string::npos)
          entries.push_back({full(trimmed(rest.substr(0, equals))),
                             trimmed(rest.substr(equals + 1)),
                             first});
        else
          throw InputError(file + ":" + std::to_string(first) + ": '" + line +
                           "' is not understood. A line is 'subsection NAME', "
                           "'set ENTRY = VALUE' or the 'end' of an open "
                           "subsection; '#' begins a comment.");
      }
    if (!path.empty())
      throw InputError(file + ":" + std::to_string(opened.back()) +
                       ": subsection " + path.back() + " has no 'end'.");
  }



  std::string
  SceneText::place(const Entry &entry) const
  {
    return entry.line == 0 ? "--set: " :
                             file + ":" + std::to_string(entry.line) + ": ";
  }



  void
  SceneText::check_declared(const dealii::ParameterHandler &prm,
                            const bool top_level_only) const
  {
    // What is declared, in the one form that ParameterHandler gives it in.
    std::ostringstream declared_text;
    prm.print_parameters(declared_text,
                         dealii::ParameterHandler::ShortText |
                           dealii::ParameterHandler::KeepDeclarationOrder);
    std::vector<Entry> declared, declared_subsections;
    scan(declared_text.str(), "", declared, declared_subsections);

    for (const Entry &item : subsections)
      if (!top_level_only && !contains(declared_subsections, item.path))
        fail_on_subsection(item, declared_subsections);
    for (const Entry &item : entries)
      if ((!top_level_only || parent(item.path).empty()) &&
          !contains(declared, item.path))
        {
          const std::string where =
            parent(item.path).empty() ? "" : " in " + parent(item.path);
          const std::string nearest =
            nearest_name(last_part(item.path),
                         children(declared, parent(item.path)));
          throw InputError(
            place(item) + "there is no entry '" + last_part(item.path) + "'" +
            where +
            (nearest.empty() ? "." : "; the nearest is '" + nearest + "'."));
        }
  }



  void
  SceneText::fail_on_subsection(const Entry              &item,
                                const std::vector<Entry> &declared) const
  {
    // Nearest among those of the same kind: `Body uper` is no `Probe`.
    const std::string        name = last_part(item.path);
    const std::string        kind = name.substr(0, name.find(' '));
    std::vector<std::string> alike;
    for (const std::string &other : children(declared, parent(item.path)))
      if (!parent(item.path).empty() ||
          other.compare(0, kind.size() + 1, kind + " ") == 0)
        alike.push_back(other);
    const std::string nearest = nearest_name(name, alike);
    const bool        nested  = !parent(item.path).empty();
    throw InputError(
      place(item) + "there is no subsection '" + name + "'" +
      (nested ? " in " + parent(item.path) : "") +
      (nearest.empty() ? "." : "; the nearest is '" + nearest + "'.") +
      (nested ? "" :
                " A subsection's name must stand in its list (Materials, "
                "Sections, Bodies, ...) first."));
  }



  std::string
  SceneText::place_of(const std::string &message) const
  {
    // The longest path that the message begins with, as a whole.
    const Entry *best = nullptr;
    for (const std::vector<Entry> *items : {&entries, &subsections})
      for (const Entry &item : *items)
        if (message.compare(0, item.path.size(), item.path) == 0 &&
            std::string("/ :").find(message[item.path.size()]) !=
              std::string::npos &&
            (best == nullptr || item.path.size() > best->path.size()))
          best = &item;
    return best == nullptr ? file + ": " : place(*best);
  }
} // namespace lamella
