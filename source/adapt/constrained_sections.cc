// SPDX-License-Identifier: LGPL-2.1-or-later

// Constraints of an end section (boundary_layer_modes.h), and mirrored zones.

#include <lamella/adapt/boundary_layer_modes.h>
#include <lamella/base/arithmetic.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lamella
{
  using namespace dealii;

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
