// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_pass_through_h
#define lamella_contact_pass_through_h

#include <lamella/contact/contact_sides.h>
#include <lamella/contact/mesh_surface.h>
#include <lamella/contact/obstacle.h>

namespace lamella
{
  /// A surface and the roller that it may touch, in one state.
  struct SurfaceAndRoller
  {
    const MeshSurface &surface;
    const Obstacle    &roller;
  };

  /**
   * Returns true if a surface passed through a cylinder between two states, so
   * that the later one has neither contact nor a negative gap: at some place of
   * the surface, with r from the axis to the place and the outward normal n,
   * the axis
   *   was ahead (r . n < 0) and is behind (r . n > 0),
   * and the chord of r normal to the axis comes within the radius. Places are
   * half a radius apart, or a fortieth of a facet if that is more. Both states
   * must have the same facets. False for a plane.
   */
  bool
  passes_through(const SurfaceAndRoller &before, const SurfaceAndRoller &after);

  /**
   * Returns true if one of two bodies passed through the other between two
   * states: a node of either surface that was ahead of the other, or overlapped
   * by at most a cell, overlaps by more, where pairing does not search
   * (exceeds_cell_depth()). A node that moved around an end also counts if it
   * had a projection before and after; shorter steps distinguish it.
   * Projections are searched within the approach of the surfaces plus the
   * largest cell depth.
   */
  bool
  passes_through(const ContactSides &before, const ContactSides &after);

  /// Returns true if the surfaces approach by at least the depth of a cell.
  bool
  may_pass_through(const ContactSides &before, const ContactSides &after);
} // namespace lamella

#endif
