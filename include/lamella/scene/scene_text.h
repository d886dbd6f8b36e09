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
  /// ParameterHandler parses it, so that messages contain line numbers and
  /// suggest the nearest known entry for an unknown one. Each line is one of
  ///   subsection NAME      opens a subsection, which may contain others
  ///   end                  closes the subsection
  ///   set ENTRY = VALUE    sets an entry of the open subsection
  /// '#' begins a comment ('\\#' is a '#' in a value). A backslash at the end
  /// of a line joins the next line. The path of an entry consists of the names
  /// of its subsections and of the entry, joined by '/'. Names may contain
  /// single blanks; longer white space is replaced. The text is UTF-8.
  class SceneText
  {
  public:
    /// An entry with its value, or a subsection, whose value is empty.
    struct Item
    {
      std::string path, ///< For example `Body upper/Kinematics/Theory`.
        value;          ///< Text after `=`.
      /// Line in the file, from 1; zero for entries of --set or set_default().
      unsigned int line = 0;
    };

    /// Parses @p text of the file named @p file. Then sets the entries in @p
    /// overrides, arguments PATH=VALUE of the option --set; the last of equal
    /// paths counts. Throws InputError for invalid lines, unclosed subsections,
    /// repeated entries and subsections, values hidden by a comment, invalid
    /// UTF-8, and a text without entries.
    SceneText(const std::string              &text,
              const std::string              &file,
              const std::vector<std::string> &overrides);

    /// Reads the scene file named @p file and sets the entries in @p overrides,
    /// arguments PATH=VALUE of --set. Throws InputError if the file cannot be
    /// read or exceeds 16 MB, and as the constructor does.
    static SceneText
    read(const std::string &file, const std::vector<std::string> &overrides);

    /// Sets the entries of @p prm, which must declare them, to the values in
    /// the text. If @p top_level_only is true, skips entries in subsections.
    /// Throws InputError for values that do not match the declared pattern.
    void
    fill(dealii::ParameterHandler &prm,
         const bool                top_level_only = false) const;

    /// Returns the text of a scene file with all entries of @p prm.
    static std::string
    printed(const dealii::ParameterHandler &prm);

    /// Returns the text @p scene, a result of printed(), with a value that the
    /// program chose: if the entry @p name of the top-level subsection @p path
    /// is `auto`, it becomes @p value; otherwise @p scene is unchanged.
    static std::string
    with_automatic(std::string        scene,
                   const std::string &path,
                   const std::string &name,
                   const std::string &value);

    /// If the option --set has replaced the entry @p list (such as `Bodies`),
    /// removes the subsections `KIND NAME` (such as `Body upper`) whose NAME is
    /// no longer in the entry. @p names are the names in the entry now.
    void
    drop_unlisted(const std::string              &list,
                  const std::string              &kind,
                  const std::vector<std::string> &names);

    /// Throws InputError, with the line of the entry @p list (such as
    /// `Bodies`), for a probable typing error: one of its @p names has no
    /// subsection `KIND NAME`, and a subsection of this kind has a name that is
    /// not listed.
    void
    check_listed(const std::string              &list,
                 const std::string              &kind,
                 const std::vector<std::string> &names) const;

    /// Returns the folder of the scene file; empty for the current folder.
    std::string
    folder() const;

    /// Returns the value of the entry @p path; empty if it is not set.
    std::optional<std::string>
    says(const std::string &path) const;

    /// Sets the entry @p path to @p value if it has no value yet.
    void
    set_default(const std::string &path, const std::string &value);

    /// Sets the entry @p path to @p value, whether or not it has a value.
    void
    replace(const std::string &path, const std::string &value);

    /// Removes the entry @p path, if there is one.
    void
    erase(const std::string &path);

    /// Replaces the subsection @p path by copies with the paths @p copies.
    void
    copy_subsection(const std::string              &path,
                    const std::vector<std::string> &copies);

    /// Returns true if the file or an option --set has the subsection @p path.
    bool
    has_subsection(const std::string &path) const;

    /// Throws InputError for the first entry or subsection of the text that @p
    /// prm does not declare; the message suggests the nearest declared name. If
    /// @p top_level_only is true, checks only entries outside of subsections.
    void
    check_declared(const dealii::ParameterHandler &prm,
                   const bool top_level_only = false) const;

    /// Returns @p error with a prefix that locates its entry or subsection:
    /// `FILE:LINE: `, or `FILE: ` without a line. Returns @p error unchanged if
    /// it has a prefix or names no entry.
    InputError
    placed(const InputError &error) const;

  private:
    /// Splits @p text into @p entries and @p subsections, in the order of
    /// lines. Throws InputError with the name @p file for invalid lines.
    static void
    scan(const std::string &text,
         const std::string &file,
         std::vector<Item> &entries,
         std::vector<Item> &subsections);

    /// Returns `FILE:LINE: ` of @p entry, or `--set: `.
    std::string
    place(const Item &entry) const;

    /// Returns the prefix `FILE:LINE: ` of the entry or subsection @p path, or
    /// of its nearest enclosing subsection in the text; otherwise `FILE: `.
    std::string
    place_of(std::string path) const;

    /// Throws InputError for the subsection @p item that is not in @p declared.
    [[noreturn]] void
    throw_unknown_subsection(const Item              &item,
                             const std::vector<Item> &declared) const;

    /// Sets the value of @p entry; adds it and its subsections if missing.
    void
    set_entry(const Item &entry);

    /// Name of the file, for messages.
    std::string file;
    /// Items in the order of the text, followed by those set by --set.
    std::vector<Item> entries, subsections;
  };

  /// Returns @p text with each sequence of white space replaced by one blank.
  std::string
  collapsed(const std::string &text);

  /// Returns `FILE:LINE: `, the prefix of messages on line @p line of @p file.
  std::string
  line_prefix(const std::string &file, const unsigned int line);

  /// Returns @p text without a UTF-8 byte order mark. Throws InputError, with
  /// the name @p file, if the text is not valid UTF-8.
  std::string
  checked_bytes(const std::string &text, const std::string &file);

  /// Returns the name of the entry for which @p path has a former name (`Points
  /// on`) or the name in other programs (`Torque`); empty otherwise.
  std::string
  new_name(const std::string &path);
} // namespace lamella

#endif
