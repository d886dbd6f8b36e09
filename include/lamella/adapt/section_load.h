// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_adapt_section_load_h
#define lamella_adapt_section_load_h

#include <lamella/body/beam.h>

#include <vector>

namespace lamella
{
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
    /// Whether it acts at one node of the axis.
    bool at_node = false;
  };

  /// A row of a support or a contact, at @p position in the scene, the same
  /// section vector at all of its nodes; @p normal: without its part along the
  /// axis, unless that is most of it.
  SectionLoad
  load_of_row(const Beam             &beam,
              const Row              &row,
              const dealii::Point<3> &position,
              const double            area,
              const bool              normal);

  /// The load vector @p load, whatever it is at each node: those of each
  /// element that it is on, of the elements @p asked, one for each cell of the
  /// axis.
  std::vector<SectionLoad>
  loads_of_vector(const Beam              &beam,
                  const Vector            &load,
                  const std::vector<bool> &asked);

  /// Those of @p loads, vectors of @p n_fields, that are independent, unit
  /// length each.
  std::vector<Vector>
  independent_of(const std::vector<SectionLoad> &loads,
                 const unsigned int              n_fields);

  /// The mean of @p loads and what varies linearly across, weighted with their
  /// areas. There must be a load.
  std::vector<Vector>
  smooth_of(const std::vector<SectionLoad> &loads, const unsigned int n_fields);
} // namespace lamella

#endif
