// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `handout`: a run as one page to hand on. It owns what is read from a
// folder of results, the page and its words, and has the project's script draw
// the pictures that are missing. It lives on files alone: it never solves
// anything, and never looks at bodies, meshes or results in memory, so a page
// can be made years after the run, elsewhere.
//
// Where to start reading: write_handout(), then RunFolder, and the chapters.

#ifndef lamella_handout_handout_h
#define lamella_handout_handout_h

#include <iosfwd>
#include <string>

namespace lamella
{
  /**
   * `lamella report DIR`: writes what the run in @p folder left behind as one
   * self-contained HTML file @p target: scene in words, sections, deformed
   * shape, contact, numbers with their bars, reserve factors, reactions,
   * checks, warnings, costs, and how to run it again. Pictures and tables are
   * in it; it has no scripts and refers to nothing outside of itself.
   *
   * Pictures that are missing are drawn first (draw_missing_pictures()); where
   * that fails the page says so. What was done is told to @p out, a line.
   *
   * Throws InputError if the folder holds no results of a run, if a file in it
   * is damaged, or if @p target cannot be written or is not called *.html; what
   * stood there before stays then.
   */
  void
  write_handout(const std::string &folder,
                const std::string &target,
                std::ostream      &out);

  /// The page of the run in @p folder with the pictures that are there;
  /// @p why says why there are none, if so. Throws InputError as above.
  std::string
  handout_text(const std::string &folder, const std::string &why);
} // namespace lamella

#endif
