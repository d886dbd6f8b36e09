// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/report/fields_table.h>
#include <lamella/run/rung_result.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace lamella
{
  namespace
  {
    nlohmann::json
    read_json(const std::string &path)
    {
      std::ifstream  file(path);
      nlohmann::json json = nlohmann::json::parse(file, nullptr, false);
      if (json.is_discarded())
        throw InputError(path + " is missing or not whole.");
      return json;
    }



    /// The rows of a CSV file without quotes, those of its last `step`.
    std::vector<std::map<std::string, std::string>>
    read_csv(const std::string &path)
    {
      std::ifstream file(path);
      std::string   line;
      if (!std::getline(file, line))
        throw InputError(path + " is missing or empty.");
      const std::vector<std::string>                  header = split(line, ',');
      std::vector<std::map<std::string, std::string>> rows;
      while (std::getline(file, line))
        {
          const auto cells = split(line, ',');
          if (cells.size() != header.size())
            throw InputError(path + " is not whole.");
          std::map<std::string, std::string> row;
          for (unsigned int c = 0; c < cells.size(); ++c)
            row[header[c]] = cells[c];
          if (!rows.empty() && rows.front().at("step") != row.at("step"))
            rows.clear();
          rows.push_back(row);
        }
      return rows;
    }



    std::map<std::string, std::vector<double>>
    resultants(const nlohmann::json &json, const std::string &key)
    {
      std::map<std::string, std::vector<double>> result;
      for (const auto &[name, entry] : json.items())
        result[name] = entry.at(key).get<std::vector<double>>();
      return result;
    }
  } // namespace



  RunFiles::RunFiles(const std::string &directory)
  {
    const nlohmann::json summary = read_json(directory + "/summary.json");
    try
      {
        dofs     = summary.at("dofs");
        memory   = summary.at("peak_memory_mb");
        seconds  = summary.at("seconds").get<std::map<std::string, double>>();
        supports = resultants(summary.at("supports"), "reaction");
        contacts = resultants(summary.at("contacts"), "force");
      }
    catch (const nlohmann::json::exception &error)
      {
        throw InputError(directory +
                         "/summary.json is not one of a run: " + error.what());
      }
    probes = read_csv(directory + "/probes.csv");
  }



  std::vector<const RunFiles::Row *>
  RunFiles::rows_of(const std::string &probe) const
  {
    std::vector<const Row *> rows;
    for (const Row &row : probes)
      if (row.at("probe") == probe)
        rows.push_back(&row);
    return rows;
  }



  double
  RunFiles::value(const TradeQuantity &quantity) const
  {
    const std::string what = "Trade/Quantities, '" + quantity.label() + "'";
    if (quantity.of != TradeQuantity::Of::probe)
      {
        const auto &all =
          quantity.of == TradeQuantity::Of::support ? supports : contacts;
        return all.at(quantity.name).at(quantity.column[1] - 'x');
      }
    std::vector<std::string> plies;
    std::vector<double>      values;
    for (const Row *row : rows_of(quantity.name))
      {
        plies.push_back(row->at("ply"));
        const double value = to_number(row->at(quantity.column), what);
        if (quantity.ply == 0 || std::to_string(quantity.ply) == plies.back())
          values.push_back(value);
      }
    if (values.empty())
      throw InputError(what + ": the probe does not lie in this ply but in " +
                       joined(plies) + ".");
    const auto [least, greatest] =
      std::minmax_element(values.begin(), values.end());
    if (*greatest - *least >
        1e-9 * std::max(std::abs(*least), std::abs(*greatest)))
      throw InputError(
        what + ": the probe lies between the plies " + joined(plies) +
        " and the values there differ. Name one: " + quantity.name + "/" +
        plies.front() + ": " + quantity.column + ".");
    return values.front();
  }



  std::vector<TradeQuantity>
  RunFiles::largest_at(const std::string &name) const
  {
    const auto                 rows = rows_of(name);
    std::vector<TradeQuantity> quantities;
    for (const std::vector<std::string> &columns :
         {std::vector<std::string>{"ux", "uy", "uz"},
          std::vector<std::string>{"sxx", "syy", "szz", "sxy", "sxz", "syz"}})
      {
        const auto magnitude = [&](const std::string &column) {
          return std::abs(to_number(rows.front()->at(column), column));
        };
        TradeQuantity largest{TradeQuantity::Of::probe, name, 0, "", {}};
        for (const std::string &column : columns)
          if (largest.column.empty() ||
              magnitude(column) > magnitude(largest.column))
            largest.column = column;
        // Displacements have no two sides.
        if (rows.size() > 1 && largest.column[0] == 's')
          largest.ply = static_cast<unsigned int>(
            to_number(rows.front()->at("ply"), "ply"));
        quantities.push_back(largest);
      }
    return quantities;
  }



  void
  RunFiles::read_cost(RungResult &result) const
  {
    result.dofs   = dofs;
    result.memory = memory;
    result.phases = seconds;
  }
} // namespace lamella
