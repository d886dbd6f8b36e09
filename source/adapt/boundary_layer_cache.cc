// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/adapt/boundary_layer_cache.h>
#include <lamella/base/processes.h>
#include <lamella/section/warping.h>

#include <algorithm>

namespace lamella
{
  using namespace dealii;

  bool
  are_sufficient(const std::vector<BoundaryLayerZone> &zones,
                 const ConstrainedSection             &held)
  {
    return !held.is_sampled || std::none_of(zones.begin(),
                                            zones.end(),
                                            [](const BoundaryLayerZone &zone) {
                                              return zone.is_embedded;
                                            });
  }



  namespace
  {
    /// Whether both have the same matrices, so that nothing tells them apart.
    bool
    are_equal(const Section &a, const Section &b)
    {
      if (&a == &b)
        return true;
      for (const auto &[p, q] :
           {std::array<int, 2>{{0, 0}}, {{0, 1}}, {{1, 1}}})
        {
          const Matrix &A = a.S(p, q), &B = b.S(p, q);
          if (A.m() != B.m() ||
              A.n_nonzero_elements() != B.n_nonzero_elements() ||
              !std::equal(A.begin(),
                          A.end(),
                          B.begin(),
                          [](const auto &one, const auto &other) {
                            return one.column() == other.column() &&
                                   one.value() == other.value();
                          }))
            return false;
        }
      return true;
    }



    bool
    are_equal(const FieldColumns &a, const FieldColumns &b)
    {
      return a.m() == b.m() && a.n() == b.n() &&
             std::equal(&a(0, 0), &a(0, 0) + a.m() * a.n(), &b(0, 0));
    }



    /// Whether it is the same @p number on all of them.
    bool
    is_same_everywhere(const int number)
    {
      return Utilities::MPI::min(number, communicator()) ==
             Utilities::MPI::max(number, communicator());
    }
  } // namespace



  std::vector<BoundaryLayerZone>
  embedded(const std::vector<BoundaryLayerZone> &zones,
           const Section                        &from,
           const Section                        &section,
           const Warping                        &warping,
           const FieldColumns                   &warpings,
           const BoundaryLayerRules             &rules)
  {
    std::vector<BoundaryLayerZone> result;
    FieldColumns                   known = warpings;
    for (const BoundaryLayerZone &zone : zones)
      {
        BoundaryLayerZone richer;
        richer.influence_length = zone.influence_length;
        richer.is_embedded      = true;
        richer.fields =
          warping.weighted_basis(embedded(zone.fields, from, section),
                                 warpings,
                                 known,
                                 rules.tolerance);
        if (richer.fields.n() == 0)
          continue;
        known = beside(known, richer.fields);
        result.push_back(std::move(richer));
      }
    return result;
  }



  BoundaryLayerModes::BoundaryLayerModes(const BoundaryLayerRules &rules)
    : rules(rules)
  {}



  std::vector<BoundaryLayerZone>
  BoundaryLayerModes::zones(const std::shared_ptr<const Section> &section,
                            const SaintVenant                    &states,
                            const Warping                        &warping,
                            const FieldColumns                   &warpings,
                            const ConstrainedSection             &held,
                            const std::vector<HeatedSection>     &heat)
  {
    ConstrainedSection of_piece = held;
    of_piece.element            = first_element(*section, held, rules);
    const auto same =
      std::find_if(known.begin(), known.end(), [&](const CachedEndFields &one) {
        return alike(one.held, of_piece) && are_equal(*one.section, *section) &&
               are_equal(one.warpings, warpings) &&
               are_sufficient(one.zones, of_piece);
      });
    // Making them is collective: processes that differ in a last bit make them.
    const bool is_known = is_same_everywhere(same - known.begin());
    if (is_known && same != known.end())
      return same->zones;
    const std::size_t              other     = poorer(*section, of_piece);
    const bool                     has_point = is_same_everywhere(other);
    std::vector<BoundaryLayerZone> zones;
    if (has_point && other < known.size())
      zones = embedded(known[other].zones,
                       *known[other].section,
                       *section,
                       warping,
                       warpings,
                       rules);
    else
      {
        zones = boundary_layer_modes(
          section, states, warping, warpings, held, heat, rules);
        ++n_pieces;
      }
    known.push_back({section, warpings, of_piece, zones});
    return zones;
  }



  std::size_t
  BoundaryLayerModes::poorer(const Section            &section,
                             const ConstrainedSection &held) const
  {
    std::size_t  best   = known.size();
    unsigned int degree = 0;
    if (!held.is_sampled)
      for (std::size_t k = 0; k < known.size(); ++k)
        if (const CachedEndFields &one = known[k];
            one.section->element().degree() < section.element().degree() &&
            one.section->element().degree() > degree &&
            one.held.body == held.body && one.held.by == held.by &&
            one.held.extends_forward == held.extends_forward &&
            one.held.has_same_element_length(held) &&
            have_same_cells(*one.section, section))
          {
            best   = k;
            degree = one.section->element().degree();
          }
    return best;
  }
} // namespace lamella
