// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/report/console.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>

namespace lamella
{
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
                  const Summary     &summary,
                  const unsigned int k)
    {
      const ContactInterface &contact = (*summary.contacts)[k];
      const ContactPair      &pair    = (*summary.pairs)[k];
      const KuhnTucker       &kkt     = summary.checks.contacts[k];
      const auto             &change  = summary.status_changes[k].back();
      const std::string       force   = unit(summary.units.force),
                        length        = unit(summary.units.length),
                        work = unit(summary.units.force, summary.units.length);

      out << "  contact " << contact.name << " ("
          << name_of(contact.discretisation) << ", "
          << name_of(pair.enforcement) << "): " << kkt.active << " of "
          << contact.rows.size() << " pairs touch (in this load step "
          << change.closed << " closed, " << change.opened << " opened)";
      for (const auto &[side, n] :
           {std::make_pair("First", contact.unpaired),
            std::make_pair("Second", contact.unpaired_second)})
        if (n > 0)
          out << ", " << n << " points of " << side << " have no partner";
      out << "\n    force on '" << contact.second_name << "' "
          << to_text(kkt.force) << force << "\n    penetration "
          << to_text(kkt.max_penetration, 3) << length << ", "
          << to_text(kkt.max_penetration / scene_size(*summary.structure), 2)
          << " of the scene's size"
          << (pair.enforcement == Enforcement::penalty ?
                " (force over penalty, by design)" :
                "")
          << "\n    Kuhn-Tucker: gaps hold the contact law to "
          << to_text(kkt.law_error, 2) << length << ", smallest force "
          << to_text(kkt.min_force, 4) << force << ", force times open gap "
          << to_text(kkt.complementarity, 2) << work << "\n";
    }
  } // namespace



  void
  print_comparison(std::ostream                           &out,
                   const std::vector<Probe>               &probes,
                   const Recorder                         &recorder,
                   const std::vector<ResultantReferences> &resultants)
  {
    Table table{{"quantity", "Lamella", "reference", "difference", "source"}};
    for (unsigned int p = 0; p < probes.size(); ++p)
      for (const Reference &reference : probes[p].references)
        add_row(table,
                probes[p].name,
                recorder.probe_value(p, reference.quantity),
                reference);
    for (const ResultantReferences &resultant : resultants)
      for (const Reference &reference : resultant.references)
        add_row(table,
                resultant.what,
                resultant.force[reference.quantity[1] - 'x'],
                reference);
    if (table.size() == 1)
      return;
    out << "\nResults beside their references:\n";
    print_table(out, table);
  }



  void
  print_summary(std::ostream &out, const Summary &summary)
  {
    const Checks     &checks = summary.checks;
    const std::string force =
      summary.units.force.empty() ? "" : " " + summary.units.force;

    out << "\nForces and checks at the last load step:\n";
    for (unsigned int s = 0; s < checks.reactions.size(); ++s)
      out << "  support " << summary.support_names[s] << ": reaction "
          << to_text(checks.reactions[s]) << force << "\n";
    for (unsigned int k = 0; k < checks.contacts.size(); ++k)
      print_contact(out, summary, k);
    out << "  force balance " << to_text(checks.force_balance, 2)
        << ", residual " << to_text(checks.residual, 2) << ", energy balance "
        << to_text(checks.energy_balance, 2) << ", largest rotation "
        << to_text(checks.max_rotation, 3) << " rad\n";

    if (checks.stabilisation_energy > 0.)
      out << "  stabilising springs hold "
          << to_text(100. * checks.stabilisation_share, 2)
          << " % of the energy\n";

    for (const auto &[line, jump] : summary.interface_jumps)
      out << "  line " << line << ": tractions jump by " << percent(100. * jump)
          << " of the largest at ply interfaces\n";

    out << "\nSeconds:\n ";
    for (const char *phase : {"setup",
                              "assembly",
                              "factorisation",
                              "solve",
                              "contact",
                              "output",
                              "total"})
      out << " " << phase << " " << seconds(summary.seconds.at(phase))
          << (std::string(phase) == "total" ? "" : ",");
    out << "; peak memory " << std::lround(summary.peak_memory / 1048576.)
        << " MB";
    if (summary.processes > 1)
      out << " (process with most), "
          << std::lround(summary.peak_memory_of_all / 1048576.) << " MB (all "
          << summary.processes << " processes)";
    out << "\n";
    for (const auto &[body, solver] : summary.solvers)
      out << "Solver of " << body << ": " << lamella::to_text(solver) << "\n";
    for (const std::string &warning : summary.warnings)
      out << "\nNote: " << warning << ".\n";
  }
} // namespace lamella
