// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/output_file.h>
#include <lamella/base/text.h>
#include <lamella/handout/chapters.h>
#include <lamella/handout/handout.h>
#include <lamella/handout/html.h>

#include <filesystem>
#include <ostream>

namespace lamella
{
  namespace fs = std::filesystem;

  namespace
  {
    /// The look: for screens and, with less of everything, for paper.
    const char *const style = R"css(
  :root { --line: #d4d8dd; --faint: #5b6570; --accent: #0b4f8a; }
  * { box-sizing: border-box; }
  body { font: 16px/1.5 system-ui, "Segoe UI", "Helvetica Neue", Arial, sans-serif;
         color: #1b1f23; background: #fff; margin: 0; }
  main { max-width: 62rem; margin: 0 auto; padding: 2rem 1.5rem 4rem; }
  h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 .3rem; }
  h2 { font-size: 1.35rem; margin: 2.6rem 0 .8rem; padding-bottom: .25rem;
       border-bottom: 2px solid var(--accent); }
  h3 { font-size: 1.05rem; margin: 1.6rem 0 .4rem; }
  p, ul { margin: .5rem 0; }
  li { margin: .25rem 0; }
  a { color: var(--accent); }
  .about, .file { color: var(--faint); }
  .file { font-size: .8rem; }
  nav ol { columns: 2; column-gap: 3rem; }
  .wide { overflow-x: auto; margin: .9rem 0 1.3rem; }
  table { border-collapse: collapse; font-size: .875rem; line-height: 1.35; }
  caption { caption-side: top; text-align: left; color: var(--faint);
            padding-bottom: .4rem; max-width: 58rem; }
  th, td { padding: .3rem .7rem; border-bottom: 1px solid var(--line);
           text-align: left; vertical-align: top; }
  th { font-weight: 600; background: #f3f5f7; border-bottom: 2px solid var(--line); }
  td.number, td data { font-variant-numeric: tabular-nums; }
  td.number { text-align: right; white-space: nowrap; }
  tr.marked td { background: #fdf1dc; }
  .warnings { border-left: 5px solid #c77700; background: #fdf6e8;
              padding: .5rem 1rem; margin: .8rem 0; }
  figure { margin: 1.2rem 0; break-inside: avoid; }
  figure img { width: 100%; max-width: 52rem; height: auto; display: block; }
  figcaption { font-size: .875rem; color: var(--faint); margin-top: .3rem; }
  code, pre { font: .85em/1.45 ui-monospace, Consolas, "DejaVu Sans Mono", monospace; }
  pre { background: #f6f7f9; border: 1px solid var(--line); border-radius: 4px;
        padding: .8rem 1rem; white-space: pre-wrap; overflow-wrap: anywhere; }
  @media print {
    @page { margin: 16mm 14mm; }
    body { font-size: 10pt; }
    main { max-width: none; padding: 0; }
    h2, h3, caption { break-after: avoid; }
    tr { break-inside: avoid; }
    thead { display: table-header-group; }
    .wide { overflow: visible; }
    table { font-size: 7.5pt; }
    th, td { padding: .15rem .4rem; }
    pre { font-size: 7.5pt; border: 0; padding: 0; background: none; }
    a { color: inherit; text-decoration: none; }
  }
)css";



    std::string
    contents(const std::vector<Chapter> &chapters)
    {
      std::string html = "<nav><h2 id=\"contents\">Contents</h2>\n<ol>\n";
      for (const Chapter &chapter : chapters)
        html += "<li><a href=\"#" + chapter.id + "\">" +
                escaped(chapter.title) + "</a></li>\n";
      return html + "</ol></nav>\n";
    }



    std::string
    to_html(const Chapter &chapter)
    {
      return "<section>\n<h2 id=\"" + chapter.id + "\">" +
             escaped(chapter.title) + "</h2>\n" + chapter.html + "</section>\n";
    }



    /// The chapters of @p run in their order, the first two before the list of
    /// contents.
    std::vector<Chapter>
    all_chapters(const RunFolder &run, const std::string &why)
    {
      Pictures             pictures(run.path);
      std::vector<Chapter> chapters{glance_chapter(run),
                                    warnings_chapter(run, why),
                                    scene_chapter(run),
                                    sections_chapter(run, pictures),
                                    shape_chapter(run, pictures),
                                    numbers_chapter(run, pictures),
                                    contact_chapter(run, pictures),
                                    strength_chapter(run),
                                    forces_chapter(run, pictures),
                                    checks_chapter(run),
                                    costs_chapter(run, pictures),
                                    files_chapter(run),
                                    again_chapter(run)};
      // Pictures of a kind that is not known here.
      for (Chapter &chapter : chapters)
        if (chapter.id == "shape")
          chapter.html += pictures.show_rest();
      return chapters;
    }



    std::string
    page(const RunFolder &run, const std::string &why)
    {
      const std::string title = run.summary.value("title", std::string());
      const std::string name =
        escaped(title.empty() ? fs::path(run.path).filename().string() : title);
      const std::vector<Chapter> chapters = all_chapters(run, why);
      std::string                html =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, "
        "initial-scale=1\">\n<title>" +
        name + "</title>\n<style>" + style +
        "</style>\n</head>\n<body>\n<main>\n<header><h1>" + name +
        "</h1>\n<p class=\"about\">Report of a run of Lamella " +
        escaped(run.summary.value("version", "?")) +
        ", a program for contact between laminated, sandwich and solid beams. "
        "Results of " +
        escaped(run.date()) + ", folder <code>" + escaped(run.path) +
        "</code>.</p></header>\n";
      for (unsigned int k = 0; k < chapters.size(); ++k)
        {
          if (k == 2)
            html += contents(chapters);
          html += to_html(chapters[k]);
        }
      return html + "</main>\n</body>\n</html>\n";
    }



    /// Throws InputError unless a page may be put at @p target.
    void
    check_target(const std::string &target)
    {
      const std::string ending = fs::path(target).extension().string();
      std::error_code   error;
      if (fs::is_directory(target, error))
        throw InputError("that is a folder. Name a file, as in " + target +
                         "/report.html.")
          .at("--output " + target + ": ");
      if (ending != ".html" && ending != ".htm")
        throw InputError("a report is a page of HTML. Give its name the ending "
                         ".html.")
          .at("--output " + target + ": ");
    }
  } // namespace



  std::string
  handout_text(const std::string &folder, const std::string &why)
  {
    const RunFolder run(folder);
    try
      {
        return page(run, why);
      }
    catch (const nlohmann::json::exception &)
      {
        throw InputError("it is not what a run writes there. The file was "
                         "changed; run the scene again.")
          .at(run.path + "/summary.json: ");
      }
  }



  void
  write_handout(const std::string &folder,
                const std::string &target,
                std::ostream      &out)
  {
    check_target(target);
    const InputError unwritable =
      InputError("the report cannot be written there. Name a file in a folder "
                 "that can be written, by --output FILE.html.")
        .at("--output " + target + ": ");
    handout_text(folder, ""); // before anything is drawn or written
    OutputFile file(target);
    if (!file.stream())
      throw unwritable;
    const std::string why  = draw_missing_pictures(folder, target + ".log");
    const std::string html = handout_text(folder, why);
    file.stream() << html;
    if (!file.put_in_place())
      throw unwritable;
    out << "Report: " << target << " (" << to_text(html.size() / 1048576., 2)
        << " MB)" << std::endl;
    if (!why.empty())
      out << "Note: " << why << std::endl;
  }
} // namespace lamella
