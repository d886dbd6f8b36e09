// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/adapt/boundary_layer_modes.h>
#include <lamella/adapt/local_interactions.h>
#include <lamella/adapt/plan.h>
#include <lamella/base/arithmetic.h>

#include <algorithm>
#include <optional>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Effect of @p touch on a section of @p n_fields: @p loads, @p at_node.
    void
    take_loads(LocalInteraction               &interaction,
               const std::vector<SectionLoad> &loads,
               const bool                      at_node,
               const unsigned int              n_fields,
               const InteractionRules         &rules)
    {
      interaction.constrains_section =
        at_node &&
        std::any_of(loads.begin(), loads.end(), [](const SectionLoad &load) {
          return load.of_clamp;
        });
      if (interaction.constrains_section)
        for (const SectionLoad &load : loads)
          interaction.held.push_back(load.f);
      else
        {
          interaction.loads  = independent_loads(loads, n_fields, rules);
          interaction.smooth = smooth_loads(loads, n_fields);
        }
    }



    /// One touch for each part of the axis that @p loads, of a section with
    /// @p n_fields, are on; of the @p kind that is to be said of them, if any.
    void
    add_interactions(const std::string       &name,
                     const unsigned int       n_fields,
                     std::vector<SectionLoad> loads,
                     bool LocalInteraction::*const  kind,
                     const InteractionRules        &rules,
                     std::vector<LocalInteraction> &interactions)
    {
      std::stable_sort(loads.begin(),
                       loads.end(),
                       [](const SectionLoad &a, const SectionLoad &b) {
                         return a.place.begin < b.place.begin;
                       });
      for (auto begin = loads.begin(); begin != loads.end();)
        {
          LocalInteraction interaction;
          interaction.name    = name;
          interaction.begin   = begin->place.begin;
          interaction.end     = begin->place.end;
          interaction.element = begin->place.element;
          bool at_node        = true;
          auto end            = begin;
          for (; end != loads.end() && end->place.begin <= interaction.end;
               ++end)
            {
              interaction.end = std::max(interaction.end, end->place.end);
              interaction.element =
                std::min(interaction.element, end->place.element);
              at_node = at_node && end->at_node;
            }
          take_loads(interaction, {begin, end}, at_node, n_fields, rules);
          if (kind != nullptr)
            interaction.*kind = true;
          interactions.push_back(std::move(interaction));
          begin = end;
        }
    }
    /// Returns for each axis element of @p beam whether its temperature varies
    /// by more than the response to a constant temperature represents.
    std::vector<bool>
    elements_with_varying_heat(const Beam &beam, const InteractionRules &rules)
    {
      const Axis         &axis = beam.axis();
      std::vector<Vector> heat;
      double              largest = 0.;
      for (const double y : axis.nodes())
        {
          heat.push_back(beam.section_thermal_load(y).on_values);
          largest = std::max(largest, heat.back().l2_norm());
        }
      const double      H = beam.section().extents().first;
      std::vector<bool> result;
      for (unsigned int cell = 0; cell < axis.n_cells(); ++cell)
        {
          const auto  &nodes  = axis.nodes_of_cell(cell);
          const double length = axis.cell_end(cell) - axis.cell_begin(cell);
          double       largest_change = 0.;
          for (const unsigned int node : nodes)
            {
              Vector change = heat[node];
              change -= heat[nodes[0]];
              largest_change = std::max(largest_change, change.l2_norm());
            }
          result.push_back(largest_change * H >
                           rules.heat_change_tolerance * largest * length);
        }
      return result;
    }



    /// The heat of @p beam as a load where it varies along the axis.
    void
    add_thermal_load(const Beam                    &beam,
                     const InteractionRules        &rules,
                     std::vector<LocalInteraction> &interactions)
    {
      if (!beam.is_heated())
        return;
      Vector load(beam.n_dofs());
      beam.add_thermal_load(undisplaced, load);
      add_interactions("heat",
                       beam.section().n_fields(),
                       loads_of_vector(beam,
                                       load,
                                       elements_with_varying_heat(beam, rules),
                                       rules),
                       &LocalInteraction::is_heat_source,
                       rules,
                       interactions);
    }



    /// Returns the section loads of @p support, number @p number, on @p beam,
    /// the body number @p body.
    std::vector<SectionLoad>
    loads_of_support(const Beam                              &beam,
                     const unsigned int                       body,
                     const unsigned int                       number,
                     const Support                           &support,
                     const std::vector<PrescribedFunctional> &rows,
                     const InteractionRules                  &rules)
    {
      std::vector<SectionLoad> held;
      for (const PrescribedFunctional &row : rows)
        if (row.support == number && row.row.body == body)
          {
            held.push_back(
              load_of_row(beam, row.row.row, row.position, 1., false, rules));
            held.back().of_clamp = std::any_of(
              support.on.begin(), support.on.end(), [&](const Region &region) {
                return region.body == body &&
                       is_clamp(region,
                                beam.place().to_body(row.position)[1],
                                beam.axis().length());
              });
          }
      return held;
    }



    /// Returns the section loads of @p contact on @p beam, the body number @p
    /// body: of normal forces, or of friction @p along a tangent.
    std::vector<SectionLoad>
    loads_of_contact(const Beam                       &beam,
                     const unsigned int                body,
                     const ContactInterface           &contact,
                     const std::optional<unsigned int> along,
                     const InteractionRules           &rules)
    {
      std::vector<SectionLoad> loads;
      for (unsigned int k = 0; k < contact.rows.size(); ++k)
        {
          const GapConstraint &row = contact.rows[k];
          if (along && *along >= row.slips.size())
            continue;
          const ContactConstraint &pair =
            along ? static_cast<const ContactConstraint &>(row.slips[*along]) :
                    row;
          for (const BodyFunctional &part : pair.parts)
            if (part.body == body)
              loads.push_back(load_of_row(beam,
                                          part.row,
                                          body == contact.first_body ?
                                            contact.points[k].first :
                                            contact.points[k].second,
                                          contact.points[k].area,
                                          !along,
                                          rules));
        }
      return loads;
    }



    /// Normal and tangential tractions of @p contact on @p beam, body @p body.
    void
    add_contact(const Beam                    &beam,
                const unsigned int             body,
                const ContactInterface        &contact,
                const InteractionRules        &rules,
                std::vector<LocalInteraction> &interactions)
    {
      const auto add = [&](const std::string                &name,
                           const std::optional<unsigned int> along,
                           bool LocalInteraction::*const kind) {
        add_interactions(name,
                         beam.section().n_fields(),
                         loads_of_contact(beam, body, contact, along, rules),
                         kind,
                         rules,
                         interactions);
      };
      add("contact " + contact.name, {}, &LocalInteraction::is_contact_side);
      for (unsigned int tangent = 0; tangent < 2; ++tangent)
        add("friction of contact " + contact.name, tangent, nullptr);
    }
  } // namespace



  std::vector<LocalInteraction>
  heated_free_ends(const Beam                          &beam,
                   const std::vector<LocalInteraction> &interactions)
  {
    const Axis                   &axis = beam.axis();
    std::vector<LocalInteraction> ends;
    if (!beam.is_heated())
      return ends;
    for (const bool at_start : {true, false})
      {
        const unsigned int cell = at_start ? 0 : axis.n_cells() - 1;
        LocalInteraction   end;
        end.name            = "heated end";
        end.begin           = at_start ? 0. : axis.length();
        end.end             = end.begin;
        end.element         = axis.cell_end(cell) - axis.cell_begin(cell);
        end.is_free         = true;
        const auto holds_it = [&](const LocalInteraction &interaction) {
          return interaction.constrains_section &&
                 std::abs(interaction.begin - end.begin) <
                   arithmetic::same_position * axis.length();
        };
        if (std::none_of(interactions.begin(), interactions.end(), holds_it))
          ends.push_back(end);
      }
    return ends;
  }



  Vector
  load_vector_on(const Load        &load,
                 const unsigned int body,
                 const Bodies      &bodies)
  {
    std::vector<types::global_dof_index> sizes;
    for (const auto &one : bodies)
      sizes.push_back(one->n_dofs());
    BlockVector forces(sizes);
    add_load(load, bodies, forces);
    return forces.block(body);
  }



  std::vector<LocalInteraction>
  find_interactions(const Beam                          &beam,
                    const unsigned int                   body,
                    const Bodies                        &bodies,
                    const std::vector<Support>          &supports,
                    const std::vector<Load>             &loads,
                    const std::vector<ContactInterface> &contacts,
                    const InteractionRules              &rules)
  {
    const unsigned int            n_fields = beam.section().n_fields();
    std::vector<LocalInteraction> interactions;
    const std::vector<PrescribedFunctional> rows =
      prescribed_functionals(supports, bodies);
    for (unsigned int s = 0; s < supports.size(); ++s)
      add_interactions(
        "support " + supports[s].name,
        n_fields,
        supports[s].isostatic ?
          std::vector<SectionLoad>() :
          loads_of_support(beam, body, s, supports[s], rows, rules),
        &LocalInteraction::holds,
        rules,
        interactions);
    for (const Load &load : loads)
      add_interactions("load " + load.name,
                       n_fields,
                       loads_of_vector(beam,
                                       load_vector_on(load, body, bodies),
                                       std::vector<bool>(beam.axis().n_cells(),
                                                         true),
                                       rules),
                       nullptr,
                       rules,
                       interactions);
    add_thermal_load(beam, rules, interactions);
    for (const ContactInterface &contact : contacts)
      add_contact(beam, body, contact, rules, interactions);
    return interactions;
  }



  void
  add_missing_field_notes(const Beam                          &beam,
                          const std::vector<LocalInteraction> &interactions,
                          std::vector<std::string>            &notes)
  {
    const auto add = [&notes](const std::string &note) {
      if (std::find(notes.begin(), notes.end(), note) == notes.end())
        notes.push_back(note);
    };
    for (const LocalInteraction &interaction : interactions)
      if (interaction.is_contact_side)
        add("adapt.fields-missing: body " + beam.name() +
            ": theory SV has no local deformation of sections near " +
            interaction.name +
            ", so pressures and stresses are inaccurate there. Use SV-6");
      else if (interaction.is_heat_source)
        add("adapt.fields-missing: body " + beam.name() +
            ": theory SV does not represent temperatures that vary along the "
            "axis, so thermal stresses are not accurate. Use Theory = SV-6");
  }



  void
  add_guide_heat_notes(const Beam                          &beam,
                       const std::vector<LocalInteraction> &interactions,
                       std::vector<std::string>            &notes)
  {
    if (!beam.is_heated())
      return;
    for (unsigned int t = 0; t < interactions.size(); ++t)
      if (interactions[t].constrains_section)
        {
          const auto constrained =
            constrained_sections(interactions, t, beam.axis());
          if (constrained[0].rows.size() < beam.section().n_fields() &&
              constrained[0].by[0] == interactions[t].name)
            notes.push_back(
              "adapt.fields-missing: body " + beam.name() +
              " has a Temperature, and " + interactions[t].name +
              " constrains some displacements of a section only: SV-N is not "
              "accurate there. Do not use stresses within two section heights "
              "of this support, or use LE-N there (Theory or Theories)");
        }
  }
} // namespace lamella
