// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/adapt/section_fields.h>
#include <lamella/base/arithmetic.h>
#include <lamella/recover/sampler.h>
#include <lamella/section/section_response.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// @p n numbers from @p first to @p last in equal ratios.
    std::vector<double>
    geometric_sequence(const double       first,
                       const double       last,
                       const unsigned int n)
    {
      std::vector<double> numbers;
      for (unsigned int k = 0; k < n; ++k)
        numbers.push_back(
          n == 1 ? std::sqrt(first * last) :
                   first * std::pow(last / first, double(k) / (n - 1)));
      return numbers;
    }



    /// Loads whose responses are needed, and the fields that each adds.
    struct ResponseTakers
    {
      std::vector<Vector>                loads;
      std::vector<std::vector<Vector> *> fields_of;

      /// Refers to @p fields.
      void
      add(const std::vector<Vector> &some, std::vector<Vector> &fields)
      {
        for (const Vector &load : some)
          {
            loads.push_back(load);
            fields_of.push_back(&fields);
          }
      }

      /// The @p answers to the loads, some fields each.
      void
      take(const std::vector<std::vector<Vector>> &answers) const
      {
        for (unsigned int i = 0; i < loads.size(); ++i)
          fields_of[i]->insert(fields_of[i]->end(),
                               answers[i].begin(),
                               answers[i].end());
      }
    };
  } // namespace



  SectionFields::SectionFields(std::shared_ptr<const Section> section_,
                               const Theory                  &theory,
                               const FieldRules              &rules,
                               const LoadsAlongAxis          &all)
    : section(std::move(section_))
    , theory(theory)
    , rules(rules)
    , states(*section)
    , warping(*section)
    , warpings(saint_venant_warpings(states, warping))
    , modes(warpings)
  {
    if (!all.inertia.empty())
      {
        Group group;
        group.smooth = all.inertia;
        // Waves as short as those of other smooth loads.
        group.element =
          rules.highest_wave / rules.highest_wave_far * warping.height();
        groups.push_back(group);
      }
    std::vector<Vector> answers;
    for (const Beam::SectionThermalLoad &one : all.heat)
      {
        heated.emplace_back(states, one);
        answers.push_back(heated.back().answer);
      }
    for (const Vector &load : all.weights)
      if (load.l2_norm() > 0.)
        answers.push_back(states.response_to_constant(load));
    if (answers.empty())
      return;
    warpings = beside(
      warpings,
      warping.basis(answers, warpings, warpings, arithmetic::same_value));
    modes = warpings;
  }



  bool
  SectionFields::Group::has_same_loads(const Group &other) const
  {
    bool same = loads.size() == other.loads.size() && influence_length == 0. &&
                std::abs(element - other.element) <
                  arithmetic::same_value * other.element;
    for (unsigned int k = 0; same && k < loads.size(); ++k)
      {
        Vector difference = other.loads[k];
        difference -= loads[k];
        same = difference.l2_norm() <
               arithmetic::same_value * other.loads[k].l2_norm();
      }
    return same;
  }



  unsigned int
  SectionFields::group_of(const LocalInteraction &interaction)
  {
    Group group{interaction.loads,
                interaction.smooth,
                interaction.element,
                interaction.holds && !interaction.constrains_section,
                {},
                {},
                0.,
                interaction.constrains_section};
    if (interaction.constrains_section)
      {
        // A clamp without modes: the tractions S_10 w and S_11 w of each
        // Saint-Venant warping w.
        group.loads.clear();
        group.smooth.clear();
        for (unsigned int j = 0; j < warpings.n(); ++j)
          for (const unsigned int q : {0, 1})
            section->S(1, q).vmult(group.loads.emplace_back(
                                     section->n_fields()),
                                   column_of(warpings, j));
      }
    for (unsigned int g = 0; g < groups.size(); ++g)
      if (groups[g].has_same_loads(group))
        {
          groups[g].is_held = groups[g].is_held || group.is_held;
          return g;
        }
    groups.push_back(group);
    return groups.size() - 1;
  }



  const std::vector<unsigned int> &
  SectionFields::zones_of(const ConstrainedSection &held)
  {
    End                end{held, {}, {}};
    ConstrainedSection opposite = held;
    opposite.extends_forward    = !held.extends_forward;
    for (const End &known : ends)
      {
        if (!are_sufficient(known.zones, held))
          continue;
        if (alike(known.held, held))
          return known.groups;
        if (alike(known.held, opposite))
          end.zones = mirrored(known.zones, *section, held);
      }
    if (end.zones.empty())
      end.zones =
        rules.ends->zones(section, states, warping, warpings, held, heated);
    for (const BoundaryLayerZone &zone : end.zones)
      {
        Group group;
        group.element          = held.element;
        group.influence_length = zone.influence_length;
        group.holds            = true;
        for (unsigned int j = 0; j < zone.fields.n(); ++j)
          group.near.push_back(column_of(zone.fields, j));
        end.groups.push_back(groups.size());
        groups.push_back(group);
      }
    ends.push_back(std::move(end));
    return ends.back().groups;
  }



  std::vector<unsigned int>
  SectionFields::groups_of(const LocalInteraction                &interaction,
                           const std::vector<ConstrainedSection> &held)
  {
    std::vector<unsigned int> result;
    for (const ConstrainedSection &one : held)
      {
        const auto &zones = zones_of(one);
        result.insert(result.end(), zones.begin(), zones.end());
      }
    if (!interaction.is_free && result.empty())
      result.push_back(group_of(interaction));
    return result;
  }



  double
  SectionFields::influence_length_of(const unsigned int g) const
  {
    const auto [smaller, larger] = section->extents();
    return groups[g].influence_length > 0. ? groups[g].influence_length :
           groups[g].holds ? rules.influence_length_of_clamp * larger :
                             rules.influence_length * smaller;
  }



  std::vector<double>
  SectionFields::wave_numbers(const double highest) const
  {
    const auto [smaller, larger] = section->extents();
    const double lowest          = rules.lowest_wave / larger,
                 last = std::max(highest, rules.min_wave_ratio * lowest);
    if (section->area() >= rules.thin_walls * smaller * larger)
      return geometric_sequence(lowest, last, theory.order);
    // Down to what walls need in no larger steps.
    const double first = rules.lowest_wave_of_walls / larger;
    const double steps =
      (theory.order - 1) * std::log(last / first) / std::log(last / lowest);
    return geometric_sequence(first, last, 1 + std::ceil(steps));
  }



  void
  SectionFields::find_responses()
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
        const double   before = std::exchange(last, k);
        ResponseTakers takers;
        for (Group &group : groups)
          {
            if (before < rules.highest_wave / group.element)
              takers.add(group.loads, group.near);
            if (before < rules.highest_wave_far / warping.height())
              takers.add(group.smooth, group.far);
          }
        takers.take(response.at(k, takers.loads));
      }
    for (Group &group : groups)
      for (const Vector &load : group.smooth)
        group.far.push_back(states.response_to_constant(load));
  }



  const std::vector<unsigned int> &
  SectionFields::list(const std::set<unsigned int> &near)
  {
    if (const auto known = lists.find(near); known != lists.end())
      return known->second;
    if (uses_responses())
      find_responses();
    std::vector<unsigned int> list;
    FieldColumns              fresh(section->n_fields(), 0);
    if (near.empty())
      {
        list = saint_venant_list();
        std::vector<Vector> smooth;
        for (const Group &group : groups)
          smooth.insert(smooth.end(), group.far.begin(), group.far.end());
        if (uses_responses())
          fresh =
            warping.basis(smooth, warpings, warpings, rules.far_tolerance);
      }
    else
      {
        // What the others there have, and what the smallest group adds to
        // it: lists that differ little share most of their modes.
        const unsigned int last =
          *std::min_element(near.begin(),
                            near.end(),
                            [this](const unsigned int a, const unsigned int b) {
                              return groups[a].order() < groups[b].order();
                            });
        std::set<unsigned int> others = near;
        others.erase(last);
        list = this->list(others);
        if (uses_responses())
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
  SectionFields::saint_venant_list() const
  {
    std::vector<unsigned int> list(6 + warpings.n());
    std::iota(list.begin(), list.begin() + 6, 0);
    std::iota(list.begin() + 6, list.end(), section->n_fields());
    return list;
  }



  FieldColumns
  SectionFields::columns_of(const std::vector<unsigned int> &list) const
  {
    std::vector<unsigned int> numbers;
    for (unsigned int j = 6; j < list.size(); ++j)
      numbers.push_back(list[j] - section->n_fields());
    return selected_columns(modes, numbers);
  }



  std::vector<Theory>
  theories_at(const double y, const TheoryPieces &pieces, const double length)
  {
    const double        tolerance = arithmetic::same_position * length;
    std::vector<Theory> result;
    for (unsigned int k = 0; k < pieces.theories.size(); ++k)
      {
        const double begin = k == 0 ? 0. : pieces.breaks[k - 1],
                     end = k < pieces.breaks.size() ? pieces.breaks[k] : length;
        if (y > begin - tolerance && y < end + tolerance)
          result.push_back(pieces.theories[k]);
      }
    return result;
  }



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



  Wanted
  requirements_of(const std::vector<Theory> &theories)
  {
    Wanted wanted;
    for (const Theory &theory : theories)
      if (theory.is_layerwise())
        wanted.degree = std::max(wanted.degree, theory.order);
      else
        wanted.any_SV = true;
    for (const Theory &theory : theories)
      wanted.plain = wanted.plain && theory.order == 0;
    return wanted;
  }



  void
  add_coarse_row_notes(const Beam                          &beam,
                       const unsigned int                   body,
                       const TheoryPieces                  &pieces,
                       const std::vector<ContactInterface> &contacts,
                       std::vector<std::string>            &notes)
  {
    std::vector<bool> is_coarse;
    for (const double y : beam.axis().nodes())
      {
        const Wanted wanted =
          requirements_of(theories_at(y, pieces, beam.axis().length()));
        is_coarse.push_back(!wanted.any_SV &&
                            wanted.degree < beam.section().element().degree());
      }
    const auto reaches = [&](const GapConstraint &row) {
      for (const BodyFunctional &part : row.parts)
        for (const auto &[dof, weight] : part.row.entries())
          if (part.body == body && is_coarse[beam.dofs().node_of(dof)])
            return true;
      return false;
    };
    for (const ContactInterface &contact : contacts)
      if (contact.discretization == Discretization::surface_to_surface &&
          std::any_of(contact.rows.begin(), contact.rows.end(), reaches))
        notes.push_back(
          "adapt.too-many-constraints: body " + beam.name() + ": contact " +
          contact.name +
          " has more contact constraints than the body has DoFs where Theories "
          "has LE-N of a lower degree. The contact force is accurate there, "
          "not the pressure. Extend the LE-N of the highest degree over the "
          "contact, or use Discretization = node to surface");
  }



  namespace
  {
    /// The lists of a body whose pieces are all LE.
    std::vector<std::vector<unsigned int>>
    lists_by_degree(const Beam &beam, const TheoryPieces &pieces)
    {
      std::vector<std::vector<unsigned int>> lists;
      for (const double y : beam.axis().nodes())
        lists.push_back(list_of_degree(
          beam.section(),
          requirements_of(theories_at(y, pieces, beam.axis().length()))
            .degree));
      return lists;
    }
  } // namespace



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



  std::unique_ptr<Body>
  make_by_degrees(const BodyDescription &description, const Beam &beam)
  {
    const auto lists = lists_by_degree(beam, description.pieces);
    return std::make_unique<Beam>(beam.name(),
                                  std::make_shared<SectionSpace>(
                                    beam.fields().shared_section()),
                                  beam.shared_axis(),
                                  beam.place(),
                                  lists,
                                  label_of(description, lists));
  }



  std::vector<StressRange>
  stress_ranges(const Bodies             &bodies,
                const std::vector<Probe> &probes,
                const std::vector<Line>  &lines,
                const std::vector<Cut>   &cuts)
  {
    std::vector<StressRange> places;
    const auto               add = [&](const unsigned int           body,
                         const std::vector<Point<3>> &corners) {
      std::vector<double> along;
      for (const Point<3> &corner : corners)
        along.push_back(bodies[body]->place().to_body(corner)[1]);
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
} // namespace lamella
