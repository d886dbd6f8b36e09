// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/recover/strength_sweep.h>
#include <lamella/report/console.h>
#include <lamella/report/csv_line.h>
#include <lamella/report/plies_table.h>

#include <algorithm>
#include <ostream>

namespace lamella
{
  std::string
  plies_lines(const Results &results, const StepResults &step)
  {
    std::string text;
    for (const PlyReserve &row : step.plies)
      text +=
        (CsvLine() << step.step << results.bodies[row.body].name << row.ply + 1
                   << row.criterion << row.mode << row.reserve << row.index
                   << row.position << row.angle)
          .text();
    return text;
  }



  std::string
  plies_along_lines(const Results &results, const StepResults &step)
  {
    std::string text;
    for (const ReserveAlong &row : step.plies_along)
      text +=
        (CsvLine() << step.step << results.bodies[row.body].name << row.ply + 1
                   << row.s << row.position << row.inverse_reserve)
          .text();
    return text;
  }



  namespace
  {
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
