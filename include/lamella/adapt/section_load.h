// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_section_load_h
#define lamella_adapt_section_load_h

#include <lamella/body/beam.h>

#include <vector>

namespace lamella
{
  /// Thresholds for interactions with a section, judged, not optimized
  /// (doc/theory/saint-venant-fields.md).
  struct InteractionRules
  {
    /// Independent part of a unit load vector below which it is dropped.
    double independent = 0.02;
    /// Share of a load's largest vector below which nodes are ignored.
    double min_weight_share = 0.05;
    /// Share of weights along the axis below which that part is dropped.
    double along_axis = 0.7;
    /// Relative change of heat along one H below which it is no load; equal to
    /// FieldRules::far_tolerance.
    double heat_change_tolerance = 1e-2;
  };

  /// A part of an axis with its shortest element there or beside it [length].
  struct AxisPart
  {
    double begin, end, element;
  };

  /// A section load vector f (LocalInteraction) and its place.
  struct SectionLoad
  {
    /// Vector in the fields of the section, a row with few entries.
    LinearFunctional f;
    AxisPart         place;
    /// Position in the section [length], and the area represented.
    dealii::Point<2> in_section;
    double           area = 1.;
    /// True if it acts at one node of the axis; if it belongs to a clamp.
    bool at_node = false, of_clamp = false;
  };

  /// Returns the load of a row of a support or a contact at @p position, one
  /// section vector at all nodes. @p normal drops a minor part along the axis.
  SectionLoad
  load_of_row(const Beam             &beam,
              const LinearFunctional &row,
              const dealii::Point<3> &position,
              const double            area,
              const bool              normal,
              const InteractionRules &rules);

  /// Returns the vectors of the load vector @p load for each element it acts on
  /// among those @p requested, one flag per axis cell.
  std::vector<SectionLoad>
  loads_of_vector(const Beam              &beam,
                  const Vector            &load,
                  const std::vector<bool> &requested,
                  const InteractionRules  &rules);

  /// Returns the independent ones of @p loads, of @p n_fields, normalized.
  std::vector<Vector>
  independent_loads(const std::vector<SectionLoad> &loads,
                    const unsigned int              n_fields,
                    const InteractionRules         &rules);

  /// Returns the area-weighted mean and linear part across of @p loads.
  std::vector<Vector>
  smooth_loads(const std::vector<SectionLoad> &loads,
               const unsigned int              n_fields);
} // namespace lamella

#endif
