// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/text.h>
#include <lamella/body/fields.h>
#include <lamella/report/console.h>
#include <lamella/report/goals_table.h>
#include <lamella/report/probes_table.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace lamella
{
  namespace
  {
    /// Rows that a reader looks through; probes.csv has all of them.
    constexpr unsigned int most_rows = 40;

    using Columns = std::vector<std::string>;

    double
    value_of(const FieldRow &row, const std::string &column)
    {
      const Columns &names = field_names();
      return field_values(
        row.sample)[std::find(names.begin(), names.end(), column) -
                    names.begin()];
    }



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
            size = std::max(size, std::abs(value_of(row, column)));
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
                const double value = value_of(row, column);
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
  } // namespace



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
    print_first(
      out, table_of(results, {"sxx", "syy", "szz", "sxy", "sxz", "syz"}, true));
  }
} // namespace lamella
