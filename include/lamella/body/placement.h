// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_placement_h
#define lamella_body_placement_h

#include <lamella/material/elasticity.h>

#include <deal.II/base/point.h>

namespace lamella
{
  /// Position and orientation of a body in the scene: the origin o of its
  /// section at y = 0, and the rotation R. Rows of R are the body axes x
  /// (across), y (along the beam), z (up) in scene components. A scene point X
  /// has body coordinates x_body; a scene vector v has body components v_body:
  ///   x_body = R (X - o),   X = o + R^T x_body,   v_body = R v.
  struct Placement
  {
    /// Scene position of the section's lower left corner, or of the origin of
    /// its mesh file, at the start of the axis.
    dealii::Point<3> origin;
    /// Rotation matrix R; its rows are the body axes. The identity by default.
    Triad axes = unit_triad();

    /// Returns the placement with y along @p axis and z as near to @p up as
    /// possible:
    ///   x = axis x up / |axis x up|,   y = axis / |axis|,   z = x x y.
    /// Throws InputError if axis and up are parallel (sine below 1e-6) or zero.
    static Placement
    from_directions(const dealii::Point<3>     &origin,
                    const dealii::Tensor<1, 3> &axis,
                    const dealii::Tensor<1, 3> &up);

    /// Returns the body coordinates of the scene point @p x.
    dealii::Point<3>
    to_body(const dealii::Point<3> &x) const
    {
      return dealii::Point<3>(axes * (x - origin));
    }

    /// Returns the scene coordinates of the point @p x in body axes.
    dealii::Point<3>
    to_scene(const dealii::Point<3> &x) const
    {
      return origin + vector_to_scene(x);
    }

    /// Returns the scene components of a vector given in body axes.
    dealii::Tensor<1, 3>
    vector_to_scene(const dealii::Tensor<1, 3> &v) const
    {
      return transpose(axes) * v;
    }

    /// Returns the body components of a vector given in scene axes.
    dealii::Tensor<1, 3>
    vector_to_body(const dealii::Tensor<1, 3> &v) const
    {
      return axes * v;
    }

    /// Returns the rotation matrix @p R, given in body axes, in scene axes.
    Triad
    rotation_in_scene(const Triad &R) const
    {
      return transpose(axes) * R * axes;
    }

    /// Returns the matrix T that transforms strains (xx, yy, zz, engineering
    /// shears xy, xz, yz) from body to scene axes. Stresses need T^-T.
    ElasticTensor
    strain_to_scene() const
    {
      return strain_rotation(transpose(axes));
    }
  };
} // namespace lamella

#endif
