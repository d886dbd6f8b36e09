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
  /// The fields of one section, shared by all bodies with this section and
  /// theory. Fields are in groups: section functions from equal load vectors,
  /// or the boundary-layer modes of a zone near an end.
  class SectionFields
  {
  public:
    /// Computes the Saint-Venant states and warpings of @p section, and its
    /// section functions from constant loads along the axis: the thermal loads
    /// @p heat and the weight vectors @p weights. Throws NumericsError if its
    /// matrices are singular.
    SectionFields(std::shared_ptr<const Section>               section,
                  const Theory                                &theory,
                  const FieldRules                            &rules,
                  const std::vector<Beam::SectionThermalLoad> &heat    = {},
                  const std::vector<Vector>                   &weights = {});

    /// Returns the group of fields of @p interaction.
    unsigned int
    group_of(const LocalInteraction &interaction);

    /// Returns the groups of a free end or of a clamped section @p held: its
    /// boundary-layer zones or, without modes, tractions of @p interaction.
    std::vector<unsigned int>
    groups_of(const LocalInteraction                &interaction,
              const std::vector<ConstrainedSection> &held);

    /// Returns the distance [length] within which nodes have group @p g.
    double
    influence_length_of(const unsigned int g) const;

    /// Returns true if there are section functions from harmonic loads.
    bool
    uses_responses() const
    {
      return theory.order > 0 && !groups.empty();
    }

    /// Returns the number of constrained load vectors of @p group (no clamp).
    std::size_t
    n_constrained(const unsigned int group) const
    {
      return groups[group].is_held ? groups[group].loads.size() : 0;
    }

    /// Returns the field numbers of a node that is near the groups @p near.
    const std::vector<unsigned int> &
    list(const std::set<unsigned int> &near);

    /// Returns the field numbers of a node of SV: rigid fields and warpings.
    std::vector<unsigned int>
    saint_venant_list() const;

    /// Returns the section functions with the field numbers @p list.
    FieldColumns
    columns_of(const std::vector<unsigned int> &list) const;

    /// Returns the space of all fields. Call it after the last list().
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
      /// Section functions from the loads, and from the smooth loads.
      std::vector<Vector> near, far;
      /// Extent of a boundary-layer zone with modes in `near`; else 0.
      double influence_length = 0.;
      /// True if the group constrains a whole section.
      bool holds = false;
      /// Returns the sort key: load vectors, then outer zones, inner zones.
      std::pair<double, std::size_t>
      order() const
      {
        return {influence_length > 0. ? influence_length :
                                        std::numeric_limits<double>::max(),
                loads.size()};
      }

      /// Returns true if @p other has the same loads and element length.
      bool
      has_same_loads(const Group &other) const;
    };

    /// A constrained section: zones of boundary-layer modes, their groups.
    struct End
    {
      ConstrainedSection             held;
      std::vector<BoundaryLayerZone> zones;
      std::vector<unsigned int>      groups;
    };

    /// Returns the groups of the boundary-layer modes of @p held.
    const std::vector<unsigned int> &
    zones_of(const ConstrainedSection &held);

    bool
    has_thin_walls() const;
    /// Returns the wave numbers up to @p highest.
    std::vector<double>
    wave_numbers(const double highest) const;
    /// Returns FieldRules::near_tolerance for N wave numbers of the theory.
    double
    near_tolerance() const
    {
      const double ratio = double(rules.reference_waves) / theory.order;
      return rules.near_tolerance * std::min(1., ratio * ratio);
    }
    /// Computes all section functions, one factorization per wave number.
    void
    find_responses();
    /// Returns tractions that replace load vectors at a clamped section:
    /// tractions of each Saint-Venant warping, as a value and as an axial
    /// derivative.
    std::vector<Vector>
    tractions_of_warpings() const;
    /// Returns the independent section functions from smooth loads.
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
