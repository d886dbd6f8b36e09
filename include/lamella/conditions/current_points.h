// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_current_points_h
#define lamella_conditions_current_points_h

#include <lamella/body/body.h>

#include <vector>

namespace lamella
{
  /// Material points of a body at any displacement u (vector of DoFs). Forces
  /// F_k at the points have the generalized forces
  ///   f(u) = sum over k of R_k(u)^T F_k,   R_k the rows of point k at u
  /// where each row gives a displacement component per change of the DoFs
  /// (Body::rows_at()). Keeps a reference to the body, which must outlive this.
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

    /// Adds sum_k R_k(u)^T F_k with the @p forces F_k to f.
    void
    add_forces(const std::vector<dealii::Tensor<1, 3>> &forces,
               const Vector                            &u,
               Vector                                  &f) const;

    /// Returns R_k(u) w, the displacements due to the DoF increment @p w.
    std::vector<dealii::Tensor<1, 3>>
    changes(const Vector &u, const Vector &w) const;

    /// Adds @p factor sum_k dR_k^T F_k to f, with the @p forces F_k and the
    /// derivative dR_k of the rows R_k at @p u in the direction @p w.
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
