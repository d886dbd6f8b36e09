// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_second_order_h
#define lamella_body_second_order_h

#include <lamella/base/linear_algebra.h>
#include <lamella/material/elasticity.h>

namespace lamella
{
  /// Second-order effects at a displacement u of a body, which the linear
  /// theory neglects: the quadratic strain e_2 due to rotations, the membrane
  /// stress that it causes, and the geometric stiffness K_G (for buckling).
  ///
  /// In a beam, e_2 is the stretch of the deflected axis,
  ///   e_2 = (w_x'^2 + w_z'^2) / 2 along the axis,
  /// with the section means w of transverse displacements. In a solid, it is
  /// the quadratic part of Green's strain for the skew part H_a of grad u,
  ///   e_2 = H_a^T H_a / 2 = (|r|^2 1 - r r^T) / 2,   r = curl u / 2.
  /// To avoid locking, e_2 is interpolated between p Gauss points along an
  /// element of degree p. The displacement v under the initial strain e_2, from
  ///   int (B w)^T C (B v + e_2) dV = 0 for all w that supports allow,
  /// gives the membrane stress s_m = C (B v + e_2), zero in a cantilever. The
  /// geometric stiffness of s = C (B u - epsilon_0) + s_m, with the thermal
  /// strain epsilon_0, is
  ///   v . K_G w = int s_ij v_k,i w_k,j dV
  /// (Crisfield, Non-linear Finite Element Analysis of Solids and Structures 1,
  /// 5.1). It includes buckling of columns with shear, lateral-torsional
  /// buckling, wrinkling of faces and buckling of walls, if the theory has the
  /// mode shapes. This class is that of a rigid body, without effects. The body
  /// must outlive this object. All functions are collective.
  class SecondOrder
  {
  public:
    virtual ~SecondOrder() = default;

    /// Subtracts the load of the quadratic strain e_2, f -= int B^T C e_2 dV.
    virtual void
    add_load(Vector & /*f*/) const
    {}

    /// Computes the total stress; @p v is the displacement due to add_load().
    /// Returns the strain energy of the membrane stress.
    virtual double
    solve(const Vector & /*v*/)
    {
      return 0.;
    }

    /// Adds the geometric stiffness K_G times @p w to @p f, after solve().
    virtual void
    add_geometric_forces(const Vector & /*w*/, Vector & /*f*/) const
    {}

    /// Returns the largest short_wave_ratio() in the body, after solve().
    virtual double
    largest_short_wave_ratio() const
    {
      return 0.;
    }
  };

  /// Returns the largest ratio, over the axes x, y and z, of the compressive
  /// stress along the axis to the lower shear modulus (from @p C) of the two
  /// planes that contain it; 0 without compression. Its inverse is the load
  /// factor of shear microbuckling (Rosen), the shortest buckling mode.
  double
  short_wave_ratio(const Voigt &stress, const ElasticTensor &C);
} // namespace lamella

#endif
