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
   */
  struct Placement
  {
    dealii::Point<3> origin;
    Triad            axes = unit_triad();

    /// y along @p axis, z as near to @p up as it goes, x = y x z. Throws
    /// InputError if the two are parallel or one is zero.
    static Placement
    from_directions(const dealii::Point<3>     &origin,
                    const dealii::Tensor<1, 3> &axis,
                    const dealii::Tensor<1, 3> &up);

    dealii::Point<3>
    to_body(const dealii::Point<3> &x) const
    {
      return dealii::Point<3>(axes * (x - origin));
    }

    dealii::Point<3>
    to_scene(const dealii::Point<3> &x) const
    {
      return origin + vector_to_scene(x);
    }

    dealii::Tensor<1, 3>
    vector_to_scene(const dealii::Tensor<1, 3> &v) const
    {
      return transpose(axes) * v;
    }

    dealii::Tensor<1, 3>
    vector_to_body(const dealii::Tensor<1, 3> &v) const
    {
      return axes * v;
    }

    /// T with strain(scene axes) = T strain(body axes).
    ElasticTensor
    strain_to_scene() const
    {
      return strain_rotation(transpose(axes));
    }
  };
} // namespace lamella

#endif
