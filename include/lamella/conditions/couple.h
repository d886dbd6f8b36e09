// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_couple_h
#define lamella_conditions_couple_h

#include <lamella/conditions/load.h>

#include <array>
#include <vector>

namespace lamella
{
  /// A moment M on a surface, applied as tractions that are linear over it,
  ///   t(x) = theta x (x - c),   J theta = M,
  ///   J = integral of (r^2 1 - r r) dA,   r = x - c,
  /// with c the surface's center of area, by Gauss points. These tractions have
  /// the moment M, no force, and least squares among those which have.
  class Couple
  {
  public:
    /// Constructs the couple of @p load. Throws InputError without the surface.
    Couple(const Load &load, const Region &region, const Body &body);

    /// Returns points with areas, exact for trace functions times linear ones.
    const std::vector<SurfacePoint> &
    points() const
    {
      return all;
    }

    /// Returns t dA at the points moved to @p x, with unchanged areas [force].
    std::vector<dealii::Tensor<1, 3>>
    forces(const std::vector<dealii::Point<3>> &x) const;

    /// Returns the first-order change of the forces for displacements @p u.
    std::vector<dealii::Tensor<1, 3>>
    change(const std::vector<dealii::Point<3>>     &x,
           const std::vector<dealii::Tensor<1, 3>> &u) const;

    /// Two vectors that are linear in the displacements u of the points,
    ///   spin    = J^-1 integral of r x u dA,
    /// the rotation of the surface, and
    ///   stretch = dJ theta
    ///           = integral of 2 (r . u) theta - (r . theta) u
    ///             - (u . theta) r dA.
    /// The symmetric part of the derivative of the forces is
    ///   df . v = -(spin(u) . stretch(v) + stretch(u) . spin(v)) / 2.
    /// Entry [k][point] is the factor of the displacement of the point. The
    /// skew part belongs to a moment of fixed direction, which has a potential
    /// only in its plane.
    struct CoupleRotation
    {
      std::array<std::vector<dealii::Tensor<1, 3>>, 3> spin, stretch;
    };
    CoupleRotation
    rotation_of(const std::vector<dealii::Point<3>> &x) const;

    /// Returns the dead load on the undeformed surface.
    PointForces
    dead_load() const;

  private:
    /// Center, J^-1 and theta of the points moved to x.
    struct Place
    {
      dealii::Tensor<1, 3> center;
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
