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
  /// with the section means w of transverse displacements. In a solid it is the
  /// quadratic part of Green's strain for the skew part H_a of grad u,
  ///   e_2 = H_a^T H_a / 2 = (|r|^2 1 - r r^T) / 2,   r = curl u / 2.
  /// It is interpolated between as many Gauss points along an element as the
  /// degree of displacements, to avoid locking.
  ///
  /// The displacement v of the body under e_2 as initial strain, from
  ///   int (B w)^T C (B v + e_2) dV = 0 for all w that supports allow,
  /// gives the membrane stress s_m = C (B v + e_2), zero in a cantilever.
  ///
  /// The geometric stiffness of s = C (B u - epsilon_0) + s_m, with the thermal
  /// strain epsilon_0, is
  ///   v . K_G w = int s_ij v_k,i w_k,j dV
  /// as in a total Lagrangian formulation (Crisfield, Non-linear Finite Element
  /// Analysis of Solids and Structures 1, 5.1). It includes buckling of columns
  /// with shear, lateral-torsional buckling, wrinkling of faces and buckling of
  /// walls, if the theory contains the mode shapes. Keeps a reference to the
  /// body. All functions are collective.
  class SecondOrder
  {
  public:
    virtual ~SecondOrder() = default;

    /// Subtracts the load for which v is the solution, f -= int B^T C e_2 dV.
    virtual void
    add_load(Vector &f) const = 0;

    /// Computes the stress s from the solution @p v for the load of add_load().
    /// Returns the membrane energy int s_m . (B v + e_2) dV / 2.
    virtual double
    solve(const Vector &v) = 0;

    /// Adds K_G @p w to @p f, with the stress s computed by solve().
    virtual void
    add_geometric_forces(const Vector &w, Vector &f) const = 0;

    /// Returns the largest short_wave_ratio() of the stress s from solve().
    virtual double
    largest_short_wave_ratio() const = 0;
  };

  /// Returns the largest -s_ii / G over the axes i, with G the lower of the two
  /// shear moduli of @p C that involve axis i. Its inverse is the load factor
  /// of shear microbuckling (Rosen, -s = G), the shortest mode of a homogeneous
  /// body. Zero without compression.
  double
  short_wave_ratio(const Voigt &stress, const ElasticTensor &C);
} // namespace lamella

#endif
