// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_body_forces_h
#define lamella_solve_body_forces_h

#include <lamella/body/body.h>

#include <deal.II/base/tensor.h>

#include <optional>
#include <utility>
#include <vector>

namespace lamella
{
  /// A force and its moment about the scene origin or another stated point.
  struct Wrench
  {
    dealii::Tensor<1, 3> force, ///< Force in scene components.
      moment;                   ///< Moment in scene components.
  };

  /// A force and its moment about a given point.
  struct Resultant
  {
    dealii::Tensor<1, 3> force, ///< Force in scene components.
      moment; ///< Moment about the point `about` in scene components.
    /// Reference point of the moment in the scene; not the point of action.
    dealii::Point<3> about;
    /// Point on the line of action nearest to `about`; empty without net force.
    std::optional<dealii::Point<3>> center_of_pressure = {};
  };

  /// Sum of all forces on one body and of their moments about its center, for
  /// the check of equilibrium. Each is computed as work on the rigid motions.
  class BodyForces
  {
  public:
    /// Creates an empty sum for the body @p of, displaced by @p u.
    BodyForces(const Body &of, const Vector &u);

    /// Returns the force of a load and its moment about the body center.
    /// @p work returns the work of the load on a displacement vector.
    template <typename Work>
    Wrench
    resultant_of_work(const Work &work) const
    {
      Wrench about_center;
      for (unsigned int c = 0; c < 3; ++c)
        {
          about_center.force[c]  = work(rigid[c]);
          about_center.moment[c] = work(rigid[3 + c]);
        }
      return about_center;
    }

    /// Converts the moment of @p about_center from body center to scene origin.
    Wrench
    about_origin(const Wrench &about_center) const;

    /// Adds a force and its moment about the body center to the sum.
    void
    add(const Wrench &about_center);

    /// Makes unbalanced() divide by a force of at least @p force.
    void
    at_least(const double force);

    /// Returns |sum of forces| / F and |sum of moments| / (F times the body
    /// size), where F is the largest added force (or moment over body size).
    std::pair<double, double>
    unbalanced() const;

    const Body &body; ///< Body on which the forces act.

  private:
    std::vector<Vector> rigid;
    double              size;
    Wrench              sum;
    double              largest = 0.;
  };
} // namespace lamella

#endif
