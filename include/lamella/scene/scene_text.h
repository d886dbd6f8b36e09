// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_scene_text_h
#define lamella_scene_scene_text_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace lamella
{
  /**
   * The text of a scene, looked at before ParameterHandler parses it. That one
   * lets a repeated entry win in silence and does not know what an unknown
   * entry was meant to be; this class does, and it knows the line of each
   * entry.
   */
  class SceneText
  {
  public:
    struct Entry
    {
      /// `Body upper/Kinematics/Theory`, and its line (0 if from --set).
      std::string  path, value;
      unsigned int line = 0;
    };

    /**
     * Takes the text of the file named @p file and replaces what the
     * @p overrides set, each PATH=VALUE as of --set. Throws InputError for what
     * is neither `subsection`, `set` nor `end`, for subsections that are not
     * closed, and for entries and subsections that come twice.
     */
    SceneText(const std::string              &text,
              const std::string              &file,
              const std::vector<std::string> &overrides);

    /// Reads the file. Throws InputError if it cannot.
    static SceneText
    read(const std::string &file, const std::vector<std::string> &overrides);

    /// Sets the entries of @p prm to what the scene says, overrides among it;
    /// with @p top_level_only what stands in subsections is left out. All must
    /// be declared.
    void
    fill(dealii::ParameterHandler &prm,
         const bool                top_level_only = false) const;

    /// All entries of @p prm as a scene of its own, '#' in values as '\\#'.
    static std::string
    printed(const dealii::ParameterHandler &prm);

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

    /// Where the file lies: what paths in the scene are relative to.
    std::string
    folder() const;

    bool
    has_subsection(const std::string &path) const;

    /**
     * Throws InputError for the first entry or subsection that @p prm does not
     * declare, naming the nearest that it does. With @p top_level_only what
     * stands in subsections is left out.
     */
    void
    check_declared(const dealii::ParameterHandler &prm,
                   const bool top_level_only = false) const;

    /// @p message with the middle left out of values that are longer than
    /// anybody reads.
    std::string
    abbreviated(std::string message) const;

    /// `FILE:LINE: ` of the entry whose path @p message begins with, or
    /// `FILE: `.
    std::string
    place_of(const std::string &message) const;

  private:
    /// Parses @p text into entries and subsections.
    static void
    scan(const std::string  &text,
         const std::string  &file,
         std::vector<Entry> &entries,
         std::vector<Entry> &subsections);

    std::string
    place(const Entry &entry) const;

    /// Throws InputError for the subsection @p item, not among @p declared.
    [[noreturn]] void
    fail_on_subsection(const Entry              &item,
                       const std::vector<Entry> &declared) const;

    std::string        file;
    std::vector<Entry> entries, subsections;
  };
} // namespace lamella

#endif
