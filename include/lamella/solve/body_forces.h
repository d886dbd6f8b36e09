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
  /// A force and its moment about the origin of the scene, scene components.
  struct Wrench
  {
    dealii::Tensor<1, 3> force, moment;
  };

  /// A force and its moment about a given point, scene components.
  struct Resultant
  {
    dealii::Tensor<1, 3> force, moment;
    /// Reference point of the moment, in the scene; not the point of action.
    dealii::Point<3> about;
    /// The point on the line of action nearest to `about`, if any.
    std::optional<dealii::Point<3>> center_of_pressure = {};
  };

  /// Sum of all forces on one body with their moments about its center, and the
  /// largest single force, or couple over the size of the body, from the work
  /// of the forces on the rigid motions.
  class BodyForces
  {
  public:
    /// Creates an empty sum for the body @p of, displaced by @p u.
    BodyForces(const Body &of, const Vector &u);

    /// Returns the force, and moment about the center, of the load that does
    /// the work work(m) on a motion m of the DoFs.
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

    /// Returns @p about_center with its moment about the origin of the scene.
    Wrench
    about_origin(const Wrench &about_center) const;

    void
    add(const Wrench &about_center);

    /// Sets a lower bound of the force by which unbalanced() divides.
    void
    at_least(const double force);

    /// Returns the summed force and moment relative to the largest force.
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
