// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_placement_h
#define lamella_body_placement_h

#include <lamella/material/elasticity.h>

#include <deal.II/base/point.h>

namespace lamella
{
  /**
   * Where a body stands in the scene: the scene's position of the lower left
   * corner of the section at the start of the axis, and the body's axes
   * x (across), y (along), z (up) as rows of unit vectors in the scene.
   *
   * A rigid change of axes, with R = axes (orthogonal, det R = 1) and o the
   * origin:
   *   x_body = R (X - o),   X = o + R^T x_body,   v_body = R v.
   * Beams and solids compute in their own axes, where the paper's Fig. 1 has
   * y along the beam; everything that leaves them is in the scene's. Lengths
   * are those of the scene either way.
   */
  struct Placement
  {
    /// Of a section that comes from a mesh file: where that file's own origin
    /// is at the start of the axis.
    dealii::Point<3> origin;
    /// By default those of the scene.
    Triad axes = unit_triad();

    /**
     * y along @p axis, z as near to @p up as it goes, x = y x z:
     *   x = axis x up / |axis x up|,   y = axis / |axis|,   z = x x y.
     * The lengths of the two directions do not matter. Throws InputError if
     * they are parallel (the sine between them below 1e-6) or one is zero.
     */
    static Placement
    from_directions(const dealii::Point<3>     &origin,
                    const dealii::Tensor<1, 3> &axis,
                    const dealii::Tensor<1, 3> &up);

    /// The point @p x of the scene in the body's axes.
    dealii::Point<3>
    to_body(const dealii::Point<3> &x) const
    {
      return dealii::Point<3>(axes * (x - origin));
    }

    /// The point @p x of the body's axes in the scene.
    dealii::Point<3>
    to_scene(const dealii::Point<3> &x) const
    {
      return origin + vector_to_scene(x);
    }

    /// The same of a direction, displacement or force, which turns but does not
    /// move.
    dealii::Tensor<1, 3>
    vector_to_scene(const dealii::Tensor<1, 3> &v) const
    {
      return transpose(axes) * v;
    }

    /// And back.
    dealii::Tensor<1, 3>
    vector_to_body(const dealii::Tensor<1, 3> &v) const
    {
      return axes * v;
    }

    /// The rotation @p R, of the body's axes, in those of the scene.
    Triad
    turn_in_scene(const Triad &R) const
    {
      return transpose(axes) * R * axes;
    }

    /// T with strain(scene axes) = T strain(body axes), order of Eq. 4 with
    /// engineering shear strains. Stresses take T^-T, as T is not orthogonal.
    ElasticTensor
    strain_to_scene() const
    {
      return strain_rotation(transpose(axes));
    }
  };
} // namespace lamella

#endif
