// SPDX-License-Identifier: LGPL-2.1-or-later

// Cache of boundary-layer modes, constraints of an end section, and mirrored
// zones (boundary_layer_modes.h).

#include <lamella/adapt/boundary_layer_modes.h>
#include <lamella/base/arithmetic.h>
#include <lamella/base/processes.h>
#include <lamella/section/warping.h>

#include <algorithm>
#include <array>
#include <cmath>

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



  std::vector<ConstrainedSection>
  constrained_sections(const std::vector<LocalInteraction> &interactions,
                       const unsigned int                   t,
                       const Axis                          &axis)
  {
    const double y         = interactions[t].begin,
                 tolerance = arithmetic::same_position * axis.length();
    ConstrainedSection held;
    held.element = interactions[t].element;
    for (const LocalInteraction &interaction : interactions)
      if ((interaction.constrains_section || interaction.is_free) &&
          std::abs(interaction.begin - y) < tolerance)
        {
          held.rows.insert(held.rows.end(),
                           interaction.held.begin(),
                           interaction.held.end());
          held.by.push_back(interaction.name);
        }
    std::vector<ConstrainedSection> result;
    for (const bool forward : {true, false})
      if (forward ? y < axis.length() - tolerance : y > tolerance)
        {
          held.extends_forward = forward;
          result.push_back(held);
        }
    return result;
  }



  bool
  ConstrainedSection::has_same_element_length(
    const ConstrainedSection &other) const
  {
    return std::abs(element - other.element) <=
           arithmetic::same_value * element;
  }



  bool
  alike(const ConstrainedSection &a, const ConstrainedSection &b)
  {
    if (a.extends_forward != b.extends_forward ||
        a.rows.size() != b.rows.size() || !a.has_same_element_length(b))
      return false;
    const auto same = [](const LinearFunctional &r, const LinearFunctional &s) {
      return std::equal(r.entries().begin(),
                        r.entries().end(),
                        s.entries().begin(),
                        s.entries().end(),
                        [](const LinearFunctional::Entry &e,
                           const LinearFunctional::Entry &f) {
                          return e.first == f.first &&
                                 std::abs(e.second - f.second) <
                                   arithmetic::same_value;
                        });
    };
    return std::equal(a.rows.begin(), a.rows.end(), b.rows.begin(), same);
  }



  namespace
  {
    /// What a mirror across the axis makes of the field @p alpha: -1 where it
    /// is along the axis, 1 across; 0 where it is both.
    int
    mirror_sign(const Section &section, const unsigned int alpha)
    {
      const auto &terms = section.field(alpha).terms;
      const auto  along =
        std::count_if(terms.begin(), terms.end(), [](const auto &term) {
          return term.component == 1;
        });
      return along == 0 ? 1 : (along == int(terms.size()) ? -1 : 0);
    }
  } // namespace



  std::vector<BoundaryLayerZone>
  mirrored(const std::vector<BoundaryLayerZone> &zones,
           const Section                        &section,
           const ConstrainedSection             &held)
  {
    std::vector<int> sign(section.n_fields());
    for (unsigned int a = 0; a < sign.size(); ++a)
      sign[a] = mirror_sign(section, a);
    if (std::count(sign.begin(), sign.end(), 0) > 0)
      return {};
    for (const LinearFunctional &row : held.rows)
      for (const auto &[field, weight] : row.entries())
        if (sign[field] != sign[row.entries()[0].first])
          return {};
    // A mirror image has the opposite S_01 and the same S_00 and S_11.
    for (const auto &[p, q, opposite] :
         {std::array<int, 3>{{0, 0, 1}}, {{1, 1, 1}}, {{0, 1, -1}}})
      {
        const Matrix &S = section.S(p, q);
        const double  nothing =
          arithmetic::rounding_of_results * S.linfty_norm();
        for (unsigned int a = 0; a < sign.size(); ++a)
          for (auto entry = S.begin(a); entry != S.end(a); ++entry)
            if (sign[a] * sign[entry->column()] != opposite &&
                std::abs(entry->value()) > nothing)
              return {};
      }
    std::vector<BoundaryLayerZone> result = zones;
    for (BoundaryLayerZone &zone : result)
      for (unsigned int j = 0; j < zone.fields.n(); ++j)
        for (unsigned int a = 0; a < sign.size(); ++a)
          zone.fields(a, j) *= sign[a];
    return result;
  }
} // namespace lamella
