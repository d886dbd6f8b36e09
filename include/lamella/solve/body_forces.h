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
  /// A force and its moment about the scene origin, in scene components.
  struct Wrench
  {
    dealii::Tensor<1, 3> force, moment;
  };

  /// A force and its moment about a given point, in scene components.
  struct Resultant
  {
    dealii::Tensor<1, 3> force, moment;
    /// Reference point of the moment in the scene; not the point of action.
    dealii::Point<3> about;
    /// Point on the line of action nearest to `about`, if any.
    std::optional<dealii::Point<3>> center_of_pressure = {};
  };

  /// Sum of all forces on one body and of their moments about its center, for
  /// the check of equilibrium. Forces are obtained from their work on the rigid
  /// motions of the body. The sum is relative to the largest force.
  class BodyForces
  {
  public:
    /// Creates an empty sum for the body @p of with the displacements @p u.
    BodyForces(const Body &of, const Vector &u);

    /// Returns the force of a load, and its moment about the body center.
    /// @p work returns the work of the load on a given displacement vector.
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

    /// Returns @p about_center with the moment about the scene origin.
    Wrench
    about_origin(const Wrench &about_center) const;

    void
    add(const Wrench &about_center);

    /// Sets a lower bound @p force of the largest force in unbalanced().
    void
    at_least(const double force);

    /// Returns the norms of summed force and moment, over the largest force and
    /// that force times the body size.
    std::pair<double, double>
    unbalanced() const;

    const Body &body;

  private:
    std::vector<Vector> rigid;
    double              size;
    Wrench              sum;
    double              largest = 0.;
  };
} // namespace lamella

#endif
