// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/adapt/local_interactions.h>
#include <lamella/adapt/section_fields.h>
#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/linear_functional.h>
#include <lamella/body/geometrically_exact_beam.h>
#include <lamella/body/total_lagrangian_beam.h>

#include <algorithm>
#include <map>
#include <set>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    bool
    is_chosen(const BodyDescription &body)
    {
      return body.theory.is_saint_venant() || !body.pieces.empty();
    }



    using FieldLists = std::vector<std::vector<unsigned int>>;

    /// What touches a body, with the groups that each belongs to, and where its
    /// stresses are asked for; its plan, and the fields that its nodes get by
    /// it: no lists where it keeps all.
    struct InteractionsOfBody
    {
      unsigned int                           number;
      PlanInput                              facts;
      std::vector<LocalInteraction>          interactions;
      std::vector<std::pair<double, double>> requested;
      std::vector<std::vector<unsigned int>> groups  = {};
      BodyPlan                               planned = {};
      FieldLists                             lists   = {};
    };



    using InteractionsBySection =
      std::map<std::pair<std::string, Theory>, std::vector<InteractionsOfBody>>;

    /// The groups that each node of @p beam is near.
    std::vector<std::set<unsigned int>>
    near_groups(const Beam               &beam,
                const InteractionsOfBody &loaded,
                const SectionFields      &fields)
    {
      std::vector<std::set<unsigned int>> result;
      for (const double y : beam.axis().nodes())
        {
          result.emplace_back();
          for (unsigned int t = 0; t < loaded.interactions.size(); ++t)
            for (const unsigned int group : loaded.groups[t])
              if (const double influence_length =
                    fields.influence_length_of(group);
                  y > loaded.interactions[t].begin - influence_length &&
                  y < loaded.interactions[t].end + influence_length)
                result.back().insert(group);
        }
      return result;
    }



    /// Gives all nodes of elements with stress output the functions of each.
    void
    equalize_elements(std::vector<std::set<unsigned int>>          &near,
                      const Axis                                   &axis,
                      const std::vector<std::pair<double, double>> &requested)
    {
      const std::vector<std::set<unsigned int>> before = near;
      const double tolerance = arithmetic::same_position * axis.length();
      for (unsigned int cell = 0; cell < axis.n_cells(); ++cell)
        if (std::any_of(
              requested.begin(), requested.end(), [&](const auto &place) {
                return place.second > axis.cell_begin(cell) - tolerance &&
                       place.first < axis.cell_end(cell) + tolerance;
              }))
          for (const unsigned int i : axis.nodes_of_cell(cell))
            for (const unsigned int j : axis.nodes_of_cell(cell))
              near[i].insert(before[j].begin(), before[j].end());
    }



    /// Fields at each node of @p beam; @p near are the groups of each.
    FieldLists
    lists_of(const Beam                                &beam,
             const std::vector<std::set<unsigned int>> &near,
             const BodyDescription                     &description,
             SectionFields                             &fields)
    {
      std::vector<std::vector<unsigned int>> lists;
      for (unsigned int node = 0; node < near.size(); ++node)
        {
          // Between two pieces a node carries what the richer one wants; LE-q
          // and SV are both in the section's own LE, and hardly in less.
          const Wanted wanted =
            requirements_of(theories_at(beam.axis().nodes()[node],
                                        description.pieces,
                                        beam.axis().length()));
          if (wanted.degree > 0)
            lists.push_back(list_of_degree(beam.section(),
                                           wanted.any_SV ?
                                             beam.section().element().degree() :
                                             wanted.degree));
          else if (wanted.plain && wanted.any_SV)
            lists.push_back(fields.saint_venant_list());
          else
            lists.push_back(fields.list(near[node]));
        }
      return lists;
    }



    /// Mean share of a node's fields that supports (no clamps) constrain.
    double
    mean_constrained(const std::vector<std::set<unsigned int>> &near,
                     const SectionFields                       &fields)
    {
      std::size_t sum = 0;
      for (const std::set<unsigned int> &groups : near)
        for (const unsigned int group : groups)
          sum += fields.n_constrained(group);
      return double(sum) / near.size();
    }



    /// Of the fields that each node would carry, @p lists.
    unsigned int
    mean_size(const std::vector<std::vector<unsigned int>> &lists)
    {
      std::size_t sum = 0;
      for (const auto &list : lists)
        sum += list.size();
      return sum / lists.size();
    }



    /// Whether @p beam was not to be solved with fewer fields than all.
    bool
    is_unsolved(const Beam &beam, const FieldRules &rules)
    {
      return std::find(rules.unsolved.begin(),
                       rules.unsolved.end(),
                       beam.name()) != rules.unsolved.end();
    }



    /// What is known of @p beam before any field is sought.
    PlanInput
    facts_of(const Beam                 &beam,
             const unsigned int          number,
             const BodyDescription      &description,
             const std::vector<Support> &supports,
             const FieldRules           &rules)
    {
      PlanInput facts;
      facts.size.dofs   = beam.n_dofs();
      facts.size.nodes  = beam.axis().n_nodes();
      facts.size.fields = beam.section().n_fields();
      facts.size.cells  = beam.section().n_cells();
      facts.size.constrained_along_axis =
        is_constrained_along_axis(supports, number);
      facts.theory      = description.theory;
      facts.has_pieces  = !description.pieces.empty();
      facts.is_unsolved = is_unsolved(beam, rules);
      return facts;
    }



    /// What holds @p beam at the touch number @p t of @p body.
    std::vector<ConstrainedSection>
    sampled_sections(const Beam               &beam,
                     const InteractionsOfBody &body,
                     const unsigned int        t,
                     const BoundaryLayerRules &rules)
    {
      const double near = rules.sampled * beam.section().extents().second,
                   y    = body.interactions[t].begin;
      auto held = constrained_sections(body.interactions, t, beam.axis());
      for (ConstrainedSection &one : held)
        {
          one.body = beam.name();
          one.is_sampled =
            std::any_of(body.requested.begin(),
                        body.requested.end(),
                        [&](const auto &at) {
                          return at.second > y - near && at.first < y + near;
                        });
        }
      return held;
    }



    /// Those of each of the touches of @p body, which is @p beam; without end
    /// fields, which cost a solution, unless @p wants_responses.
    std::vector<std::vector<unsigned int>>
    groups_of(const Beam               &beam,
              const InteractionsOfBody &body,
              SectionFields            &fields,
              const FieldRules         &rules,
              const bool                wants_responses)
    {
      std::vector<std::vector<unsigned int>> groups;
      for (unsigned int t = 0; t < body.interactions.size(); ++t)
        if (const LocalInteraction &interaction = body.interactions[t];
            (interaction.constrains_section || interaction.is_free) &&
            wants_responses)
          groups.push_back(fields.groups_of(
            interaction,
            sampled_sections(beam, body, t, rules.ends->limits())));
        else if (interaction.is_free)
          groups.emplace_back();
        else
          groups.push_back({fields.group_of(interaction)});
      return groups;
    }



    /// The plan of @p body, which is @p beam, and its lists.
    void
    choose_lists(const Beam            &beam,
                 InteractionsOfBody    &body,
                 const BodyDescription &description,
                 SectionFields         &fields,
                 const FieldRules      &rules)
    {
      auto near = near_groups(beam, body, fields);
      equalize_elements(near, beam.axis(), body.requested);
      body.facts.held = mean_constrained(near, fields);
      body.planned    = plan(body.facts, rules.plan);
      if (body.planned.all_fields)
        return;
      body.lists        = lists_of(beam, near, description, fields);
      body.facts.wanted = mean_size(body.lists);
      body.planned      = plan(body.facts, rules.plan);
      if (body.planned.all_fields)
        body.lists.clear();
    }



    /// Heat of @p beam at nodes whose values span those at the others.
    std::vector<Beam::SectionThermalLoad>
    independent_heat(const Beam &beam, const FieldRules &rules)
    {
      if (!beam.is_heated())
        return {};
      std::vector<Beam::SectionThermalLoad> heat, result;
      for (const double y : beam.axis().nodes())
        heat.push_back(beam.section_thermal_load(y));
      const unsigned int       n = beam.section().n_fields();
      LAPACKFullMatrix<double> rows(heat.size(), n);
      for (unsigned int k = 0; k < heat.size(); ++k)
        for (unsigned int a = 0; a < n; ++a)
          rows(k, a) = heat[k].on_values[a];
      for (const unsigned int k :
           select_independent_rows(rows, rules.heat_tolerance))
        result.push_back(heat[k]);
      return result;
    }



    /// Returns the loads of all sections of the bodies @p loaded.
    LoadsAlongAxis
    loads_along_axis(const std::vector<const Beam *>       &beams,
                     const std::vector<InteractionsOfBody> &loaded,
                     const std::vector<BodyDescription>    &descriptions,
                     const Tensor<1, 3>                    &gravity,
                     const FieldRules                      &rules)
    {
      LoadsAlongAxis found;
      for (const InteractionsOfBody &body : loaded)
        {
          const Beam &beam = *beams[body.number];
          for (const Beam::SectionThermalLoad &one :
               independent_heat(beam, rules))
            found.heat.push_back(one);
          if (gravity.norm() > 0.)
            found.weights.push_back(beam.section_weight(gravity));
          // Bodies of one section have equal densities.
          if (descriptions[body.number].has_inertia && found.inertia.empty())
            found.inertia = beam.section_inertia();
        }
      return found;
    }



    /// Adds notes on @p body, which is @p beam: @p why it keeps all fields of
    /// its section, or which interactions have no fields.
    void
    note_choice(const Beam               &beam,
                const InteractionsOfBody &body,
                const BodyDescription    &description,
                const std::string        &why,
                std::vector<std::string> &notes)
    {
      const Theory &theory = description.theory;
      if (!why.empty())
        notes.push_back(
          "adapt.all-fields: body " + beam.name() + ": for " + theory.name() +
          ", " + why +
          (body.facts.is_unsolved ? "." :
                                    ", so reducing its DoFs saves nothing.") +
          " Each node has all section functions as DoFs (those of " +
          beam.section().theory().name() + ")");
      if (theory.order == 0 && description.pieces.empty())
        add_missing_field_notes(beam, body.interactions, notes);
      else if (why.empty())
        add_guide_heat_notes(beam, body.interactions, notes);
    }



    /// Returns @p beam with the fields @p lists of @p space at its nodes.
    std::unique_ptr<Beam>
    with_lists(const Beam                                   &beam,
               const std::shared_ptr<const SectionSpace>    &space,
               const BodyDescription                        &description,
               const std::vector<std::vector<unsigned int>> &lists)
    {
      const std::string label = label_of(description, lists);
      if (description.has_finite_rotations)
        return std::make_unique<GeometricallyExactBeam>(
          beam.name(), space, beam.shared_axis(), beam.place(), lists, label);
      return std::make_unique<Beam>(
        beam.name(), space, beam.shared_axis(), beam.place(), lists, label);
    }



    /// Returns @p beam with finite rotations and all fields of its section.
    /// Throws InputError if its axis elements are not cubic.
    std::unique_ptr<Beam>
    with_finite_rotations_and_all_fields(const Beam            &beam,
                                         const BodyDescription &description)
    {
      if (beam.axis().degree() < 3)
        throw InputError(
          "Body " + beam.name() + "/Kinematics/Axis element",
          "B" + std::to_string(beam.axis().degree() + 1),
          "adapt.axis-element-locks: Rotations = large with Theory = " +
            description.theory.name() +
            " needs cubic axis elements; B2 and B3 have membrane locking",
          "Write Axis element = B4.");
      return std::make_unique<TotalLagrangianBeam>(
        beam.name(),
        beam.fields().shared_section(),
        beam.shared_axis(),
        beam.place());
    }



    /// Replaces the bodies @p touched of one section and theory.
    void
    replace(Bodies                             &bodies,
            const std::vector<BodyDescription> &descriptions,
            const Tensor<1, 3>                 &gravity,
            std::vector<InteractionsOfBody>    &loaded,
            const FieldRules                   &rules,
            std::vector<std::string>           &notes)
    {
      const std::vector<const Beam *> beams = beams_of(bodies);
      SectionFields                   fields(
        beams[loaded[0].number]->fields().shared_section(),
        descriptions[loaded[0].number].theory,
        rules,
        loads_along_axis(beams, loaded, descriptions, gravity, rules));
      for (InteractionsOfBody &body : loaded)
        {
          const Beam &beam = *beams[body.number];
          // A body with all fields of its section needs none.
          const bool uses_responses =
            descriptions[body.number].theory.order > 0 &&
            !plan(body.facts, rules.plan).all_fields;
          body.groups = groups_of(beam, body, fields, rules, uses_responses);
        }

      for (InteractionsOfBody &body : loaded)
        {
          const Beam            &beam        = *beams[body.number];
          const BodyDescription &description = descriptions[body.number];
          choose_lists(beam, body, description, fields, rules);
          note_choice(
            beam, body, description, body.planned.fields_reason, notes);
        }
      const auto space = fields.space();
      for (const InteractionsOfBody &body : loaded)
        if (const unsigned int b = body.number; !body.lists.empty())
          bodies[b] = with_lists(*beams[b], space, descriptions[b], body.lists);
        else if (descriptions[b].has_finite_rotations)
          bodies[b] =
            with_finite_rotations_and_all_fields(*beams[b], descriptions[b]);
    }



    /// What of the scene is on @p beam, which is the body number @p b.
    InteractionsOfBody
    interactions_of_body(const Beam                          &beam,
                         const unsigned int                   b,
                         const Bodies                        &bodies,
                         const BodyDescription               &description,
                         const std::vector<Support>          &supports,
                         const std::vector<Load>             &loads,
                         const std::vector<ContactInterface> &contacts,
                         const std::vector<StressRange>      &requested,
                         const FieldRules                    &rules)
    {
      InteractionsOfBody body{
        b,
        facts_of(beam, b, description, supports, rules),
        find_interactions(
          beam, b, bodies, supports, loads, contacts, rules.interactions),
        {}};
      for (const StressRange &place : requested)
        if (place.body == b)
          body.requested.emplace_back(place.begin, place.end);
      for (const LocalInteraction &end :
           heated_free_ends(beam, body.interactions))
        body.interactions.push_back(end);
      return body;
    }
  } // namespace

  bool
  has_fields_to_choose(const std::vector<BodyDescription> &descriptions)
  {
    return std::any_of(descriptions.begin(), descriptions.end(), is_chosen);
  }

  std::vector<std::string>
  choose_fields(Bodies                              &bodies,
                const std::vector<BodyDescription>  &descriptions,
                const std::vector<Support>          &supports,
                const std::vector<Load>             &loads,
                const std::vector<ContactInterface> &contacts,
                const std::vector<StressRange>      &requested,
                const FieldRules                    &rules,
                const Tensor<1, 3>                  &gravity,
                std::vector<std::string>            *why)
  {
    const std::vector<const Beam *> beams = beams_of(bodies);
    InteractionsBySection           loaded;
    for (unsigned int b = 0; b < descriptions.size(); ++b)
      if (descriptions[b].theory.is_saint_venant())
        loaded[{descriptions[b].section, descriptions[b].theory}].push_back(
          interactions_of_body(*beams[b],
                               b,
                               bodies,
                               descriptions[b],
                               supports,
                               loads,
                               contacts,
                               requested,
                               rules));
    std::vector<std::string> notes;
    for (unsigned int b = 0; b < descriptions.size(); ++b)
      if (descriptions[b].theory.hierarchical)
        add_coarse_row_notes(
          *beams[b], b, descriptions[b].pieces, contacts, notes);
    for (auto &[key, of_section] : loaded)
      replace(bodies, descriptions, gravity, of_section, rules, notes);
    // After all interactions are found: they use the fields of whole sections.
    for (unsigned int b = 0; b < descriptions.size(); ++b)
      if (is_chosen(descriptions[b]) && descriptions[b].theory.is_layerwise())
        bodies[b] = make_by_degrees(descriptions[b], *beams[b]);
    for (const auto &[key, of_section] : loaded)
      for (const InteractionsOfBody &body : of_section)
        if (why != nullptr)
          (*why)[body.number] = describe_fields(body.facts, body.planned);
    return notes;
  }
} // namespace lamella
