// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_surface_node_h
#define lamella_body_surface_node_h

#include <lamella/body/body.h>

namespace lamella
{
  /// A node of a surface during the loop over facets in Body::surface_points():
  /// the sums A = int N dA, n ~ int N n dA, and the flag of a corner.
  class SurfaceNode
  {
  public:
    /// Sets the place from @p at, the point of one of the facets.
    void
    meet(const SurfacePoint &at);

    /// Adds @p share of an area [length^2] whose normal is @p normal.
    void
    add(const double share, const dealii::Tensor<1, 3> &normal)
    {
      area += share;
      weighted += share * normal;
    }

    /// Removes the node, which hangs between two ends, and adds half to each.
    void
    distribute_to_ends(SurfaceNode &one_end, SurfaceNode &other_end);

    /// Returns true if a facet has been met.
    bool
    has_point() const
    {
      return met;
    }

    /// Returns the point with its area and mean normal. Requires has_point().
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
