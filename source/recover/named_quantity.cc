// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/body/fields.h>
#include <lamella/contact/contact_patch.h>
#include <lamella/recover/named_quantity.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace lamella
{
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



  char
  kind_of_column(const std::string &column)
  {
    return column[0] == 'g' ? 'e' : column[0];
  }



  char
  NamedQuantity::kind() const
  {
    if (of == ObjectKind::mode)
      return column == "factor" ? 'l' : 'h';
    return of == ObjectKind::measure ? terms[0].kind() : kind_of_column(column);
  }



  unsigned int
  NamedQuantity::number_of_mode() const
  {
    return of == ObjectKind::mode ?
             std::stoul(name.substr(name.find('-') + 1)) :
             0;
  }



  std::string
  column_of_mode(const std::string &name)
  {
    return name[0] == 'b' ? "factor" : "frequency";
  }



  std::string
  NamedQuantity::unit(const Units &units) const
  {
    if (!keeps_unit)
      return "";
    switch (kind())
      {
        case 'u':
        case 'w':
          return units.length;
        case 's':
        case 'p':
          return units.stress;
        case 'f':
          return units.force;
        case 'd':
        case 'm':
          return trimmed(units.force + " " + units.length);
        case 'h':
          return "Hz";
        default:
          return "";
      }
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
    contact_quantity_names()
    {
      static const std::vector<std::string> names{"pressure",
                                                  "width",
                                                  "width x",
                                                  "width y",
                                                  "width z",
                                                  "dissipated",
                                                  "peel",
                                                  "shear"};
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



    /// Returns the column at the beginning of @p words and the strip at their
    /// end; @p of_contact is whether a strip is allowed.
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
        text.refuse("recover.strip-without-contact: only the results of a "
                    "contact can be limited to a strip (in AXIS FROM TO)",
                    "Remove the text after " + column + ".");
      const auto axis = parts.end() - in == 4 ? axis_of(in[1]) : std::nullopt;
      if (!axis)
        text.refuse(
          "recover.strip-syntax: write a strip of a contact as CONTACT: COLUMN "
          "in AXIS FROM TO, as in roller: fz in y 40 60");
      const ContactStrip strip{*axis, text.number(in[2]), text.number(in[3])};
      if (!(strip.from < strip.to))
        text.refuse("recover.strip-empty: a strip must begin before its end",
                    "Exchange " + in[2] + " and " + in[3] +
                      ", or write two different limits.");
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
      for (const auto &mode : names.modes)
        all.push_back(mode.first);
      return all;
    }



    /// Returns the quantity of the support or contact @p name; @p words are its
    /// column and strip, @p text is the whole entry.
    NamedQuantity
    find_resultant(const Entry         &text,
                   const std::string   &name,
                   const std::string   &words,
                   const QuantityNames &names)
    {
      const bool of_support = names.supports.count(name) > 0,
                 of_contact = names.contacts.count(name) > 0;
      if (of_support && of_contact)
        text.refuse(
          "recover.ambiguous-name: both a support and a contact are called '" +
            name + "'",
          "Rename one of the two.");
      NamedQuantity quantity;
      if (!of_support && !of_contact)
        return quantity;
      const auto [column, strip]       = parse_strip(text, words, of_contact);
      std::vector<std::string> columns = components();
      if (of_contact)
        columns.insert(columns.end(),
                       contact_quantity_names().begin(),
                       contact_quantity_names().end());
      if (std::find(columns.begin(), columns.end(), column) == columns.end())
        text.refuse("recover.unknown-column: unknown quantity; those of " +
                    std::string(of_contact ? "contact " : "support ") + name +
                    " are " + joined(columns));
      quantity.strip  = strip;
      quantity.of     = of_support ? NamedQuantity::ObjectKind::support :
                                     NamedQuantity::ObjectKind::contact;
      quantity.name   = name;
      quantity.column = column;
      quantity.path   = text.path();
      if (!strip)
        quantity.given =
          first_of((of_support ? names.supports : names.contacts).at(name),
                   column);
      return quantity;
    }



    /// Returns a column of @p probe at @p place (NAME or NAME/PLY).
    NamedQuantity
    find_column(const Entry                    &text,
                const Probe                    &probe,
                const std::vector<std::string> &place,
                const std::string              &column)
    {
      NamedQuantity quantity{NamedQuantity::ObjectKind::probe,
                             probe.name,
                             0,
                             column,
                             {},
                             text.path()};
      if (place.size() > 1)
        {
          constexpr double most = 1e6;
          const double     ply  = text.number(place[1]);
          if (place.size() > 2 ||
              !(ply >= 1. && ply <= most && ply == std::floor(ply)))
            text.refuse(
              "recover.ply-number: the number after the slash must be that of "
              "a ply, counted from 1 at the bottom, as in tip/2: syz");
          quantity.ply = static_cast<unsigned int>(ply);
        }
      const auto &columns = field_names();
      if (std::find(columns.begin(), columns.end(), column) == columns.end())
        text.refuse(
          "recover.unknown-column: the results of a probe have no column '" +
            column + "'",
          "Check the spelling: the most similar name is '" +
            nearest_name(column, columns) + "'; the names are " +
            joined(columns) + ".");
      quantity.given = first_of(probe.references, column);
      return quantity;
    }



    /// Returns the value of the mode @p name.
    NamedQuantity
    find_mode(const Entry                  &text,
              const std::string            &name,
              const std::string            &column,
              const std::vector<Reference> &references)
    {
      if (column != column_of_mode(name))
        text.refuse("recover.unknown-column: the only result of " + name +
                    " is its " + column_of_mode(name));
      NamedQuantity quantity{
        NamedQuantity::ObjectKind::mode, name, 0, column, {}, text.path()};
      quantity.given = first_of(references, column);
      return quantity;
    }
  } // namespace



  NamedQuantity
  parse_probe_quantity(const Entry &text, const std::vector<Probe> &probes)
  {
    const auto parts = text.items(':');
    if (parts.size() != 2)
      text.refuse(
        "recover.quantity-syntax: write PROBE: COLUMN, for example tip: uz");
    const auto               place = split(parts[0], '/');
    std::vector<std::string> names;
    for (const Probe &probe : probes)
      {
        if (!place.empty() && probe.name == place[0])
          return find_column(text, probe, place, parts[1]);
        names.push_back(probe.name);
      }
    text.refuse("recover.unknown-name: no probe is called '" + parts[0] + "'",
                names.empty() ?
                  "Add the probe to Probes." :
                  "Check the spelling: the most similar name is '" +
                    nearest_name(parts[0], names) + "'.");
  }



  NamedQuantity
  parse_quantity(const Entry &text, const QuantityNames &names)
  {
    if (text.text().find_first_of(",;") != std::string::npos)
      text.refuse("recover.quantity-syntax: quantities are separated by '|', "
                  "not by a comma or semicolon",
                  "Write, for example, tip: uz | clamp: fz.");
    const auto parts = text.items(':');
    if (parts.size() != 2)
      text.refuse(
        "recover.quantity-syntax: write each quantity as NAME: COLUMN, and '|' "
        "between quantities, as in tip: uz | clamp: fz");
    const auto place = split(parts[0], '/');
    for (const Probe &probe : names.probes)
      if (!place.empty() && probe.name == place[0])
        return find_column(text, probe, place, parts[1]);
    for (const Measure &measure : names.measures)
      if (measure.name == parts[0])
        {
          if (parts[1] != measure.quantity.column)
            text.refuse("recover.unknown-column: " + measure.name +
                        " is a Measure, whose only column is " +
                        measure.quantity.column);
          NamedQuantity quantity = measure.quantity;
          quantity.path          = text.path();
          return quantity;
        }
    for (const auto &[name, references] : names.modes)
      if (name == parts[0])
        return find_mode(text, name, parts[1], references);
    NamedQuantity resultant = find_resultant(text, parts[0], parts[1], names);
    if (resultant.of == NamedQuantity::ObjectKind::undefined)
      text.refuse(
        "recover.unknown-name: no probe, measure, support, contact or mode of "
        "Find is called '" +
          parts[0] + "'",
        "Check the spelling: the most similar name is '" +
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
      entry.refuse(
        "recover.axis-along-normal: the contact normal points along " +
          std::string(1, "xyz"[facing]) +
          ", and along its normal a contact has no " + what,
        "Use " + across + ".");
    };
    if (quantity.column == std::string("width ") + "xyz"[facing])
      refuse_axis("width");
    if (!quantity.strip)
      return;
    if (quantity.strip->axis == facing)
      refuse_axis("strips");
    const auto [begin, end] = search_radius_along(points, quantity.strip->axis);
    if (quantity.strip->to <= begin || quantity.strip->from >= end)
      entry.refuse("recover.strip-outside: the contact only extends from " +
                     to_text(begin) + " to " + to_text(end) + " along " +
                     "xyz"[quantity.strip->axis],
                   "Write a strip within this range.");
  }



  std::vector<NamedQuantity>
  quantities_with_references(const QuantityNames      &names,
                             std::vector<std::string> &others)
  {
    std::vector<NamedQuantity> quantities;
    const auto                 add = [&](const NamedQuantity::ObjectKind of,
                         const std::string              &name,
                         const std::vector<Reference>   &references) {
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
        add(NamedQuantity::ObjectKind::probe, probe.name, probe.references);
        if (probe.references.empty())
          others.push_back(probe.name);
      }
    for (const Measure &measure : names.measures)
      if (!measure.references.empty())
        quantities.push_back(measure.quantity);
    for (const auto &[name, references] : names.supports)
      add(NamedQuantity::ObjectKind::support, name, references);
    for (const auto &[name, references] : names.contacts)
      add(NamedQuantity::ObjectKind::contact, name, references);
    for (const auto &[name, references] : names.modes)
      add(NamedQuantity::ObjectKind::mode, name, references);
    return quantities;
  }



  void
  check_ply(const NamedQuantity            &quantity,
            const std::vector<std::string> &plies)
  {
    if (quantity.ply == 0 ||
        std::find(plies.begin(), plies.end(), std::to_string(quantity.ply)) !=
          plies.end())
      return;
    const Entry entry(quantity.path, quantity.label());
    if (plies == std::vector<std::string>{"0"})
      entry.refuse(
        "recover.ply-of-box: the Box of the probe extends over several plies, "
        "and its results are means over all of them",
        "Remove the ply after the slash, or make Box smaller.");
    entry.refuse("recover.wrong-ply: the probe lies in ply " + joined(plies) +
                   ", not in the ply after the slash",
                 "Write the number of the ply, or move the probe (At).");
  }



  void
  refuse_interface(const NamedQuantity            &quantity,
                   const std::vector<std::string> &plies)
  {
    Entry(quantity.path, quantity.label())
      .refuse("recover.probe-on-interface: the probe lies between the plies " +
                joined(plies) + ", where the results of the two plies differ",
              "Name one of these plies, as in " + quantity.name + "/" +
                plies.front() + ": " + quantity.column + ".");
  }
} // namespace lamella
