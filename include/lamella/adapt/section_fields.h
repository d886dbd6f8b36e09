// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_section_fields_h
#define lamella_adapt_section_fields_h

#include <lamella/adapt/node_fields.h>
#include <lamella/body/beam.h>
#include <lamella/body/parameters.h>
#include <lamella/contact/gap_constraints.h>
#include <lamella/section/saint_venant.h>
#include <lamella/section/section_space.h>
#include <lamella/section/warping.h>

#include <limits>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  /// Loads along the whole axis of bodies with one section.
  struct LoadsAlongAxis
  {
    /// Thermal loads, constant along the axis.
    std::vector<Beam::SectionThermalLoad> heat;
    /// Load vectors of gravity, constant along the axis.
    std::vector<Vector> weights;
    /// Inertial forces (Beam::section_inertia()), harmonic along the axis.
    std::vector<Vector> inertia;
  };

  /// The section functions of reduced beam models (SV-N) for bodies with one
  /// section and theory. Each group has the functions from the load vectors of
  /// one interaction, or the boundary-layer modes of a zone near an end.
  class SectionFields
  {
  public:
    /// Computes the Saint-Venant states and warpings of @p section, and its
    /// section functions from the loads @p all along the axis. Throws
    /// NumericsError if the section matrices are singular.
    SectionFields(std::shared_ptr<const Section> section,
                  const Theory                  &theory,
                  const FieldRules              &rules,
                  const LoadsAlongAxis          &all = {});

    /// Returns the index of the group for the load vectors of @p interaction,
    /// which is added if no group has the same load vectors.
    unsigned int
    group_of(const LocalInteraction &interaction);

    /// Returns the groups of boundary-layer modes of a clamp or free end @p
    /// interaction with the constrained sections @p held. A clamp without modes
    /// has one group of section load vectors instead.
    std::vector<unsigned int>
    groups_of(const LocalInteraction                &interaction,
              const std::vector<ConstrainedSection> &held);

    /// Returns the distance within which nodes have group @p g [length].
    double
    influence_length_of(const unsigned int g) const;

    /// Returns true if there are section functions from harmonic loads.
    bool
    uses_responses() const
    {
      return theory.order > 0 && !groups.empty();
    }

    /// Returns the number of load vectors of a support @p group; 0 for a clamp.
    std::size_t
    n_constrained(const unsigned int group) const
    {
      return groups[group].is_held ? groups[group].loads.size() : 0;
    }

    /// Returns the indices of the section functions of a node near the groups
    /// @p near. Computes these functions if necessary.
    const std::vector<unsigned int> &
    list(const std::set<unsigned int> &near);

    /// Returns the indices of the section functions of a node of the theory SV:
    /// rigid displacements and Saint-Venant warpings.
    std::vector<unsigned int>
    saint_venant_list() const;

    /// Returns the section functions @p list, except rigid ones, as columns.
    FieldColumns
    columns_of(const std::vector<unsigned int> &list) const;

    /// Returns the space of all functions. Call it after the last list().
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

    /// A constrained section with its zones and the index of each zone's group.
    struct End
    {
      ConstrainedSection             held;
      std::vector<BoundaryLayerZone> zones;
      std::vector<unsigned int>      groups;
    };

    /// Returns the groups of the boundary-layer modes of @p held.
    const std::vector<unsigned int> &
    zones_of(const ConstrainedSection &held);

    /// Returns the ascending wave numbers of harmonic loads up to @p highest.
    std::vector<double>
    wave_numbers(const double highest) const;
    /// Returns FieldRules::near_tolerance, reduced for many wave numbers.
    double
    near_tolerance() const
    {
      const double ratio = double(rules.reference_waves) / theory.order;
      return rules.near_tolerance * std::min(1., ratio * ratio);
    }
    /// Computes the functions of all groups, one factorization per wave number.
    void
                                   find_responses();
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

  /// Returns the theories of those segments @p pieces of an axis of length @p
  /// length (entry `Theories`) that contain @p y.
  std::vector<Theory>
  theories_at(const double y, const TheoryPieces &pieces, const double length);

  /// Returns the indices of the section functions of @p section for nodes of
  /// LE-@p degree: functions up to this polynomial degree.
  std::vector<unsigned int>
  list_of_degree(const Section &section, const unsigned int degree);

  /// Theories of all axis segments that meet at a node, combined.
  struct Wanted
  {
    unsigned int degree = 0;     ///< Highest degree N of LE-N; 0 without LE.
    bool         any_SV = false; ///< True if any segment is SV or SV-N.
    bool         plain  = true;  ///< True if all segments are SV, not SV-N.
  };

  /// Returns the combined requirements of @p theories, which meet at a node.
  Wanted
  requirements_of(const std::vector<Theory> &theories);

  /// Adds to @p notes a message for each of @p contacts with surface-to-surface
  /// discretization on nodes of @p beam, body number @p body, that have a lower
  /// degree of LE than its section. There are more constraints than DoFs there.
  void
  add_coarse_row_notes(const Beam                          &beam,
                       const unsigned int                   body,
                       const TheoryPieces                  &pieces,
                       const std::vector<ContactInterface> &contacts,
                       std::vector<std::string>            &notes);

  /// Returns a description of the theory of @p body with the section functions
  /// @p lists of its nodes, e.g. "SV-6 (of LE-2), 12 to 111 fields a node".
  std::string
  label_of(const BodyDescription                        &body,
           const std::vector<std::vector<unsigned int>> &lists);

  /// Creates the body of @p description, with LE theories on all axis segments,
  /// from @p beam, which has all section functions at all nodes.
  std::unique_ptr<Body>
  make_by_degrees(const BodyDescription &description, const Beam &beam);
} // namespace lamella

#endif
