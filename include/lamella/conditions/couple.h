// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_couple_h
#define lamella_conditions_couple_h

#include <lamella/conditions/load.h>

#include <array>
#include <vector>

namespace lamella
{
  /// A moment M on a surface, applied as tractions t(x) that are linear in x,
  ///   t(x) = theta x (x - c),   J theta = M,
  ///   J = integral of (r^2 1 - r r) dA,   r = x - c,
  /// with c the centroid of the surface. The resultant force of these tractions
  /// is zero, their moment is M, and their L2 norm is the smallest possible.
  class Couple
  {
  public:
    /// Constructs the couple of @p load on the surface @p region of @p body.
    /// Throws InputError if the body has no such surface.
    Couple(const Load &load, const Region &region, const Body &body);

    /// Returns the Gauss points of the surface with their areas. They integrate
    /// displacements times linear tractions exactly.
    const std::vector<SurfacePoint> &
    points() const
    {
      return all;
    }

    /// Returns the forces at points() moved to the positions @p x [force].
    std::vector<dealii::Tensor<1, 3>>
    forces(const std::vector<dealii::Point<3>> &x) const;

    /// Returns the derivative of forces() at the positions @p x in the
    /// direction of the displacements @p u of the points.
    std::vector<dealii::Tensor<1, 3>>
    change(const std::vector<dealii::Point<3>>     &x,
           const std::vector<dealii::Tensor<1, 3>> &u) const;

    /// Derivative of the forces of a couple by displacements u of its points.
    /// Its symmetric part, for virtual displacements v, is
    ///   df . v = -(spin(u) . stretch(v) + stretch(u) . spin(v)) / 2
    /// with two vectors linear in u. Entry [k][p] has the coefficients of u at
    /// point p in component k of the vector. The skew part is omitted: a moment
    /// of fixed direction is not conservative for spatial rotations.
    struct CoupleRotation
    {
      /// Mean rotation J^-1 integral of r x u dA of the surface, r = x - c.
      std::array<std::vector<dealii::Tensor<1, 3>>, 3> spin,
        /// Vector dJ theta, dJ the change of the tensor J (Couple) due to u:
        /// integral of 2 (r . u) theta - (r . theta) u
        /// - (u . theta) r dA.
        stretch;
    };
    /// Returns spin and stretch for points() moved to the positions @p x.
    CoupleRotation
    rotation_of(const std::vector<dealii::Point<3>> &x) const;

    /// Returns the forces on the undeformed surface, for small displacements.
    PointForces
    dead_load() const;

  private:
    /// Centroid c, J^-1 and theta (see Couple) for points at their positions x.
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
