// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_fields_of_section_h
#define lamella_adapt_fields_of_section_h

#include <lamella/adapt/node_fields.h>
#include <lamella/section/field_space.h>
#include <lamella/section/saint_venant.h>
#include <lamella/section/warping.h>

#include <limits>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace lamella
{
  /**
   * The fields of one section, for all bodies that have it and the same
   * theory. Load vectors come in groups, one for each thing that touches, the
   * same for two that touch alike (the two supports of a beam in bending).
   * The zones of end fields are groups that bring their fields.
   */
  class FieldsOfSection
  {
  public:
    /// Makes the states and warpings of @p section, and beside these its
    /// responses to what acts all along the axis and little changed: @p heat
    /// and the section load vectors @p weights. Throws NumericsError if its
    /// matrices cannot be factorised.
    FieldsOfSection(std::shared_ptr<const Section>        section,
                    const Theory                         &theory,
                    const FieldRules                     &rules,
                    const std::vector<Beam::SectionHeat> &heat    = {},
                    const std::vector<Vector>            &weights = {});

    /// The group of @p touch.
    unsigned int
    group_of(const Touch &touch);

    /// Those of what holds a section as a whole, or of a free end, as @p held
    /// say: the zones of its end fields; the tractions of its touch @p touch
    /// where something holds and there are none, or the rules want these.
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

      /// Whether its fields answer @p other, too: the same loads on elements as
      /// short.
      bool
      asks_as(const Group &other) const;
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
      const double ratio = double(rules.cut_of_waves) / theory.order;
      return rules.near_tolerance * std::min(1., ratio * ratio);
    }
    /// The responses of all groups, at one set of wave numbers: one
    /// factorisation each.
    void
    find_responses();
    /// What holds a section as a whole answers to no load vector: it holds the
    /// warping w, with the tractions that w has as a value and as a derivative.
    std::vector<Vector>
    tractions_of_warpings() const;
    /// The responses to smooth loads, as far as they are news.
    FieldColumns
    fields_from_afar() const;

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
