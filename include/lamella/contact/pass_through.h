// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_pass_through_h
#define lamella_contact_pass_through_h

#include <lamella/contact/contact_sides.h>
#include <lamella/contact/mesh_surface.h>
#include <lamella/contact/obstacle.h>

namespace lamella
{
  /// A surface and a roller, in one state, for passes_through().
  struct SurfaceAndRoller
  {
    const MeshSurface &surface;
    const Obstacle    &roller;
  };

  /// Returns true if a surface passed through a cylinder between two states, so
  /// that the later state has neither contact nor a negative gap. With the
  /// vector r from the cylinder axis to a point of the surface and the outward
  /// normal n, this is so if at some point the axis
  ///   was ahead (r . n < 0) and is behind (r . n > 0),
  /// and the chord between both r, projected normal to the axis, comes within
  /// the radius. Sampled points are half a radius apart, or a fortieth of a
  /// facet if that is more. Facets must be the same. False for a plane.
  bool
  passes_through(const SurfaceAndRoller &before, const SurfaceAndRoller &after);

  /// Returns true if one of two bodies passed through the other between two
  /// states: a node of either surface that was outside the other body, or
  /// overlapped by at most the depth of a cell, now overlaps by more, where
  /// pairing does not search (exceeds_cell_depth()). A node that moved around
  /// an end also counts if it has a projection in both states.
  bool
  passes_through(const ContactSides &before, const ContactSides &after);

  /// Returns true if the surfaces approach by at least the depth of a cell, so
  /// that passes_through() must be checked.
  bool
  may_pass_through(const ContactSides &before, const ContactSides &after);
} // namespace lamella

#endif
