// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_passage_h
#define lamella_contact_passage_h

#include <lamella/contact/contact_sides.h>
#include <lamella/contact/mesh_surface.h>
#include <lamella/contact/obstacle.h>

namespace lamella
{
  /// A surface and the roller that it may touch, in one state.
  struct BesideRoller
  {
    const MeshSurface &surface;
    const Obstacle    &roller;
  };

  /**
   * Whether a surface has gone through a cylinder between two states, so that
   * the later one has nothing that touches and no gap that says so: whether at
   * any place of the surface the axis, with r from it to the place and n the
   * outward normal,
   *   was ahead (r . n < 0) and is behind (r . n > 0),
   * while the chord of r across the axis comes within the radius. Places are
   * half a radius apart, or a fortieth of a facet where that is more. A surface
   * that slides over a roller, or is rolled around it, has the axis ahead.
   *
   * The same facets in both. False for a plane, behind which gaps are negative.
   */
  bool
  goes_through(const BesideRoller &before, const BesideRoller &after);

  /**
   * Whether one of two bodies has gone through the other between two states:
   * whether a node of either surface that was ahead of the other one, or in it
   * by no more than the cells there are deep, is behind by more, where pairing
   * looks for nothing (is_too_deep()). A node that came around an end is taken
   * for one that went through, if it had its foot before and after: a shorter
   * step tells.
   *
   * Feet are sought as far as the two surfaces move towards each other.
   */
  bool
  goes_through(const ContactSides &before, const ContactSides &after);

  /// Whether the two surfaces move towards each other by as much as a cell is
  /// deep at least: nothing goes through else.
  bool
  may_go_through(const ContactSides &before, const ContactSides &after);
} // namespace lamella

#endif
