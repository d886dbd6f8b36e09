// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
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
    std::string text =
      name + (ply == 0 ? "" : "/" + std::to_string(ply)) + ": " + column;
    if (strip)
      text += std::string(" in ") + "xyz"[strip->axis] + " " +
              to_text(strip->from, 12) + " " + to_text(strip->to, 12);
    return text;
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



    /// What contacts have beside components.
    const std::vector<std::string> &
    of_what_presses()
    {
      static const std::vector<std::string> names{
        "pressure", "width", "width x", "width y", "width z"};
      return names;
    }



    /// x, y or z as a number.
    std::optional<unsigned int>
    axis_of(const std::string &word)
    {
      for (unsigned int d = 0; d < 3; ++d)
        if (word == std::string(1, "xyz"[d]))
          return d;
      return std::nullopt;
    }



    /// The column that @p words begin with, and the strip that they end with;
    /// @p of_contact is whether there may be one.
    std::pair<std::string, std::optional<ContactStrip>>
    parse_strip(const Entry       &text,
                const std::string &words,
                const bool         of_contact)
    {
      std::vector<std::string> parts;
      for (const std::string &word : split(words, ' '))
        if (!word.empty())
          parts.push_back(word);
      const auto        in     = std::find(parts.begin(), parts.end(), "in");
      const std::string column = joined({parts.begin(), in}, " ");
      if (in == parts.end())
        return {column, std::nullopt};
      if (!of_contact)
        text.refuse("only contacts have strips",
                    "Leave out what follows " + column + ".");
      const auto axis = parts.end() - in == 4 ? axis_of(in[1]) : std::nullopt;
      if (!axis)
        text.refuse("a strip is written in AXIS FROM TO, as in roller: fz in "
                    "y 40 60");
      const ContactStrip strip{*axis, text.number(in[2]), text.number(in[3])};
      if (!(strip.from < strip.to))
        text.refuse("a strip must begin below its end",
                    "Exchange " + in[2] + " and " + in[3] +
                      ", or give it a width.");
      return {column, strip};
    }



    std::vector<std::string>
    all_names(const QuantityNames &names)
    {
      std::vector<std::string> all;
      for (const Probe &probe : names.probes)
        all.push_back(probe.name);
      for (const Measure &measure : names.measures)
        all.push_back(measure.name);
      for (const auto *resultants : {&names.supports, &names.contacts})
        for (const auto &resultant : *resultants)
          all.push_back(resultant.first);
      return all;
    }



    /// What a support or a contact gives, if one is called @p name; @p words
    /// are its column and strip, @p text is all that the scene says of it.
    NamedQuantity
    find_resultant(const Entry         &text,
                   const std::string   &name,
                   const std::string   &words,
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
      const auto [column, strip]       = parse_strip(text, words, of_contact);
      std::vector<std::string> columns = components();
      if (of_contact)
        columns.insert(columns.end(),
                       of_what_presses().begin(),
                       of_what_presses().end());
      if (std::find(columns.begin(), columns.end(), column) == columns.end())
        text.refuse(name + " is no probe but a " +
                    (of_contact ? "contact" : "resultant") +
                    ": its quantities are " + joined(columns));
      quantity.strip = strip;
      quantity.of =
        of_support ? NamedQuantity::Of::support : NamedQuantity::Of::contact;
      quantity.name   = name;
      quantity.column = column;
      quantity.path   = text.path();
      if (!strip)
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
  parse_of_probe(const Entry &text, const std::vector<Probe> &probes)
  {
    const auto parts = text.items(':');
    if (parts.size() != 2)
      text.refuse("write PROBE: COLUMN, as in tip: uz");
    const auto               place = split(parts[0], '/');
    std::vector<std::string> names;
    for (const Probe &probe : probes)
      {
        if (!place.empty() && probe.name == place[0])
          return find_column(text, probe, place, parts[1]);
        names.push_back(probe.name);
      }
    text.refuse("no probe is called '" + parts[0] + "'",
                names.empty() ?
                  "Add it to Probes." :
                  "The nearest is '" + nearest_name(parts[0], names) + "'.");
  }



  NamedQuantity
  parse_quantity(const Entry &text, const QuantityNames &names)
  {
    if (text.text().find_first_of(",;") != std::string::npos)
      text.refuse("between quantities stands '|'",
                  "Write them as in tip: uz | clamp: fz.");
    const auto parts = text.items(':');
    if (parts.size() != 2)
      text.refuse("write NAME: QUANTITY, as in tip: uz, with '|' between "
                  "several");
    const auto place = split(parts[0], '/');
    for (const Probe &probe : names.probes)
      if (!place.empty() && probe.name == place[0])
        return find_column(text, probe, place, parts[1]);
    for (const Measure &measure : names.measures)
      if (measure.name == parts[0])
        {
          if (parts[1] != measure.quantity.column)
            text.refuse(measure.name + " is a measure: its only quantity is " +
                        measure.quantity.column);
          NamedQuantity quantity = measure.quantity;
          quantity.path          = text.path();
          return quantity;
        }
    const NamedQuantity resultant =
      find_resultant(text, parts[0], parts[1], names);
    if (resultant.of == NamedQuantity::Of::undefined)
      text.refuse("no probe, measure, support or contact is called '" +
                    parts[0] + "'",
                  "The nearest is '" +
                    nearest_name(parts[0], all_names(names)) + "'.");
    return resultant;
  }



  std::vector<NamedQuantity>
  parse_quantities(const Entry &text, const QuantityNames &names)
  {
    std::vector<NamedQuantity> all;
    for (const std::string &piece : text.items('|'))
      all.push_back(parse_quantity(Entry(text.path(), piece), names));
    return all;
  }



  void
  check_strip(const NamedQuantity                        &quantity,
              const std::vector<ContactInterface::Point> &points)
  {
    const Entry        entry(quantity.path, quantity.label());
    const unsigned int facing = facing_axis(points);
    const std::string  across = joined(
      {std::string(1, "xyz"[std::min((facing + 1) % 3, (facing + 2) % 3)]),
        std::string(1, "xyz"[std::max((facing + 1) % 3, (facing + 2) % 3)])},
      " or ");
    const auto refuse_axis = [&](const std::string &what) {
      entry.refuse("the contact faces along " + std::string(1, "xyz"[facing]) +
                     ", where it has no " + what,
                   "Take " + across + ".");
    };
    if (quantity.column == std::string("width ") + "xyz"[facing])
      refuse_axis("width");
    if (!quantity.strip)
      return;
    if (quantity.strip->axis == facing)
      refuse_axis("strips");
    const auto [begin, end] = reach_along(points, quantity.strip->axis);
    if (quantity.strip->to <= begin || quantity.strip->from >= end)
      entry.refuse("the strip is outside of the contact, which reaches from " +
                     to_text(begin) + " to " + to_text(end) + " along " +
                     "xyz"[quantity.strip->axis],
                   "Move it there.");
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
          quantities.push_back({of,
                                name,
                                0,
                                reference.quantity,
                                reference.value,
                                references_path});
    };
    for (const Probe &probe : names.probes)
      {
        add(NamedQuantity::Of::probe, probe.name, probe.references);
        if (probe.references.empty())
          others.push_back(probe.name);
      }
    for (const Measure &measure : names.measures)
      if (!measure.references.empty())
        quantities.push_back(measure.quantity);
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
      {
        const std::string &name = results.contacts[k].name;
        contacts[name] =
          six(step.checks.contacts[k].force, step.checks.contacts[k].moment);
        points[name] = step.contacts[k];
      }
    for (unsigned int k = 0; k < results.probes.size(); ++k)
      for (const FieldRow &row : step.probes[k])
        {
          probes.push_back({results.probes[k], row.ply + 1, {}});
          const std::vector<double> values = field_values(row.sample);
          for (unsigned int c = 0; c < values.size(); ++c)
            probes.back().columns[field_names()[c]] = values[c];
        }
  }



  namespace
  {
    /// Place, normal, and what it does on the second side; area and force.
    nlohmann::json
    point_json(const ContactRow &row)
    {
      nlohmann::json numbers;
      for (const Tensor<1, 3> &three : {Tensor<1, 3>(place_of(row.point)),
                                        row.point.normal,
                                        row.on_second.force,
                                        row.on_second.moment})
        for (unsigned int d = 0; d < 3; ++d)
          numbers.push_back(three[d]);
      numbers.push_back(row.point.area);
      numbers.push_back(row.force);
      return numbers;
    }



    ContactRow
    point_of(const nlohmann::json &json)
    {
      const std::array<double, 14> numbers = json;
      ContactRow                   row;
      for (unsigned int d = 0; d < 3; ++d)
        {
          row.point.first[d]      = numbers[d];
          row.point.normal[d]     = numbers[3 + d];
          row.on_second.force[d]  = numbers[6 + d];
          row.on_second.moment[d] = numbers[9 + d];
        }
      row.point.area = numbers[12];
      row.force      = numbers[13];
      return row;
    }
  } // namespace



  void
  require_ply(const NamedQuantity            &quantity,
              const std::vector<std::string> &plies)
  {
    if (quantity.ply == 0 ||
        std::find(plies.begin(), plies.end(), std::to_string(quantity.ply)) !=
          plies.end())
      return;
    const Entry entry(quantity.path, quantity.label());
    if (plies == std::vector<std::string>{"0"})
      entry.refuse("the probe is a box that reaches into several plies, and "
                   "its mean is one of all of them",
                   "Leave out the ply, or make the box smaller.");
    entry.refuse("the probe does not lie in this ply but in " + joined(plies));
  }



  void
  refuse_interface(const NamedQuantity            &quantity,
                   const std::vector<std::string> &plies)
  {
    Entry(quantity.path, quantity.label())
      .refuse("the probe lies between the plies " + joined(plies) +
                ", and the values there differ",
              "Name one: " + quantity.name + "/" + plies.front() + ": " +
                quantity.column + ".");
  }



  ResultNumbers::ResultNumbers(const nlohmann::json &json)
  {
    for (const auto &[name, list] : json.at("points").items())
      for (const auto &point : list)
        points[name].push_back(point_of(point));
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
    nlohmann::json patches = nlohmann::json::object();
    for (const auto &[name, list] : points)
      {
        patches[name] = nlohmann::json::array();
        for (const ContactRow &row : list)
          patches[name].push_back(point_json(row));
      }
    return {{"supports", supports},
            {"contacts", contacts},
            {"points", patches},
            {"probes", rows}};
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
  ResultNumbers::value_of_resultant(const NamedQuantity &quantity) const
  {
    const std::string &column = quantity.column;
    const bool         is_component =
      std::find(components().begin(), components().end(), column) !=
      components().end();
    const unsigned int component = column[1] - 'x';
    if (is_component && !quantity.strip)
      return (quantity.of == NamedQuantity::Of::support ? supports : contacts)
        .at(quantity.name)
        .at((column[0] == 'f' ? 0 : 3) + component);
    const PressedPatch patch(points.at(quantity.name), quantity.strip);
    if (is_component)
      {
        const Wrench wrench = patch.resultant();
        return (column[0] == 'f' ? wrench.force : wrench.moment)[component];
      }
    if (column == "pressure")
      return patch.pressure();
    return column == "width" ? patch.width() : patch.width(column.back() - 'x');
  }



  double
  ResultNumbers::value(const NamedQuantity &quantity) const
  {
    if (quantity.of == NamedQuantity::Of::measure)
      return (value(quantity.terms[0]) - value(quantity.terms[1])) /
             quantity.over;
    if (quantity.of != NamedQuantity::Of::probe)
      return value_of_resultant(quantity);
    std::vector<std::string> plies;
    std::vector<double>      values;
    for (const ProbeRow *row : rows_of(quantity.name))
      {
        plies.push_back(std::to_string(row->ply));
        if (quantity.ply == 0 || quantity.ply == row->ply)
          values.push_back(row->columns.at(quantity.column));
      }
    require_ply(quantity, plies);
    const auto [least, greatest] =
      std::minmax_element(values.begin(), values.end());
    if (*greatest - *least > arithmetic::negligible *
                               std::max(std::abs(*least), std::abs(*greatest)))
      refuse_interface(quantity, plies);
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
    if (quantity.of == NamedQuantity::Of::measure)
      return std::max(largest_of_kind(quantity.terms[0]),
                      largest_of_kind(quantity.terms[1])) /
             std::abs(quantity.over);
    // Kinds are told by the first letter: u, e, s of a probe, f, m of a
    // resultant, p and w of a contact.
    const char kind    = quantity.column[0];
    double     largest = 0.;
    for (const ProbeRow &row : probes)
      for (const auto &[column, value] : row.columns)
        if (quantity.of == NamedQuantity::Of::probe && column[0] == kind)
          largest = std::max(largest, std::abs(value));
    if (quantity.of == NamedQuantity::Of::probe)
      return largest;
    for (const auto *resultants : {&supports, &contacts})
      for (const auto &resultant : *resultants)
        for (unsigned int c = 0; c < 6; ++c)
          if ((kind == 'f' && c < 3) || (kind == 'm' && c >= 3))
            largest = std::max(largest, std::abs(resultant.second[c]));
    for (const auto &contact : points)
      {
        const PressedPatch patch(contact.second);
        if (kind == 'p')
          largest = std::max(largest, patch.largest_pressure());
        if (kind == 'w')
          for (unsigned int d = 0; d < 3; ++d)
            largest = std::max(largest, patch.width(d));
      }
    return largest;
  }
} // namespace lamella
