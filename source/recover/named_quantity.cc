// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/entry.h>
#include <lamella/body/fields.h>
#include <lamella/recover/named_quantity.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace lamella
{
  using dealii::Tensor;

  std::string
  NamedQuantity::label() const
  {
    return name + (ply == 0 ? "" : "/" + std::to_string(ply)) + ": " + column;
  }



  namespace
  {
    /// The first of @p references of @p column.
    std::optional<double>
    first_of(const std::vector<Reference> &references,
             const std::string            &column)
    {
      for (const Reference &reference : references)
        if (reference.quantity == column)
          return reference.value;
      return std::nullopt;
    }



    const std::vector<std::string> &
    components()
    {
      static const std::vector<std::string> names{
        "fx", "fy", "fz", "mx", "my", "mz"};
      return names;
    }



    std::vector<std::string>
    all_names(const QuantityNames &names)
    {
      std::vector<std::string> all;
      for (const Probe &probe : names.probes)
        all.push_back(probe.name);
      for (const auto *resultants : {&names.supports, &names.contacts})
        for (const auto &resultant : *resultants)
          all.push_back(resultant.first);
      return all;
    }



    /// A component of a resultant, if a support or a contact is called
    /// @p name; @p text is what the scene says of the quantity.
    NamedQuantity
    find_resultant(const Entry         &text,
                   const std::string   &name,
                   const std::string   &column,
                   const QuantityNames &names)
    {
      const bool of_support = names.supports.count(name) > 0,
                 of_contact = names.contacts.count(name) > 0;
      if (of_support && of_contact)
        text.refuse("both a support and a contact are called '" + name + "'",
                    "Rename one of the two.");
      NamedQuantity quantity;
      if (!of_support && !of_contact)
        return quantity;
      if (std::find(components().begin(), components().end(), column) ==
          components().end())
        text.refuse(name + " is no probe but a resultant: its quantities are " +
                    joined(components()));
      quantity.of =
        of_support ? NamedQuantity::Of::support : NamedQuantity::Of::contact;
      quantity.name   = name;
      quantity.column = column;
      quantity.path   = text.path();
      quantity.given =
        first_of((of_support ? names.supports : names.contacts).at(name),
                 column);
      return quantity;
    }



    /// A column of @p probe, which @p place (NAME or NAME/PLY) begins with.
    NamedQuantity
    find_column(const Entry                    &text,
                const Probe                    &probe,
                const std::vector<std::string> &place,
                const std::string              &column)
    {
      NamedQuantity quantity{
        NamedQuantity::Of::probe, probe.name, 0, column, {}, text.path()};
      if (place.size() > 1)
        {
          constexpr double most = 1e6;
          const double     ply  = text.number(place[1]);
          if (place.size() > 2 ||
              !(ply >= 1. && ply <= most && ply == std::floor(ply)))
            text.refuse("plies are counted from 1 at the bottom, as in tip/2: "
                        "syz");
          quantity.ply = static_cast<unsigned int>(ply);
        }
      const auto &columns = field_names();
      if (std::find(columns.begin(), columns.end(), column) == columns.end())
        text.refuse("a probe gives no '" + column + "'",
                    "The nearest is '" + nearest_name(column, columns) +
                      "'; all of them: " + joined(columns) + ".");
      quantity.given = first_of(probe.references, column);
      return quantity;
    }
  } // namespace



  NamedQuantity
  parse_quantity(const Entry &text, const QuantityNames &names)
  {
    const auto parts = text.items(':');
    if (parts.size() != 2)
      text.refuse("write NAME: QUANTITY, as in tip: uz");
    const auto place = split(parts[0], '/');
    for (const Probe &probe : names.probes)
      if (!place.empty() && probe.name == place[0])
        return find_column(text, probe, place, parts[1]);
    const NamedQuantity resultant =
      find_resultant(text, parts[0], parts[1], names);
    if (resultant.of == NamedQuantity::Of::undefined)
      text.refuse("no probe, support or contact is called '" + parts[0] + "'",
                  "The nearest is '" +
                    nearest_name(parts[0], all_names(names)) + "'.");
    return resultant;
  }



  std::vector<NamedQuantity>
  quantities_with_references(const QuantityNames      &names,
                             std::vector<std::string> &others)
  {
    std::vector<NamedQuantity> quantities;
    const auto                 add = [&](const NamedQuantity::Of       of,
                         const std::string            &name,
                         const std::vector<Reference> &references) {
      std::set<std::string> seen;
      for (const Reference &reference : references)
        if (seen.insert(reference.quantity).second)
          quantities.push_back(
            {of, name, 0, reference.quantity, reference.value, "References"});
    };
    for (const Probe &probe : names.probes)
      {
        add(NamedQuantity::Of::probe, probe.name, probe.references);
        if (probe.references.empty())
          others.push_back(probe.name);
      }
    for (const auto &[name, references] : names.supports)
      add(NamedQuantity::Of::support, name, references);
    for (const auto &[name, references] : names.contacts)
      add(NamedQuantity::Of::contact, name, references);
    return quantities;
  }



  ResultNumbers::ResultNumbers(const Results &results)
  {
    const auto six = [](const Tensor<1, 3> &force, const Tensor<1, 3> &moment) {
      std::vector<double> numbers(force.begin_raw(), force.end_raw());
      numbers.insert(numbers.end(), moment.begin_raw(), moment.end_raw());
      return numbers;
    };
    const StepResults &step = results.last();
    for (unsigned int k = 0; k < results.supports.size(); ++k)
      supports[results.supports[k]] =
        six(step.checks.reactions[k].force, step.checks.reactions[k].moment);
    for (unsigned int k = 0; k < results.contacts.size(); ++k)
      contacts[results.contacts[k].name] =
        six(step.checks.contacts[k].force, step.checks.contacts[k].moment);
    for (unsigned int k = 0; k < results.probes.size(); ++k)
      for (const FieldRow &row : step.probes[k])
        {
          probes.push_back({results.probes[k], row.ply + 1, {}});
          const std::vector<double> values = field_values(row.sample);
          for (unsigned int c = 0; c < values.size(); ++c)
            probes.back().columns[field_names()[c]] = values[c];
        }
  }



  ResultNumbers::ResultNumbers(const nlohmann::json &json)
  {
    json.at("supports").get_to(supports);
    json.at("contacts").get_to(contacts);
    for (const auto &row : json.at("probes"))
      probes.push_back({row.at("probe"), row.at("ply"), row.at("columns")});
  }



  nlohmann::json
  ResultNumbers::to_json() const
  {
    nlohmann::json rows = nlohmann::json::array();
    for (const ProbeRow &row : probes)
      rows.push_back(
        {{"probe", row.probe}, {"ply", row.ply}, {"columns", row.columns}});
    return {{"supports", supports}, {"contacts", contacts}, {"probes", rows}};
  }



  std::vector<const ResultNumbers::ProbeRow *>
  ResultNumbers::rows_of(const std::string &probe) const
  {
    std::vector<const ProbeRow *> rows;
    for (const ProbeRow &row : probes)
      if (row.probe == probe)
        rows.push_back(&row);
    return rows;
  }



  double
  ResultNumbers::value(const NamedQuantity &quantity) const
  {
    const Entry entry(quantity.path, quantity.label());
    if (quantity.of != NamedQuantity::Of::probe)
      {
        const auto &all =
          quantity.of == NamedQuantity::Of::support ? supports : contacts;
        return all.at(quantity.name)
          .at((quantity.column[0] == 'f' ? 0 : 3) + quantity.column[1] - 'x');
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



  std::vector<NamedQuantity>
  ResultNumbers::largest_at(const std::string &name) const
  {
    const auto                 rows = rows_of(name);
    std::vector<NamedQuantity> quantities;
    for (const std::vector<std::string> &columns :
         {std::vector<std::string>{"ux", "uy", "uz"},
          std::vector<std::string>{"sxx", "syy", "szz", "sxy", "sxz", "syz"}})
      {
        const auto magnitude = [&](const std::string &column) {
          return std::abs(rows.front()->columns.at(column));
        };
        NamedQuantity largest{
          NamedQuantity::Of::probe, name, 0, "", {}, "Quantities"};
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



  double
  ResultNumbers::largest_of_kind(const NamedQuantity &quantity) const
  {
    // Kinds are told by the first letter: u, e, s of a probe, f, m of a
    // resultant.
    const char kind    = quantity.column[0];
    double     largest = 0.;
    for (const ProbeRow &row : probes)
      for (const auto &[column, value] : row.columns)
        if (quantity.of == NamedQuantity::Of::probe && column[0] == kind)
          largest = std::max(largest, std::abs(value));
    for (const auto *resultants : {&supports, &contacts})
      for (const auto &resultant : *resultants)
        for (unsigned int c = 0; c < 6; ++c)
          if (quantity.of != NamedQuantity::Of::probe &&
              (c < 3) == (kind == 'f'))
            largest = std::max(largest, std::abs(resultant.second[c]));
    return largest;
  }
} // namespace lamella
