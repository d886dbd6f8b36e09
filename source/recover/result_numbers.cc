// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/entry.h>
#include <lamella/body/fields.h>
#include <lamella/contact/contact_patch.h>
#include <lamella/recover/named_quantity.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using dealii::Point;
  using dealii::Tensor;

  ContactTraction
  traction_of(const ContactSummary                     &contact,
              const std::vector<ContactRow>            &rows,
              std::vector<ContactTraction::Dissipation> left)
  {
    std::vector<ContactTraction::Row> all;
    for (const ContactRow &row : rows)
      {
        all.push_back({place_of(row.point),
                       row.point.normal,
                       row.point.area,
                       row.force,
                       row.on_second.moment});
        if (row.friction)
          {
            // Across curved rows a body feels less than lambda_t.
            all.back().shear =
              row.on_second.force - row.force * row.point.normal;
            all.back().dissipated = row.friction->dissipated;
          }
      }
    return ContactTraction(contact.surface, std::move(all), std::move(left));
  }



  namespace
  {
    /// Empty of a mean over several plies.
    std::string
    material_of(const Results &results, const FieldRow &row)
    {
      for (const BodySummary &body : results.bodies)
        if (body.name == row.body && row.ply < body.materials.size())
          return body.materials[row.ply];
      return "";
    }



    std::vector<Mode>
    without_shapes(std::vector<Mode> modes)
    {
      for (Mode &mode : modes)
        mode.shape.reinit(0);
      return modes;
    }



    /// Returns the modes among @p modes that are similar to one of @p given,
    /// with its number.
    std::vector<Mode>
    numbered_as(const std::vector<Mode> &given, std::vector<Mode> modes)
    {
      constexpr double  similar = 0.5;
      std::vector<Mode> numbered;
      for (const Mode &mode : given)
        {
          const auto best =
            std::max_element(modes.begin(),
                             modes.end(),
                             [&](const Mode &one, const Mode &other) {
                               return mode.similarity(one) <
                                      mode.similarity(other);
                             });
          if (best == modes.end() || mode.similarity(*best) <= similar)
            continue;
          numbered.push_back(std::move(*best));
          numbered.back().number = mode.number;
          modes.erase(best);
        }
      return numbered;
    }
  } // namespace



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
        std::vector<ContactTraction::Dissipation> left;
        for (const auto &[point, history] : step.state.friction.history)
          if (point.first == k && history.is_dropped)
            left.push_back({history.position, history.dissipated});
        tractions.emplace(
          name, traction_of(results.contacts[k], step.contacts[k], left));
      }
    if (results.natural_modes)
      natural_modes = without_shapes(results.natural_modes->modes);
    buckling_modes = without_shapes(results.buckling_modes);
    for (unsigned int k = 0; k < results.probes.size(); ++k)
      for (const FieldRow &row : step.probes[k])
        {
          probes.push_back(
            {results.probes[k], row.ply + 1, material_of(results, row), {}});
          const std::vector<double> values = field_values(row.sample);
          for (unsigned int c = 0; c < values.size(); ++c)
            probes.back().columns[field_names()[c]] = values[c];
        }
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
    const std::string &column       = quantity.column;
    const bool         is_component = column[0] == 'f' || column[0] == 'm';
    const unsigned int component    = column[1] - 'x';
    if (is_component && !quantity.strip)
      return (quantity.of == NamedQuantity::ObjectKind::support ? supports :
                                                                  contacts)
        .at(quantity.name)
        .at((column[0] == 'f' ? 0 : 3) + component);
    const ContactTraction &traction = tractions.at(quantity.name);
    if (is_component)
      {
        const auto part = traction.resultant(quantity.strip);
        return (column[0] == 'f' ? part.force : part.moment)[component];
      }
    if (column == "dissipated")
      return traction.dissipated(quantity.strip);
    const ContactPatch patch(traction, quantity.strip);
    if (column == "pressure")
      return patch.pressure();
    if (column == "peel")
      return patch.peel();
    if (column == "shear")
      return patch.shear();
    return column == "width" ? patch.width() : patch.width(column.back() - 'x');
  }



  const Mode *
  ResultNumbers::find_mode(const NamedQuantity &quantity) const
  {
    for (const Mode &mode :
         quantity.column == "factor" ? buckling_modes : natural_modes)
      if (mode.number == quantity.number_of_mode())
        return &mode;
    return nullptr;
  }



  double
  ResultNumbers::value(const NamedQuantity &quantity) const
  {
    if (quantity.of == NamedQuantity::ObjectKind::measure)
      return (value(quantity.terms[0]) - value(quantity.terms[1])) /
             quantity.over;
    if (quantity.of == NamedQuantity::ObjectKind::mode)
      {
        if (const Mode *const mode = find_mode(quantity); mode != nullptr)
          return mode->value;
        Entry(quantity.path, quantity.label())
          .refuse(
            "recover.mode-not-found: this mode is not among those that were "
            "found",
            "Request more Modes, or another range.");
      }
    if (quantity.of != NamedQuantity::ObjectKind::probe)
      return value_of_resultant(quantity);
    std::vector<std::string> plies;
    std::vector<double>      values;
    for (const ProbeRow *row : rows_of(quantity.name))
      {
        plies.push_back(std::to_string(row->ply));
        if (quantity.ply == 0 || quantity.ply == row->ply)
          values.push_back(row->columns.at(quantity.column));
      }
    check_ply(quantity, plies);
    const auto [least, greatest] =
      std::minmax_element(values.begin(), values.end());
    if (*greatest - *least >
        1e-9 * std::max(std::abs(*least), std::abs(*greatest)))
      refuse_interface(quantity, plies);
    return values.front();
  }



  double
  ResultNumbers::scale_of(const NamedQuantity &quantity,
                          const GoalRules     &rules) const
  {
    const double size    = std::abs(value(quantity)),
                 all     = largest_of_kind(quantity),
                 own     = largest_in_material(quantity),
                 largest = own > rules.nothing * all ? own : all;
    return size > rules.near_zero * largest ? size : largest;
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
          NamedQuantity::ObjectKind::probe, name, 0, "", {}, "Quantities"};
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
  ResultNumbers::number_modes_as(const Results &run)
  {
    if (run.natural_modes)
      natural_modes = numbered_as(run.natural_modes->modes, natural_modes);
    buckling_modes = numbered_as(run.buckling_modes, buckling_modes);
  }



  std::vector<NamedQuantity>
  ResultNumbers::of_modes() const
  {
    std::vector<NamedQuantity> quantities;
    for (const auto *modes : {&natural_modes, &buckling_modes})
      for (const Mode &mode : *modes)
        {
          const std::string name =
            (modes == &natural_modes ? "mode-" : "buckling-") +
            std::to_string(mode.number);
          quantities.push_back({NamedQuantity::ObjectKind::mode,
                                name,
                                0,
                                column_of_mode(name),
                                {},
                                "Modes"});
        }
    return quantities;
  }



  double
  ResultNumbers::largest_of_kind(const NamedQuantity &quantity) const
  {
    if (quantity.of == NamedQuantity::ObjectKind::measure)
      return std::max(largest_of_kind(quantity.terms[0]),
                      largest_of_kind(quantity.terms[1])) /
             std::abs(quantity.over);
    const char kind    = quantity.kind();
    double     largest = 0.;
    if (quantity.of == NamedQuantity::ObjectKind::mode)
      return std::abs(value(quantity));
    if (quantity.of == NamedQuantity::ObjectKind::probe)
      {
        for (const ProbeRow &row : probes)
          largest = std::max(largest, largest_of(kind, row));
        return largest;
      }
    for (const auto *resultants : {&supports, &contacts})
      for (const auto &resultant : *resultants)
        for (unsigned int c = 0; c < 6; ++c)
          if ((kind == 'f' && c < 3) || (kind == 'm' && c >= 3))
            largest = std::max(largest, std::abs(resultant.second[c]));
    for (const auto &[name, traction] : tractions)
      {
        const ContactPatch patch(traction);
        if (kind == 'd')
          largest = std::max(largest, traction.dissipated());
        if (kind == 'p')
          for (const ContactTraction::Row &row : traction.rows())
            largest = std::max(largest, row.force / row.area);
        if (kind == 'w')
          for (unsigned int d = 0; d < 3; ++d)
            largest = std::max(largest, patch.width(d));
      }
    return largest;
  }



  double
  ResultNumbers::largest_of(const char kind, const ProbeRow &row)
  {
    double largest = 0.;
    for (const auto &[column, value] : row.columns)
      if (kind_of_column(column) == kind)
        largest = std::max(largest, std::abs(value));
    return largest;
  }



  double
  ResultNumbers::largest_in_material(const NamedQuantity &quantity) const
  {
    if (quantity.of == NamedQuantity::ObjectKind::measure)
      return std::max(largest_in_material(quantity.terms[0]),
                      largest_in_material(quantity.terms[1])) /
             std::abs(quantity.over);
    const char kind = quantity.kind();
    if (quantity.of != NamedQuantity::ObjectKind::probe ||
        (kind != 's' && kind != 'e'))
      return largest_of_kind(quantity);
    std::optional<double> least;
    for (const ProbeRow *own : rows_of(quantity.name))
      if (quantity.ply == 0 || quantity.ply == own->ply)
        {
          double largest = largest_of(kind, *own);
          for (const ProbeRow &row : probes)
            if (!own->material.empty() && row.material == own->material)
              largest = std::max(largest, largest_of(kind, row));
          least = std::min(least.value_or(largest), largest);
        }
    return least.value_or(0.);
  }
} // namespace lamella
