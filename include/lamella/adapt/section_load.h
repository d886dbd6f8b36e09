// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_section_load_h
#define lamella_adapt_section_load_h

#include <lamella/body/beam.h>

#include <vector>

namespace lamella
{
  /// Thresholds of find_interactions(), chosen by judgment
  /// (doc/theory/saint-venant-fields.md).
  struct InteractionRules
  {
    /// Unit load vectors with a smaller independent part are omitted.
    double independent = 0.02;
    /// Nodes with less than this fraction of the largest load are ignored.
    double min_weight_share = 0.05;
    /// The axial part of a contact normal below this fraction is omitted.
    double along_axis = 0.7;
    /// A smaller relative change of temperature along the section height H is
    /// no load; equal to FieldRules::far_tolerance.
    double heat_change_tolerance = 1e-2;
  };

  /// Segment of a beam's axis, and length of its shortest element [length].
  struct AxisPart
  {
    double begin, end, element;
  };

  /// A section load vector f (LocalInteraction), with its position.
  struct SectionLoad
  {
    /// Load vector in the fields of the section, with few entries.
    LinearFunctional f;
    AxisPart         place;
    /// Position in the section [length], and tributary area.
    dealii::Point<2> in_section;
    double           area = 1.;
    /// True if the load acts at one axis node; if it is part of a clamp.
    bool at_node = false, of_clamp = false;
  };

  /// Returns the section load vector of a support or contact constraint @p row
  /// at @p position; nodes differ by a factor. If @p normal, drops a small
  /// axial part.
  SectionLoad
  load_of_row(const Beam             &beam,
              const LinearFunctional &row,
              const dealii::Point<3> &position,
              const double            area,
              const bool              normal,
              const InteractionRules &rules);

  /// Returns the section load vectors of the load vector @p load for each
  /// loaded element among those @p requested, one flag per axis cell.
  std::vector<SectionLoad>
  loads_of_vector(const Beam              &beam,
                  const Vector            &load,
                  const std::vector<bool> &requested,
                  const InteractionRules  &rules);

  /// Returns an independent subset of the load vectors @p loads, normalized.
  std::vector<Vector>
  independent_loads(const std::vector<SectionLoad> &loads,
                    const unsigned int              n_fields,
                    const InteractionRules         &rules);

  /// Returns two sets of load vectors that replace @p loads on distant nodes:
  /// the area-weighted mean, and the part linear in the section coordinates.
  std::vector<Vector>
  smooth_loads(const std::vector<SectionLoad> &loads,
               const unsigned int              n_fields);
} // namespace lamella

#endif
