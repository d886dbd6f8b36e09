// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/text.h>
#include <lamella/body/fields.h>
#include <lamella/contact/contact_patch.h>
#include <lamella/recover/sampler.h>
#include <lamella/report/console.h>
#include <lamella/report/goals_table.h>
#include <lamella/report/summary.h>
#include <lamella/report/tables.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>

namespace lamella
{
  using dealii::Tensor;

  void
  print_table(std::ostream &out, const TextTable &table)
  {
    std::vector<std::size_t> width(table.front().size(), 0);
    for (const auto &row : table)
      for (unsigned int c = 0; c < row.size(); ++c)
        width[c] = std::max(width[c], row[c].size());
    for (const auto &row : table)
      {
        out << "  ";
        for (unsigned int c = 0; c < row.size(); ++c)
          {
            const bool left = c == 0 || c + 1 == row.size();
            out << (left ? std::left : std::right);
            if (c + 1 < row.size())
              out << std::setw(width[c]);
            out << row[c] << (c + 1 < row.size() ? "  " : "\n");
          }
      }
  }



  namespace
  {
    using Table = TextTable;

    std::string
    percent(const double value)
    {
      std::ostringstream text;
      text << std::fixed << std::setprecision(std::abs(value) < 0.1 ? 4 : 2)
           << value << " %";
      return text.str();
    }



    void
    add_row(Table             &table,
            const std::string &what,
            const double       result,
            const Reference   &reference)
    {
      const double difference = reference.value == 0. ?
                                  std::nan("") :
                                  100. * (result / reference.value - 1.);
      table.push_back({what + " " + reference.quantity,
                       to_text(result, 6),
                       to_text(reference.value, 6),
                       std::isnan(difference) ? "-" : percent(difference),
                       reference.source});
    }



    std::string
    seconds(const double value)
    {
      std::ostringstream text;
      text << std::fixed << std::setprecision(3) << value << " s";
      return text.str();
    }



    /// The units of a product, with a blank before; none where there are none.
    std::string
    unit(const std::string &a, const std::string &b = "")
    {
      return (a.empty() ? "" : " " + a) + (b.empty() ? "" : " " + b);
    }



    void
    print_contact(std::ostream      &out,
                  const Results     &results,
                  const unsigned int k)
    {
      const ContactSummary &contact = results.contacts[k];
      const KktResidual    &kkt     = results.last().checks.contacts[k];
      const StatusChanges  &change  = results.last().changes[k];
      const std::string     force   = unit(results.units.force),
                        length      = unit(results.units.length),
                        work = unit(results.units.force, results.units.length);
      out << "  contact " << contact.name << " ("
          << name_of(contact.discretization) << ", "
          << name_of(contact.enforcement) << "): " << kkt.active << " of "
          << contact.rows;
      if (contact.is_tied())
        out << " pairs are tied";
      else
        out << " pairs touch (in this load step " << change.closed
            << " closed, " << change.opened << " opened)";
      for (const auto &[side, n] :
           {std::make_pair("First", contact.unpaired),
            std::make_pair("Second", contact.unpaired_second)})
        if (n > 0)
          out << ", " << n << " points of " << side << " have no partner";
      out << "\n    force on '" << contact.second_name << "' "
          << to_text(kkt.force) << force << ", moment " << to_text(kkt.moment)
          << work << " about the origin";
      if (kkt.force.norm() > 0.)
        out << ", its line of action through "
            << to_text(kkt.center_of_pressure);
      if (kkt.obstacle_displacement)
        out << "\n    displacement of '" << contact.second_name << "' "
            << to_text(*kkt.obstacle_displacement) << length;
      if (contact.is_tied())
        {
          if (!results.last().contacts.empty())
            {
              const ContactTraction traction =
                traction_of(contact, results.last().contacts[k]);
              const ContactPatch patch(traction);
              const std::string  stress = unit(results.units.stress);
              out << "\n    largest peel " << to_text(patch.peel(), 4) << stress
                  << ", largest shear " << to_text(patch.shear(), 4) << stress;
            }
          out << "\n    error of the tie " << to_text(kkt.law_error, 2)
              << length << "\n";
          return;
        }
      out << "\n    penetration " << to_text(kkt.max_penetration, 3) << length
          << ", " << to_text(kkt.max_penetration / results.size, 2)
          << " of the scene's size"
          << (contact.enforcement == Enforcement::penalty ?
                " (force over penalty, by design)" :
                "")
          << "\n    Kuhn-Tucker: gaps hold the contact law to "
          << to_text(kkt.law_error, 2) << length << ", smallest force "
          << to_text(kkt.min_force, 4) << force << ", force times open gap "
          << to_text(kkt.complementarity, 2) << work << "\n";
      if (contact.friction > 0.)
        out << "    friction " << to_text(contact.friction) << ": "
            << to_text(kkt.shear) << force << " of it, an area of "
            << to_text(kkt.sticking, 3) << " sticks and "
            << to_text(kkt.slipping, 3) << " slips, dissipated so far "
            << to_text(kkt.dissipated, 4) << work << "\n";
    }



    void
    print_resultants(std::ostream &out, const Results &results)
    {
      const Checks &checks = results.last().checks;
      for (unsigned int s = 0; s < checks.reactions.size(); ++s)
        {
          const Resultant &reaction = checks.reactions[s];
          out << "  support " << results.supports[s] << ": reaction "
              << to_text(reaction.force) << unit(results.units.force)
              << ", moment " << to_text(reaction.moment)
              << unit(results.units.force, results.units.length) << " about "
              << to_text(reaction.about);
          if (reaction.center_of_pressure)
            out << ", its line of action through "
                << to_text(*reaction.center_of_pressure);
          out << "\n";
        }
      for (unsigned int k = 0; k < checks.contacts.size(); ++k)
        print_contact(out, results, k);
    }



    void
    print_cost(std::ostream &out, const Results &results)
    {
      out << "\nSeconds:\n ";
      for (const std::string &phase : phase_names())
        out << " " << phase << " " << seconds(results.seconds.at(phase)) << ",";
      out << " total " << seconds(results.seconds.at("total"))
          << "; peak memory " << std::lround(results.peak_memory / 1048576.)
          << " MB";
      if (results.processes > 1)
        out << " (process with most), "
            << std::lround(results.peak_memory_of_all / 1048576.) << " MB (all "
            << results.processes << " processes)";
      out << "\n";
      for (const BodySummary &body : results.bodies)
        if (body.solver)
          out << "Solver of " << body.name << ": "
              << lamella::to_text(*body.solver) << "\n";
    }



    /// The column @p name of what is found at a point.
    double
    field_named(const std::string &name, const FieldSample &sample)
    {
      const auto &names = field_names();
      const auto  place = std::find(names.begin(), names.end(), name);
      return field_values(sample)[place - names.begin()];
    }



    /// Prints the energy dissipated by friction so far and the error of the
    /// energy balance that finite load steps cause.
    void
    print_path(std::ostream &out, const Results &results)
    {
      const FrictionState &friction = results.last().state.friction;
      const std::string    energy =
        unit(results.units.force, results.units.length);
      if (!has_friction(results))
        return;
      out << "  dissipated so far " << to_text(friction.all_dissipated(), 4)
          << energy;
      // path_gap is defined by the energies of linear theory only.
      if (!results.last().checks.is_large)
        out << "; error of the energy balance due to the length of load steps "
            << to_text(friction.path_gap, 2) << energy;
      out << "\n";
    }



    void
    print_checks(std::ostream &out, const Checks &checks)
    {
      out << "  force balance " << to_text(checks.force_balance, 2)
          << ", moment balance " << to_text(checks.moment_balance, 2)
          << ", residual " << to_text(checks.residual, 2)
          << (checks.is_large ?
                "" :
                ", energy balance " + to_text(checks.energy_balance, 2))
          << ", largest rotation " << to_text(checks.max_rotation, 3) << " rad";
      if (checks.is_large)
        {
          out << "\n  large rotations: strains to "
              << to_text(100. * checks.max_strain, 3) << " %";
          if (checks.max_element_rotation > 0.)
            out << ", elements turn by up to "
                << to_text(checks.max_element_rotation * 180. /
                             dealii::numbers::PI,
                           3)
                << " degrees";
          out << "; places, moments and balances are those of the "
                 "deformed bodies\n";
          return;
        }
      out << "\n  stiffening by large "
          << "deflections " << to_text(100. * checks.beyond.stiffening, 2)
          << " %, buckling at "
          << (checks.beyond.buckling_factor ?
                to_text(*checks.beyond.buckling_factor, 4) +
                  " times these loads" :
                "more than 100 times these loads, or never")
          << "\n";
      if (checks.stabilization_energy > 0.)
        out << "  stabilizing springs hold "
            << to_text(100. * checks.stabilization_share, 2)
            << " % of the energy\n";
    }



    /// Rows that a reader looks through; probes.csv has all of them.
    constexpr unsigned int most_rows = 40;

    using Columns = std::vector<std::string>;

    /// ` +- 0.1 %` if @p column of @p row of the probe @p name is a goal that
    /// has a bar, @p is_first telling whether it is what the name alone means.
    std::string
    error_bar_of(const Results     &results,
                 const std::string &name,
                 const FieldRow    &row,
                 const bool         is_first,
                 const std::string &column)
    {
      const std::string of_ply =
        name + "/" + std::to_string(row.ply + 1) + ": " + column;
      for (const GoalResult &goal : results.goals)
        if (goal.trusted && (goal.name == of_ply ||
                             (is_first && goal.name == name + ": " + column)))
          return " +- " + share_text(goal, goal.bar);
      return "";
    }



    /// Largest of @p columns over all probes: rounding beside it becomes 0.
    double
    displacement_scale(const StepResults &step, const Columns &columns)
    {
      double size = 0.;
      for (const auto &rows : step.probes)
        for (const FieldRow &row : rows)
          for (const std::string &column : columns)
            size = std::max(size, std::abs(field_named(column, row.sample)));
      return size;
    }



    /// A row a probe, or with @p all one for each ply that it touches.
    TextTable
    table_of(const Results &results, const Columns &columns, const bool all)
    {
      const StepResults &step = results.last();
      const double       size = displacement_scale(step, columns);
      TextTable          table{{"probe", all ? "ply" : "at"}};
      table.front().insert(table.front().end(), columns.begin(), columns.end());
      table.front().push_back("");
      for (unsigned int p = 0; p < step.probes.size(); ++p)
        for (const FieldRow &row : step.probes[p])
          {
            const bool is_first = &row == &step.probes[p].front();
            if (!all && !is_first)
              continue;
            table.push_back(
              {results.probes[p],
               all ? std::to_string(row.ply + 1) : to_text(row.position)});
            for (const std::string &column : columns)
              {
                const double value = field_named(column, row.sample);
                table.back().push_back(
                  to_text(std::abs(value) < arithmetic::negligible * size ?
                            0. :
                            value) +
                  error_bar_of(
                    results, results.probes[p], row, is_first, column));
              }
            table.back().push_back("");
          }
      return table;
    }



    void
    print_first(std::ostream &out, TextTable table)
    {
      const unsigned int rows = table.size() - 1;
      if (rows > most_rows)
        table.resize(most_rows + 1);
      print_table(out, table);
      if (rows > most_rows)
        out << "  ... and " << rows - most_rows << " more in probes.csv\n";
    }



    /// Prints displacements and stresses (scene axes) of at most 40 probes in
    /// the last load step; for quantities of interest also error bars.
    void
    print_probes(std::ostream &out, const Results &results)
    {
      if (results.last().probes.empty())
        return;
      const auto in = [](const std::string &unit) {
        return unit.empty() ? "" : " [" + unit + "]";
      };
      out << "\nProbes at the last load step, displacements"
          << in(results.units.length) << ":\n";
      print_first(out, table_of(results, {"ux", "uy", "uz"}, false));
      out << "Stresses in the scene's axes" << in(results.units.stress)
          << ", from the lowest ply (0: a mean over several):\n";
      print_first(out,
                  table_of(results,
                           {"sxx", "syy", "szz", "sxy", "sxz", "syz"},
                           true));
    }



    /// Adds the modes with @p references to @p table.
    void
    add_modes(Table                        &table,
              const Results                &results,
              const std::vector<Reference> &references)
    {
      if (references.empty())
        return;
      const ResultNumbers numbers(results);
      for (const NamedQuantity &mode : numbers.of_modes())
        for (const Reference &reference : references)
          if (reference.quantity == mode.name)
            add_row(table,
                    mode.name,
                    numbers.value(mode),
                    {mode.column, reference.value, reference.source});
    }
  } // namespace



  void
  print_comparison(std::ostream         &out,
                   const Results        &results,
                   const ReferenceLists &references)
  {
    const StepResults &step = results.last();
    Table table{{"quantity", "Lamella", "reference", "difference", "source"}};
    for (unsigned int p = 0; p < step.probes.size(); ++p)
      for (const Reference &reference : references.probes[p])
        add_row(table,
                results.probes[p],
                field_named(reference.quantity, step.probes[p].front().sample),
                reference);
    for (unsigned int m = 0; m < step.measures.size(); ++m)
      for (const Reference &reference : references.measures[m])
        add_row(table,
                "measure " + results.measures[m],
                step.measures[m],
                reference);
    const auto add_resultant = [&](const std::string            &what,
                                   const Tensor<1, 3>           &force,
                                   const std::vector<Reference> &of) {
      for (const Reference &reference : of)
        add_row(table, what, force[reference.quantity[1] - 'x'], reference);
    };
    for (unsigned int s = 0; s < results.supports.size(); ++s)
      add_resultant("support " + results.supports[s],
                    step.checks.reactions[s].force,
                    references.supports[s]);
    for (unsigned int k = 0; k < results.contacts.size(); ++k)
      add_resultant("contact " + results.contacts[k].name,
                    step.checks.contacts[k].force,
                    references.contacts[k]);
    add_modes(table, results, references.modes);
    if (table.size() == 1)
      return;
    out << "\nResults beside their references:\n";
    print_table(out, table);
  }



  void
  print_summary(std::ostream &out, const Results &results)
  {
    const StepResults &step = results.last();
    out << "\nForces and checks at the last load step:\n";
    print_resultants(out, results);
    for (unsigned int m = 0; m < step.measures.size(); ++m)
      out << "  measure " << results.measures[m] << ": "
          << to_text(step.measures[m], 6) << "\n";
    print_path(out, results);
    print_checks(out, step.checks);
    for (unsigned int l = 0; l < results.lines.size(); ++l)
      if (step.jumps[l].interfaces > 0)
        out << "  line " << results.lines[l]
            << ": at ply interfaces tractions jump by "
            << percent(100. * step.jumps[l].of_stress)
            << " of the line's largest stress, "
            << percent(100. * step.jumps[l].of_traction)
            << " of its largest traction\n";
    for_each_defect(results,
                    step.defects,
                    [&out](const std::string &kind,
                           const std::string &name,
                           const double       share) {
                      out
                        << "  " << kind << " " << name
                        << ": equilibrium misses the upper face's traction by "
                        << percent(100. * share)
                        << " of the largest, which is distributed\n";
                    });
    print_modes(out, results);
    print_reserves(out, results);
    print_probes(out, results);
    print_goals(out, results);
    if (!results.no_goals_reason.empty())
      out << "\nNo error bars: " << results.no_goals_reason << ".\n";
    print_cost(out, results);
    for (const std::string &warning : results.all_warnings())
      out << "\n" << note_line(warning) << "\n";
  }
} // namespace lamella
