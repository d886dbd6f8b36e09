// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/adapt/fields_of_section.h>
#include <lamella/base/arithmetic.h>
#include <lamella/base/independent_rows.h>
#include <lamella/base/text.h>
#include <lamella/recover/box_points.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    bool
    is_chosen(const BodyDescription &body)
    {
      return body.theory.kind == Theory::Kind::SV || !body.pieces.empty();
    }



    /// What touches a body, with the groups that each belongs to, and where its
    /// stresses are asked for.
    struct TouchedBody
    {
      unsigned int                           number;
      std::vector<Touch>                     touches;
      std::vector<std::pair<double, double>> asked;
      std::vector<std::vector<unsigned int>> groups;
    };



    /// Of the pieces by hand that hold @p y the theories.
    std::vector<Theory>
    theories_at(const double y, const TheoryPieces &pieces, const double length)
    {
      const double        tolerance = arithmetic::same_place * length;
      std::vector<Theory> result;
      for (unsigned int k = 0; k < pieces.theories.size(); ++k)
        {
          const double begin = k == 0 ? 0. : pieces.breaks[k - 1],
                       end =
                         k < pieces.breaks.size() ? pieces.breaks[k] : length;
          if (y > begin - tolerance && y < end + tolerance)
            result.push_back(pieces.theories[k]);
        }
      return result;
    }



    /// The list of LE-@p degree: all of the section's fields, or those of lower
    /// degree that lead them.
    std::vector<unsigned int>
    list_of_degree(const Section &section, const unsigned int degree)
    {
      std::vector<unsigned int> list;
      for (unsigned int alpha = 0; alpha < section.n_fields(); ++alpha)
        if (degree >= section.element().degree() ||
            section.field_degree(alpha) <= degree)
          list.push_back(alpha);
      return list;
    }



    /// Of the pieces at a node what they want of it together.
    struct Wanted
    {
      /// The highest degree of LE, or 0; and whether there is SV, or nothing
      /// but SV without responses.
      unsigned int degree = 0;
      bool         any_SV = false, plain = true;
    };

    Wanted
    wanted_by(const std::vector<Theory> &theories)
    {
      Wanted wanted;
      for (const Theory &theory : theories)
        if (theory.kind == Theory::Kind::LE)
          wanted.degree = std::max(wanted.degree, theory.order);
        else
          wanted.any_SV = true;
      for (const Theory &theory : theories)
        wanted.plain = wanted.plain && theory.order == 0;
      return wanted;
    }



    /// Notes the contacts surface to surface that reach nodes of LE of a lower
    /// degree than the section's: they have a row for each node of its trace.
    void
    note_coarse_rows(const Beam                          &beam,
                     const unsigned int                   body,
                     const TheoryPieces                  &pieces,
                     const std::vector<ContactInterface> &contacts,
                     std::vector<std::string>            &notes)
    {
      std::vector<bool> is_coarse;
      for (const double y : beam.axis().nodes())
        {
          const Wanted wanted =
            wanted_by(theories_at(y, pieces, beam.axis().length()));
          is_coarse.push_back(!wanted.any_SV &&
                              wanted.degree <
                                beam.section().element().degree());
        }
      const auto reaches = [&](const GapRow &row) {
        for (const BodyRow &part : row.parts)
          for (const auto &[dof, weight] : part.row.entries())
            if (part.body == body && is_coarse[beam.dofs().node_of(dof)])
              return true;
        return false;
      };
      for (const ContactInterface &contact : contacts)
        if (contact.discretisation == Discretisation::surface_to_surface &&
            std::any_of(contact.rows.begin(), contact.rows.end(), reaches))
          notes.push_back(
            "body " + beam.name() + ": rows of contact " + contact.name +
            " outnumber what nodes of LE of a lower degree can deform; where "
            "it closes there its force is right and single pressures are not "
            "to be used. Let the piece of the highest degree reach further, or "
            "use Discretisation = node to surface");
    }



    /// The lists of a body whose pieces are all LE.
    std::vector<std::vector<unsigned int>>
    lists_by_degree(const Beam &beam, const TheoryPieces &pieces)
    {
      std::vector<std::vector<unsigned int>> lists;
      for (const double y : beam.axis().nodes())
        lists.push_back(list_of_degree(
          beam.section(),
          wanted_by(theories_at(y, pieces, beam.axis().length())).degree));
      return lists;
    }



    /// The groups that each node of @p beam is near.
    std::vector<std::set<unsigned int>>
    near_groups(const Beam            &beam,
                const TouchedBody     &touched,
                const FieldsOfSection &fields)
    {
      std::vector<std::set<unsigned int>> result;
      for (const double y : beam.axis().nodes())
        {
          result.emplace_back();
          for (unsigned int t = 0; t < touched.touches.size(); ++t)
            for (const unsigned int group : touched.groups[t])
              if (const double reach = fields.reach_of(group);
                  y > touched.touches[t].begin - reach &&
                  y < touched.touches[t].end + reach)
                result.back().insert(group);
        }
      return result;
    }



    /// Lets all nodes of an element have what one of them has, where stresses
    /// are asked for in it.
    void
    even_out(std::vector<std::set<unsigned int>>          &near,
             const Axis                                   &axis,
             const std::vector<std::pair<double, double>> &asked)
    {
      const std::vector<std::set<unsigned int>> before = near;
      const double tolerance = arithmetic::same_place * axis.length();
      for (unsigned int cell = 0; cell < axis.n_cells(); ++cell)
        if (std::any_of(asked.begin(), asked.end(), [&](const auto &place) {
              return place.second > axis.cell_begin(cell) - tolerance &&
                     place.first < axis.cell_end(cell) + tolerance;
            }))
          for (const unsigned int i : axis.nodes_of_cell(cell))
            for (const unsigned int j : axis.nodes_of_cell(cell))
              near[i].insert(before[j].begin(), before[j].end());
    }



    /// The fields that each node of @p beam carries, @p near the groups of
    /// each.
    std::vector<std::vector<unsigned int>>
    lists_of(const Beam                                &beam,
             const std::vector<std::set<unsigned int>> &near,
             const BodyDescription                     &description,
             FieldsOfSection                           &fields)
    {
      std::vector<std::vector<unsigned int>> lists;
      for (unsigned int node = 0; node < near.size(); ++node)
        {
          // Between two pieces a node carries what the richer one wants; LE-q
          // and SV are both in the section's own LE, and hardly in less.
          const Wanted wanted = wanted_by(theories_at(beam.axis().nodes()[node],
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



    /// As in "SV-6 (of LE-2), 12 to 111 fields a node".
    std::string
    label_of(const BodyDescription                        &body,
             const std::vector<std::vector<unsigned int>> &lists)
    {
      std::size_t least = lists[0].size(), most = least;
      for (const auto &list : lists)
        {
          least = std::min(least, list.size());
          most  = std::max(most, list.size());
        }
      std::string names;
      for (const Theory &theory : body.pieces.theories)
        names += (names.empty() ? "" : ", ") + theory.name();
      return (names.empty() ? body.theory.name() : names) + ", " +
             std::to_string(least) +
             (most > least ? " to " + std::to_string(most) : "") +
             " fields a node";
    }



    /// Why nothing can be won on @p beam, before any field is sought; nothing
    /// if something may be.
    std::string
    nothing_to_win(const std::vector<std::set<unsigned int>> &near,
                   const Beam                                &beam,
                   const FieldsOfSection                     &fields,
                   const FieldRules                          &rules)
    {
      const std::size_t n_nodes = near.size();
      if (n_nodes <= rules.least_nodes)
        return "its axis has " + std::to_string(n_nodes) + " nodes only";
      std::size_t sum = 0;
      for (const std::set<unsigned int> &groups : near)
        for (const unsigned int group : groups)
          sum += fields.n_held(group);
      const unsigned int all = beam.section().n_fields();
      if (sum > rules.most_held * n_nodes * all)
        return "supports would hold " + std::to_string(sum / n_nodes) + " of " +
               std::to_string(all) + " fields of a node";
      return "";
    }



    /// Why a beam with the fields @p lists would cost as much as one with all
    /// fields of its section; nothing if it costs less.
    std::string
    nothing_won(const std::vector<std::vector<unsigned int>> &lists,
                const Beam                                   &beam,
                const FieldRules                             &rules)
    {
      const unsigned int all = beam.section().n_fields();
      std::size_t        sum = 0;
      for (const auto &list : lists)
        sum += list.size();
      const unsigned int mean = sum / lists.size();
      if (mean > rules.most_fields * all)
        return "a node would carry " + std::to_string(mean) + " of " +
               std::to_string(all) + " fields";
      return "";
    }



    /// Replaces the body @p description, whose pieces are all LE, by one with
    /// the leading fields of each degree.
    void
    replace_by_degrees(const BodyDescription &description,
                       std::unique_ptr<Body> &body)
    {
      const auto &beam  = dynamic_cast<const Beam &>(*body);
      const auto  lists = lists_by_degree(beam, description.pieces);
      body              = std::make_unique<Beam>(beam.name(),
                                    std::make_shared<FieldSpace>(
                                      beam.fields().shared_section()),
                                    beam.shared_axis(),
                                    beam.place(),
                                    lists,
                                    label_of(description, lists));
    }



    /// Whether supports hold, as a whole, more sections of @p body than clamps
    /// do: in plane strain all of them are, and nothing is far from a clamp.
    bool
    is_held_all_along(const TouchedBody &body, const Axis &axis)
    {
      constexpr double most_clamps = 0.25;
      const auto       held =
        std::count_if(body.touches.begin(),
                      body.touches.end(),
                      [](const Touch &touch) { return touch.holds_section; });
      return held > most_clamps * axis.n_nodes();
    }



    /// Whether @p beam was not to be solved with fewer fields than all.
    bool
    is_unsolved(const Beam &beam, const FieldRules &rules)
    {
      return std::find(rules.unsolved.begin(),
                       rules.unsolved.end(),
                       beam.name()) != rules.unsolved.end();
    }



    /// Whether @p body has responses and end fields at all: one that is going
    /// to keep all fields of its section wants none.
    bool
    wants_responses(const BodyDescription &description,
                    const Beam            &beam,
                    const TouchedBody     &body,
                    const FieldRules      &rules)
    {
      return description.theory.order > 0 &&
             ((beam.axis().n_nodes() > rules.least_nodes &&
               !is_unsolved(beam, rules) &&
               !is_held_all_along(body, beam.axis())) ||
              !description.pieces.empty());
    }



    /// What holds @p beam at the touch number @p t of @p body.
    std::vector<HeldSection>
    looked_at_sections(const Beam          &beam,
                       const TouchedBody   &body,
                       const unsigned int   t,
                       const EndFieldRules &rules)
    {
      const double near = rules.looked_at * beam.section().extents().second,
                   y    = body.touches[t].begin;
      auto held         = held_sections(body.touches, t, beam.axis());
      for (HeldSection &one : held)
        {
          one.body = beam.name();
          one.is_looked_at =
            std::any_of(body.asked.begin(),
                        body.asked.end(),
                        [&](const auto &at) {
                          return at.second > y - near && at.first < y + near;
                        });
        }
      return held;
    }



    /// Those of each of the touches of @p body, which is @p beam; without end
    /// fields, which cost a solution, unless @p wants_responses.
    std::vector<std::vector<unsigned int>>
    groups_of(const Beam        &beam,
              const TouchedBody &body,
              FieldsOfSection   &fields,
              const FieldRules  &rules,
              const bool         wants_responses)
    {
      std::vector<std::vector<unsigned int>> groups;
      for (unsigned int t = 0; t < body.touches.size(); ++t)
        if (const Touch &touch = body.touches[t];
            (touch.holds_section || touch.is_free) && wants_responses)
          groups.push_back(fields.groups_of(
            touch, looked_at_sections(beam, body, t, rules.ends->limits())));
        else if (touch.is_free)
          groups.emplace_back();
        else
          groups.push_back({fields.group_of(touch)});
      return groups;
    }



    /// The fields of each node of @p beam into @p lists; or why it had better
    /// keep all fields of its section, and no lists.
    std::string
    choose_lists(const Beam                             &beam,
                 const TouchedBody                      &body,
                 const BodyDescription                  &description,
                 FieldsOfSection                        &fields,
                 const FieldRules                       &rules,
                 std::vector<std::vector<unsigned int>> &lists)
    {
      auto near = near_groups(beam, body, fields);
      even_out(near, beam.axis(), body.asked);
      // Theories are taken at their word, and SV has nothing to choose.
      const bool may_keep_all =
        description.pieces.empty() && description.theory.order > 0;
      std::string why;
      if (may_keep_all && is_unsolved(beam, rules))
        why = "the scene could not be solved in double precision";
      else if (may_keep_all && is_held_all_along(body, beam.axis()))
        why = "supports hold its sections all along";
      else if (may_keep_all)
        why = nothing_to_win(near, beam, fields, rules);
      if (why.empty())
        lists = lists_of(beam, near, description, fields);
      if (may_keep_all && why.empty())
        why = nothing_won(lists, beam, rules);
      if (!why.empty())
        lists.clear();
      return why;
    }



    /// The heat of @p beam at as many nodes of its axis as span that at the
    /// others.
    std::vector<Beam::SectionHeat>
    spanning_heat(const Beam &beam)
    {
      constexpr double nothing = 1e-3;
      if (!beam.is_heated())
        return {};
      std::vector<Beam::SectionHeat> heat, result;
      for (const double y : beam.axis().nodes())
        heat.push_back(beam.section_heat(y));
      const unsigned int       n = beam.section().n_fields();
      LAPACKFullMatrix<double> rows(heat.size(), n);
      for (unsigned int k = 0; k < heat.size(); ++k)
        for (unsigned int a = 0; a < n; ++a)
          rows(k, a) = heat[k].on_values[a];
      for (const unsigned int k : most_independent(rows, nothing))
        result.push_back(heat[k]);
      return result;
    }



    /// Notes what touches @p body, which is @p beam, of SV, and has no fields.
    void
    note_missing_fields(const Beam               &beam,
                        const TouchedBody        &body,
                        std::vector<std::string> &notes)
    {
      for (const Touch &touch : body.touches)
        if (touch.presses)
          notes.push_back("body " + beam.name() + ": SV has no fields that " +
                          touch.name +
                          " can dent: forces are those of a beam, pressures "
                          "and stresses there are not to be used. Use SV-N, "
                          "SV-6 say");
        else if (touch.heats)
          notes.push_back("body " + beam.name() +
                          ": SV has no fields for heat that varies along the "
                          "axis: stresses are not to be used where it does. "
                          "Use SV-N, SV-6 say");
    }



    /// Notes what holds sections of @p body, which is @p beam and heated, in
    /// part: end fields do not know what heat does there.
    void
    note_heat_of_guides(const Beam               &beam,
                        const TouchedBody        &body,
                        std::vector<std::string> &notes)
    {
      if (!beam.is_heated())
        return;
      for (unsigned int t = 0; t < body.touches.size(); ++t)
        if (body.touches[t].holds_section)
          {
            const auto held = held_sections(body.touches, t, beam.axis());
            if (held[0].rows.size() < beam.section().n_fields() &&
                held[0].by[0] == body.touches[t].name)
              notes.push_back(
                "body " + beam.name() + " is heated, and " +
                body.touches[t].name +
                " holds its section in part: SV-N has no fields for what heat "
                "does there, and stresses within a height or two of it are not "
                "to be used. Use LE-N, or Theories with LE-N there");
          }
    }



    /// Replaces the bodies @p touched of one section and theory.
    void
    replace(Bodies                             &bodies,
            const std::vector<BodyDescription> &descriptions,
            const Tensor<1, 3>                 &gravity,
            std::vector<TouchedBody>           &touched,
            const FieldRules                   &rules,
            std::vector<std::string>           &notes)
    {
      const auto beam_of = [&](const unsigned int body) -> const Beam & {
        return dynamic_cast<const Beam &>(*bodies[body]);
      };
      const Theory &theory = descriptions[touched[0].number].theory;
      const auto section = beam_of(touched[0].number).fields().shared_section();
      std::vector<Beam::SectionHeat> heat;
      std::vector<Vector>            weights;
      for (const TouchedBody &body : touched)
        {
          const Beam &beam = beam_of(body.number);
          for (const Beam::SectionHeat &one : spanning_heat(beam))
            heat.push_back(one);
          if (gravity.norm() > 0.)
            weights.push_back(beam.section_weight(gravity));
        }
      FieldsOfSection fields(section, theory, rules, heat, weights);
      for (TouchedBody &body : touched)
        {
          const Beam &beam = beam_of(body.number);
          body.groups      = groups_of(
            beam,
            body,
            fields,
            rules,
            wants_responses(descriptions[body.number], beam, body, rules));
        }

      std::vector<std::vector<std::vector<unsigned int>>> lists;
      for (const TouchedBody &body : touched)
        {
          const Beam            &beam        = beam_of(body.number);
          const BodyDescription &description = descriptions[body.number];
          lists.emplace_back();
          const std::string why =
            choose_lists(beam, body, description, fields, rules, lists.back());
          if (!why.empty())
            notes.push_back("body " + beam.name() + ": with " + theory.name() +
                            " " + why +
                            (is_unsolved(beam, rules) ?
                               "; its nodes" :
                               "; nothing is won there, and its nodes") +
                            " carry all fields of the section (" +
                            section->theory().name() + ")");
          if (theory.order == 0 && description.pieces.empty())
            note_missing_fields(beam, body, notes);
          else if (!lists.back().empty())
            note_heat_of_guides(beam, body, notes);
        }
      const auto space = fields.space();
      for (unsigned int k = 0; k < touched.size(); ++k)
        if (!lists[k].empty())
          {
            const Beam &beam = beam_of(touched[k].number);
            bodies[touched[k].number] =
              std::make_unique<Beam>(beam.name(),
                                     space,
                                     beam.shared_axis(),
                                     beam.place(),
                                     lists[k],
                                     label_of(descriptions[touched[k].number],
                                              lists[k]));
          }
    }
  } // namespace

  bool
  has_fields_to_choose(const std::vector<BodyDescription> &descriptions)
  {
    return std::any_of(descriptions.begin(), descriptions.end(), is_chosen);
  }

  std::vector<StressPlace>
  stress_places(const Bodies             &bodies,
                const std::vector<Probe> &probes,
                const std::vector<Line>  &lines,
                const std::vector<Cut>   &cuts)
  {
    std::vector<StressPlace> places;
    const auto               add = [&](const unsigned int           body,
                         const std::vector<Point<3>> &corners) {
      const auto *beam = dynamic_cast<const Beam *>(bodies[body].get());
      if (beam == nullptr)
        return;
      std::vector<double> along;
      for (const Point<3> &corner : corners)
        along.push_back(beam->place().to_body(corner)[1]);
      const auto [least, greatest] =
        std::minmax_element(along.begin(), along.end());
      places.push_back({body, *least, *greatest});
    };
    for (const Probe &probe : probes)
      add(probe.body, box_corners(probe.position, probe.box));
    for (const Line &line : lines)
      add(line.body, {line.from, line.to});
    for (const Cut &cut : cuts)
      places.push_back({cut.body, cut.position, cut.position});
    return places;
  }



  std::vector<std::string>
  choose_fields(Bodies                              &bodies,
                const std::vector<BodyDescription>  &descriptions,
                const std::vector<Support>          &supports,
                const std::vector<Load>             &loads,
                const std::vector<ContactInterface> &contacts,
                const std::vector<StressPlace>      &asked,
                const FieldRules                    &rules,
                const Tensor<1, 3>                  &gravity)
  {
    const auto asked_of = [&asked](const unsigned int body) {
      std::vector<std::pair<double, double>> places;
      for (const StressPlace &place : asked)
        if (place.body == body)
          places.emplace_back(place.begin, place.end);
      return places;
    };
    std::map<std::pair<std::string, Theory>, std::vector<TouchedBody>> touched;
    for (unsigned int b = 0; b < descriptions.size(); ++b)
      if (is_chosen(descriptions[b]) &&
          descriptions[b].theory.kind == Theory::Kind::SV)
        {
          const auto &beam = dynamic_cast<const Beam &>(*bodies[b]);
          auto all = find_touches(beam, b, bodies, supports, loads, contacts);
          for (const Touch &end : heated_free_ends(beam, all))
            all.push_back(end);
          touched[{descriptions[b].section, descriptions[b].theory}].push_back(
            {b, std::move(all), asked_of(b), {}});
        }
    std::vector<std::string> notes;
    for (unsigned int b = 0; b < descriptions.size(); ++b)
      if (descriptions[b].theory.hierarchical)
        note_coarse_rows(dynamic_cast<const Beam &>(*bodies[b]),
                         b,
                         descriptions[b].pieces,
                         contacts,
                         notes);
    for (auto &[key, of_section] : touched)
      replace(bodies, descriptions, gravity, of_section, rules, notes);
    // Not before all touches are found, which the fields of whole sections say.
    for (unsigned int b = 0; b < descriptions.size(); ++b)
      if (is_chosen(descriptions[b]) &&
          descriptions[b].theory.kind == Theory::Kind::LE)
        replace_by_degrees(descriptions[b], bodies[b]);
    return notes;
  }
} // namespace lamella
