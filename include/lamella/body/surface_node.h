// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_surface_node_h
#define lamella_body_surface_node_h

#include <lamella/body/body.h>

namespace lamella
{
  /// Computes the tributary area int N dA of a surface node with shape function
  /// N, and its mean normal along int N n dA, as sums over facets.
  class SurfaceNode
  {
  public:
    /// Sets the location of the node to that of @p at, a facet point at the
    /// node. Marks a corner if its facets' normals differ by 20 degrees or
    /// more.
    void
    meet(const SurfacePoint &at);

    /// Adds the area @p share [length^2] of a facet with the normal @p normal.
    void
    add(const double share, const dealii::Tensor<1, 3> &normal)
    {
      area += share;
      weighted += share * normal;
    }

    /// Distributes the area of this hanging node to the two nodes that
    /// constrain it, half to each; has_point() is false afterwards.
    void
    distribute_to_ends(SurfaceNode &one_end, SurfaceNode &other_end);

    /// Returns true if the node has a location, set by meet().
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
