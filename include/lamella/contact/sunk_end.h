// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_sunk_end_h
#define lamella_contact_sunk_end_h

#include <lamella/contact/contact_sides.h>

#include <optional>

namespace lamella
{
  /// A node of a body that is behind the surface of the other one.
  struct SunkEnd
  {
    /// Whether it is of the second side.
    bool second = false;
    /// How deep it is [length], and the depth of the cell below the place that
    /// it faces.
    double depth = 0., cell = 0.;
    /// The place that it faces.
    MeshSurface::FacetPlace at = {};
  };

  /// The deepest node of two bodies, or of their ends alone, behind the surface
  /// of the other where they stand @p now, with feet at most @p reach away
  /// [length], the nearest places of all: inside of it. Feet and normals are
  /// those of the sides as @p paired: the same where bodies turn, the
  /// undeformed in linear kinematics. Faces that slide over an end have no
  /// constraint for it, unless it is among the points.
  std::optional<SunkEnd>
  deepest_node(const ContactSides &paired,
               const ContactSides &now,
               const double        reach,
               const bool          of_ends);
} // namespace lamella

#endif
