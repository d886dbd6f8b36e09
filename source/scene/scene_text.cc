// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/scene/scene_text.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace lamella
{
  namespace
  {
    /// @p text with runs of white space as single spaces, as ParameterHandler
    /// reads names.
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



    /// The lines of a scene that set PATH=VALUE.
    std::string
    override_text(const std::string &assignment)
    {
      const auto equals = assignment.find('=');
      if (equals == std::string::npos || equals == 0)
        throw InputError("--set " + assignment +
                         ": write SUBSECTION/ENTRY=VALUE, as in "
                         "\"Body upper/Kinematics/Theory=LE-3\".");
      const auto  parts = split(assignment.substr(0, equals), '/');
      std::string text;
      for (unsigned int i = 0; i + 1 < parts.size(); ++i)
        text += "subsection " + parts[i] + "\n";
      text +=
        "set " + parts.back() + " = " + assignment.substr(equals + 1) + "\n";
      for (unsigned int i = 0; i + 1 < parts.size(); ++i)
        text += "end\n";
      return text;
    }
  } // namespace



  SceneText::SceneText(const std::string              &text,
                       const std::string              &file,
                       const std::vector<std::string> &overrides)
    : file(file)
    , full_text(text + "\n")
  {
    scan(text, file, entries, subsections);
    refuse_repetition(entries, "entry", file);
    refuse_repetition(subsections, "subsection", file);
    if (entries.empty())
      throw InputError(file + ": the scene is empty. `lamella "
                              "--print-parameters` prints what it may say.");
    for (const std::string &assignment : overrides)
      {
        const std::string  lines = override_text(assignment);
        std::vector<Entry> more, more_subsections;
        scan(lines, "--set " + assignment, more, more_subsections);
        for (std::vector<Entry> *items : {&more, &more_subsections})
          for (Entry &item : *items)
            item.line = 0;
        // The later one wins, also in place_of().
        entries.insert(entries.begin(), more.begin(), more.end());
        subsections.insert(subsections.end(),
                           more_subsections.begin(),
                           more_subsections.end());
        full_text += lines;
      }
  }



  SceneText
  SceneText::read(const std::string              &file,
                  const std::vector<std::string> &overrides)
  {
    std::ifstream      input(file);
    std::ostringstream text;
    text << input.rdbuf();
    if (!input)
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
        while (!line.empty() && line.back() == '\\' &&
               std::getline(lines, next))
          {
            ++number;
            line = line.substr(0, line.size() - 1) + next;
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
  SceneText::check_declared(const dealii::ParameterHandler &prm) const
  {
    // What is declared, in the one form that ParameterHandler gives it in.
    std::ostringstream declared_text;
    prm.print_parameters(declared_text,
                         dealii::ParameterHandler::ShortText |
                           dealii::ParameterHandler::KeepDeclarationOrder);
    std::vector<Entry> declared, declared_subsections;
    scan(declared_text.str(), "", declared, declared_subsections);

    const auto check = [this](const std::vector<Entry> &given,
                              const std::vector<Entry> &valid,
                              const std::string        &kind) {
      for (const Entry &item : given)
        {
          std::vector<std::string> siblings;
          bool                     known = false;
          for (const Entry &other : valid)
            {
              known = known || other.path == item.path;
              if (parent(other.path) == parent(item.path))
                siblings.push_back(last_part(other.path));
            }
          if (known)
            continue;
          const std::string where =
            parent(item.path).empty() ? "" : " in " + parent(item.path);
          const std::string nearest =
            nearest_name(last_part(item.path), siblings);
          throw InputError(
            place(item) + "there is no " + kind + " '" + last_part(item.path) +
            "'" + where +
            (nearest.empty() ? "." : "; the nearest is '" + nearest + "'.") +
            (kind == "subsection" ?
               " A subsection's name must stand in its list (Materials, "
               "Sections, Bodies, ...) first." :
               ""));
        }
    };
    check(subsections, declared_subsections, "subsection");
    check(entries, declared, "entry");
  }



  std::string
  SceneText::place_of(const std::string &message) const
  {
    // The longest path that the message begins with.
    const Entry *best = nullptr;
    for (const std::vector<Entry> *items : {&entries, &subsections})
      for (const Entry &item : *items)
        if (message.compare(0, item.path.size(), item.path) == 0 &&
            (best == nullptr || item.path.size() > best->path.size()))
          best = &item;
    return best == nullptr ? file + ": " : place(*best);
  }
} // namespace lamella
