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
  /// A force and its moment about the scene's origin, scene components.
  struct Wrench
  {
    dealii::Tensor<1, 3> force, moment;
  };

  /// A wrench: a force and its moment about a point, scene components.
  struct Resultant
  {
    dealii::Tensor<1, 3> force, moment;
    /// The point, in the scene; not where the force acts.
    dealii::Point<3> about;
    /// Where it acts: of its line of action the point nearest to `about`. None
    /// without a force, or with one that is rounding beside the moment.
    std::optional<dealii::Point<3>> centre_of_pressure = {};
  };

  /**
   * All forces on one body, summed, with their moments about its centre, and
   * the largest single one of them: a force, or a couple over the size of the
   * body. What a force does as a whole is its work on the rigid motions of the
   * body, which is what the body's theory feels of it.
   */
  class BodyForces
  {
  public:
    /// On @p of where @p u has moved it (Body::rigid_motions_at()).
    BodyForces(const Body &of, const Vector &u);

    /// Force and moment about the body's centre of what does the work
    /// work(m) on a motion m of its degrees of freedom.
    template <typename Work>
    Wrench
    felt(const Work &work) const
    {
      Wrench about_centre;
      for (unsigned int c = 0; c < 3; ++c)
        {
          about_centre.force[c]  = work(rigid[c]);
          about_centre.moment[c] = work(rigid[3 + c]);
        }
      return about_centre;
    }

    /// The same, its moment about the scene's origin.
    Wrench
    at_origin(const Wrench &about_centre) const;

    void
    add(const Wrench &about_centre);

    /// Forces are compared with no less than that.
    void
    at_least(const double force);

    /// What is left of forces and of moments, as shares of the largest.
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
