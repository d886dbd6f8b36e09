// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_section_load_h
#define lamella_adapt_section_load_h

#include <lamella/body/beam.h>
#include <lamella/conditions/load.h>

#include <vector>

namespace lamella
{
  /// A point of a beam's axis at which short elements are required.
  struct ShortElement
  {
    /// Distance from the start of the axis [length].
    double y = 0.;
    /// Required length of the axis elements at this point [length].
    double size = 0.;
    /// True if a support or contact may constrain displacements at this point.
    bool holds = false;
  };

  /// Segment of an axis with a distributed load, and the span that contains it.
  /// Spans end at supports, contacts, and changes of the load's sign.
  struct LoadedPart
  {
    double begin = 0.; ///< Start of the segment, coordinate y [length].
    double end   = 0.; ///< End of the segment, coordinate y [length].
    double span  = 0.; ///< Length of the span [length].
  };

  /// Returns the segments of the axis of the beam number @p body with
  /// distributed transverse loads: @p loads on sides and lines, weight under @p
  /// gravity, and nonlinear temperature. Spans also end at axis ends and at
  /// points of @p places with ShortElement::holds. Collective.
  std::vector<LoadedPart>
  loaded_parts(const unsigned int               body,
               const Bodies                    &bodies,
               const std::vector<Load>         &loads,
               const dealii::Tensor<1, 3>      &gravity,
               const std::vector<ShortElement> &places);

  /// Thresholds of find_interactions(), chosen by judgment
  /// (doc/theory/saint-venant-fields.md).
  struct InteractionRules
  {
    /// Length below which the component of a unit load vector orthogonal to the
    /// other load vectors of the interaction counts as zero.
    double independent = 0.02;
    /// Nodes with less than this fraction of the largest load are ignored.
    double min_weight_share = 0.05;
    /// The axial component of a contact normal below this fraction is omitted.
    double along_axis = 0.7;
    /// Relative change of temperature per axial length H (smaller section side)
    /// below which it counts as constant; equal to FieldRules::far_tolerance.
    double heat_change_tolerance = 1e-2;
  };

  /// A segment of a beam's axis.
  struct AxisPart
  {
    double begin;   ///< Start of the segment, coordinate y [length].
    double end;     ///< End of the segment, coordinate y [length].
    double element; ///< Length of the shortest element in it [length].
  };

  /// A section load vector f (see LocalInteraction), with its position.
  struct SectionLoad
  {
    /// Load vector: section functions and their weights, which are sparse.
    LinearFunctional f;
    AxisPart         place;      ///< Loaded segment of the axis.
    dealii::Point<2> in_section; ///< Position (x, z) in the section [length].
    double           area     = 1.; ///< Tributary area or another weight of f.
    bool             at_node  = false; ///< True if one axis node is loaded.
    bool             of_clamp = false; ///< True for a constraint of a clamp.
  };

  /// Returns the section load vector of a support or contact constraint @p row
  /// at @p position (scene axes) with tributary @p area: the sum of its weights
  /// over axis nodes. If @p normal is true, a small axial component is omitted.
  SectionLoad
  load_of_row(const Beam             &beam,
              const LinearFunctional &row,
              const dealii::Point<3> &position,
              const double            area,
              const bool              normal,
              const InteractionRules &rules);

  /// Returns the section load vectors of the nodal forces @p load, for each
  /// node of the axis elements for which @p requested is true.
  std::vector<SectionLoad>
  loads_of_vector(const Beam              &beam,
                  const Vector            &load,
                  const std::vector<bool> &requested,
                  const InteractionRules  &rules);

  /// Returns linearly independent vectors among @p loads, with unit length.
  std::vector<Vector>
  independent_loads(const std::vector<SectionLoad> &loads,
                    const unsigned int              n_fields,
                    const InteractionRules         &rules);

  /// Returns the load vectors that replace @p loads at distant nodes: their
  /// area-weighted mean, and their component linear in a section coordinate.
  std::vector<Vector>
  smooth_loads(const std::vector<SectionLoad> &loads,
               const unsigned int              n_fields);
} // namespace lamella

#endif
