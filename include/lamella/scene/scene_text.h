// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_scene_text_h
#define lamella_scene_scene_text_h

#include <lamella/base/exceptions.h>

#include <deal.II/base/parameter_handler.h>

#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /**
   * The text of a scene with its lines, checked before ParameterHandler parses
   * it. Messages have line numbers and suggest the nearest known entry for an
   * unknown one. The grammar, by lines:
   *   subsection NAME      opens a subsection; they nest
   *   end                  closes it
   *   set ENTRY = VALUE    sets an entry of the open subsection
   * '#' begins a comment ('\\#' is a '#' of the value); a backslash at the end
   * joins the next line. The path of an entry is the names of its subsections
   * and its own, joined by '/'; white space in names collapses to single
   * blanks. The text is UTF-8. Permitted entries are those declared in a
   * ParameterHandler.
   */
  class SceneText
  {
  public:
    /// An entry with its value, or a subsection without one.
    struct Item
    {
      /// Path, as `Body upper/Kinematics/Theory`, and value.
      std::string path, value;
      /// Line in the file, from 1; 0 for --set.
      unsigned int line = 0;
    };

    /// Parses @p text of the file named @p file and applies @p overrides, each
    /// PATH=VALUE as of --set; of equal ones the last counts, and new entries
    /// are added. Throws InputError for lines other than `subsection`, `set`
    /// and `end`, open subsections, repeated entries and subsections, values
    /// hidden by a comment, bytes that are not UTF-8, and a text without
    /// entries.
    SceneText(const std::string              &text,
              const std::string              &file,
              const std::vector<std::string> &overrides);

    /// Reads the file named @p file. Throws InputError if it cannot be read or
    /// exceeds 16 MB, and as the constructor does.
    static SceneText
    read(const std::string &file, const std::vector<std::string> &overrides);

    /// Sets the entries of @p prm to the values of the scene; with
    /// @p top_level_only without those in subsections. All must be declared.
    /// Throws InputError for a value that does not match its pattern.
    void
    fill(dealii::ParameterHandler &prm,
         const bool                top_level_only = false) const;

    /// Returns all entries of @p prmas the text of a scene, in the order of
    /// declaration.
    static std::string
    printed(const dealii::ParameterHandler &prm);

    /// Returns @p scene, made by printed(), with @p value in place of `auto`
    /// for the entry @p name of the top-level subsection @p path.
    static std::string
    with_automatic(std::string        scene,
                   const std::string &path,
                   const std::string &name,
                   const std::string &value);

    /// Removes the subsections `KIND NAME` with names not among @p names if
    /// --set gave the list @p list.
    void
    drop_unlisted(const std::string              &list,
                  const std::string              &kind,
                  const std::vector<std::string> &names);

    /// Throws InputError, at the line of @p list, if one of its @p names has no
    /// subsection `KIND NAME` while another of this kind is not among them.
    void
    check_listed(const std::string              &list,
                 const std::string              &kind,
                 const std::vector<std::string> &names) const;

    /// Returns the folder of the file; empty for the current folder.
    std::string
    folder() const;

    /// Returns the value of the entry @p path in the text or an override.
    std::optional<std::string>
    says(const std::string &path) const;

    /// Sets the entry @p path to @p value unless it has a value.
    void
    set_default(const std::string &path, const std::string &value);

    /// Sets the entry @p path to @p value.
    void
    replace(const std::string &path, const std::string &value);

    /// Removes the entry @p path, if there is one.
    void
    erase(const std::string &path);

    /// Replaces the subsection @p path by copies of it with the paths
    /// @p copies.
    void
    copy_subsection(const std::string              &path,
                    const std::vector<std::string> &copies);

    /// Returns whether the text, or an override, has the subsection @p path.
    bool
    has_subsection(const std::string &path) const;

    /// Throws InputError for the first entry or subsection that @p prm does not
    /// declare, with the nearest declared one. Subsections are skipped with
    /// @p top_level_only.
    void
    check_declared(const dealii::ParameterHandler &prm,
                   const bool top_level_only = false) const;

    /// Returns @p error with the place of its entry or subsection, `FILE:LINE:
    /// ` or `FILE: `, unless it has a place or no entry.
    InputError
    placed(const InputError &error) const;

  private:
    /// Parses @p text into entries and subsections in their order. Throws
    /// InputError for lines outside the grammar, with @p file.
    static void
    scan(const std::string &text,
         const std::string &file,
         std::vector<Item> &entries,
         std::vector<Item> &subsections);

    /// Returns `FILE:LINE: ` of @p entry, or `--set: `.
    std::string
    place(const Item &entry) const;

    /// Returns `FILE:LINE: ` of the entry or subsection @p pathor its nearest
    /// parent, or `FILE: `.
    std::string
    place_of(std::string path) const;

    /// Throws InputError for the subsection @p item, not among @p declared.
    [[noreturn]] void
    throw_unknown_subsection(const Item              &item,
                             const std::vector<Item> &declared) const;

    /// Adds @p entry with its subsections, or replaces the one with its path.
    void
    set_entry(const Item &entry);

    /// Name of the file, for messages.
    std::string file;
    /// Items in the order of the text; overrides of new ones follow.
    std::vector<Item> entries, subsections;
  };
} // namespace lamella

#endif
