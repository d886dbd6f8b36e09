// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/body/fields.h>
#include <lamella/recover/strength_sweep.h>
#include <lamella/report/console.h>
#include <lamella/report/tables.h>

#include <deal.II/fe/mapping_q.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <ostream>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    std::string
    history_header(const Results &results)
    {
      std::string header;
      const auto  add = [&header](const std::string              &kind,
                                 const std::vector<std::string> &names,
                                 const std::string              &letter) {
        for (const std::string &name : names)
          for (const char c : {'x', 'y', 'z'})
            header += "," + kind + ":" + name + ":" + letter + c;
      };
      std::vector<std::string> contacts, pressed;
      for (unsigned int k = 0; k < results.contacts.size(); ++k)
        {
          contacts.push_back(results.contacts[k].name);
          if (!results.steps.empty() &&
              results.last().checks.contacts[k].obstacle_displacement)
            pressed.push_back(contacts.back());
        }
      add("support", results.supports, "f");
      add("contact", contacts, "f");
      add("probe", results.probes, "u");
      add("support", results.supports, "m");
      add("contact", contacts, "m");
      add("contact", pressed, "u");
      return header;
    }



    /// Names of columns common to the tables of probes, lines and cuts.
    std::string
    fields_header()
    {
      return "body,ply,x,y,z," + joined(field_names(), ",");
    }



    /// Appends @p row in these columns; plies are numbered from 1.
    std::string
    fields_line(CsvLine &line, const FieldRow &row)
    {
      line << row.body << row.ply + 1 << row.position;
      for (const double value : field_values(row.sample))
        line << value;
      return line.text();
    }



    /// Adds the columns of steps with finite rotations to @p line.
    void
    add_rotations(const StepResults &step, CsvLine &line)
    {
      if (step.checks.is_large)
        line << step.state.iterations << step.halvings << step.checks.max_strain
             << step.checks.max_rotation << step.checks.max_element_rotation;
    }



    /// Forces, displacements and moments of @p state, a StepResults or a
    /// FailureTrial, as history_header() names them.
    template <typename StateOfLoad>
    CsvLine &
    add_state(const StateOfLoad &state, CsvLine &line)
    {
      for (const Resultant &reaction : state.checks.reactions)
        line << reaction.force;
      for (const KktResidual &contact : state.checks.contacts)
        line << contact.force;
      for (const std::vector<FieldRow> &plies : state.probes)
        line << plies.front().sample.displacement;
      for (const Resultant &reaction : state.checks.reactions)
        line << reaction.moment;
      for (const KktResidual &contact : state.checks.contacts)
        line << contact.moment;
      for (const KktResidual &contact : state.checks.contacts)
        if (contact.obstacle_displacement)
          line << *contact.obstacle_displacement;
      return line;
    }



    std::string
    contact_rows(const unsigned int step, const std::vector<ContactRow> &rows)
    {
      std::string text;
      for (const ContactRow &row : rows)
        {
          const ContactInterface::Point &at = row.point;
          CsvLine                        line;
          line << step << at.first << at.second << at.normal << at.area
               << row.initial_gap << row.gap << row.force << row.force / at.area
               << row.touches();
          if (row.friction)
            line << (!row.touches()      ? "open" :
                     row.friction->slips ? "slip" :
                                           "stick")
                 << row.friction->shear << row.friction->length
                 << row.friction->dissipated / at.area;
          text += line.text();
        }
      return text;
    }



    struct Node
    {
      dealii::Point<3> position;
      unsigned int     fields;
    };



    /// DoFs of a node follow upon each other, and all are at home there.
    std::vector<Node>
    nodes_of(const Body &body)
    {
      std::vector<Node> nodes;
      for (DofIndex dof = 0; dof < body.n_dofs(); ++dof)
        {
          const dealii::Point<3> position = body.dof(dof).position;
          if (nodes.empty() || position != nodes.back().position)
            nodes.push_back({position, 0});
          ++nodes.back().fields;
        }
      return nodes;
    }



    /// The side @p f of @p cell as points between semicolons, from its first
    /// vertex to the other or, unless it goes @p forwards, back.
    std::string
    side_points(const Triangulation<2>::active_cell_iterator &cell,
                const unsigned int                            f,
                const bool                                    forwards,
                const MappingQ<2>                            &mapping)
    {
      const bool curved =
        cell->face(f)->manifold_id() != numbers::flat_manifold_id;
      const unsigned int n = curved ? 8 : 1;
      std::string        side;
      for (unsigned int i = 0; i <= n; ++i)
        {
          const double   t    = double(forwards ? i : n - i) / n;
          const Point<2> unit = f < 2 ? Point<2>(f, t) : Point<2>(t, f - 2);
          const Point<2> x    = mapping.transform_unit_to_real_cell(cell, unit);
          side += (i == 0 ? "" : ";") + csv(x[0]) + " " + csv(x[1]);
        }
      return side;
    }



    std::vector<std::string>
    cells_of(const Results &results, const PlyReserve &row)
    {
      return {row.reserve ? to_text(*row.reserve, 5) : "none",
              results.bodies[row.body].name,
              std::to_string(row.ply + 1),
              row.criterion,
              row.mode,
              to_text(row.position),
              row.angle ? to_text(*row.angle, 4) : ""};
    }



    const std::vector<std::string> titles =
      {"reserve factor", "body", "ply", "criterion", "mode", "at", "angle"};
  } // namespace



  FileTexts
  table_headers(const Results &results)
  {
    FileTexts headers;
    headers["probes.csv"]  = "step,probe," + fields_header() + "\n";
    headers["history.csv"] = "step,load_factor" + history_header(results);
    for (const std::string &name : results.measures)
      headers["history.csv"] += ",measure:" + name;
    if (!results.steps.empty() && results.last().checks.is_large)
      headers["history.csv"] +=
        ",iterations,halvings,max_strain,max_rotation,max_element_rotation";
    headers["history.csv"] += "\n";
    for (const std::string &line : results.lines)
      headers["lines/" + line + ".csv"] =
        "s,step,line," + fields_header() + "\n";
    for (const std::string &cut : results.cuts)
      headers["cuts/" + cut + ".csv"] =
        "step,cut,cell,i,j," + fields_header() + "\n";
    for (const ContactSummary &contact : results.contacts)
      headers["contact_" + contact.name + ".csv"] =
        "step,x,y,z,x2,y2,z2,nx,ny,nz,area,initial_gap,gap,force,pressure,"
        "active" +
        std::string(contact.friction > 0. || contact.is_tied() ?
                      ",state,shear_x,shear_y,shear_z,slid,dissipated" :
                      "") +
        "\n";
    if (!results.steps.empty() && !results.last().plies.empty())
      {
        headers["plies.csv"] =
          "step,body,ply,criterion,mode,reserve_factor,index,x,y,z,angle\n";
        headers["plies_along.csv"] =
          "step,body,ply,s,x,y,z,inverse_reserve_factor\n";
      }
    return headers;
  }



  FileTexts
  table_rows(const Results &results, const StepResults &step)
  {
    FileTexts rows;
    for (unsigned int p = 0; p < step.probes.size(); ++p)
      for (const FieldRow &row : step.probes[p])
        rows["probes.csv"] +=
          fields_line(CsvLine() << step.step << results.probes[p], row);
    for (unsigned int l = 0; l < step.lines.size(); ++l)
      for (const LineRow &row : step.lines[l])
        rows["lines/" + results.lines[l] + ".csv"] +=
          fields_line(CsvLine() << row.s << step.step << results.lines[l],
                      row.fields);
    for (unsigned int c = 0; c < step.cuts.size(); ++c)
      for (const CutRow &row : step.cuts[c])
        rows["cuts/" + results.cuts[c] + ".csv"] +=
          fields_line(CsvLine() << step.step << results.cuts[c] << row.cell
                                << row.i << row.j,
                      row.fields);
    for (unsigned int k = 0; k < step.contacts.size(); ++k)
      rows["contact_" + results.contacts[k].name + ".csv"] =
        contact_rows(step.step, step.contacts[k]);
    for (const PlyReserve &row : step.plies)
      rows["plies.csv"] +=
        (CsvLine() << step.step << results.bodies[row.body].name << row.ply + 1
                   << row.criterion << row.mode << row.reserve << row.index
                   << row.position << row.angle)
          .text();
    for (const ReserveAlong &row : step.plies_along)
      rows["plies_along.csv"] +=
        (CsvLine() << step.step << results.bodies[row.body].name << row.ply + 1
                   << row.s << row.position << row.inverse_reserve)
          .text();
    CsvLine history;
    add_state(step, history << step.step << step.load_factor.of_scene());
    for (const double measure : step.measures)
      history << measure;
    add_rotations(step, history);
    rows["history.csv"] = history.text();
    return rows;
  }



  std::string
  failure_table(const Results &results)
  {
    std::vector<FailureTrial> trials = results.first_failure->trials;
    std::stable_sort(trials.begin(),
                     trials.end(),
                     [](const auto &a, const auto &b) {
                       return a.load_factor < b.load_factor;
                     });
    std::string text =
      "load_factor,reserve_factor" + history_header(results) + "\n";
    for (const FailureTrial &trial : trials)
      text += add_state(trial, CsvLine() << trial.load_factor << trial.reserve)
                .text();
    return text;
  }



  std::string
  csv(const double value)
  {
    // As a stream would write it, in a fifth of the time: files of cuts hold
    // hundreds of thousands of numbers.
    std::array<char, 32> text;
    const auto           end = std::to_chars(text.data(),
                                   text.data() + text.size(),
                                   value,
                                   std::chars_format::general,
                                   15);
    return {text.data(), end.ptr};
  }



  std::string
  fields_of_nodes(const Bodies &bodies)
  {
    std::string text = "body,node,s,x,y,z,fields\n";
    for (const auto &body : bodies)
      {
        if (body->is_nodal())
          continue;
        const std::vector<Node> nodes = nodes_of(*body);
        for (unsigned int k = 0; k < nodes.size(); ++k)
          {
            const dealii::Point<3> &place = nodes[k].position;
            text += (CsvLine() << body->name() << k + 1
                               << place.distance(nodes.front().position)
                               << place << nodes[k].fields)
                      .text();
          }
      }
    return text;
  }



  std::string
  section_table(const SectionMesh &section)
  {
    // Sides counter-clockwise: deal.II's face, and its direction there.
    constexpr std::array<std::pair<unsigned int, bool>, 4> around{
      {{2, true}, {1, true}, {3, false}, {0, false}}};
    const MappingQ<2> mapping(6);

    std::string table = "cell,ply,wall,material,angle,normal_x,normal_z";
    for (const char *kind : {"boundary", "side"})
      for (unsigned int k = 1; k <= 4; ++k)
        table += std::string(",") + kind + "_" + std::to_string(k);
    table += "\n";
    for (const auto &cell : section.mesh.active_cell_iterators())
      {
        const Ply &ply = section.plies[cell->material_id()];
        CsvLine    line;
        line << cell->active_cell_index() << cell->material_id() + 1
             << ply.plane.wall << ply.material << ply.angle
             << ply.plane.at(
                  mapping.transform_unit_to_real_cell(cell,
                                                      Point<2>(0.5, 0.5)));
        for (const auto &side : around)
          {
            const auto face = cell->face(side.first);
            line << (face->at_boundary() ?
                       section.boundaries.at(face->boundary_id()) :
                       "");
          }
        for (const auto &[f, forwards] : around)
          line << side_points(cell, f, forwards, mapping);
        table += line.text();
      }
    return table;
  }



  void
  print_reserves(std::ostream &out, const Results &results)
  {
    if (results.last().plies.empty())
      return;
    constexpr unsigned int n_worst = 5;

    if (results.steps.size() > 1)
      {
        out << "\nWhat governs each load step:\n";
        TextTable table{titles};
        table.front().insert(table.front().begin(), "load factor");
        for (const StepResults &step : results.steps)
          if (const PlyReserve *worst = worst_of(step.plies))
            {
              table.push_back(cells_of(results, *worst));
              table.back().insert(table.back().begin(),
                                  to_text(step.load_factor.of_scene()));
            }
        print_table(out, table);
      }

    std::vector<PlyReserve> rows = results.last().plies;
    std::stable_sort(rows.begin(), rows.end(), is_worse);
    out << "\nNearest to failure at the last load step:\n";
    TextTable table{titles};
    for (unsigned int k = 0; k < std::min<std::size_t>(n_worst, rows.size());
         ++k)
      table.push_back(cells_of(results, rows[k]));
    print_table(out, table);

    if (const auto &first = results.first_failure; first && first->where)
      out << "First failure at load factor " << to_text(first->failing, 6)
          << " (none at " << to_text(first->safe, 6) << "): ply "
          << first->where->ply + 1 << " of "
          << results.bodies[first->where->body].name << ", "
          << first->where->criterion << ", " << first->where->mode << ", at "
          << to_text(first->where->position) << "\n";
  }
} // namespace lamella
