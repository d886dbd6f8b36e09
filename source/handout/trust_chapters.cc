// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/base/version.h>
#include <lamella/handout/chapters.h>
#include <lamella/handout/html.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace lamella
{
  using Json   = nlohmann::ordered_json;
  namespace fs = std::filesystem;

  namespace
  {
    /// Tables of up to so many bytes are put into the page whole.
    constexpr std::uintmax_t largest_table = 1 << 20;

    /// Of each kind, that is what a glance takes in.
    constexpr unsigned int most_at_a_glance = 6;



    double
    value_of(const Json &json)
    {
      return json.is_number() ? json.get<double>() : std::nan("");
    }



    bool
    is_finished(const RunFolder &run)
    {
      return run.summary.value("converged", false);
    }



    std::string
    steps_text(const RunFolder &run)
    {
      return number(run.summary.value("load_steps", Json())) + " of " +
             number(run.summary.value("load_steps_of_scene", Json())) +
             " load steps";
    }



    /// A row for the sum of what @p value gives, beyond @p most_at_a_glance one
    /// that refers to the chapter @p chapter.
    template <typename Cells>
    void
    add_first(HtmlTable         &table,
              const std::size_t  n,
              const std::string &chapter,
              const Cells       &cells)
    {
      for (unsigned int k = 0; k < n && k < most_at_a_glance; ++k)
        table.rows.push_back(cells(k));
      if (n > most_at_a_glance)
        table.rows.push_back({"<a href=\"#" + chapter + "\">" +
                                std::to_string(n - most_at_a_glance) +
                                " more</a>",
                              "–"});
    }



    void
    add_goals(HtmlTable &table, const RunFolder &run)
    {
      add_first(table,
                run.goals.rows.size(),
                "numbers",
                [&run](const unsigned int k) {
                  const std::string name  = run.goals.cell(k, "goal");
                  const auto        colon = name.rfind(": ");
                  const std::string column =
                    colon == std::string::npos ? "" : name.substr(colon + 2);
                  const std::string bar = run.goals.cell(k, "bar");
                  return std::vector<std::string>{
                    escaped(name),
                    number(run.goals.cell(k, "value"), 0., 6) +
                      (bar.empty() ? "" : " ± " + number(bar, 0., 2)) + " " +
                      run.unit_of_column(column.substr(0, column.find(' '))) +
                      (bar.empty() ? " (no bar)" : "")};
                });
    }



    void
    add_contacts(HtmlTable &table, const RunFolder &run)
    {
      std::vector<std::string> names;
      for (const auto &contact : member(run.summary, "contacts").items())
        names.push_back(contact.key());
      add_first(table, names.size(), "contact", [&](const unsigned int k) {
        const Json &contact = run.summary["contacts"][names[k]];
        return std::vector<std::string>{
          "contact " + escaped(names[k]),
          "force " + components(member(contact, "force")) +
            run.unit_behind("force") + "; " +
            number(contact.value("active", Json())) + " of " +
            number(contact.value("rows", Json())) + " pairs touch"};
      });
    }



    void
    add_probes(HtmlTable &table, const RunFolder &run)
    {
      std::vector<unsigned int> first; // row of each probe
      for (unsigned int k = 0; k < run.probes.rows.size(); ++k)
        if (k == 0 ||
            run.probes.cell(k, "probe") != run.probes.cell(k - 1, "probe"))
          first.push_back(k);
      add_first(table, first.size(), "numbers", [&](const unsigned int p) {
        // The largest component.
        std::string column = "ux";
        for (const char *other : {"uy", "uz"})
          if (std::abs(run.probes.value(first[p], other)) >
              std::abs(run.probes.value(first[p], column)))
            column = other;
        return std::vector<std::string>{
          "displacement of probe " +
            escaped(run.probes.cell(first[p], "probe")),
          symbol(column) + " = " + number(run.probes.cell(first[p], column)) +
            run.unit_behind("length")};
      });
    }



    /// @p warning, which begins and ends in the middle of one, as a sentence.
    std::string
    sentence(std::string warning)
    {
      if (!warning.empty() && warning[0] >= 'a' && warning[0] <= 'z')
        warning[0] += 'A' - 'a';
      return escaped(warning) + ".";
    }



    /// Goals without a bar, or outside of their tolerance; what is true of
    /// several is said once.
    std::vector<std::string>
    doubts_of_goals(const RunFolder &run)
    {
      std::vector<std::pair<std::string, std::string>> why; // and names
      std::string                                      beyond;
      const auto add = [](std::string &names, const std::string &name) {
        names += (names.empty() ? "" : "; ") + name;
      };
      for (unsigned int k = 0; k < run.goals.rows.size(); ++k)
        {
          const std::string name   = escaped(run.goals.cell(k, "goal"));
          const std::string reason = escaped(run.goals.cell(k, "why"));
          if (run.goals.cell(k, "met") == "0")
            add(beyond, name);
          if (run.goals.cell(k, "trusted") == "1")
            continue;
          auto known = std::find_if(why.begin(), why.end(), [&](const auto &w) {
            return w.first == reason;
          });
          if (known == why.end())
            known = why.insert(why.end(), {reason, ""});
          add(known->second, name);
        }
      std::vector<std::string> doubts;
      for (const auto &[reason, names] : why)
        doubts.push_back("No error bar is held for " + names + ": " + reason +
                         ".");
      if (!beyond.empty())
        doubts.push_back("The tolerance is not met of " + beyond + ".");
      return doubts;
    }



    /// A check with what it means and how much is too much.
    struct Check
    {
      std::string key, what, limit;
    };



    /// Beyond what a run ends (`solve/checks.h`: require_sound()).
    const std::vector<Check> &
    checks()
    {
      static const std::vector<Check> all{
        {"force_balance",
         "Sum of all forces on a body (loads, reactions, contact) over the "
         "largest of them, the worst body. Zero in equilibrium",
         "10⁻³"},
        {"residual",
         "Forces that remain unbalanced inside of the bodies, over the inner "
         "forces. Zero where the equations are solved exactly",
         "10⁻³"},
        {"energy_balance",
         "Strain energy against the work of all forces (Clapeyron's theorem), "
         "relative. Zero if both agree",
         "10⁻³"},
        {"max_rotation",
         "Largest rotation [rad]. The model is linear: from 0.1 on geometry "
         "would have to follow the deformation",
         ""},
        {"beyond_linear/stiffening",
         "Stiffening: twice the energy of what stretching at large deflections "
         "would leave in the worst body, over its energy. About the share by "
         "which forces at these displacements are too small in a linear model",
         "1, unless accepted"},
        {"beyond_linear/buckling_factor",
         "Buckling factor: what multiplies the loads where the worst load step "
         "buckles; none if that is above 100, or never. Loads over that factor "
         "is what the linear model leaves out",
         "1 from above, unless accepted"}};
      return all;
    }



    std::string
    checks_table(const RunFolder &run)
    {
      HtmlTable table;
      table.id = "checks";
      table.caption =
        "Checks of the last load step. A run that exceeds a limit "
        "ends with an error and leaves no numbers of that step.";
      table.header = {"check", "value", "limit"};
      for (const Check &check : checks())
        table.rows.push_back(
          {check.what,
           number(
             run.summary.value(Json::json_pointer("/" + check.key), Json())),
           check.limit.empty() ? escaped(run.says("Rotation limit")) :
                                 check.limit});
      for (const char *key : {"free_corrections", "contact_corrections"})
        if (const Json &corrections = member(run.summary, key);
            corrections.is_array() && !corrections.empty())
          table.rows.push_back(
            {std::string("Last correction of the ") +
               (key[0] == 'f' ? "displacements without contact" :
                                "contact solution") +
               " over the displacements: digits that are still moving",
             number(corrections.back()),
             "10⁻⁶"});
      return to_html(table);
    }



    std::string
    contact_law_table(const RunFolder &run)
    {
      const Json &contacts = member(run.summary, "contacts");
      if (contacts.empty())
        return "";
      const std::string force = run.unit("force"), length = run.unit("length");
      HtmlTable         table;
      table.id = "contact-law";
      table.caption =
        "The contact law over all pairs, touching or not: no force "
        "pulls, nothing penetrates beyond what a penalty is made "
        "for, no force acts across an open gap.";
      table.header = {"contact",
                      "smallest force " + run.unit_in_brackets("force"),
                      "largest penetration " + run.unit_in_brackets("length"),
                      "penetration over the scene's size",
                      "gaps miss the law by " + run.unit_in_brackets("length"),
                      "force times open gap " + run.moment_unit_in_brackets()};
      for (const auto &contact : contacts.items())
        {
          table.rows.push_back({escaped(contact.key())});
          for (const char *key : {"min_force",
                                  "max_penetration",
                                  "max_penetration_relative",
                                  "law_error",
                                  "complementarity"})
            table.rows.back().push_back(
              number(contact.value().value(key, Json())));
        }
      return to_html(table);
    }



    /// Sizes with their units, for people.
    std::string
    size_text(const std::uintmax_t bytes)
    {
      return bytes < 1024        ? std::to_string(bytes) + " bytes" :
             bytes < 1024 * 1024 ? to_text(bytes / 1024., 3) + " kB" :
                                   to_text(bytes / 1048576., 3) + " MB";
    }



    std::string
    seconds_table(const RunFolder &run)
    {
      HtmlTable table;
      table.id      = "costs";
      table.caption = "What the run cost";
      table.header  = {"what", "value", "unit"};
      table.rows.push_back({"degrees of freedom, all bodies",
                            number(run.summary.value("dofs", Json()), 0., 12),
                            ""});
      for (const auto &phase : member(run.summary, "seconds").items())
        table.rows.push_back({phase.key() == "total" ?
                                "<b>time in all</b>" :
                                "time of: " + escaped(phase.key()),
                              number(phase.value()),
                              "[s]"});
      table.rows.push_back({"largest memory of a process",
                            number(run.summary.value("peak_memory_mb", Json())),
                            "[MB]"});
      table.rows.push_back(
        {"processes", number(run.summary.value("processes", Json())), ""});
      return to_html(table);
    }



    std::string
    bodies_table(const RunFolder &run)
    {
      HtmlTable table;
      table.id      = "bodies";
      table.caption = "Bodies and their equations";
      table.header  = {"body", "theory", "DoFs", "solver"};
      for (const auto &body : member(run.summary, "bodies").items())
        table.rows.push_back(
          {escaped(body.key()),
           escaped(
             member(run.summary, "theory").value(body.key(), std::string())),
           number(body.value().value("dofs", Json()), 0., 12),
           escaped(member(body.value(), "solver").value("name", "–"))});
      return to_html(table);
    }
  } // namespace



  Chapter
  glance_chapter(const RunFolder &run)
  {
    HtmlTable table;
    table.id     = "glance";
    table.header = {"what", "result"};
    table.rows.push_back(
      {"the run",
       (is_finished(run) ? "came to its end: " :
                           "<b>did not come to its end</b>: ") +
         steps_text(run)});
    add_goals(table, run);
    if (run.goals.empty())
      add_probes(table, run);
    add_contacts(table, run);
    if (const Json &worst = member(run.summary, "strength"); !worst.empty())
      table.rows.push_back(
        {"smallest reserve factor",
         (worst.contains("reserve_factor") ? number(worst["reserve_factor"]) :
                                             "none") +
           " (ply " + number(worst.at("ply")) + " of " +
           escaped(worst.at("body").get<std::string>()) + ", " +
           escaped(worst.at("criterion").get<std::string>()) + ": " +
           escaped(worst.at("mode").get<std::string>()) + ")"});
    if (const Json &first = member(run.summary, "first_failure");
        !first.empty())
      table.rows.push_back(
        {"first failure", "at load factor " + number(first.at("load_factor"))});
    table.rows.push_back(
      {"size and time",
       number(run.summary.value("dofs", Json()), 0., 12) +
         " degrees of freedom, " +
         number(member(member(run.summary, "seconds"), "total"), 0., 3) +
         "&nbsp;s"});
    return {"glance", "At a glance", to_html(table)};
  }



  Chapter
  warnings_chapter(const RunFolder &run, const std::string &why)
  {
    std::vector<std::string> items;
    if (!is_finished(run))
      items.push_back("<b>The run did not come to its end</b>: what follows is "
                      "of " +
                      steps_text(run) +
                      ". What stopped it stood on its console.");
    const Json &worst = member(run.summary, "strength");
    if (const double reserve = value_of(worst.value("reserve_factor", Json()));
        reserve <= 1.)
      items.push_back(
        "<b>A ply has failed</b>: the smallest reserve factor is " +
        number(worst["reserve_factor"]) +
        ". See <a "
        "href=\"#strength\">Reserve factors</a>.");
    for (const std::string &doubt : doubts_of_goals(run))
      items.push_back(doubt);
    for (const Json &warning : member(run.summary, "warnings"))
      if (warning.is_string())
        items.push_back(sentence(warning.get<std::string>()));
    if (run.summary.value("version", "") != version())
      items.push_back("The run was made by version " +
                      escaped(run.summary.value("version", "?")) +
                      " of Lamella, this page by version " +
                      escaped(version()) + ".");
    if (!why.empty())
      items.push_back(escaped(why));
    return {"warnings",
            "Warnings",
            items.empty() ?
              paragraph("The run gave no warnings.") :
              "<div class=\"warnings\">" + list(items) + "</div>\n"};
  }



  Chapter
  checks_chapter(const RunFolder &run)
  {
    std::string html  = checks_table(run) + contact_law_table(run);
    const Json &jumps = member(run.summary, "interface_jumps");
    if (!jumps.empty())
      {
        HtmlTable table;
        table.id = "interface-jumps";
        table.caption =
          "Jumps of the tractions at ply interfaces, over the largest stress on "
          "the line, and over its largest traction. Where the line is normal "
          "to the plies, the exact solution has none; what is there says how "
          "far transverse stresses are off. Where these should vanish, the "
          "second compares an error with itself.";
        table.header = {"line", "over the stress", "over the traction"};
        const Json &of_tractions =
          member(run.summary, "interface_jumps_of_tractions");
        for (const auto &line : jumps.items())
          table.rows.push_back({escaped(line.key()),
                                number(line.value()),
                                number(member(of_tractions, line.key()))});
        html += to_html(table);
      }
    return {"checks", "Checks", html};
  }



  Chapter
  costs_chapter(const RunFolder &run, Pictures &pictures)
  {
    return {"costs",
            "Size, time and memory",
            seconds_table(run) + bodies_table(run) +
              pictures.show_one("fields")};
  }



  Chapter
  files_chapter(const RunFolder &run)
  {
    std::vector<std::string> items;
    for (const std::string &file : run.table_files())
      {
        const std::string path = run.path + "/" + file;
        std::error_code   error;
        const auto        size = fs::file_size(path, error);
        if (error)
          continue;
        const std::string words = " (" + size_text(size) + ")";
        items.push_back(
          size > largest_table ?
            "<code>" + escaped(file) + "</code>" + words +
              ", too long for this page, in the folder of the results" :
            "<a download=\"" + escaped(replaced(file, "/", "_")) +
              "\" href=\"" + data_uri("text/csv", content_of(path)) + "\">" +
              escaped(file) + "</a>" + words);
      }
    return {"files",
            "All numbers as tables",
            paragraph("The tables of the run are in this page; a click saves "
                      "one (CSV, numbers with 15 digits, in the scene's "
                      "units).") +
              list(items)};
  }



  Chapter
  again_chapter(const RunFolder &run)
  {
    const Json       &n_processes = member(run.summary, "processes");
    const std::string processes =
      n_processes.is_number() && n_processes.get<unsigned int>() > 1 ?
        "mpirun -np " + n_processes.dump() + " " :
        "";
    std::string html = paragraph(
      "Save the text below as <code>scene.prm</code> and run it with Lamella " +
      escaped(run.summary.value("version", "")) +
      ". It is the scene as it was run, with the values of all entries that "
      "the user left out.");
    html += "<pre>" + escaped(processes) +
            "lamella scene.prm --output again\nlamella report again</pre>\n";
    for (const std::string &name : run.names("Sections"))
      if (run.says("Section " + name + "/Shape") == "file")
        html += paragraph("It needs the mesh of the section " + escaped(name) +
                          ", <code>" +
                          escaped(run.says("Section " + name + "/File")) +
                          "</code>, which is not in this page.");
    return {"again",
            "How to run it again",
            html + "<pre class=\"scene\">" + escaped(run.scene_text) +
              "</pre>\n"};
  }
} // namespace lamella
