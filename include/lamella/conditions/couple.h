// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_couple_h
#define lamella_conditions_couple_h

#include <lamella/conditions/load.h>

#include <array>
#include <vector>

namespace lamella
{
  /**
   * A moment M that acts on a surface as tractions that are linear over it,
   *   t(x) = theta x (x - c),   J theta = M,
   *   J = integral of (r^2 1 - r r) dA,   r = x - c,
   * c the surface's own centre of area, by Gauss points: those of least square
   * that have the moment M, and no force.
   */
  class Couple
  {
  public:
    /// @p load, which has a couple, on @p region of @p body. Throws InputError
    /// where the body has no such surface.
    Couple(const Load &load, const Region &region, const Body &body);

    /// The points with the areas that they carry, which integrate the trace
    /// functions of the surface times a linear function.
    const std::vector<SurfacePoint> &
    points() const
    {
      return all;
    }

    /// t dA of each of them where they have moved to @p x, their areas
    /// unchanged [force].
    std::vector<dealii::Tensor<1, 3>>
    forces(const std::vector<dealii::Point<3>> &x) const;

    /// By how much these forces change where the points at @p x move on by
    /// @p u, to the first order.
    std::vector<dealii::Tensor<1, 3>>
    change(const std::vector<dealii::Point<3>>     &x,
           const std::vector<dealii::Tensor<1, 3>> &u) const;

    /// Two vectors that are linear in the displacements u of the points,
    ///   spin    = J^-1 integral of r x u dA,
    /// by how much the surface turns, and
    ///   stretch = dJ theta
    ///           = integral of 2 (r . u) theta - (r . theta) u
    ///             - (u . theta) r dA.
    /// With them the symmetric part of the derivative of the forces is
    ///   df . v = -(spin(u) . stretch(v) + stretch(u) . spin(v)) / 2.
    /// Entry [k][point] is what the displacement of the point is multiplied by.
    /// (The other part is that of a moment whose direction is fixed, which has
    /// no potential but in its plane.)
    struct Turning
    {
      std::array<std::vector<dealii::Tensor<1, 3>>, 3> spin, stretch;
    };
    Turning
    turning(const std::vector<dealii::Point<3>> &x) const;

    /// The dead load, of the undeformed surface.
    PointForces
    dead() const;

  private:
    /// Where the points have moved to x: their centre, J^-1 and theta.
    struct Place
    {
      dealii::Tensor<1, 3> centre;
      dealii::Tensor<2, 3> inverse;
      dealii::Tensor<1, 3> theta;
    };
    Place
    place(const std::vector<dealii::Point<3>> &x) const;

    const dealii::Tensor<1, 3> moment;
    std::vector<SurfacePoint>  all;
  };
} // namespace lamella

#endif
