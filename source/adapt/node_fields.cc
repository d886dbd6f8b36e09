// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/adapt/node_fields.h>
#include <lamella/base/text.h>
#include <lamella/section/saint_venant.h>
#include <lamella/section/section_response.h>

#include <algorithm>
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



    /// What touches a body, with the group of load vectors that each belongs
    /// to, and where its stresses are asked for.
    struct TouchedBody
    {
      unsigned int                           number;
      std::vector<Touch>                     touches;
      std::vector<std::pair<double, double>> asked;
      std::vector<unsigned int>              groups;
    };



    /// @p n numbers from @p first to @p last in equal ratios.
    std::vector<double>
    in_equal_ratios(const double first, const double last, const unsigned int n)
    {
      std::vector<double> numbers;
      for (unsigned int k = 0; k < n; ++k)
        numbers.push_back(
          n == 1 ? std::sqrt(first * last) :
                   first * std::pow(last / first, double(k) / (n - 1)));
      return numbers;
    }



    /**
     * The fields of one section, for all bodies that have it and the same
     * theory. Load vectors come in groups, one for each thing that touches, the
     * same for two that touch alike (the two supports of a beam in bending).
     */
    class FieldsOfSection
    {
    public:
      FieldsOfSection(std::shared_ptr<const Section> section,
                      const Theory                  &theory,
                      const FieldRules              &rules);

      /// The group of @p touch.
      unsigned int
      group_of(const Touch &touch);

      /// Whether there are wave numbers to answer at.
      bool
      responds() const
      {
        return theory.order > 0 && !groups.empty();
      }

      /// How many load vectors of the group @p group a support holds; none of
      /// one that holds the section as a whole.
      std::size_t
      n_held(const unsigned int group) const
      {
        return groups[group].is_held ? groups[group].loads.size() : 0;
      }

      /// The list of a node near the groups @p near.
      const std::vector<unsigned int> &
      list(const std::set<unsigned int> &near);

      /// That of a node of SV: the rigid fields and the warpings.
      std::vector<unsigned int>
      saint_venant_list() const;

      /// The modes of @p list.
      FieldColumns
      columns_of(const std::vector<unsigned int> &list) const;

      /// When no more lists are asked for.
      std::shared_ptr<const FieldSpace>
      space() const
      {
        return std::make_shared<FieldSpace>(section, modes);
      }

    private:
      struct Group
      {
        std::vector<Vector> loads, smooth;
        double              element = 0.;
        bool                is_held = false;
        /// To the loads, and to the smooth ones.
        std::vector<Vector> near, far;
      };

      double
      lowest_wave() const;
      /// FieldRules::near_tolerance for N of the theory.
      double
      near_tolerance() const
      {
        return rules.near_tolerance *
               std::min(1., 36. / double(theory.order * theory.order));
      }
      /// The responses of all groups, at one set of wave numbers: one
      /// factorisation each.
      void
      find_responses();

      std::shared_ptr<const Section> section;
      Theory                         theory;
      FieldRules                     rules;
      SaintVenant                    states;
      Warping                        warping;
      FieldColumns                   warpings;
      FieldColumns                   modes;
      std::vector<Group>             groups;
      bool                           responses_are_known = false;
      std::map<std::set<unsigned int>, std::vector<unsigned int>> lists;
    };

    FieldsOfSection::FieldsOfSection(std::shared_ptr<const Section> section_,
                                     const Theory                  &theory,
                                     const FieldRules              &rules)
      : section(std::move(section_))
      , theory(theory)
      , rules(rules)
      , states(*section)
      , warping(*section)
      , warpings(saint_venant_warpings(states, warping))
      , modes(warpings)
    {}

    unsigned int
    FieldsOfSection::group_of(const Touch &touch)
    {
      Group group{touch.loads,
                  touch.smooth,
                  touch.element,
                  touch.holds && !touch.holds_section,
                  {},
                  {}};
      if (touch.holds_section)
        {
          // It answers to no load vector: it holds the warping w, with the
          // tractions that w has as a value and as a derivative.
          group.loads.clear();
          for (unsigned int j = 0; j < warpings.n(); ++j)
            for (const unsigned int q : {0, 1})
              {
                Vector traction(section->n_fields());
                section->S(1, q).vmult(traction, column_of(warpings, j));
                group.loads.push_back(traction);
              }
          group.smooth.clear();
        }
      constexpr double alike = 1e-6;
      for (unsigned int g = 0; g < groups.size(); ++g)
        {
          bool same =
            groups[g].loads.size() == group.loads.size() &&
            std::abs(groups[g].element - group.element) < alike * group.element;
          for (unsigned int k = 0; same && k < group.loads.size(); ++k)
            {
              Vector difference = group.loads[k];
              difference -= groups[g].loads[k];
              same = difference.l2_norm() < alike * group.loads[k].l2_norm();
            }
          if (same)
            {
              groups[g].is_held = groups[g].is_held || group.is_held;
              return g;
            }
        }
      groups.push_back(group);
      return groups.size() - 1;
    }



    double
    FieldsOfSection::lowest_wave() const
    {
      const BoundingBox<2> box = section->element().bounding_box();
      // Thin walls fill little of the box around them.
      constexpr double walls = 0.5;
      const bool       thin =
        section->area() < walls * box.side_length(0) * box.side_length(1);
      return (thin ? rules.lowest_wave_of_walls : rules.lowest_wave) /
             std::max(box.side_length(0), box.side_length(1));
    }



    void
    FieldsOfSection::find_responses()
    {
      if (std::exchange(responses_are_known, true))
        return;
      double shortest = groups[0].element;
      for (const Group &group : groups)
        shortest = std::min(shortest, group.element);
      const double          lowest = lowest_wave();
      const SectionResponse response(*section);
      double                last = 0.;
      for (const double k :
           in_equal_ratios(lowest,
                           std::max(rules.highest_wave / shortest, 2. * lowest),
                           theory.order))
        {
          // Up to the first one above what each of them can show.
          const double                       before = std::exchange(last, k);
          std::vector<Vector>                loads;
          std::vector<std::vector<Vector> *> wanted_by;
          const auto want = [&](const std::vector<Vector> &some,
                                std::vector<Vector>       &fields,
                                const double               highest) {
            if (before < highest)
              for (const Vector &load : some)
                {
                  loads.push_back(load);
                  wanted_by.push_back(&fields);
                }
          };
          for (Group &group : groups)
            {
              want(group.loads, group.near, rules.highest_wave / group.element);
              want(group.smooth,
                   group.far,
                   rules.highest_wave_afar / warping.height());
            }
          const auto fields = response.at(k, loads);
          for (unsigned int i = 0; i < loads.size(); ++i)
            wanted_by[i]->insert(wanted_by[i]->end(),
                                 fields[i].begin(),
                                 fields[i].end());
        }
      for (Group &group : groups)
        for (const Vector &load : group.smooth)
          group.far.push_back(states.response_to_constant(load));
    }



    const std::vector<unsigned int> &
    FieldsOfSection::list(const std::set<unsigned int> &near)
    {
      if (const auto known = lists.find(near); known != lists.end())
        return known->second;
      const bool                nothing_near = near.empty();
      FieldColumns              fresh(section->n_fields(), 0);
      std::vector<unsigned int> list;
      if (nothing_near)
        {
          list = saint_venant_list();
          if (responds())
            {
              find_responses();
              std::vector<Vector> smooth;
              for (const Group &group : groups)
                smooth.insert(smooth.end(), group.far.begin(), group.far.end());
              fresh =
                warping.basis(smooth, warpings, warpings, rules.far_tolerance);
            }
        }
      else
        {
          // What the others there have, and what the smallest group adds to
          // it: lists that differ little share most of their modes.
          const unsigned int last = *std::min_element(
            near.begin(),
            near.end(),
            [this](const unsigned int a, const unsigned int b) {
              return groups[a].loads.size() < groups[b].loads.size();
            });
          std::set<unsigned int> others = near;
          others.erase(last);
          list = this->list(others);
          if (responds())
            fresh = warping.basis(groups[last].near,
                                  warpings,
                                  columns_of(list),
                                  near_tolerance());
        }
      for (unsigned int j = 0; j < fresh.n(); ++j)
        list.push_back(section->n_fields() + modes.n() + j);
      modes              = beside(modes, fresh);
      return lists[near] = list;
    }



    std::vector<unsigned int>
    FieldsOfSection::saint_venant_list() const
    {
      std::vector<unsigned int> list(6 + warpings.n());
      std::iota(list.begin(), list.begin() + 6, 0);
      std::iota(list.begin() + 6, list.end(), section->n_fields());
      return list;
    }



    FieldColumns
    FieldsOfSection::columns_of(const std::vector<unsigned int> &list) const
    {
      std::vector<unsigned int> numbers;
      for (unsigned int j = 6; j < list.size(); ++j)
        numbers.push_back(list[j] - section->n_fields());
      return these_of(modes, numbers);
    }



    /// Of the pieces by hand that hold @p y the theories.
    std::vector<Theory>
    theories_at(const double y, const TheoryPieces &pieces, const double length)
    {
      const double        tolerance = 1e-9 * length;
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



    /// The groups of load vectors that each node of @p beam is near.
    std::vector<std::set<unsigned int>>
    near_groups(const Beam        &beam,
                const TouchedBody &touched,
                const FieldRules  &rules)
    {
      const BoundingBox<2> box = beam.section().element().bounding_box();
      const double         a = box.side_length(0), b = box.side_length(1);
      const auto           reach = [&](const Touch &touch) {
        return touch.holds_section ? rules.reach_of_clamp * std::max(a, b) :
                                               rules.reach * std::min(a, b);
      };
      std::vector<std::set<unsigned int>> result;
      for (const double y : beam.axis().nodes())
        {
          result.emplace_back();
          for (unsigned int t = 0; t < touched.touches.size(); ++t)
            if (const Touch &touch = touched.touches[t];
                y > touch.begin - reach(touch) && y < touch.end + reach(touch))
              result.back().insert(touched.groups[t]);
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
      const double tolerance                           = 1e-9 * axis.length();
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



    /// Replaces the bodies @p touched of one section and theory.
    void
    replace(Bodies                             &bodies,
            const std::vector<BodyDescription> &descriptions,
            std::vector<TouchedBody>           &touched,
            const FieldRules                   &rules,
            std::vector<std::string>           &notes)
    {
      const auto beam_of = [&](const unsigned int body) -> const Beam & {
        return dynamic_cast<const Beam &>(*bodies[body]);
      };
      const Theory &theory = descriptions[touched[0].number].theory;
      const auto section = beam_of(touched[0].number).fields().shared_section();
      FieldsOfSection fields(section, theory, rules);
      for (TouchedBody &body : touched)
        for (const Touch &touch : body.touches)
          body.groups.push_back(fields.group_of(touch));

      std::vector<std::vector<std::vector<unsigned int>>> lists;
      for (const TouchedBody &body : touched)
        {
          const Beam            &beam        = beam_of(body.number);
          const BodyDescription &description = descriptions[body.number];
          auto                   near        = near_groups(beam, body, rules);
          even_out(near, beam.axis(), body.asked);
          // Theories are taken at their word, and SV has nothing to choose.
          const bool may_keep_all =
            description.pieces.empty() && theory.order > 0;
          std::string why;
          if (may_keep_all)
            why = nothing_to_win(near, beam, fields, rules);
          lists.emplace_back();
          if (why.empty())
            lists.back() = lists_of(beam, near, description, fields);
          if (may_keep_all && why.empty())
            why = nothing_won(lists.back(), beam, rules);
          if (!why.empty())
            {
              notes.push_back("body " + beam.name() + ": with " +
                              theory.name() + " " + why +
                              "; nothing is won there, and its nodes carry "
                              "all fields of the section (" +
                              section->theory().name() + ")");
              lists.back().clear();
            }
          for (const Touch &touch : body.touches)
            if (touch.presses && theory.order == 0 &&
                description.pieces.empty())
              notes.push_back("body " + beam.name() +
                              ": SV has no fields that " + touch.name +
                              " can dent: forces are those of a beam, "
                              "pressures and stresses there are not to be "
                              "used. Use SV-N, SV-6 say");
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
    const auto               add =
      [&](const unsigned int body, const Point<3> &from, const Point<3> &to) {
        if (const auto *beam = dynamic_cast<const Beam *>(bodies[body].get()))
          {
            const double a = beam->place().to_body(from)[1],
                         b = beam->place().to_body(to)[1];
            places.push_back({body, std::min(a, b), std::max(a, b)});
          }
      };
    for (const Probe &probe : probes)
      add(probe.body, probe.position, probe.position);
    for (const Line &line : lines)
      add(line.body, line.from, line.to);
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
                const FieldRules                    &rules)
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
        touched[{descriptions[b].section, descriptions[b].theory}].push_back(
          {b,
           find_touches(dynamic_cast<const Beam &>(*bodies[b]),
                        b,
                        bodies,
                        supports,
                        loads,
                        contacts),
           asked_of(b),
           {}});
    std::vector<std::string> notes;
    for (unsigned int b = 0; b < descriptions.size(); ++b)
      if (descriptions[b].theory.hierarchical)
        note_coarse_rows(dynamic_cast<const Beam &>(*bodies[b]),
                         b,
                         descriptions[b].pieces,
                         contacts,
                         notes);
    for (auto &[key, of_section] : touched)
      replace(bodies, descriptions, of_section, rules, notes);
    // Not before all touches are found, which the fields of whole sections say.
    for (unsigned int b = 0; b < descriptions.size(); ++b)
      if (is_chosen(descriptions[b]) &&
          descriptions[b].theory.kind == Theory::Kind::LE)
        replace_by_degrees(descriptions[b], bodies[b]);
    return notes;
  }
} // namespace lamella
