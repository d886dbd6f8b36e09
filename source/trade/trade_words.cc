// SPDX-License-Identifier: LGPL-2.1-or-later

// What is said of a trade: its sentences, what is printed, the CSV file.

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/report/console.h>
#include <lamella/report/fields_table.h>
#include <lamella/trade/trade_table.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace lamella
{
  namespace
  {
    std::string
    per_cent(const double relative)
    {
      // Two digits, but no powers of ten.
      const double value = 100. * relative;
      return (value < 99.5 ? to_text(value, 2) :
                             std::to_string(std::lround(value))) +
             " %";
    }
  } // namespace



  std::string
  TradeTable::count_of_bars() const
  {
    unsigned int n_bars = 0, n_holding = 0, n_more = 0, n_without = 0;
    for (unsigned int k = 0; k < all.size(); ++k)
      for (unsigned int q = 0; q < asked.size(); ++q)
        if (has_error(k, q) && made_bar(k, q))
          {
            const std::optional<double> own = bar(k, q);
            n_bars += own.has_value();
            const double its = against < 0 ? 0. : bar(against, q).value_or(0.);
            n_holding += own && error(k, q) <= *own;
            n_more += own && error(k, q) > *own && error(k, q) <= *own + its;
            n_without += !own;
          }
    if (n_bars + n_without == 0)
      return "";
    return "Bars that hold, with the error at most the bar: " +
           std::to_string(n_holding) + " of " + std::to_string(n_bars) +
           (n_more == 0 ? "" :
                          " (" + std::to_string(n_more) +
                            " more with the reference's own bar added)") +
           "; values without a bar: " + std::to_string(n_without) + ".";
  }



  std::string
  TradeTable::described(const unsigned int k, const unsigned int q) const
  {
    return all[k].name + ": " + std::to_string(all[k].dofs) + " DoFs, " +
           to_text(all[k].seconds, 2) + " s (off by " + per_cent(error(k, q)) +
           ").";
  }



  std::string
  TradeTable::sentence(const unsigned int q, const double tolerance) const
  {
    const std::string limit =
      "For " + to_text(100. * tolerance, 3) + " % in " + asked[q].label();
    const std::string or_else =
      against < 0 ? "." : " but the reference itself.";
    if (reference(q) == 0.)
      return limit + " there is no answer: the reference is zero, and no error "
                     "is relative to it.";
    const int k = cheapest(q, tolerance);
    if (k < 0)
      return limit + " no rung is enough" + or_else;
    const std::string text  = limit + " the cheapest is " + described(k, q);
    const int         other = richer_and_worse(k, q, tolerance);
    if (other < 0)
      return text;
    const int sure = cheapest_to_count_on(q, tolerance);
    return text + " Do not count on it: " + all[other].name +
           ", which is richer, is off by " + per_cent(error(other, q)) + ". " +
           (sure < 0 ? "There is none to count on" + or_else :
                       "The cheapest to count on is " + described(sure, q));
  }



  std::string
  TradeTable::basis() const
  {
    if (against < 0)
      return "Errors are against the values given in the scene.";
    const std::string text    = "Errors are against " + all[against].name + ".";
    const auto [nearest, off] = nearest_to_reference();
    if (nearest < 0)
      return text;
    // What is further away tells nothing of how sure the reference is.
    constexpr double near = 0.05;
    if (off > near)
      return text +
             " No other rung comes near it in all quantities (the "
             "nearest, " +
             all[nearest].name + ", is off by up to " + per_cent(off) +
             "), so nothing here tells how sure it is.";
    return text + " The nearest to it, " + all[nearest].name +
           ", is off by up to " + per_cent(off) +
           ": errors smaller than that say little.";
  }



  std::string
  TradeTable::beyond_linear() const
  {
    // As BeyondLinear's notes: below that nothing is said.
    constexpr double worth_saying = 1e-2, near = 10.;
    int              k = against;
    for (unsigned int other = 0; against < 0 && other < all.size(); ++other)
      if (all[other].failure.empty() &&
          (k < 0 || all[other].dofs > all[k].dofs))
        k = other;
    if (k < 0)
      return "";
    const RungResult        &rung = all[k];
    std::vector<std::string> parts;
    if (rung.stiffening > worth_saying)
      parts.push_back("stiffening " + per_cent(rung.stiffening));
    if (rung.buckling_factor && *rung.buckling_factor < near)
      parts.push_back("buckling factor " + to_text(*rung.buckling_factor, 4));
    if (parts.empty())
      return "";
    return "All rungs are linear, and none of these errors says what large "
           "deflections do. By " +
           rung.name + ": " + joined(parts) + " (doc/beyond-linear.md).";
  }



  namespace
  {
    std::string
    fixed(const double value, const int digits)
    {
      std::ostringstream text;
      text << std::fixed << std::setprecision(digits) << value;
      return text.str();
    }



    /// The first sentence.
    std::string
    brief(const std::string &message)
    {
      const std::string line = message.substr(0, message.find('\n'));
      const auto        end  = line.find(". ");
      return end == std::string::npos ? line : line.substr(0, end + 1);
    }



    /// The error of rung @p k in quantity @p q, with its own bar.
    std::string
    error_cell(const TradeTable  &table,
               const unsigned int k,
               const unsigned int q)
    {
      const std::string error =
        table.has_error(k, q) ? per_cent(table.error(k, q)) : "-";
      const std::optional<double> own = table.bar(k, q);
      if (own)
        return error + " (bar " + per_cent(*own) + ")";
      return table.made_bar(k, q) && table.reference(q) != 0. ?
               error + " (no bar)" :
               error;
    }



    TextTable
    table_of_costs(const TradeTable &table)
    {
      TextTable                 text{{"rung", "DoFs", "seconds"}};
      std::vector<std::string> &head = text.front();
      head.insert(head.end(), phase_names().begin(), phase_names().end());
      head.insert(head.end(), {"MB", ""});
      for (const RungResult &rung : table.rungs())
        {
          const bool               failed = !rung.failure.empty();
          std::vector<std::string> row{rung.name,
                                       failed ? "-" : std::to_string(rung.dofs),
                                       fixed(rung.seconds, 2)};
          for (const std::string &phase : phase_names())
            row.push_back(failed ? "-" : fixed(rung.phases.at(phase), 2));
          row.push_back(failed ? "-" : fixed(rung.memory, 0));
          row.push_back(failed ? "failed: " + brief(rung.failure) : "");
          text.push_back(row);
        }
      return text;
    }



    TextTable
    table_of_errors(const TradeTable &table)
    {
      TextTable text{{"rung"}};
      for (const NamedQuantity &quantity : table.quantities())
        text.front().push_back(quantity.label());
      text.front().push_back("");
      for (unsigned int k = 0; k < table.rungs().size(); ++k)
        {
          std::vector<std::string> row{table.rungs()[k].name};
          for (unsigned int q = 0; q < table.quantities().size(); ++q)
            row.push_back(error_cell(table, k, q));
          row.push_back(static_cast<int>(k) == table.reference_rung() ?
                          "the reference" :
                        table.rungs()[k].failure.empty() ? "" :
                                                           "failed");
          text.push_back(row);
        }
      std::vector<std::string> values{"reference value"};
      for (unsigned int q = 0; q < table.quantities().size(); ++q)
        values.push_back(to_text(table.reference(q)));
      values.push_back("");
      text.push_back(values);
      return text;
    }
  } // namespace



  void
  print_trade(std::ostream &out, const TradeTable &table)
  {
    out << "\nWhat it costs (seconds of the whole process, then by phase; peak "
           "memory)\n\n";
    print_table(out, table_of_costs(table));
    out << "\nHow far it is off\n\n";
    print_table(out, table_of_errors(table));
    out << "\n" << table.basis() << "\n";
    const std::string beyond = table.beyond_linear();
    out << beyond << (beyond.empty() ? "" : "\n");
    const std::string bars = table.count_of_bars();
    out << bars << (bars.empty() ? "\n" : "\n\n");
    for (const double tolerance : table.tolerances())
      for (unsigned int q = 0; q < table.quantities().size(); ++q)
        out << table.sentence(q, tolerance) << "\n";
  }



  namespace
  {
    /// As a CSV file has it: in quotes if it holds a comma or a quote.
    std::string
    quoted(std::string text)
    {
      std::replace(text.begin(), text.end(), '\n', ' ');
      if (text.find_first_of(",\"") == std::string::npos)
        return text;
      return '"' + replaced(text, "\"", "\"\"") + '"';
    }



    /// What a rung cost; empty cells of one that failed.
    std::string
    cost_cells(const RungResult &rung)
    {
      std::vector<std::string> cells{quoted(rung.name), rung.theory};
      const bool               failed = !rung.failure.empty();
      cells.push_back(failed ? "" : std::to_string(rung.dofs));
      cells.push_back(csv(rung.seconds));
      for (const std::string &phase : phase_names())
        cells.push_back(failed ? "" : csv(rung.phases.at(phase)));
      cells.push_back(failed ? "" : csv(rung.memory));
      return joined(cells, ",");
    }
  } // namespace



  void
  write_trade_csv(const TradeTable &table, const std::string &path)
  {
    std::ofstream file(path);
    file << "rung,theory,dofs,seconds," << joined(phase_names(), ",")
         << ",memory_mb,quantity,value,reference,error,front_seconds,"
            "front_dofs,bar,stiffening,buckling_factor,failure\n";
    using Cost          = TradeTable::Cost;
    const auto contains = [](const std::vector<unsigned int> &front,
                             const unsigned int               k) {
      return std::find(front.begin(), front.end(), k) != front.end() ? "1" :
                                                                       "0";
    };
    for (unsigned int k = 0; k < table.rungs().size(); ++k)
      {
        const RungResult &rung = table.rungs()[k];
        const std::string cost = cost_cells(rung);
        if (!rung.failure.empty())
          {
            file << cost << ",,,,,,,,,," << quoted(rung.failure) << "\n";
            continue;
          }
        for (unsigned int q = 0; q < table.quantities().size(); ++q)
          file << cost << "," << table.quantities()[q].label() << ","
               << csv(rung.values[q]) << "," << csv(table.reference(q)) << ","
               << (table.has_error(k, q) ? csv(table.error(k, q)) : "") << ","
               << contains(table.front(q, Cost::seconds), k) << ","
               << contains(table.front(q, Cost::dofs), k) << ","
               << (table.bar(k, q) ? csv(*table.bar(k, q)) : "") << ","
               << csv(rung.stiffening) << ","
               << (rung.buckling_factor ? csv(*rung.buckling_factor) : "")
               << ",\n";
      }
    file.close();
    if (!file)
      throw InputError("Cannot write " + path + ". Is the disk full?");
  }
} // namespace lamella
