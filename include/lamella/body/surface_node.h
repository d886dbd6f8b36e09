// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_surface_node_h
#define lamella_body_surface_node_h

#include <lamella/body/body.h>

namespace lamella
{
  /// Accumulates tributary area int N dA and mean normal, along int N n dA, of
  /// a surface node with shape function N over its facets.
  class SurfaceNode
  {
  public:
    /// Sets the location to that of @p at, a point of a facet at the node, and
    /// marks a corner if normals differ.
    void
    meet(const SurfacePoint &at);

    /// Adds the area @p share [length^2] with the normal @p normal.
    void
    add(const double share, const dealii::Tensor<1, 3> &normal)
    {
      area += share;
      weighted += share * normal;
    }

    /// Distributes the area of this hanging node to the two nodes that
    /// constrain it, half to each, and removes it.
    void
    distribute_to_ends(SurfaceNode &one_end, SurfaceNode &other_end);

    /// Returns true if meet() has been called.
    bool
    has_point() const
    {
      return met;
    }

    /// Returns the node with area and mean normal. Requires has_point().
    SurfacePoint
    finished() const;

  private:
    double               area = 0.;
    dealii::Tensor<1, 3> weighted;
    bool                 met = false;
    SurfacePoint         point;
  };
} // namespace lamella

#endif
