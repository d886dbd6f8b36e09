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
  /// The text of a scene file with line numbers. It is checked before deal.II's
  /// ParameterHandler parses it, so that messages have line numbers and suggest
  /// the nearest known entry for an unknown entry. Each line is one of
  ///   subsection NAME      opens a subsection; they nest
  ///   end                  closes it
  ///   set ENTRY = VALUE    sets an entry of the open subsection
  /// '#' begins a comment ('\\#' is a '#' of the value); a backslash at the end
  /// joins the next line. The path of an entry is the names of its subsections
  /// and its own, joined by '/'; white space in names collapses to single
  /// blanks. The text is UTF-8. A ParameterHandler declares the permitted
  /// entries.
  class SceneText
  {
  public:
    /// An entry with its value, or a subsection (its value is empty).
    struct Item
    {
      /// Path, such as `Body upper/Kinematics/Theory`, and value.
      std::string path, value;
      /// Line in the file, from 1; 0 for --set.
      unsigned int line = 0;
    };

    /// Parses @p text of the file named @p file and applies @p overrides, each
    /// PATH=VALUE as in the option --set. An override may add an entry; if a
    /// path is repeated, the last override counts. Throws InputError for
    /// invalid lines, unclosed subsections, repeated entries and subsections,
    /// values hidden by a comment, invalid UTF-8, and a text without entries.
    SceneText(const std::string              &text,
              const std::string              &file,
              const std::vector<std::string> &overrides);

    /// Reads the file named @p file. Throws InputError if it cannot be read or
    /// exceeds 16 MB, and as the constructor does.
    static SceneText
    read(const std::string &file, const std::vector<std::string> &overrides);

    /// Sets the entries of @p prm to the values in the text; only entries
    /// outside of subsections if @p top_level_only is true. @p prm must declare
    /// all of them. Throws InputError if a value does not match its pattern.
    void
    fill(dealii::ParameterHandler &prm,
         const bool                top_level_only = false) const;

    /// Returns all entries of @p prm as the text of a scene file.
    static std::string
    printed(const dealii::ParameterHandler &prm);

    /// Returns @p scene, a result of printed(), in which the entry @p name of
    /// the top-level subsection @p path has @p value instead of `auto`.
    static std::string
    with_automatic(std::string        scene,
                   const std::string &path,
                   const std::string &name,
                   const std::string &value);

    /// Removes the subsections `KIND NAME` whose names are not among @p names,
    /// if the option --set has replaced the list of names @p list.
    void
    drop_unlisted(const std::string              &list,
                  const std::string              &kind,
                  const std::vector<std::string> &names);

    /// Throws InputError, with the line of the entry @p list, if one of its @p
    /// names has no subsection `KIND NAME` although there is a subsection of
    /// this kind with a name that is not listed.
    void
    check_listed(const std::string              &list,
                 const std::string              &kind,
                 const std::vector<std::string> &names) const;

    /// Returns the folder of the file; empty for the current folder.
    std::string
    folder() const;

    /// Returns the value of the entry @p path; none if it is not set.
    std::optional<std::string>
    says(const std::string &path) const;

    /// Sets the entry @p path to @p value if it has no value yet.
    void
    set_default(const std::string &path, const std::string &value);

    /// Sets the entry @p path to @p value.
    void
    replace(const std::string &path, const std::string &value);

    /// Removes the entry @p path, if there is one.
    void
    erase(const std::string &path);

    /// Replaces the subsection @p path by duplicates with the paths @p copies.
    void
    copy_subsection(const std::string              &path,
                    const std::vector<std::string> &copies);

    /// Returns whether the text, or an override, has the subsection @p path.
    bool
    has_subsection(const std::string &path) const;

    /// Throws InputError for the first entry or subsection that @p prm does not
    /// declare; the message suggests the nearest declared name. Subsections are
    /// ignored if @p top_level_only is true.
    void
    check_declared(const dealii::ParameterHandler &prm,
                   const bool top_level_only = false) const;

    /// Returns @p error with the prefix `FILE:LINE: ` (or `FILE: `) of its
    /// entry or subsection, unless it has a prefix already or names no entry.
    InputError
    placed(const InputError &error) const;

  private:
    /// Parses @p text into entries and subsections, in the order of lines.
    /// Throws InputError, which names @p file, for invalid lines.
    static void
    scan(const std::string &text,
         const std::string &file,
         std::vector<Item> &entries,
         std::vector<Item> &subsections);

    /// Returns `FILE:LINE: ` of @p entry, or `--set: `.
    std::string
    place(const Item &entry) const;

    /// Returns `FILE:LINE: ` of the entry or subsection @p path, or of its
    /// nearest parent in the text, otherwise `FILE: `.
    std::string
    place_of(std::string path) const;

    /// Throws InputError for the subsection @p item that is not in @p declared.
    [[noreturn]] void
    throw_unknown_subsection(const Item              &item,
                             const std::vector<Item> &declared) const;

    /// Adds @p entry and its subsections, or replaces the entry of equal path.
    void
    set_entry(const Item &entry);

    /// Name of the file, for messages.
    std::string file;
    /// Items in the order of the text, followed by those of overrides.
    std::vector<Item> entries, subsections;
  };
} // namespace lamella

#endif
