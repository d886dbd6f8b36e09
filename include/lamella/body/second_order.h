// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_second_order_h
#define lamella_body_second_order_h

#include <lamella/base/linear_algebra.h>
#include <lamella/material/elasticity.h>

namespace lamella
{
  /**
   * What the linear strain (Eq. 5) leaves out of a body that is displaced by u,
   * to the first order: the quadratic strain e_2 of its rotations, the stress
   * that this makes, and the forces of all stress on turned material.
   *
   * The stretch. Of a beam it is that of a line that deflects,
   *   e_2 = (w_x'^2 + w_z'^2) / 2 along the axis, the same all over a section,
   * with w the mean over the section of the two transverse displacements. Of a
   * solid it is
   *   e_2 = H_a^T H_a / 2 = (|r|^2 1 - r r^T) / 2,   r = curl u / 2,
   * Green's quadratic part of the skew part H_a of grad u. It is sampled at as
   * many Gauss points along an element as its displacements have degrees and
   * interpolated between them: there a displacement v can undo it, and does
   * where supports let it.
   *
   * The stress that stays. With v in equilibrium under e_2 as under heat,
   *   int (B w)^T C (B v + e_2) dV = 0 for all w that supports allow,
   * it is s_m = C (B v + e_2): none in a cantilever, and in a strip between
   * clamps what carries it at large deflections.
   *
   * Geometric stiffness: with s = C (B u - epsilon_0) + s_m, epsilon_0
   * thermal,
   *   v . K_G w = int s_ij v_k,i w_k,j dV
   * of the stress field with all of the body's fields, as in a total
   * Lagrangian formulation (Crisfield, Non-linear Finite Element Analysis of
   * Solids and Structures 1, 5.1). It includes columns with the shear of their
   * section and lateral-torsional buckling under loads at any height, if the
   * theory has the stress that carries them. It also includes wrinkling of
   * faces and buckling of walls, if the theory has their mode shapes.
   *
   * Refers to the body. All functions are collective.
   */
  class SecondOrder
  {
  public:
    virtual ~SecondOrder() = default;

    /// f -= int B^T C e_2 dV: the load that makes v.
    virtual void
    add_load(Vector &f) const = 0;

    /// Takes @p v as it came of that load and keeps the stress s. Returns
    /// int s_m . (B v + e_2) dV / 2, the energy of the stress that stays.
    virtual double
    settle(const Vector &v) = 0;

    /// f += K_G @p w, after settle().
    virtual void
    add_geometric_forces(const Vector &w, Vector &f) const = 0;

    /// Returns the largest short_wave_ratio() of the sampled points. Call
    /// settle() first.
    virtual double
    short_waves() const = 0;
  };

  /**
   * Returns the largest -s_ii / G over the axes i, where G is the lower of the
   * two shear moduli of C with that axis. Its inverse is the buckling factor of
   * plane shear waves along i in the material (Rosen's microbuckling of fibers,
   * -s = G). No mode of a homogeneous body has a lower one. Zero without
   * compression.
   */
  double
  short_wave_ratio(const Voigt &stress, const ElasticTensor &C);
} // namespace lamella

#endif
