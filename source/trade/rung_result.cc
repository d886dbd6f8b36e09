// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/entry.h>
#include <lamella/base/memory.h>
#include <lamella/body/fields.h>
#include <lamella/trade/rung_result.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using dealii::Tensor;

  RungValues::RungValues(const Results &results)
    : dofs(results.n_dofs())
    , memory(results.peak_memory / megabyte)
    , seconds(results.seconds)
  {
    const auto components = [](const Tensor<1, 3> &force) {
      return std::vector<double>(force.begin_raw(), force.end_raw());
    };
    const StepResults &step = results.last();
    for (unsigned int k = 0; k < results.supports.size(); ++k)
      supports[results.supports[k]] =
        components(step.checks.reactions[k].force);
    for (unsigned int k = 0; k < results.contacts.size(); ++k)
      contacts[results.contacts[k].name] =
        components(step.checks.contacts[k].force);
    for (unsigned int k = 0; k < results.probes.size(); ++k)
      for (const FieldRow &row : step.probes[k])
        {
          probes.push_back({results.probes[k], row.ply + 1, {}});
          const std::vector<double> values = field_values(row.sample);
          for (unsigned int c = 0; c < values.size(); ++c)
            probes.back().columns[field_names()[c]] = values[c];
        }
  }



  RungValues::RungValues(const nlohmann::json &json)
  {
    json.at("dofs").get_to(dofs);
    json.at("peak_memory_mb").get_to(memory);
    json.at("seconds").get_to(seconds);
    json.at("supports").get_to(supports);
    json.at("contacts").get_to(contacts);
    for (const auto &row : json.at("probes"))
      probes.push_back({row.at("probe"), row.at("ply"), row.at("columns")});
  }



  nlohmann::json
  RungValues::to_json() const
  {
    nlohmann::json rows = nlohmann::json::array();
    for (const ProbeRow &row : probes)
      rows.push_back(
        {{"probe", row.probe}, {"ply", row.ply}, {"columns", row.columns}});
    return {{"dofs", dofs},
            {"peak_memory_mb", memory},
            {"seconds", seconds},
            {"supports", supports},
            {"contacts", contacts},
            {"probes", rows}};
  }



  std::vector<const RungValues::ProbeRow *>
  RungValues::rows_of(const std::string &probe) const
  {
    std::vector<const ProbeRow *> rows;
    for (const ProbeRow &row : probes)
      if (row.probe == probe)
        rows.push_back(&row);
    return rows;
  }



  double
  RungValues::value(const TradeQuantity &quantity) const
  {
    const Entry entry("Trade/Quantities", quantity.label());
    if (quantity.of != TradeQuantity::Of::probe)
      {
        const auto &all =
          quantity.of == TradeQuantity::Of::support ? supports : contacts;
        return all.at(quantity.name).at(quantity.column[1] - 'x');
      }
    std::vector<std::string> plies;
    std::vector<double>      values;
    for (const ProbeRow *row : rows_of(quantity.name))
      {
        plies.push_back(std::to_string(row->ply));
        if (quantity.ply == 0 || quantity.ply == row->ply)
          values.push_back(row->columns.at(quantity.column));
      }
    if (values.empty())
      entry.refuse("the probe does not lie in this ply but in " +
                   joined(plies));
    const auto [least, greatest] =
      std::minmax_element(values.begin(), values.end());
    if (*greatest - *least >
        1e-9 * std::max(std::abs(*least), std::abs(*greatest)))
      entry.refuse("the probe lies between the plies " + joined(plies) +
                     " and the values there differ",
                   "Name one: " + quantity.name + "/" + plies.front() + ": " +
                     quantity.column + ".");
    return values.front();
  }



  std::vector<TradeQuantity>
  RungValues::largest_at(const std::string &name) const
  {
    const auto                 rows = rows_of(name);
    std::vector<TradeQuantity> quantities;
    for (const std::vector<std::string> &columns :
         {std::vector<std::string>{"ux", "uy", "uz"},
          std::vector<std::string>{"sxx", "syy", "szz", "sxy", "sxz", "syz"}})
      {
        const auto magnitude = [&](const std::string &column) {
          return std::abs(rows.front()->columns.at(column));
        };
        TradeQuantity largest{TradeQuantity::Of::probe, name, 0, "", {}};
        for (const std::string &column : columns)
          if (largest.column.empty() ||
              magnitude(column) > magnitude(largest.column))
            largest.column = column;
        // Displacements have no two sides.
        if (rows.size() > 1 && largest.column[0] == 's')
          largest.ply = rows.front()->ply;
        quantities.push_back(largest);
      }
    return quantities;
  }



  void
  RungValues::tell_cost(RungResult &result) const
  {
    result.dofs   = dofs;
    result.memory = memory;
    result.phases = seconds;
  }
} // namespace lamella
