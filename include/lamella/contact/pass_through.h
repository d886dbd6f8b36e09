// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_pass_through_h
#define lamella_contact_pass_through_h

#include <lamella/contact/contact_pair.h>
#include <lamella/contact/contact_sides.h>
#include <lamella/contact/mesh_surface.h>

#include <optional>

namespace lamella
{
  /// A node of a body that penetrates the surface of the other body.
  struct EndPenetration
  {
    /// True for a node of the second body, false for one of the first.
    bool   second = false;
    double depth  = 0., ///< Penetration [length].
      cell = 0.; ///< Depth of the penetrated cell along its normal [length].
    /// Closest-point projection of the node onto the other surface.
    MeshSurface::FacetPoint at = {};
  };

  /// Returns the node of either body with the deepest penetration into the
  /// other surface in the configuration @p now; empty if none penetrates. If @p
  /// of_ends is true, only nodes at body ends are considered, since they have
  /// no constraint if a surface slides over them. Projections are at most @p
  /// search_radius away [length]. @p paired are the surfaces that were paired.
  std::optional<EndPenetration>
  deepest_node(const ContactSides &paired,
               const ContactSides &now,
               const double        search_radius,
               const bool          of_ends);

  /// A surface and a rigid roller (cylinder) in one equilibrium state.
  struct SurfaceAndRoller
  {
    const MeshSurface &surface; ///< Surface of the body, deformed.
    const Obstacle    &roller;  ///< Roller at its current position.
  };

  /// Returns true if a surface passed through a rigid cylinder between two
  /// equilibrium states, so that the later state has neither contact nor a
  /// negative gap. With the vector r from the cylinder axis to a point of the
  /// surface and the outward normal n, the function tests if at some point the
  /// axis
  ///   was ahead (r . n < 0) and is behind (r . n > 0),
  /// and if the straight line between both vectors r, projected along the axis,
  /// comes closer to it than the radius. Sampled points are half a radius
  /// apart, but at least a fortieth of a facet. Both states must have the same
  /// facets. Returns false for a plane.
  bool
  passes_through(const SurfaceAndRoller &before, const SurfaceAndRoller &after);

  /// Returns true if one of two bodies passed through the other between two
  /// equilibrium states. This is so if a surface node that was outside the
  /// other body, or overlapped by at most the element depth, now overlaps by
  /// more, so that pairing ignores it (exceeds_cell_depth()). A node that moved
  /// around a body end also counts if it has a projection in both states.
  bool
  passes_through(const ContactSides &before, const ContactSides &after);

  /// Returns true if the motion between the states reaches the smallest element
  /// depth, so that passes_through() must be called.
  bool
  may_pass_through(const ContactSides &before, const ContactSides &after);
} // namespace lamella

#endif
