// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_boundary_layer_cache_h
#define lamella_adapt_boundary_layer_cache_h

#include <lamella/adapt/boundary_layer_modes.h>

#include <memory>
#include <vector>

namespace lamella
{
  /// Returns true if the boundary-layer modes @p zones are accurate enough near
  /// the constrained section @p held. Modes of a lower degree
  /// (BoundaryLayerZone::is_embedded) are not if stresses are requested there.
  bool
  are_sufficient(const std::vector<BoundaryLayerZone> &zones,
                 const ConstrainedSection             &held);

  /// Converts the boundary-layer modes @p zones from the section functions of
  /// @p from to those of @p section, which has the same cells and a higher
  /// degree. Removes parts that its Saint-Venant @p warpings contain.
  std::vector<BoundaryLayerZone>
  embedded(const std::vector<BoundaryLayerZone> &zones,
           const Section                        &from,
           const Section                        &section,
           const Warping                        &warping,
           const FieldColumns                   &warpings,
           const BoundaryLayerRules             &rules = {});

  /// Cache of boundary-layer modes for all models of one scene. A section of
  /// higher degree (LE-4) reuses the modes of a lower degree (LE-3) if no
  /// stresses are requested near the end (ConstrainedSection::is_sampled),
  /// since the degree then matters little and modes are expensive.
  class BoundaryLayerModes
  {
  public:
    /// Constructs an empty cache of modes for the parameters @p rules.
    explicit BoundaryLayerModes(const BoundaryLayerRules &rules = {});

    /// Returns the boundary-layer modes of the constrained section @p held.
    /// Reuses cached modes of an equal section with equal constraints, or else
    /// those of a lower degree (embedded()), or else calls
    /// boundary_layer_modes(). Collective.
    std::vector<BoundaryLayerZone>
    zones(const std::shared_ptr<const Section> &section,
          const SaintVenant                    &states,
          const Warping                        &warping,
          const FieldColumns                   &warpings,
          const ConstrainedSection             &held,
          const std::vector<HeatedSection>     &heat = {});

    /// Returns the parameters with which the modes are computed.
    const BoundaryLayerRules &
    limits() const
    {
      return rules;
    }

    /// Returns the number of end segments of beams that were solved for modes.
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
      /// Constraint for which the modes were computed.
      ConstrainedSection             held;
      std::vector<BoundaryLayerZone> zones;
    };

    /// Returns the index in `known` of the highest degree below that of @p
    /// section for equal body, cells and constraints; known.size() if there is
    /// none.
    std::size_t
    poorer(const Section &section, const ConstrainedSection &held) const;

    BoundaryLayerRules           rules;
    std::vector<CachedEndFields> known;
    std::size_t                  n_pieces = 0;
  };
} // namespace lamella

#endif
