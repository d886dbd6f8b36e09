// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_obstacle_h
#define lamella_contact_obstacle_h

#include <deal.II/base/point.h>

#include <optional>
#include <string>

namespace lamella
{
  /**
   * A rigid body of a simple shape that others may touch: a floor (the half
   * space behind a plane) or a roller (a circular cylinder without ends). It
   * has no DoFs; its motion is prescribed.
   */
  struct Obstacle
  {
    enum class Shape
    {
      undefined,
      plane,
      cylinder
    };

    std::string name;
    Shape       shape = Shape::undefined;
    /// A point of the plane, or of the cylinder's axis.
    dealii::Point<3> point;
    /// The unit normal that points away from the half space, or the unit
    /// direction of the cylinder's axis.
    dealii::Tensor<1, 3> direction;
    double               radius = 0.;
    /// At load factor 1.
    dealii::Tensor<1, 3> displacement;
  };

  /// Where a ray meets a surface.
  struct Hit
  {
    dealii::Point<3>     position;
    dealii::Tensor<1, 3> normal;
    /// Along the ray, negative behind its origin.
    double distance = 0.;
  };

  /// The place nearest to @p x, ahead or behind, where the line x + t d, d a
  /// unit vector, meets the surface of @p obstacle with d against its outward
  /// normal.
  std::optional<Hit>
  meet(const Obstacle             &obstacle,
       const dealii::Point<3>     &x,
       const dealii::Tensor<1, 3> &d);

  /// Whether @p x is in @p obstacle.
  bool
  contains(const Obstacle &obstacle, const dealii::Point<3> &x);
} // namespace lamella

#endif
