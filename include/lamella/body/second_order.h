// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_second_order_h
#define lamella_body_second_order_h

#include <lamella/base/linear_algebra.h>
#include <lamella/material/elasticity.h>

namespace lamella
{
  /**
   * Terms of second order in the strain of a body displaced by u, which the
   * linear strain (Eq. 5) neglects: the quadratic strain e_2 of rotations, the
   * stress that it causes, and the geometric stiffness of all stress.
   *
   * The stretch of a beam is that of a deflected line, equal all over a
   * section,
   *   e_2 = (w_x'^2 + w_z'^2) / 2 along the axis,
   * with the section means w of the transverse displacements. In a solid it is
   * Green's quadratic part of the skew part H_a of grad u,
   *   e_2 = H_a^T H_a / 2 = (|r|^2 1 - r r^T) / 2,   r = curl u / 2.
   * It is sampled at as many Gauss points along an element as the displacements
   * have degrees and interpolated, so that a displacement v can compensate it.
   *
   * With v in equilibrium under e_2 as under an initial strain,
   *   int (B w)^T C (B v + e_2) dV = 0 for all w that supports allow,
   * the membrane stress is s_m = C (B v + e_2): zero in a cantilever, and in a
   * strip between clamps the stress that carries it at large deflections.
   *
   * Geometric stiffness: with s = C (B u - epsilon_0) + s_m, epsilon_0 thermal,
   *   v . K_G w = int s_ij v_k,i w_k,j dV
   * of the stress field with all of the body's fields, as in a total Lagrangian
   * formulation (Crisfield, Non-linear Finite Element Analysis of Solids and
   * Structures 1, 5.1). It includes columns with shear, lateral-torsional
   * buckling, wrinkling of faces and buckling of walls, if the theory has the
   * stresses and mode shapes. Refers to the body. Collective.
   */
  class SecondOrder
  {
  public:
    virtual ~SecondOrder() = default;

    /// Subtracts the load that causes v, f -= int B^T C e_2 dV.
    virtual void
    add_load(Vector &f) const = 0;

    /// Stores the stress s for the solution @p v of add_load(). Returns the
    /// energy of s_m, int s_m . (B v + e_2) dV / 2.
    virtual double
    solve(const Vector &v) = 0;

    /// Adds K_G @p w to @p f. Call solve() first.
    virtual void
    add_geometric_forces(const Vector &w, Vector &f) const = 0;

    /// Returns the largest short_wave_ratio() of sampled points, after solve().
    virtual double
    largest_short_wave_ratio() const = 0;
  };

  /// Returns the largest -s_ii / G over the axes i, G the lower of the two
  /// shear moduli of C with that axis. Its inverse is the buckling factor of
  /// plane shear waves along i (Rosen's microbuckling of fibers, -s = G), the
  /// lowest mode of a homogeneous body. Zero without compression.
  double
  short_wave_ratio(const Voigt &stress, const ElasticTensor &C);
} // namespace lamella

#endif
