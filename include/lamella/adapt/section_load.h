// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_section_load_h
#define lamella_adapt_section_load_h

#include <lamella/body/beam.h>

#include <vector>

namespace lamella
{
  /**
   * What of rows counts as a touch of a section, and which touch is a clamp.
   * They are judgements, not optima, and all that doc/saint-venant-fields.md
   * compares was made with them.
   */
  struct TouchRules
  {
    /// Of a unit load vector: with less than that beside the others it is
    /// nothing new.
    double independent = 0.02;
    /// Of the largest vector of a load: nodes with less are not looked at.
    double strong = 0.05;
    /// Of a row's weights: above it a row presses along the axis, and below it
    /// what it has along the axis is left out (surfaces that slope).
    double along_axis = 0.7;
    /// What heat may change along one H, of its largest, without being a load:
    /// FieldRules::far_tolerance, to which the response to constant heat
    /// follows it.
    double heat_varies = 1e-2;
  };

  /// A part of an axis: from, to, and the shortest element there or beside
  /// [length].
  struct AxisPart
  {
    double begin, end, element;
  };

  /// A section load vector f (Touch) with where it acts.
  struct SectionLoad
  {
    /// Its DoFs are the fields of the section. A row, since a support of a
    /// whole body has as many as it has nodes, of few entries each.
    Row      f;
    AxisPart place;
    /// Where in the section [length], and the area that it stands for.
    dealii::Point<2> in_section;
    double           area = 1.;
    /// Whether it acts at one node of the axis, and whether it is of a clamp
    /// (is_clamp()).
    bool at_node = false, of_clamp = false;
  };

  /// A row of a support or a contact, at @p position in the scene, the same
  /// section vector at all of its nodes; @p normal: without its part along the
  /// axis, unless that is most of it.
  SectionLoad
  load_of_row(const Beam             &beam,
              const Row              &row,
              const dealii::Point<3> &position,
              const double            area,
              const bool              normal,
              const TouchRules       &rules);

  /// The load vector @p load, whatever it is at each node: those of each
  /// element that it is on, of the elements @p asked, one for each cell of the
  /// axis.
  std::vector<SectionLoad>
  loads_of_vector(const Beam              &beam,
                  const Vector            &load,
                  const std::vector<bool> &asked,
                  const TouchRules        &rules);

  /// Those of @p loads, vectors of @p n_fields, that are independent, unit
  /// length each.
  std::vector<Vector>
  independent_of(const std::vector<SectionLoad> &loads,
                 const unsigned int              n_fields,
                 const TouchRules               &rules);

  /// The mean of @p loads and what varies linearly across, weighted with their
  /// areas. There must be a load.
  std::vector<Vector>
  smooth_of(const std::vector<SectionLoad> &loads, const unsigned int n_fields);
} // namespace lamella

#endif
