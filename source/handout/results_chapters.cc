// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/handout/chapters.h>
#include <lamella/handout/html.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lamella
{
  using Json = nlohmann::ordered_json;

  namespace
  {
    /// The largest size of the numbers in @p columns of @p table.
    double
    size_of(const CsvTable &table, const std::vector<std::string> &columns)
    {
      double size = 0.;
      for (unsigned int k = 0; k < table.rows.size(); ++k)
        for (const std::string &column : columns)
          if (const double value = std::abs(table.value(k, column));
              std::isfinite(value))
            size = std::max(size, value);
      return size;
    }



    /// What stands in @p table of @p columns as a table of the page.
    void
    add_columns(HtmlTable                      &html,
                const RunFolder                &run,
                const CsvTable                 &table,
                const std::vector<std::string> &columns)
    {
      const double size = size_of(table, columns);
      for (const std::string &column : columns)
        html.header.push_back(run.with_unit(column));
      for (unsigned int k = 0; k < table.rows.size(); ++k)
        for (const std::string &column : columns)
          html.rows[k].push_back(number(table.cell(k, column), size));
    }



    // ---- sections

    /// Where a ply lies, in the section's coordinates.
    struct Extent
    {
      std::string           material, angle;
      std::array<double, 2> low{{std::numeric_limits<double>::infinity(),
                                 std::numeric_limits<double>::infinity()}},
        high{{-std::numeric_limits<double>::infinity(),
              -std::numeric_limits<double>::infinity()}};
    };



    /// The plies, or parts, of a section's mesh, the first one first.
    std::vector<Extent>
    plies_of(const CsvTable &mesh)
    {
      std::vector<Extent> plies;
      for (unsigned int k = 0; k < mesh.rows.size(); ++k)
        {
          const double ply = mesh.value(k, "ply");
          if (!(ply >= 1. && ply <= 1e6))
            continue;
          if (plies.size() < ply)
            plies.resize(ply);
          Extent &extent  = plies[ply - 1];
          extent.material = mesh.cell(k, "material");
          extent.angle    = mesh.cell(k, "angle");
          for (unsigned int side = 1; side <= 4; ++side)
            for (const std::string &point :
                 split(mesh.cell(k, "side_" + std::to_string(side)), ';'))
              {
                const auto   blank = point.find(' ');
                const double x[]   = {to_number(point.substr(0, blank)),
                                      to_number(point.substr(blank + 1))};
                for (unsigned int c = 0; c < 2; ++c)
                  {
                    extent.low[c]  = std::min(extent.low[c], x[c]);
                    extent.high[c] = std::max(extent.high[c], x[c]);
                  }
              }
        }
      return plies;
    }



    /// A length that was computed from numbers of 15 digits.
    std::string
    length_cell(const double length, const double size)
    {
      return number(to_text(length, 14), size);
    }



    std::string
    plies_table(const RunFolder           &run,
                const std::string         &name,
                const std::vector<Extent> &plies)
    {
      const std::string length = run.unit_in_brackets("length");
      HtmlTable         table;
      table.id      = "plies-of-" + name;
      table.caption = "Plies of " + escaped(name) +
                      ", the lowest first. An angle of 0 is along the body's "
                      "axis, positive from +<i>y</i> towards +<i>x</i>.";
      table.header = {"ply",
                      "material",
                      "angle [°]",
                      "width along <i>x</i> " + length,
                      "thickness along <i>z</i> " + length,
                      "from <i>z</i> " + length,
                      "to <i>z</i> " + length};
      double size  = 0.;
      for (const Extent &ply : plies)
        size = std::max({size, std::abs(ply.low[1]), std::abs(ply.high[1])});
      for (unsigned int k = 0; k < plies.size(); ++k)
        {
          const Extent &ply = plies[k];
          if (ply.material.empty())
            continue;
          table.rows.push_back({number(std::to_string(k + 1)),
                                escaped(ply.material),
                                number(ply.angle, 1.),
                                length_cell(ply.high[0] - ply.low[0], 0.),
                                length_cell(ply.high[1] - ply.low[1], 0.),
                                length_cell(ply.low[1], size),
                                length_cell(ply.high[1], size)});
        }
      return to_html(table);
    }



    std::string
    stiffness_table(const RunFolder   &run,
                    const std::string &name,
                    const Json        &section)
    {
      if (section.contains("fault"))
        return paragraph("As a beam it has no stiffnesses here: " +
                         escaped(section["fault"].get<std::string>()));
      const std::string force = run.unit("force"), length = run.unit("length");
      const std::string square =
        in_brackets(force.empty() ? "" : force + " " + length + "²",
                    "force length²");
      HtmlTable  table;
      const auto add = [&](const std::string &key,
                           const std::string &what,
                           const std::string &unit) {
        if (!section.contains(key))
          return;
        table.rows.push_back({what,
                              section[key].is_array() ?
                                components(section[key]) :
                                number(section[key]),
                              unit});
      };
      table.id      = "stiffness-of-" + name;
      table.caption = escaped(name) + " as a beam";
      table.header  = {"stiffness", "value", "unit"};
      add("EA", "axial, <i>EA</i>", run.unit_in_brackets("force"));
      add("EI_1", "bending about the stiffer axis, <i>EI</i>₁", square);
      add("EI_2", "bending about the softer axis, <i>EI</i>₂", square);
      add(
        "angle_deg",
        "the axis that <i>EI</i>₁ bends about, from <i>x</i> towards <i>z</i>",
        "[°]");
      add("GJ", "torsion, <i>GJ</i>", square);
      add("kGA_x",
          "shear along <i>x</i>, <i>kGA</i>",
          run.unit_in_brackets("force"));
      add("kGA_z",
          "shear along <i>z</i>, <i>kGA</i>",
          run.unit_in_brackets("force"));
      const std::string in_length = run.unit_in_brackets("length");
      add("tension_centre", "tension centre (<i>x</i>, <i>z</i>)", in_length);
      add("shear_centre", "shear centre (<i>x</i>, <i>z</i>)", in_length);
      return to_html(table);
    }



    // ---- numbers

    /// `tip: uz` to `uz`, `c: fz in y 1 2` to `fz`.
    std::string
    column_of_goal(const std::string &goal)
    {
      const auto colon = goal.rfind(": ");
      if (colon == std::string::npos)
        return "";
      const std::string rest = goal.substr(colon + 2);
      return rest.substr(0, rest.find(' '));
    }



    std::string
    goals_table(const RunFolder &run)
    {
      const CsvTable &goals = run.goals;
      HtmlTable       table;
      table.id = "goals";
      table.caption =
        "What the run was made for. Finer meshes and richer theories are held "
        "to end within value ± bar. The estimated error comes from richer "
        "models of the same scene; the corrected value is the value with its "
        "estimated error added.";
      table.header = {"number",
                      "value",
                      "unit",
                      "estimated error",
                      "corrected value",
                      "bar ±",
                      "bar [%]",
                      "tolerance",
                      "judgement"};
      for (unsigned int k = 0; k < goals.rows.size(); ++k)
        {
          const std::string name      = goals.cell(k, "goal");
          const bool        trusted   = goals.cell(k, "trusted") == "1";
          const std::string met       = goals.cell(k, "met");
          const double      scale     = goals.value(k, "scale");
          const double      share     = 100. * goals.value(k, "bar") / scale;
          std::string       judgement = trusted ?
                                          "the bar holds" :
                                          "no bar: " + escaped(goals.cell(k, "why"));
          if (trusted && !met.empty())
            judgement =
              met == "1" ? "within the tolerance" : "<b>tolerance not met</b>";
          if (!trusted || met == "0")
            table.marked.push_back(k);
          table.rows.push_back({escaped(name),
                                number(goals.cell(k, "value"), 0., 6),
                                run.unit_of_column(column_of_goal(name)),
                                number(goals.cell(k, "estimate"), scale, 3),
                                number(goals.cell(k, "corrected"), 0., 6),
                                number(goals.cell(k, "bar"), 0., 2),
                                std::isfinite(share) ? readable(share, 2) : "–",
                                number(goals.cell(k, "tolerance"), 0., 2),
                                judgement});
        }
      return to_html(table);
    }



    std::string
    passes_table(const RunFolder &run)
    {
      HtmlTable table;
      table.id      = "passes";
      table.caption = "The passes of the run to its tolerance, each with a "
                      "finer model";
      for (const std::string &name : run.passes.names)
        table.header.push_back(escaped(name));
      for (const auto &row : run.passes.rows)
        {
          table.rows.emplace_back();
          for (const std::string &cell : row)
            table.rows.back().push_back(number(cell));
        }
      return to_html(table);
    }



    /// A table of the probes at the last load step with their places and
    /// @p columns.
    std::string
    probes_table(const RunFolder                &run,
                 const std::string              &id,
                 const std::string              &caption,
                 const std::vector<std::string> &columns,
                 const bool                      with_places)
    {
      HtmlTable table;
      table.id      = id;
      table.caption = caption;
      table.header  = {"probe", "body", "ply"};
      for (unsigned int k = 0; k < run.probes.rows.size(); ++k)
        table.rows.push_back({escaped(run.probes.cell(k, "probe")),
                              escaped(run.probes.cell(k, "body")),
                              number(run.probes.cell(k, "ply"))});
      if (with_places)
        add_columns(table, run, run.probes, {"x", "y", "z"});
      add_columns(table, run, run.probes, columns);
      return to_html(table);
    }



    /// Adds a row for each of the references `quantity: value: source | ...` of
    /// the scene, @p found telling the run's text of a quantity.
    template <typename Found>
    void
    add_references(HtmlTable         &table,
                   const RunFolder   &run,
                   const std::string &subsection,
                   const Found       &found)
    {
      for (const std::string &reference :
           split(run.says(subsection + "/References"), '|'))
        {
          const std::vector<std::string> parts = split(reference, ':');
          if (parts.size() < 3)
            continue;
          const std::string value    = found(parts[0]);
          const double      expected = to_number(parts[1]);
          const double      off = 100. * (to_number(value) / expected - 1.);
          table.rows.push_back(
            {escaped(subsection) + ": " + run.with_unit(parts[0]),
             number(value, std::abs(expected)),
             number(parts[1]),
             value.empty() || !std::isfinite(off) ? "–" : readable(off, 3),
             escaped(joined({parts.begin() + 2, parts.end()}, ": "))});
        }
    }



    std::string
    references_table(const RunFolder &run)
    {
      HtmlTable table;
      table.id = "references";
      table.caption =
        "Numbers of this run beside values from elsewhere, as the "
        "scene gives them";
      table.header = {
        "quantity", "this run", "reference", "difference [%]", "source"};
      for (const std::string &name : run.names("Probes"))
        add_references(
          table, run, "Probe " + name, [&](const std::string &column) {
            for (unsigned int k = 0; k < run.probes.rows.size(); ++k)
              if (run.probes.cell(k, "probe") == name)
                return run.probes.cell(k, column);
            return std::string();
          });
      const auto add = [&](const std::string &list,
                           const std::string &kind,
                           const std::string &key,
                           const std::string &force) {
        for (const std::string &name : run.names(list))
          add_references(
            table, run, kind + " " + name, [&](const std::string &component) {
              const Json &of = member(member(run.summary, key), name);
              return component.size() == 2 && of.contains(force) ?
                       of[force].at(component[1] - 'x').dump() :
                       std::string();
            });
      };
      add("Supports", "Support", "supports", "reaction");
      add("Contacts", "Contact", "contacts", "force");
      return table.rows.empty() ? "" : to_html(table);
    }
  } // namespace



  Chapter
  sections_chapter(const RunFolder &run, Pictures &pictures)
  {
    std::string html;
    for (const std::string &name : run.names("Sections"))
      {
        const std::string shape = run.says("Section " + name + "/Shape");
        const std::vector<Extent> plies = plies_of(run.section_mesh(name));
        html += "<h3>" + escaped(name) + "</h3>\n" +
                paragraph("Shape: " + escaped(shape) + ".");
        if (!plies.empty())
          html += plies_table(run, name, plies);
        const Json section = run.section_stiffness(name);
        if (!section.is_null())
          html += stiffness_table(run, name, section);
        html += pictures.show_one("section_" + name,
                                  "The mesh of the section, its plies, and the "
                                  "names of its surfaces.");
      }
    if (html.empty())
      html = paragraph("The scene has no sections.");
    return {"sections", "Sections and plies", html};
  }



  namespace
  {
    /// Why the numbers have no bars.
    std::string
    no_bars(const RunFolder &run)
    {
      const std::string why = run.summary.value("no_error_bars", "");
      const std::string how =
        "how exact the numbers below are is not known from this run alone.";
      if (!why.empty())
        return "There are no error bars: " + escaped(why) + ". So " + how;
      return "The scene names no goals, or asked for no error bars: " + how +
             " (<code>--set \"Goals/Error bars=true\"</code> puts a bar on "
             "them.)";
    }
  } // namespace



  Chapter
  numbers_chapter(const RunFolder &run, Pictures &pictures)
  {
    std::string html = run.goals.empty() ?
                         paragraph(no_bars(run)) :
                         goals_table(run) + pictures.show("goals");
    if (!run.passes.empty())
      html += passes_table(run) + pictures.show("passes");
    if (!run.probes.empty())
      {
        html += probes_table(run,
                             "probes-displacements",
                             "Displacements at the probes, last load step. A "
                             "point between two plies has a row for each; ply "
                             "0 is a mean over several",
                             {"ux", "uy", "uz"},
                             true);
        html += probes_table(run,
                             "probes-stresses",
                             "Stresses at the probes in the scene's axes, last "
                             "load step",
                             {"sxx", "syy", "szz", "sxy", "sxz", "syz"},
                             false);
      }
    html += references_table(run);
    return {"numbers", "Numbers, with their error bars", html};
  }



  Chapter
  shape_chapter(const RunFolder &run, Pictures &pictures)
  {
    std::string html = pictures.show("deformed");
    if (html.empty())
      html = paragraph(
        run.says("Write VTU") == "false" ?
          "There is no picture of the deformed bodies: the run was told to "
          "write no displacements for it (<code>Write VTU = false</code>)." :
          "There is no picture of the deformed bodies.");
    for (const char *kind :
         {"along_the_axis", "across_the_width", "through_the_thickness"})
      html += pictures.show(kind);
    for (const std::string &cut : run.names("Cuts"))
      html += pictures.show("section_" + cut);
    for (const std::string &line : run.names("Lines"))
      html += pictures.show_one(line,
                                "Displacements and stresses along the line " +
                                  escaped(line) + ".");
    return {"shape", "Deformed shape and fields", html};
  }
} // namespace lamella
