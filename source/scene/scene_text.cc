// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/patterns.h>
#include <lamella/scene/scene_text.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace lamella
{
  namespace
  {
    /// Returns the text before the last slash: the subsection of an entry.
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



    /// Returns the one of @p items with the path @p path, if there is one.
    const SceneText::Item *
    find(const std::vector<SceneText::Item> &items, const std::string &path)
    {
      const auto item =
        std::find_if(items.begin(), items.end(), [&path](const auto &i) {
          return i.path == path;
        });
      return item == items.end() ? nullptr : &*item;
    }



    /// Returns the names of those of @p items in the subsection @p path.
    std::vector<std::string>
    children(const std::vector<SceneText::Item> &items, const std::string &path)
    {
      std::vector<std::string> names;
      for (const SceneText::Item &item : items)
        if (parent(item.path) == path)
          names.push_back(last_part(item.path));
      return names;
    }



    /// Limit above any scene; larger files are devices or results.
    constexpr std::size_t longest_scene = 1 << 24;



    /// Returns whether @p a and @p b differ by one or two letters at most.
    bool
    are_alike(const std::string &a, const std::string &b)
    {
      const std::size_t longer = std::max(a.size(), b.size()),
                        common = std::min(a.size(), b.size());
      std::size_t first = 0, last = 0;
      while (first < common && a[first] == b[first])
        ++first;
      while (last < common - first &&
             a[a.size() - 1 - last] == b[b.size() - 1 - last])
        ++last;
      return longer - first - last <= 2;
    }



    void
    refuse_repetition(const std::vector<SceneText::Item> &items,
                      const std::string                  &kind,
                      const std::string                  &file)
    {
      for (auto a = items.begin(); a != items.end(); ++a)
        for (auto b = std::next(a); b != items.end(); ++b)
          if (a->path == b->path)
            throw InputError("scene.repeated-item: " + kind + " " + a->path +
                             " is already in line " + std::to_string(a->line) +
                             " of the file. Remove one of the two.")
              .at(line_prefix(file, b->line));
    }



    /// Returns the entry of PATH=VALUE of --set.
    SceneText::Item
    override_entry(const std::string &assignment)
    {
      const auto equals = assignment.find('=');
      if (equals == std::string::npos || equals == 0)
        throw InputError(
          "scene.invalid-override: write --set SUBSECTION/ENTRY=VALUE, as in "
          "--set \"Body upper/Kinematics/Theory=LE-3\".")
          .at("--set " + assignment + ": ");
      std::vector<std::string> parts = split(assignment.substr(0, equals), '/');
      for (std::string &part : parts)
        part = collapsed(part);
      // A '#' alone begins no comment here; values are as in a file.
      return {joined(parts, "/"),
              replaced(trimmed(assignment.substr(equals + 1)), "\\#", "#"),
              0};
    }
  } // namespace



  SceneText::SceneText(const std::string              &text,
                       const std::string              &file,
                       const std::vector<std::string> &overrides)
    : file(file)
  {
    scan(checked_bytes(text, file), file, entries, subsections);
    refuse_repetition(entries, "entry", file);
    refuse_repetition(subsections, "subsection", file);
    if (entries.empty())
      throw InputError("scene.no-entries: the scene file has no entries. "
                       "`lamella --print-parameters` prints all entries.")
        .at(file + ": ");
    for (const std::string &assignment : overrides)
      set_entry(override_entry(checked_bytes(assignment, "--set")));
  }



  void
  SceneText::set_entry(const Item &entry)
  {
    const auto old =
      std::find_if(entries.begin(), entries.end(), [&entry](const Item &e) {
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



  std::optional<std::string>
  SceneText::says(const std::string &path) const
  {
    for (const Item &entry : entries)
      if (entry.path == path)
        return entry.value;
    return std::nullopt;
  }



  void
  SceneText::set_default(const std::string &path, const std::string &value)
  {
    if (!says(path))
      set_entry({path, value, 0});
  }



  void
  SceneText::replace(const std::string &path, const std::string &value)
  {
    set_entry({path, value, 0});
  }



  void
  SceneText::erase(const std::string &path)
  {
    entries.erase(std::remove_if(entries.begin(),
                                 entries.end(),
                                 [&path](const Item &entry) {
                                   return entry.path == path;
                                 }),
                  entries.end());
  }



  void
  SceneText::copy_subsection(const std::string              &path,
                             const std::vector<std::string> &copies)
  {
    const auto copied = [&](const std::vector<Item> &items) {
      std::vector<Item> result;
      for (const Item &item : items)
        if (item.path != path &&
            item.path.compare(0, path.size() + 1, path + "/") != 0)
          result.push_back(item);
        else
          for (const std::string &copy : copies)
            {
              result.push_back(item);
              result.back().path = copy + item.path.substr(path.size());
            }
      return result;
    };
    entries     = copied(entries);
    subsections = copied(subsections);
  }



  void
  SceneText::fill(dealii::ParameterHandler &prm,
                  const bool                top_level_only) const
  {
    for (const Item &entry : entries)
      {
        if (top_level_only && !parent(entry.path).empty())
          continue;
        const std::vector<std::string> parts = split(entry.path, '/');
        for (unsigned int i = 0; i + 1 < parts.size(); ++i)
          prm.enter_subsection(parts[i]);
        try
          {
            prm.set(parts.back(), entry.value);
          }
        catch (const dealii::ParameterHandler::ExcValueDoesNotMatchPattern &)
          {
            patterns::refuse(Entry(entry.path, entry.value), prm);
          }
        for (unsigned int i = 0; i + 1 < parts.size(); ++i)
          prm.leave_subsection();
      }
  }



  std::string
  SceneText::printed(const dealii::ParameterHandler &prm)
  {
    std::ostringstream text;
    prm.print_parameters(text,
                         dealii::ParameterHandler::ShortText |
                           dealii::ParameterHandler::KeepDeclarationOrder);
    return replaced(text.str(), "#", "\\#");
  }



  std::string
  SceneText::with_automatic(std::string        scene,
                            const std::string &path,
                            const std::string &name,
                            const std::string &value)
  {
    const std::string word  = "auto";
    const auto        begin = scene.find("subsection " + path + "\n");
    const auto        end   = scene.find("\nend", begin);
    const auto        entry = scene.find("set " + name, begin);
    if (begin == std::string::npos || entry > end)
      return scene;
    const auto equals = scene.find("= ", entry) + 2;
    if (scene.compare(equals, word.size() + 1, word + "\n") == 0)
      scene.replace(equals, word.size(), value);
    return scene;
  }



  void
  SceneText::drop_unlisted(const std::string              &list,
                           const std::string              &kind,
                           const std::vector<std::string> &names)
  {
    const bool overridden =
      std::any_of(entries.begin(), entries.end(), [&list](const Item &entry) {
        return entry.path == list && entry.line == 0;
      });
    if (!overridden)
      return;
    const auto is_excluded = [&](const Item &item) {
      const std::string first = item.path.substr(0, item.path.find('/'));
      return first.compare(0, kind.size() + 1, kind + " ") == 0 &&
             item.line != 0 &&
             std::find(names.begin(),
                       names.end(),
                       first.substr(kind.size() + 1)) == names.end();
    };
    // `Load factors` is an entry, not a load.
    entries.erase(std::remove_if(entries.begin(),
                                 entries.end(),
                                 [&](const Item &entry) {
                                   return !parent(entry.path).empty() &&
                                          is_excluded(entry);
                                 }),
                  entries.end());
    subsections.erase(std::remove_if(subsections.begin(),
                                     subsections.end(),
                                     is_excluded),
                      subsections.end());
  }



  void
  SceneText::check_listed(const std::string              &list,
                          const std::string              &kind,
                          const std::vector<std::string> &names) const
  {
    std::vector<std::string> bare, unlisted;
    for (const std::string &name : names)
      if (!has_subsection(kind + " " + name))
        bare.push_back(name);
    const std::string begin = kind + " ";
    for (const Item &item : subsections)
      if (item.path.compare(0, begin.size(), begin) == 0 &&
          parent(item.path).empty() &&
          std::find(names.begin(),
                    names.end(),
                    item.path.substr(begin.size())) == names.end())
        unlisted.push_back(item.path.substr(begin.size()));
    const Item *given = find(entries, list);
    if (bare.empty() || unlisted.empty() || given == nullptr)
      return;
    const std::string other = begin + nearest_name(bare[0], unlisted);
    throw InputError(list,
                     given->value,
                     "scene.name-without-subsection: '" + bare[0] +
                       "' has no subsection, and the subsection '" + other +
                       "' (line " +
                       std::to_string(find(subsections, other)->line) +
                       ") is not in the list",
                     "Write the same name in the list and after subsection.")
      .at(place(*given));
  }



  std::string
  SceneText::folder() const
  {
    return std::filesystem::path(file).parent_path().string();
  }



  bool
  SceneText::has_subsection(const std::string &path) const
  {
    return find(subsections, path) != nullptr;
  }



  SceneText
  SceneText::read(const std::string              &file,
                  const std::vector<std::string> &overrides)
  {
    std::ifstream input(file);
    if (!input || std::filesystem::is_directory(file))
      throw InputError("scene.cannot-read: the scene file cannot be read. "
                       "Check its name, and that you may read it.")
        .at(file + ": ");
    std::string text(longest_scene + 1, ' ');
    input.read(text.data(), text.size());
    text.resize(input.gcount());
    if (text.size() > longest_scene)
      throw InputError(
        "scene.file-too-large: the file has more than 16 MB, so it is no scene "
        "file. Name a text file (NAME.prm) of subsections and entries.")
        .at(file + ": ");
    return SceneText(text, file, overrides);
  }



  std::string
  SceneText::place(const Item &entry) const
  {
    return entry.line == 0 ? "--set: " : line_prefix(file, entry.line);
  }



  void
  SceneText::check_declared(const dealii::ParameterHandler &prm,
                            const bool top_level_only) const
  {
    // Declared items, in the format of ParameterHandler.
    std::vector<Item> declared, declared_subsections;
    scan(printed(prm), "", declared, declared_subsections);

    for (const Item &item : subsections)
      if (!top_level_only && find(declared_subsections, item.path) == nullptr)
        throw_unknown_subsection(item, declared_subsections);
    for (const Item &item : entries)
      if ((!top_level_only || parent(item.path).empty()) &&
          find(declared, item.path) == nullptr)
        {
          const std::string where =
            parent(item.path).empty() ? "" : " in " + parent(item.path);
          const std::string renamed = new_name(item.path);
          if (!renamed.empty())
            throw InputError(
              "scene.renamed-entry: the entry '" + last_part(item.path) + "'" +
              where + " is called '" + renamed + "'. Write the new name.")
              .at(place(item));
          const std::string nearest =
            nearest_name(last_part(item.path),
                         children(declared, parent(item.path)));
          throw InputError("scene.unknown-entry: there is no entry '" +
                           last_part(item.path) + "'" + where +
                           (nearest.empty() ?
                              ". Remove it." :
                              "; the most similar entry is '" + nearest +
                                "'. Check the spelling, or remove it."))
            .at(place(item));
        }
  }



  void
  SceneText::throw_unknown_subsection(const Item              &item,
                                      const std::vector<Item> &declared) const
  {
    // The nearest of the same kind: `Body uper` is no `Probe`.
    const std::string        name = last_part(item.path);
    const std::string        kind = name.substr(0, name.find(' '));
    std::vector<std::string> alike;
    for (const std::string &other : children(declared, parent(item.path)))
      if (!parent(item.path).empty() ||
          other.compare(0, kind.size() + 1, kind + " ") == 0)
        alike.push_back(other);
    const std::string nearest = nearest_name(name, alike);
    if (!parent(item.path).empty())
      throw InputError(
        "scene.unknown-subsection: there is no subsection '" + name + "' in " +
        parent(item.path) +
        (nearest.empty() ? "" :
                           "; the most similar name is '" + nearest + "'") +
        ". Remove this subsection, or add the missing 'end' before it.")
        .at(place(item));
    throw InputError(
      "scene.unknown-subsection: there is no subsection '" + name +
      "', since this name is in no list (Materials, Sections, Bodies "
      "and so on). Add the name to its list, or remove the subsection" +
      (are_alike(name, nearest) ?
         "; the most similar name is '" + nearest + "'." :
         "."))
      .at(place(item));
  }



  std::string
  SceneText::place_of(std::string path) const
  {
    for (; !path.empty(); path = parent(path))
      for (const std::vector<Item> *items : {&entries, &subsections})
        if (const Item *item = find(*items, path))
          return place(*item);
    return file + ": ";
  }



  InputError
  SceneText::placed(const InputError &error) const
  {
    return error.has_place() || error.path().empty() ?
             error :
             error.at(place_of(error.path()));
  }
} // namespace lamella
