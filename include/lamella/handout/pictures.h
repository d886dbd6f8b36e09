// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_handout_pictures_h
#define lamella_handout_pictures_h

#include <string>
#include <vector>

namespace lamella
{
  /**
   * Has the project's own script, scripts/plot, draw what the run in @p folder
   * left, into its subfolder pictures, unless the pictures there are younger
   * than its summary. The script is sought beside the program as it is
   * installed (`../share/lamella/scripts`), then in the tree that it was built
   * from.
   *
   * Returns an empty text if there are pictures, or nothing to draw; otherwise
   * why there are none and which command draws them, in plain sentences.
   * @p errors is a file that can be written, for the script's messages; it is
   * removed again. Throws nothing for pictures: a page without them is a page.
   */
  std::string
  draw_missing_pictures(const std::string &folder, const std::string &errors);

  /// The pictures of a run, each to be shown once.
  class Pictures
  {
  public:
    /// Lists DIR/pictures/*.png of the folder @p folder.
    explicit Pictures(const std::string &folder);

    /// Those not shown yet whose name is @p beginning, or goes on after it with
    /// an underscore, as figures with captions; empty if there are none.
    std::string
    show(const std::string &beginning);

    /// That called @p name, if it has not been shown yet, with the caption
    /// @p caption, in HTML, or that of its kind; empty otherwise.
    std::string
    show_one(const std::string &name, const std::string &caption = "");

    /// All that have not been shown yet.
    std::string
    show_rest();

  private:
    std::string folder;
    /// File names without their ending.
    std::vector<std::string> left;
  };
} // namespace lamella

#endif
