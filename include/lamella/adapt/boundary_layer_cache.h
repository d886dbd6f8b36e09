// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_boundary_layer_cache_h
#define lamella_adapt_boundary_layer_cache_h

#include <lamella/adapt/boundary_layer_modes.h>

#include <memory>
#include <vector>

namespace lamella
{
  /// Returns whether @p zones, perhaps embedded, suffice for @p held.
  bool
  are_sufficient(const std::vector<BoundaryLayerZone> &zones,
                 const ConstrainedSection             &held);

  /// Returns the zones @p zones of the section @p from, of the same cells and a
  /// lower degree, embedded in @p section, free of its @p warpings.
  std::vector<BoundaryLayerZone>
  embedded(const std::vector<BoundaryLayerZone> &zones,
           const Section                        &from,
           const Section                        &section,
           const Warping                        &warping,
           const FieldColumns                   &warpings,
           const BoundaryLayerRules             &rules = {});

  /// Cache of end fields for the models of one scene, which have the same ends.
  /// A richer section (LE-4 for LE-3) takes the embedded fields of a poorer one
  /// if no stresses are requested at the end (ConstrainedSection::is_sampled):
  /// the effect of the degree is local, and the piece is most of the model's
  /// cost.
  class BoundaryLayerModes
  {
  public:
    explicit BoundaryLayerModes(const BoundaryLayerRules &rules = {});

    /// Returns boundary_layer_modes(), cached for a section with the same
    /// matrices, fields and constraints, or embedded. Collective.
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

    /// Returns the number of pieces solved.
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
      /// Constraint with the element of the piece.
      ConstrainedSection             held;
      std::vector<BoundaryLayerZone> zones;
    };

    /// Returns the index of the zones of a poorer section of the body with the
    /// same constraints, or known.size().
    std::size_t
    poorer(const Section &section, const ConstrainedSection &held) const;

    BoundaryLayerRules           rules;
    std::vector<CachedEndFields> known;
    std::size_t                  n_pieces = 0;
  };
} // namespace lamella

#endif
