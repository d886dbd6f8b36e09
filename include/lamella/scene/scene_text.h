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
   * The text of a scene, looked at before ParameterHandler parses it. That one
   * lets a repeated entry win in silence and does not know what an unknown
   * entry was meant to be; this class does, and it knows the line of each
   * entry.
   *
   * The grammar, a line each:
   *   subsection NAME      opens one; they nest
   *   end                  closes it
   *   set ENTRY = VALUE    an entry of the open subsection
   * '#' begins a comment ('\\#' is a '#' of the value), a backslash at the end
   * joins the next line. An entry is known by its path, the names of its
   * subsections and its own with '/' between them; white space in names
   * collapses to single blanks. The text is UTF-8.
   *
   * It knows nothing of mechanics: what may be said stands in a
   * ParameterHandler that others have declared.
   */
  class SceneText
  {
  public:
    /// An entry with its value, or a subsection, which has none.
    struct Item
    {
      /// `Body upper/Kinematics/Theory`.
      std::string path, value;
      /// Where it stands in the file, from 1; 0 if it is from --set.
      unsigned int line = 0;
    };

    /**
     * Takes the text of the file named @p file and replaces what the
     * @p overrides set, each PATH=VALUE as of --set. Throws InputError for what
     * is neither `subsection`, `set` nor `end`, for subsections that are not
     * closed, for entries and subsections that come twice, for values that a
     * comment has swallowed, for bytes that are no UTF-8, and for a text
     * without any entry. An override of an entry that the text does not have
     * adds it, with its subsections; whether there is such an entry shows in
     * check_declared(). Of equal overrides the last counts.
     */
    SceneText(const std::string              &text,
              const std::string              &file,
              const std::vector<std::string> &overrides);

    /// Reads the file named @p file. Throws InputError if it cannot, if that
    /// has more than 16 MB, and as the constructor does.
    static SceneText
    read(const std::string &file, const std::vector<std::string> &overrides);

    /// Sets the entries of @p prm to what the scene says, overrides among it;
    /// with @p top_level_only what stands in subsections is left out. All must
    /// be declared. Throws InputError for a value that does not match the
    /// pattern of its entry.
    void
    fill(dealii::ParameterHandler &prm,
         const bool                top_level_only = false) const;

    /// All entries of @p prm, in the order of their declaration, as a scene of
    /// its own, '#' in values as '\\#'.
    static std::string
    printed(const dealii::ParameterHandler &prm);

    /// @p scene, as printed() makes it, with @p value for the entry @p name in
    /// the subsection @p path at the top level, where it says `auto` there.
    static std::string
    with_automatic(std::string        scene,
                   const std::string &path,
                   const std::string &name,
                   const std::string &value);

    /// Removes the subsections `KIND NAME`, with all in them, whose name is not
    /// among @p names, if --set gave the list @p list: leaving a name out there
    /// is to leave out what it names.
    void
    drop_unlisted(const std::string              &list,
                  const std::string              &kind,
                  const std::vector<std::string> &names);

    /// Throws InputError, at the line of the list @p list, if one of its
    /// @p names has no subsection `KIND NAME` while the name of a subsection of
    /// this kind is not among them: one of the two is a slip.
    void
    check_listed(const std::string              &list,
                 const std::string              &kind,
                 const std::vector<std::string> &names) const;

    /// Where the file lies: what paths in the scene are relative to. Empty for
    /// the present folder.
    std::string
    folder() const;

    /// What the text, or an override, says of the entry @p path; none if it
    /// does not have it.
    std::optional<std::string>
    says(const std::string &path) const;

    /// Says that the entry @p path is @p value, unless the text says something
    /// of it.
    void
    assume(const std::string &path, const std::string &value);

    /// Says that the entry @p path is @p value, whatever the text says of it.
    void
    replace(const std::string &path, const std::string &value);

    /// Removes the entry @p path, if there is one.
    void
    erase(const std::string &path);

    /// Replaces the subsection @p path by copies of it, with all in them, that
    /// have the paths @p copies. Each item keeps the line that it had.
    void
    copy_subsection(const std::string              &path,
                    const std::vector<std::string> &copies);

    /// Whether the text, or an override, has the subsection @p path.
    bool
    has_subsection(const std::string &path) const;

    /**
     * Throws InputError for the first entry or subsection that @p prm does not
     * declare, naming the nearest that it does: of the same subsection, or for
     * a subsection of the same kind. With @p top_level_only what stands in
     * subsections is left out.
     */
    void
    check_declared(const dealii::ParameterHandler &prm,
                   const bool top_level_only = false) const;

    /// @p error with the place of its entry or subsection before it,
    /// `FILE:LINE: ` (`FILE: ` if none of the text has its path), unless it has
    /// a place or is of no entry.
    InputError
    placed(const InputError &error) const;

  private:
    /// Parses @p text into entries and subsections, both in their order;
    /// @p file begins the messages. Throws InputError for what is no line of
    /// the grammar.
    static void
    scan(const std::string &text,
         const std::string &file,
         std::vector<Item> &entries,
         std::vector<Item> &subsections);

    /// `FILE:LINE: ` of @p entry, or `--set: `.
    std::string
    place(const Item &entry) const;

    /// `FILE:LINE: ` of the entry or subsection with the path @p path, or of
    /// the first above it that the text has, or `FILE: `.
    std::string
    place_of(std::string path) const;

    /// Throws InputError for the subsection @p item, not among @p declared.
    [[noreturn]] void
    fail_on_subsection(const Item              &item,
                       const std::vector<Item> &declared) const;

    /// Puts in @p entry, in the place of that with its path if there is one,
    /// with the subsections it needs.
    void
    put(const Item &entry);

    /// Its name, for messages.
    std::string file;
    /// In the order of the text, overrides of new ones at the end.
    std::vector<Item> entries, subsections;
  };
} // namespace lamella

#endif
