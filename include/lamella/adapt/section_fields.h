// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_section_fields_h
#define lamella_adapt_section_fields_h

#include <lamella/adapt/node_fields.h>
#include <lamella/section/saint_venant.h>
#include <lamella/section/section_space.h>
#include <lamella/section/warping.h>

#include <limits>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace lamella
{
  /// The fields of one section, for all bodies with this section and theory, in
  /// groups of equal load vectors or zones of end fields.
  class SectionFields
  {
  public:
    /// Computes the states and warpings of @p section, and its responses to
    /// slowly varying actions along the axis: @p heat and the load vectors @p
    /// weights. Throws NumericsError if its matrices cannot be factorized.
    SectionFields(std::shared_ptr<const Section>               section,
                  const Theory                                &theory,
                  const FieldRules                            &rules,
                  const std::vector<Beam::SectionThermalLoad> &heat    = {},
                  const std::vector<Vector>                   &weights = {});

    /// Returns the group of @p interaction.
    unsigned int
    group_of(const LocalInteraction &interaction);

    /// Returns the groups of a free end or of a clamped section @p held: the
    /// zones of its end fields, or else the tractions of its @p interaction.
    std::vector<unsigned int>
    groups_of(const LocalInteraction                &interaction,
              const std::vector<ConstrainedSection> &held);

    /// Returns the distance within which nodes carry the fields of group @p g.
    double
    influence_length_of(const unsigned int g) const;

    /// Returns whether there are responses at wave numbers.
    bool
    uses_responses() const
    {
      return theory.order > 0 && !groups.empty();
    }

    /// Returns the number of load vectors of group @p group that a support
    /// constrains; 0 for a clamp.
    std::size_t
    n_constrained(const unsigned int group) const
    {
      return groups[group].is_held ? groups[group].loads.size() : 0;
    }

    /// Returns the list of a node near the groups @p near.
    const std::vector<unsigned int> &
    list(const std::set<unsigned int> &near);

    /// Returns the list of a node of SV: rigid fields and warpings.
    std::vector<unsigned int>
    saint_venant_list() const;

    /// Returns the modes of @p list.
    FieldColumns
    columns_of(const std::vector<unsigned int> &list) const;

    /// Returns the space of all modes. Call it after the last list.
    std::shared_ptr<const SectionSpace>
    space() const
    {
      return std::make_shared<SectionSpace>(section, modes);
    }

  private:
    struct Group
    {
      std::vector<Vector> loads, smooth;
      double              element = 0.;
      bool                is_held = false;
      /// Responses to the loads, and to the smooth ones.
      std::vector<Vector> near, far;
      /// Extent of a zone of end fields, which are in `near`; else 0.
      double influence_length = 0.;
      /// True if the group holds a section as a whole.
      bool holds = false;
      /// Returns the sort key of groups near a node: outer zones before inner
      /// ones, and after groups with load vectors.
      std::pair<double, std::size_t>
      order() const
      {
        return {influence_length > 0. ? influence_length :
                                        std::numeric_limits<double>::max(),
                loads.size()};
      }

      /// Returns whether @p other has the same loads on elements as short.
      bool
      has_same_loads(const Group &other) const;
    };

    /// A held section with the zones of its end fields and their groups.
    struct End
    {
      ConstrainedSection             held;
      std::vector<BoundaryLayerZone> zones;
      std::vector<unsigned int>      groups;
    };

    /// Returns the groups of the end fields of @p held, perhaps mirrored.
    const std::vector<unsigned int> &
    zones_of(const ConstrainedSection &held);

    bool
    has_thin_walls() const;
    /// Returns the wave numbers up to @p highest.
    std::vector<double>
    wave_numbers(const double highest) const;
    /// Returns FieldRules::near_tolerance for N of the theory.
    double
    near_tolerance() const
    {
      const double ratio = double(rules.reference_waves) / theory.order;
      return rules.near_tolerance * std::min(1., ratio * ratio);
    }
    /// Computes the responses of all groups, one factorization per wave number.
    void
    find_responses();
    /// Returns tractions in place of load vectors for a clamped section with
    /// the warping w: those of w as a value and as a derivative.
    std::vector<Vector>
    tractions_of_warpings() const;
    /// Returns the independent responses to smooth loads.
    FieldColumns
    far_fields() const;

    std::shared_ptr<const Section> section;
    Theory                         theory;
    FieldRules                     rules;
    SaintVenant                    states;
    Warping                        warping;
    FieldColumns                   warpings;
    FieldColumns                   modes;
    std::vector<HeatedSection>     heated;
    std::vector<Group>             groups;
    bool                           responses_are_known = false;
    std::map<std::set<unsigned int>, std::vector<unsigned int>> lists;
    std::vector<End>                                            ends;
  };
} // namespace lamella

#endif
