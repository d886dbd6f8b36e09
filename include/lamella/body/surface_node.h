// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_surface_node_h
#define lamella_body_surface_node_h

#include <lamella/body/body.h>

namespace lamella
{
  /**
   * A node of a surface while its facets are gone through: what they add up to,
   *   A = int N dA,   n ~ int N n dA,
   * and whether they meet at an angle there. How Body::surface_points() comes
   * about, of any body.
   */
  class SurfaceNode
  {
  public:
    /// Takes the place from one of the facets, whose own @p at is.
    void
    meet(const SurfacePoint &at);

    /// Adds @p share of an area [length^2] whose normal is @p normal.
    void
    add(const double share, const dealii::Tensor<1, 3> &normal)
    {
      area += share;
      weighted += share * normal;
    }

    /// Gives half of what it has to each of @p ends and is no node any more:
    /// one that hangs in their middle.
    void
    share_out(SurfaceNode &one_end, SurfaceNode &other_end);

    /// Whether a facet has been met.
    bool
    is_there() const
    {
      return met;
    }

    /// The point with its area and mean normal. is_there().
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
