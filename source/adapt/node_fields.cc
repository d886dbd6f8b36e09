// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/adapt/node_fields.h>
#include <lamella/base/text.h>
#include <lamella/section/saint_venant.h>
#include <lamella/section/section_response.h>

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



    /// What touches a body, with the groups that each belongs to.
    struct TouchedBody
    {
      unsigned int                           number;
      std::vector<Touch>                     touches;
      std::vector<std::vector<unsigned int>> groups;
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
     * The zones of end fields are groups that bring their fields.
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

      /// Those of what holds a section as a whole as @p held say: the zones of
      /// its end fields; the tractions of its touch @p touch where there are
      /// none, or where the rules want these.
      std::vector<unsigned int>
      groups_of(const Touch &touch, const std::vector<HeldSection> &held);

      /// How far along the axis the nodes carry the fields of group @p g.
      double
      reach_of(const unsigned int g) const;

      /// Whether there are wave numbers to answer at.
      bool
      responds() const
      {
        return theory.order > 0 && !groups.empty();
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
        /// To the loads, and to the smooth ones.
        std::vector<Vector> near, far;
        /// Of a zone of end fields, whose fields are `near`; else 0.
        double reach = 0.;
        /// Whether it holds a section as a whole.
        bool holds = false;
        /// The first of those near a node is the last to be added: inner zones
        /// after outer ones, and these after what has load vectors.
        std::pair<double, std::size_t>
        order() const
        {
          return {reach > 0. ? reach : std::numeric_limits<double>::max(),
                  loads.size()};
        }
      };

      /// What is held, with the zones of its end fields and their groups.
      struct End
      {
        HeldSection               held;
        std::vector<EndZone>      zones;
        std::vector<unsigned int> groups;
      };

      /// The groups of the end fields of @p held, made once; from those of the
      /// other end where that is its mirror image.
      const std::vector<unsigned int> &
      zones_of(const HeldSection &held);

      bool
      has_thin_walls() const;
      /// Up to @p highest.
      std::vector<double>
      wave_numbers(const double highest) const;
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
      std::vector<End>                                            ends;
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
                  {},
                  {},
                  0.,
                  touch.holds_section};
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
            groups[g].reach == 0. &&
            std::abs(groups[g].element - group.element) < alike * group.element;
          for (unsigned int k = 0; same && k < group.loads.size(); ++k)
            {
              Vector difference = group.loads[k];
              difference -= groups[g].loads[k];
              same = difference.l2_norm() < alike * group.loads[k].l2_norm();
            }
          if (same)
            return g;
        }
      groups.push_back(group);
      return groups.size() - 1;
    }



    const std::vector<unsigned int> &
    FieldsOfSection::zones_of(const HeldSection &held)
    {
      End         end{held, {}, {}};
      HeldSection opposite  = held;
      opposite.goes_forward = !held.goes_forward;
      for (const End &known : ends)
        {
          if (alike(known.held, held))
            return known.groups;
          if (alike(known.held, opposite))
            end.zones = mirrored(known.zones, *section, held);
        }
      if (end.zones.empty())
        end.zones = end_fields(
          section, states, warping, warpings, held, rules.end_fields);
      for (const EndZone &zone : end.zones)
        {
          Group group;
          group.element = held.element;
          group.reach   = zone.reach;
          group.holds   = true;
          for (unsigned int j = 0; j < zone.fields.n(); ++j)
            group.near.push_back(column_of(zone.fields, j));
          end.groups.push_back(groups.size());
          groups.push_back(group);
        }
      ends.push_back(std::move(end));
      return ends.back().groups;
    }



    std::vector<unsigned int>
    FieldsOfSection::groups_of(const Touch                    &touch,
                               const std::vector<HeldSection> &held)
    {
      std::vector<unsigned int> result;
      if (rules.clamps != FieldRules::Clamps::tractions)
        for (const HeldSection &one : held)
          {
            const auto &zones = zones_of(one);
            result.insert(result.end(), zones.begin(), zones.end());
          }
      if (result.empty() || rules.clamps == FieldRules::Clamps::both)
        result.push_back(group_of(touch));
      return result;
    }



    double
    FieldsOfSection::reach_of(const unsigned int g) const
    {
      const BoundingBox<2> box = section->element().bounding_box();
      const double         a = box.side_length(0), b = box.side_length(1);
      return groups[g].reach > 0. ? groups[g].reach :
             groups[g].holds      ? rules.reach_of_clamp * std::max(a, b) :
                                    rules.reach * std::min(a, b);
    }



    bool
    FieldsOfSection::has_thin_walls() const
    {
      // They fill little of the box around them.
      constexpr double     walls = 0.5;
      const BoundingBox<2> box   = section->element().bounding_box();
      return section->area() < walls * box.side_length(0) * box.side_length(1);
    }



    std::vector<double>
    FieldsOfSection::wave_numbers(const double highest) const
    {
      const BoundingBox<2> box = section->element().bounding_box();
      const double larger = std::max(box.side_length(0), box.side_length(1)),
                   lowest = rules.lowest_wave / larger,
                   last   = std::max(highest, 2. * lowest);
      if (!has_thin_walls())
        return in_equal_ratios(lowest, last, theory.order);
      // Down to what walls need in no larger steps.
      const double first = rules.lowest_wave_of_walls / larger;
      const double steps =
        (theory.order - 1) * std::log(last / first) / std::log(last / lowest);
      return in_equal_ratios(first, last, 1 + std::ceil(steps));
    }



    void
    FieldsOfSection::find_responses()
    {
      if (std::exchange(responses_are_known, true))
        return;
      double shortest = groups[0].element;
      bool   any      = false;
      for (const Group &group : groups)
        {
          shortest = std::min(shortest, group.element);
          any      = any || !group.loads.empty() || !group.smooth.empty();
        }
      if (!any)
        return;
      const SectionResponse response(*section);
      double                last = 0.;
      for (const double k : wave_numbers(rules.highest_wave / shortest))
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
          const unsigned int last =
            *std::min_element(near.begin(),
                              near.end(),
                              [this](const unsigned int a,
                                     const unsigned int b) {
                                return groups[a].order() < groups[b].order();
                              });
          std::set<unsigned int> others = near;
          others.erase(last);
          list = this->list(others);
          if (responds())
            {
              find_responses();
              fresh = warping.basis(groups[last].near,
                                    warpings,
                                    columns_of(list),
                                    near_tolerance());
            }
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



    /// The fields that each node of @p beam carries.
    std::vector<std::vector<unsigned int>>
    lists_of(const Beam            &beam,
             const TouchedBody     &touched,
             const BodyDescription &description,
             FieldsOfSection       &fields)
    {
      std::vector<unsigned int> all(beam.section().n_fields());
      std::iota(all.begin(), all.end(), 0);
      std::vector<std::vector<unsigned int>> lists;
      for (const double y : beam.axis().nodes())
        {
          std::set<unsigned int> near;
          for (unsigned int t = 0; t < touched.touches.size(); ++t)
            for (const unsigned int group : touched.groups[t])
              if (const double reach = fields.reach_of(group);
                  y > touched.touches[t].begin - reach &&
                  y < touched.touches[t].end + reach)
                near.insert(group);
          // Between two pieces a node carries what the richer one wants.
          bool whole = false, plain = !description.pieces.empty();
          for (const Theory &theory :
               theories_at(y, description.pieces, beam.axis().length()))
            {
              whole = whole || theory.kind == Theory::Kind::LE;
              plain = plain && theory.order == 0;
            }
          lists.push_back(whole ? all :
                          plain ? fields.saint_venant_list() :
                                  fields.list(near));
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
      if (lists.size() <= rules.least_nodes)
        return "its axis has " + std::to_string(lists.size()) + " nodes only";
      if (mean > rules.most_fields * all)
        return "a node would carry " + std::to_string(mean) + " of " +
               std::to_string(all) + " fields";
      return "";
    }



    /// Those of each of the touches of @p body, whose axis is @p axis; without
    /// end fields, which cost a solution, unless @p wants_responses.
    std::vector<std::vector<unsigned int>>
    groups_of(const Axis        &axis,
              const TouchedBody &body,
              FieldsOfSection   &fields,
              const bool         wants_responses)
    {
      std::vector<std::vector<unsigned int>> groups;
      for (unsigned int t = 0; t < body.touches.size(); ++t)
        if (const Touch &touch = body.touches[t];
            touch.holds_section && wants_responses)
          groups.push_back(
            fields.groups_of(touch, held_sections(body.touches, t, axis)));
        else
          groups.push_back({fields.group_of(touch)});
      return groups;
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
        {
          // A body that is going to keep all fields wants none.
          const Axis &axis = beam_of(body.number).axis();
          body.groups =
            groups_of(axis,
                      body,
                      fields,
                      theory.order > 0 &&
                        (axis.n_nodes() > rules.least_nodes ||
                         !descriptions[body.number].pieces.empty()));
        }

      std::vector<std::vector<std::vector<unsigned int>>> lists;
      for (const TouchedBody &body : touched)
        {
          const Beam            &beam        = beam_of(body.number);
          const BodyDescription &description = descriptions[body.number];
          lists.push_back(lists_of(beam, body, description, fields));
          for (const Touch &touch : body.touches)
            if (touch.presses && theory.order == 0 &&
                description.pieces.empty())
              notes.push_back("body " + beam.name() +
                              ": SV has no fields that " + touch.name +
                              " can dent: forces are those of a beam, "
                              "pressures and stresses there are not to be "
                              "used. Use SV-N, SV-6 say");
          if (description.pieces.empty() && theory.order > 0)
            if (const std::string why = nothing_won(lists.back(), beam, rules);
                !why.empty())
              {
                notes.push_back("body " + beam.name() + ": with " +
                                theory.name() + " " + why +
                                "; nothing is won there, and its nodes carry "
                                "all fields of the section (" +
                                section->theory().name() + ")");
                lists.back().clear();
              }
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

  std::vector<std::string>
  choose_fields(Bodies                              &bodies,
                const std::vector<BodyDescription>  &descriptions,
                const std::vector<Support>          &supports,
                const std::vector<Load>             &loads,
                const std::vector<ContactInterface> &contacts,
                const FieldRules                    &rules)
  {
    std::map<std::pair<std::string, Theory>, std::vector<TouchedBody>> touched;
    for (unsigned int b = 0; b < descriptions.size(); ++b)
      if (is_chosen(descriptions[b]))
        touched[{descriptions[b].section, descriptions[b].theory}].push_back(
          {b,
           find_touches(dynamic_cast<const Beam &>(*bodies[b]),
                        b,
                        bodies,
                        supports,
                        loads,
                        contacts),
           {}});
    std::vector<std::string> notes;
    for (auto &[key, of_section] : touched)
      replace(bodies, descriptions, of_section, rules, notes);
    return notes;
  }
} // namespace lamella
