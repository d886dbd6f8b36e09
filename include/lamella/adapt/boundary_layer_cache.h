// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_boundary_layer_cache_h
#define lamella_adapt_boundary_layer_cache_h

#include <lamella/adapt/boundary_layer_modes.h>

#include <memory>
#include <vector>

namespace lamella
{
  /// Returns true if the boundary-layer modes @p zones may be used for the
  /// section @p held. Modes of a section of lower degree (is_embedded) do not
  /// suffice if stresses are requested near the end.
  bool
  are_sufficient(const std::vector<BoundaryLayerZone> &zones,
                 const ConstrainedSection             &held);

  /// Returns the boundary-layer zones @p zones of the section @p from, which
  /// has the same cells and a lower degree, as fields of @p section. The fields
  /// are made independent of its Saint-Venant @p warpings.
  std::vector<BoundaryLayerZone>
  embedded(const std::vector<BoundaryLayerZone> &zones,
           const Section                        &from,
           const Section                        &section,
           const Warping                        &warping,
           const FieldColumns                   &warpings,
           const BoundaryLayerRules             &rules = {});

  /// Cache of boundary-layer modes for all models of one scene. A section of
  /// higher degree (LE-4) reuses the modes of a lower degree (LE-3) if no
  /// stresses are requested near the end (ConstrainedSection::is_sampled): the
  /// degree matters little elsewhere, and the modes are the largest cost.
  class BoundaryLayerModes
  {
  public:
    explicit BoundaryLayerModes(const BoundaryLayerRules &rules = {});

    /// Returns boundary_layer_modes(), from the cache for a section with the
    /// same matrices, fields and constraints, or embedded. Collective.
    std::vector<BoundaryLayerZone>
    zones(const std::shared_ptr<const Section> &section,
          const SaintVenant                    &states,
          const Warping                        &warping,
          const FieldColumns                   &warpings,
          const ConstrainedSection             &held,
          const std::vector<HeatedSection>     &heat = {});

    const BoundaryLayerRules &
    limits() const
    {
      return rules;
    }

    /// Returns the number of end segments that were solved for modes.
    std::size_t
    n_pieces_solved() const
    {
      return n_pieces;
    }

  private:
    struct CachedEndFields
    {
      std::shared_ptr<const Section> section;
      FieldColumns                   warpings;
      /// Constraint of the section.
      ConstrainedSection             held;
      std::vector<BoundaryLayerZone> zones;
    };

    /// Returns the index in `known` of zones of a section of lower degree with
    /// the same body and constraints, or known.size() if there are none.
    std::size_t
    poorer(const Section &section, const ConstrainedSection &held) const;

    BoundaryLayerRules           rules;
    std::vector<CachedEndFields> known;
    std::size_t                  n_pieces = 0;
  };
} // namespace lamella

#endif
