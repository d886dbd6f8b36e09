// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_obstacle_h
#define lamella_contact_obstacle_h

#include <lamella/base/linear_algebra.h>
#include <lamella/base/names.h>
#include <lamella/conditions/load_factor.h>

#include <deal.II/base/point.h>

#include <limits>
#include <optional>
#include <string>

namespace lamella
{
  /// A rigid obstacle, the second side of contacts: a floor (half space behind
  /// a plane) or a roller (infinite circular cylinder), in prescribed motion or
  /// pressed by a given force along a guide (GuidedObstacle).
  struct Obstacle
  {
    /// Shape of an obstacle; `undefined` until it is set.
    enum class Shape
    {
      undefined,
      plane,
      cylinder
    };

    /// Name in `subsection Obstacle NAME`, and in `Second` of contacts.
    std::string name;
    Shape       shape = Shape::undefined; ///< Plane or cylinder.
    /// Initial position of a point of the plane or of the cylinder axis.
    dealii::Point<3> point;
    /// Unit normal out of the half space, or direction of the cylinder axis.
    dealii::Tensor<1, 3> direction;
    /// Radius of the cylinder [length]; unused by a plane.
    double radius = 0.;
    /// Prescribed translation at load factor 1 [length], scene axes.
    dealii::Tensor<1, 3> displacement;
    /// Index of the load history of the displacement (LoadFactor::of()).
    unsigned int history = 0;

    /// Force at load factor 1 in place of `displacement` [force], scene axes;
    /// zero if the motion is prescribed.
    dealii::Tensor<1, 3> force = {};
    /// Index of the GuidedObstacle whose DoF is the displacement along `force`;
    /// empty if the motion is prescribed.
    std::optional<unsigned int> body = {};

    /// Returns the displacement [length] at load factor @p factor and, for an
    /// obstacle under a force, displacements @p u of all bodies. Without its
    /// block in @p u (temporary models), the obstacle is not displaced.
    dealii::Tensor<1, 3>
    displacement_at(const LoadFactor &factor, const BlockVector &u) const
    {
      dealii::Tensor<1, 3> moved = factor.of(history) * displacement;
      if (body && *body < u.n_blocks())
        moved += u.block(*body)[0] * guide();
      return moved;
    }

    /// Returns the unit vector along `force`.
    dealii::Tensor<1, 3>
    guide() const
    {
      return force / force.norm();
    }

    /// Returns true if the obstacle never moves.
    bool
    is_fixed() const
    {
      return displacement.norm() == 0. && !body;
    }

    /// Returns the largest depth at which the nearest surface point is unique:
    /// the radius of a cylinder, infinity for a plane.
    double
    depth() const
    {
      return shape == Shape::plane ? std::numeric_limits<double>::infinity() :
                                     radius;
    }

    /// Returns the component of @p v normal to the cylinder axis.
    dealii::Tensor<1, 3>
    across_axis(const dealii::Tensor<1, 3> &v) const
    {
      return v - (v * direction) * direction;
    }
  };

  /// Names of the shapes of obstacles in parameter files.
  template <>
  struct Names<Obstacle::Shape>
  {
    static constexpr NameOf<Obstacle::Shape> all[] = {
      {Obstacle::Shape::plane, "plane"},
      {Obstacle::Shape::cylinder, "cylinder"}}; ///< Value and name.
  };

  /// Intersection of a line with a surface.
  struct Hit
  {
    dealii::Point<3>     position; ///< Position, scene axes.
    dealii::Tensor<1, 3> normal;   ///< Outward unit normal of the surface.
    /// Distance along the line [length], negative against its direction: a gap.
    double distance = 0.;
  };

  /// Returns the nearest intersection, in either direction, of the line x + t
  /// d, with unit vector d, and the surface of the undisplaced @p obstacle, at
  /// which the line enters the obstacle against its outward normal:
  ///   plane:     t = (p - x) . N / (d . N),
  ///   cylinder:  |r + t e| = R, the smaller root t,
  /// with point p, direction N and radius R of the obstacle, and the components
  /// r and e of x - p and d normal to the axis. The result is empty if the line
  /// is parallel to the surface, leaves the half space, or misses the cylinder.
  std::optional<Hit>
  meet(const Obstacle             &obstacle,
       const dealii::Point<3>     &x,
       const dealii::Tensor<1, 3> &d);

  /// Returns true if @p x is inside the undisplaced @p obstacle.
  bool
  contains(const Obstacle &obstacle, const dealii::Point<3> &x);
} // namespace lamella

#endif
