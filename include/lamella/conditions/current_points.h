// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_current_points_h
#define lamella_conditions_current_points_h

#include <lamella/body/body.h>

#include <vector>

namespace lamella
{
  /// Points of a body in any state u: displacements, and generalized forces
  ///   f(u) = sum over k of R_k(u)^T F_k,   R_k the rows of point k at u
  /// (Body::rows_at(), cached if constant). Keeps a reference to the body.
  class CurrentPoints
  {
  public:
    CurrentPoints(const Body &body, std::vector<Location> locations);

    /// Returns R_k(u), three rows per point.
    std::vector<std::vector<LinearFunctional>>
    rows(const Vector &u) const;

    /// Returns the displacements of the points, scene axes [length].
    std::vector<dealii::Tensor<1, 3>>
    displacements(const Vector &u) const;

    /// Adds the generalized forces of @p forces at @p u to f.
    void
    add_forces(const std::vector<dealii::Tensor<1, 3>> &forces,
               const Vector                            &u,
               Vector                                  &f) const;

    /// Returns the displacement of each point for the change @p w of @p u.
    std::vector<dealii::Tensor<1, 3>>
    changes(const Vector &u, const Vector &w) const;

    /// Adds @p factor sum_k dR_k^T F_k, for a change @p w of @p u, to f.
    void
    add_rotated_forces(const std::vector<dealii::Tensor<1, 3>> &forces,
                       const double                             factor,
                       const Vector                            &u,
                       const Vector                            &w,
                       Vector                                  &f) const;

    /// Calls @p use for the blocks of the matrix of add_rotated_forces().
    void
    for_each_rotation_block(
      const std::vector<dealii::Tensor<1, 3>>           &forces,
      const double                                       factor,
      const Vector                                      &u,
      const std::function<void(const StiffnessBlock &)> &use) const;

  private:
    const Body                                &body;
    std::vector<Location>                      locations;
    std::vector<std::vector<LinearFunctional>> fixed;
  };
} // namespace lamella

#endif
