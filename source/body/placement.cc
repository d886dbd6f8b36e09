// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/body/placement.h>

namespace lamella
{
  using namespace dealii;

  Placement
  Placement::from_directions(const Point<3>     &origin,
                             const Tensor<1, 3> &axis,
                             const Tensor<1, 3> &up)
  {
    const Tensor<1, 3> across = cross_product_3d(axis, up);
    if (!(across.norm() > arithmetic::parallel_sine * axis.norm() * up.norm()))
      throw InputError(
        "Placement",
        "",
        "body.placement-degenerate: Axis and Up must be neither zero nor "
        "parallel, since they define the directions x and z of the section",
        "Choose Up perpendicular to Axis, as in 0, 0, 1 for Axis = 0, 1, 0.");
    Placement placement;
    placement.origin  = origin;
    placement.axes[0] = across / across.norm();
    placement.axes[1] = axis / axis.norm();
    placement.axes[2] = cross_product_3d(placement.axes[0], placement.axes[1]);
    return placement;
  }
} // namespace lamella
