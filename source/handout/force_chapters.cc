// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/handout/chapters.h>
#include <lamella/handout/html.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace lamella
{
  using Json = nlohmann::ordered_json;

  namespace
  {
    /// Rows that a reader looks through; the folder's table has all of them.
    constexpr unsigned int most_plies = 24, most_points = 8, most_steps = 8;



    // ---- contact

    /// What is known of the contact @p name as a whole.
    std::string
    contact_table(const RunFolder   &run,
                  const std::string &name,
                  const Json        &contact)
    {
      HtmlTable table;
      table.id          = "contact-" + name;
      table.caption     = "Contact " + escaped(name) + " at the last load step";
      table.header      = {"what", "value", "unit"};
      const auto force  = run.unit_in_brackets("force"),
                 length = run.unit_in_brackets("length"),
                 stress = run.unit_in_brackets("stress");
      // Penetrations below 1e-9 of the scene are rounding.
      const double relative = contact.value("max_penetration_relative", 0.);
      const double size =
        relative > 0. ? contact.value("max_penetration", 0.) / relative : 0.;
      const auto add = [&](const std::string &key,
                           const std::string &what,
                           const std::string &unit) {
        if (contact.contains(key))
          table.rows.push_back(
            {what,
             contact[key].is_array() ?
               components(contact[key]) :
               number(contact[key], key == "max_penetration" ? size : 0.),
             unit});
      };
      const std::string second =
        escaped(split(run.says("Contact " + name + "/Second"), ':').front());
      add("force", "force on " + second, force);
      add("centre_of_pressure", "a point on its line of action", length);
      add("rows", "pairs of points that may touch", "");
      add("active", "of these touch", "");
      add("pressure", "mean pressure over what is pressed", stress);
      add("width", "width of what is pressed", length);
      add("max_penetration", "largest penetration", length);
      add("initial_gap_min", "smallest gap at the start", length);
      add("initial_gap_max", "largest gap at the start", length);
      add("unpaired", "points of the first surface without a partner", "");
      add("unpaired_second", "points of the second one without a partner", "");
      return to_html(table);
    }



    /// The pairs with the largest pressures.
    std::string
    peaks_table(const RunFolder &run, const std::string &name)
    {
      const CsvTable            pairs = run.contact(name);
      std::vector<unsigned int> order;
      for (unsigned int k = 0; k < pairs.rows.size(); ++k)
        if (pairs.value(k, "pressure") > 0.)
          order.push_back(k);
      if (order.empty())
        return "";
      std::stable_sort(order.begin(),
                       order.end(),
                       [&pairs](const unsigned int a, const unsigned int b) {
                         return pairs.value(a, "pressure") >
                                pairs.value(b, "pressure");
                       });
      const std::size_t n = order.size();
      order.resize(std::min<std::size_t>(n, most_points));
      HtmlTable table;
      table.id      = "peaks-of-" + name;
      table.caption = "The largest of the " + std::to_string(n) +
                      " pressures of " + escaped(name) +
                      ", with the force of each point and the places in the "
                      "bodies as they were at the start. All of them: "
                      "<code>contact_" +
                      escaped(name) + ".csv</code>";
      for (const char *column : {"x", "y", "z"})
        table.header.push_back("<i>" + std::string(column) + "</i> " +
                               run.unit_in_brackets("length"));
      table.header.push_back("pressure " + run.unit_in_brackets("stress"));
      table.header.push_back("force " + run.unit_in_brackets("force"));
      table.header.push_back("gap " + run.unit_in_brackets("length"));
      const auto is_length = [](const std::string &column) {
        return column != "pressure" && column != "force";
      };
      double size = 0.;
      for (const unsigned int k : order)
        for (const char *column : {"x", "y", "z"})
          size = std::max(size, std::abs(pairs.value(k, column)));
      for (const unsigned int k : order)
        {
          table.rows.emplace_back();
          for (const char *column : {"x", "y", "z", "pressure", "force", "gap"})
            table.rows.back().push_back(
              number(pairs.cell(k, column), is_length(column) ? size : 0.));
        }
      return to_html(table);
    }



    // ---- strength

    /// The rows of @p plies, the smallest reserve factor first, those without
    /// one (nothing brings failure) last.
    std::vector<unsigned int>
    worst_first(const CsvTable &plies)
    {
      std::vector<unsigned int> order(plies.rows.size());
      std::iota(order.begin(), order.end(), 0);
      const auto reserve = [&plies](const unsigned int k) {
        const double value = plies.value(k, "reserve_factor");
        return std::isnan(value) ? std::numeric_limits<double>::infinity() :
                                   value;
      };
      std::stable_sort(order.begin(),
                       order.end(),
                       [&](const unsigned int a, const unsigned int b) {
                         return reserve(a) < reserve(b);
                       });
      return order;
    }



    /// The rows @p order of @p plies, with their load steps if @p with_step.
    std::string
    reserves_table(const RunFolder                 &run,
                   const CsvTable                  &plies,
                   const std::vector<unsigned int> &order,
                   const std::string               &id,
                   const std::string               &caption,
                   const bool                       with_step)
    {
      const std::string length = run.unit_in_brackets("length");
      HtmlTable         table;
      table.id      = id;
      table.caption = caption;
      table.header  = {"reserve factor",
                       "body",
                       "ply",
                       "criterion",
                       "what fails",
                       "index",
                       "<i>x</i> " + length,
                       "<i>y</i> " + length,
                       "<i>z</i> " + length,
                       "fracture angle [°]"};
      // Only Puck's criterion has one.
      const bool with_angle =
        std::any_of(order.begin(), order.end(), [&plies](const unsigned int k) {
          return !plies.cell(k, "angle").empty();
        });
      if (!with_angle)
        table.header.pop_back();
      if (with_step)
        table.header.insert(table.header.begin(), "load step");
      for (const unsigned int k : order)
        {
          if (plies.value(k, "reserve_factor") <= 1.)
            table.marked.push_back(table.rows.size());
          double size = 0.;
          for (const char *column : {"x", "y", "z"})
            size = std::max(size, std::abs(plies.value(k, column)));
          table.rows.emplace_back();
          std::vector<std::string> &row = table.rows.back();
          if (with_step)
            row.push_back(number(plies.cell(k, "step")));
          const std::string &reserve = plies.cell(k, "reserve_factor");
          row.push_back(reserve.empty() ? "none" : number(reserve));
          row.push_back(escaped(plies.cell(k, "body")));
          row.push_back(number(plies.cell(k, "ply")));
          row.push_back(escaped(plies.cell(k, "criterion")));
          row.push_back(escaped(plies.cell(k, "mode")));
          row.push_back(number(plies.cell(k, "index")));
          for (const char *column : {"x", "y", "z"})
            row.push_back(number(plies.cell(k, column), size));
          if (with_angle)
            row.push_back(number(plies.cell(k, "angle")));
        }
      return to_html(table);
    }



    /// Of each load step the row with the smallest reserve factor.
    std::vector<unsigned int>
    governing(const CsvTable &plies)
    {
      std::vector<unsigned int> rows;
      std::vector<std::string>  steps;
      for (const unsigned int k : worst_first(plies))
        if (const std::string &step = plies.cell(k, "step");
            std::find(steps.begin(), steps.end(), step) == steps.end())
          {
            steps.push_back(step);
            rows.push_back(k);
          }
      std::sort(rows.begin(), rows.end());
      return rows;
    }



    std::string
    first_failure(const RunFolder &run)
    {
      if (!run.summary.contains("first_failure"))
        return "";
      const Json &first = run.summary["first_failure"];
      return paragraph(
        "<b>First failure at load factor " + number(first.at("load_factor")) +
        "</b> (none at " + number(first.at("safe")) + "): ply " +
        number(first.at("ply")) + " of " +
        escaped(first.at("body").get<std::string>()) + ", " +
        escaped(first.at("criterion").get<std::string>()) + ", " +
        escaped(first.at("mode").get<std::string>()) + ", at " +
        components(first.at("place")) + run.unit_behind("length") + ".");
    }



    // ---- forces

    using Force = std::array<double, 3>;



    Force
    force_of(const Json &json)
    {
      Force force{{0., 0., 0.}};
      for (unsigned int c = 0; c < 3 && c < json.size(); ++c)
        force[c] = json[c].is_number() ? json[c].get<double>() : 0.;
      return force;
    }



    /// Whether the load @p name is a temperature, which has no resultant.
    bool
    is_heat(const RunFolder &run, const std::string &name)
    {
      return !run.says("Load " + name + "/Temperature").empty();
    }



    /// What the loads are in all.
    std::string
    loads_table(const RunFolder &run)
    {
      HtmlTable table;
      table.id      = "loads";
      table.caption = "What the loads are in all at load factor 1, moments "
                      "about the scene's origin";
      table.header  = {"load",
                       "force " + run.unit_in_brackets("force"),
                       "moment " + run.moment_unit_in_brackets()};
      for (const auto &load : member(run.summary, "loads").items())
        if (!is_heat(run, load.key()))
          table.rows.push_back({escaped(load.key()),
                                components(member(load.value(), "force")),
                                components(member(load.value(), "moment"))});
      return table.rows.empty() ? "" : to_html(table);
    }



    /// All that acts on the bodies from outside at the last load step; its sum
    /// is zero in equilibrium. Forces between bodies are inner ones.
    std::string
    balance_table(const RunFolder &run)
    {
      const unsigned int n = run.history.rows.size();
      if (n == 0)
        return paragraph("The run left no table of its load steps.");
      const double      factor = run.history.value(n - 1, "load_factor");
      const std::string force  = run.unit_in_brackets("force");
      HtmlTable         table;
      table.id      = "forces";
      table.caption = "All forces on the bodies from outside at the last load "
                      "step, load factor " +
                      number(factor) + ". In equilibrium their sum is zero.";
      table.header = {"from",
                      symbol("fx") + " " + force,
                      symbol("fy") + " " + force,
                      symbol("fz") + " " + force};
      std::vector<std::pair<std::string, Force>> all;
      for (const auto &load : member(run.summary, "loads").items())
        {
          if (is_heat(run, load.key()))
            continue;
          Force on_bodies = force_of(member(load.value(), "force"));
          for (double &component : on_bodies)
            component *= factor;
          all.emplace_back("load " + load.key(), on_bodies);
        }
      for (const auto &support : member(run.summary, "supports").items())
        all.emplace_back("support " + support.key(),
                         force_of(member(support.value(), "reaction")));
      for (const auto &contact : member(run.summary, "contacts").items())
        {
          const std::string second =
            run.says("Contact " + contact.key() + "/Second");
          if (second.find(':') != std::string::npos)
            continue; // a body's
          Force on_bodies = force_of(member(contact.value(), "force"));
          for (double &component : on_bodies)
            component = -component; // reported as it acts on the obstacle
          all.emplace_back("obstacle " + second + " (contact " + contact.key() +
                             ")",
                           on_bodies);
        }
      Force  sum{{0., 0., 0.}};
      double size = 0.;
      for (const auto &[from, on_bodies] : all)
        for (unsigned int c = 0; c < 3; ++c)
          {
            sum[c] += on_bodies[c];
            size = std::max(size, std::abs(on_bodies[c]));
          }
      all.emplace_back("sum", sum);
      for (const auto &[from, on_bodies] : all)
        table.rows.push_back({escaped(from),
                              number(on_bodies[0], size),
                              number(on_bodies[1], size),
                              number(on_bodies[2], size)});
      table.marked = {static_cast<unsigned int>(all.size()) - 1};
      return to_html(table);
    }



    /// Moments of the reactions about points of their own.
    std::string
    reactions_table(const RunFolder &run)
    {
      const Json &supports = member(run.summary, "supports");
      if (supports.empty())
        return "";
      HtmlTable table;
      table.id = "reactions";
      table.caption =
        "What the supports do to the bodies at the last load step";
      table.header = {"support",
                      "force " + run.unit_in_brackets("force"),
                      "moment " + run.moment_unit_in_brackets(),
                      "about the point " + run.unit_in_brackets("length")};
      for (const auto &support : supports.items())
        table.rows.push_back({escaped(support.key()),
                              components(member(support.value(), "reaction")),
                              components(member(support.value(), "moment")),
                              components(member(support.value(), "about"))});
      return to_html(table);
    }



    /// The columns of history.csv, `support:NAME:fx`, `contact:NAME:fx` or
    /// `probe:NAME:ux`, but for those that are zero in all steps, and how large
    /// each of them gets.
    std::vector<std::pair<std::string, double>>
    columns_of_history(const CsvTable &history)
    {
      std::vector<std::pair<std::string, double>> columns;
      for (const std::string &name : history.names)
        {
          double size = 0.;
          for (unsigned int k = 0; k < history.rows.size(); ++k)
            size = std::max(size, std::abs(history.value(k, name)));
          if (size > 0. && name != "step")
            columns.emplace_back(name, size);
        }
      return columns;
    }



    /// history.csv, a column a load step: there are more quantities than a page
    /// is wide. Of many load steps the last ones.
    std::string
    history_table(const RunFolder &run)
    {
      const CsvTable    &history = run.history;
      const unsigned int n       = history.rows.size();
      if (n < 2)
        return "";
      const unsigned int first = n > most_steps ? n - most_steps : 0;
      HtmlTable          table;
      table.id = "history";
      table.caption =
        "Load step by load step: reactions of supports on the bodies, forces "
        "of contacts on their second side, displacements of probes; components "
        "that stay zero are left out" +
        (first > 0 ? "; the last " + std::to_string(most_steps) + " of " +
                       std::to_string(n) +
                       " load steps, all of them: <code>history.csv</code>" :
                     std::string());
      table.header = {"quantity"};
      for (unsigned int k = first; k < n; ++k)
        table.header.push_back("step " + escaped(history.cell(k, "step")));
      for (const auto &[name, size] : columns_of_history(history))
        {
          const std::vector<std::string> parts = split(name, ':');
          table.rows.push_back({parts.size() == 3 ?
                                  escaped(parts[0] + " " + parts[1]) + ": " +
                                    run.with_unit(parts[2]) :
                                  "load factor"});
          for (unsigned int k = first; k < n; ++k)
            table.rows.back().push_back(number(history.cell(k, name), size));
        }
      return to_html(table);
    }
  } // namespace



  Chapter
  contact_chapter(const RunFolder &run, Pictures &pictures)
  {
    const Json &contacts = member(run.summary, "contacts");
    std::string html =
      contacts.empty() ?
        paragraph("The scene has no contact.") :
        paragraph("Forces and pressures are positive in compression; the force "
                  "of a contact is given as it acts on its second side.");
    html += pictures.show("through_the_contact");
    for (const auto &contact : contacts.items())
      html += "<h3>" + escaped(contact.key()) + "</h3>\n" +
              contact_table(run, contact.key(), contact.value()) +
              pictures.show("contact_" + contact.key()) +
              peaks_table(run, contact.key());
    return {"contact", "Contact", html};
  }



  Chapter
  strength_chapter(const RunFolder &run)
  {
    const std::string title = "Reserve factors of the plies";
    if (run.plies.empty())
      return {"strength",
              title,
              paragraph("No failure criterion was asked for (<code>subsection "
                        "Strength</code>), so this run says nothing of "
                        "failure.")};
    const CsvTable            last  = run.plies.last_step();
    std::vector<unsigned int> order = worst_first(last);
    const std::size_t         n     = order.size();
    order.resize(std::min<std::size_t>(n, most_plies));
    std::string html = paragraph(
      "A reserve factor is what the stresses of the loads may be multiplied "
      "with before the ply fails by the criterion: at 1 or below it has failed. "
      "<i>None</i> means that no such factor is known to bring failure. Places are "
      "those of the bodies before they deform.");
    html += first_failure(run);
    html += reserves_table(run,
                           last,
                           order,
                           "reserve-factors",
                           (order.size() < n ?
                              "The " + std::to_string(order.size()) +
                                " smallest of " + std::to_string(n) +
                                " reserve factors" :
                              "All " + std::to_string(n) + " reserve factors") +
                             std::string(" at the last load step, the worst "
                                         "first. All of them: "
                                         "<code>plies.csv</code>"),
                           false);
    const std::vector<unsigned int> steps = governing(run.plies);
    if (steps.size() > 1)
      html += reserves_table(run,
                             run.plies,
                             steps,
                             "reserve-factors-of-steps",
                             "What governs each load step",
                             true);
    return {"strength", title, html};
  }



  Chapter
  forces_chapter(const RunFolder &run, Pictures &pictures)
  {
    return {"forces",
            "Loads, supports and reactions",
            balance_table(run) + loads_table(run) + reactions_table(run) +
              history_table(run) + pictures.show("history")};
  }
} // namespace lamella
