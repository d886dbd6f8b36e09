// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/child_process.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/handout/html.h>
#include <lamella/handout/pictures.h>
#include <lamella/handout/run_folder.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace lamella
{
  namespace fs = std::filesystem;

  namespace
  {
    /// The paths of the pictures of the run in @p folder, in alphabetical
    /// order.
    std::vector<fs::path>
    pictures_in(const std::string &folder)
    {
      std::vector<fs::path> paths;
      std::error_code       error;
      for (const auto &entry :
           fs::directory_iterator(folder + "/pictures", error))
        if (entry.path().extension() == ".png")
          paths.push_back(entry.path());
      std::sort(paths.begin(), paths.end());
      return paths;
    }



    /// Whether there are pictures, all of them of the run that left the
    /// summary: one that went on with --resume has an older run's.
    bool
    are_up_to_date(const std::string &folder)
    {
      const std::vector<fs::path> paths = pictures_in(folder);
      std::error_code             error;
      const auto written = fs::last_write_time(folder + "/summary.json", error);
      return !paths.empty() &&
             std::all_of(paths.begin(), paths.end(), [&](const fs::path &path) {
               return fs::last_write_time(path, error) >= written;
             });
    }



    /// scripts/plot, where it is; empty if it is nowhere.
    std::string
    plot_script()
    {
      const fs::path  program = own_program();
      std::error_code error;
      for (const fs::path &folder :
           {program.parent_path().parent_path() / "share/lamella/scripts",
            fs::path(LAMELLA_SCRIPTS)})
        if (fs::is_regular_file(folder / "plot", error))
          return (folder / "plot").string();
      return "";
    }



    std::string
    last_line(const std::string &text)
    {
      const std::string all = trimmed(text);
      const auto        end = all.rfind('\n');
      return end == std::string::npos ? all : all.substr(end + 1);
    }



    /// What a picture shows, by how its name begins; doc/output.md has the
    /// list.
    std::string
    meaning(const std::string &name)
    {
      static const std::vector<std::pair<std::string, std::string>> meanings{
        {"deformed_stress",
         "The stress that is largest over the bodies, on their surface where "
         "they end up, in isometric projection; what is not to scale is said "
         "below."},
        {"deformed",
         "The bodies where they end up, coloured by how far they "
         "have moved; grey, where they were."},
        {"along_the_axis", "Displacements and stresses along the bodies."},
        {"across_the_width", "Displacements and stresses across the width."},
        {"through_the_thickness",
         "Displacements and stresses through the thickness, ply by ply."},
        {"through_the_contact",
         "Displacements and stresses through all bodies that meet."},
        {"section_", "Stresses over the section, as seen along the axis."},
        {"history",
         "Forces against displacement, load step by load step; on an axis of "
         "their own the moments that supports hold."},
        {"fields",
         "How many fields of its section each node of the axis carries: more "
         "where more happens."},
        {"goals",
         "Each goal in per cent from its corrected value, with its "
         "bar and, where it has one, its tolerance."},
        {"passes",
         "Estimated errors and bars of all goals from pass to pass, "
         "against the size of the model and the time."},
        {"contact_", "Contact pressure."}};
      for (const auto &[beginning, words] : meanings)
        if (name.compare(0, beginning.size(), beginning) == 0)
          return words;
      return "";
    }
  } // namespace



  std::string
  draw_missing_pictures(const std::string &folder, const std::string &errors)
  {
    if (are_up_to_date(folder))
      return "";
    const std::string script = plot_script();
    if (script.empty())
      return "There are no pictures: the script that draws them is not "
             "installed with this program. In the program's source tree, "
             "scripts/plot " +
             folder + " draws them; then make the report again.";
    // A picture takes a second or two.
    constexpr double most_seconds = 600.;
    std::string      reason;
    try
      {
        const ProcessEnd end =
          run_process(script, {folder}, "/dev/null", errors, most_seconds);
        if (end.status != 0)
          reason = "exit status " + std::to_string(end.status) + ": " +
                   last_line(content_of(errors));
      }
    catch (const InputError &error)
      {
        reason = error.what();
      }
    std::error_code error;
    fs::remove(errors, error);
    if (!reason.empty())
      return "The pictures could not be drawn (" + reason + "). Once that is " +
             "mended, " + script + " " + folder +
             " draws them; then make the report again.";
    return "";
  }



  Pictures::Pictures(const std::string &folder)
    : folder(folder)
  {
    for (const fs::path &path : pictures_in(folder))
      left.push_back(path.stem().string());
  }



  std::string
  Pictures::show_one(const std::string &name, const std::string &caption)
  {
    const auto found = std::find(left.begin(), left.end(), name);
    if (found == left.end())
      return "";
    left.erase(found);
    const std::string file  = "pictures/" + name + ".png";
    const std::string words = caption.empty() ? meaning(name) : caption;
    return figure(content_of(folder + "/" + file),
                  name,
                  (words.empty() ? "" : words + " ") + "<span class=\"file\">" +
                    escaped(file) + "</span>");
  }



  std::string
  Pictures::show(const std::string &beginning)
  {
    std::string html;
    for (const std::string &name : std::vector<std::string>(left))
      if (name == beginning ||
          name.compare(0, beginning.size() + 1, beginning + "_") == 0)
        html += show_one(name);
    return html;
  }



  std::string
  Pictures::show_rest()
  {
    std::string html;
    for (const std::string &name : std::vector<std::string>(left))
      html += show_one(name);
    return html;
  }
} // namespace lamella
