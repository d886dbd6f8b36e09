// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_obstacle_h
#define lamella_contact_obstacle_h

#include <lamella/base/names.h>
#include <lamella/conditions/load_factor.h>

#include <deal.II/base/point.h>

#include <limits>
#include <optional>
#include <string>

namespace lamella
{
  /**
   * A rigid body of a simple shape that others may touch: a floor (the half
   * space behind a plane) or a roller (a circular cylinder without ends). It
   * has no DoFs; its motion is prescribed.
   *
   * Contact treats it as the second side: it carries no points and no weights,
   * and a row against it has the body's part alone. A pure description, which a
   * scene makes and the contacts on it share.
   */
  struct Obstacle
  {
    /// `undefined` fails an assertion in meet().
    enum class Shape
    {
      undefined,
      plane,
      cylinder
    };

    /// As in `subsection Obstacle NAME`, and in the `Second` of contacts.
    std::string name;
    Shape       shape = Shape::undefined;
    /// A point of the plane, or of the cylinder's axis. Before it moves; scene
    /// axes.
    dealii::Point<3> point;
    /// The unit normal that points away from the half space, or the unit
    /// direction of the cylinder's axis.
    dealii::Tensor<1, 3> direction;
    /// Of the cylinder [length]; unused by a plane.
    double radius = 0.;
    /// The prescribed translation at load factor 1 [length], scene axes.
    dealii::Tensor<1, 3> displacement;
    /// Of its load factors (LoadFactor::of()).
    unsigned int history = 0;

    /// That at load factor @p factor.
    dealii::Tensor<1, 3>
    displacement_at(const LoadFactor &factor) const
    {
      return factor.of(history) * displacement;
    }

    /// How deep places may be in it that the same surface is nearest to.
    /// [length]; infinity behind a plane.
    double
    depth() const
    {
      return shape == Shape::plane ? std::numeric_limits<double>::infinity() :
                                     radius;
    }

    /// What @p v has across the cylinder's axis.
    dealii::Tensor<1, 3>
    across_axis(const dealii::Tensor<1, 3> &v) const
    {
      return v - (v * direction) * direction;
    }
  };

  template <>
  struct Names<Obstacle::Shape>
  {
    static constexpr NameOf<Obstacle::Shape> all[] = {
      {Obstacle::Shape::plane, "plane"},
      {Obstacle::Shape::cylinder, "cylinder"}};
  };

  /// Where a ray meets a surface, with the surface's outward unit normal there.
  struct Hit
  {
    dealii::Point<3>     position;
    dealii::Tensor<1, 3> normal;
    /// Along the ray [length], negative behind its origin: the gap, if the ray
    /// starts at X_1 along n.
    double distance = 0.;
  };

  /**
   * The place nearest to @p x, ahead or behind, where the line x + t d, d a
   * unit vector, meets the surface of @p obstacle with d against its outward
   * normal,
   *   plane:     t = (p - x) . N / (d . N),
   *   cylinder:  |r + t e| = R, the smaller root t,
   * with p, N, R the obstacle's point, direction and radius and r, e what x - p
   * and d have across the axis. So a line enters the obstacle there and never
   * leaves it.
   *
   * Nothing where the line runs along the plane or the axis, leads out of the
   * half space, or passes the cylinder by. The obstacle is where it stands
   * before it moves.
   */
  std::optional<Hit>
  meet(const Obstacle             &obstacle,
       const dealii::Point<3>     &x,
       const dealii::Tensor<1, 3> &d);

  /// Whether @p x lies inside of @p obstacle, not on its surface, before it
  /// moves.
  bool
  contains(const Obstacle &obstacle, const dealii::Point<3> &x);
} // namespace lamella

#endif
