// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_current_points_h
#define lamella_conditions_current_points_h

#include <lamella/body/body.h>

#include <vector>

namespace lamella
{
  /// Material points of a body at any displacement u (vector of DoFs). Forces
  /// F_k at the points have the generalized forces
  ///   f(u) = sum over k of R_k(u)^T F_k,
  /// where the three rows of R_k give the displacement of point k per change of
  /// the DoFs (Body::rows()). The body must outlive this object.
  class CurrentPoints
  {
  public:
    /// Constructs the points at @p locations of @p body.
    CurrentPoints(const Body &body, std::vector<Location> locations);

    /// Returns the derivatives R_k(u) of displacements, three rows per point.
    std::vector<std::vector<LinearFunctional>>
    rows(const Vector &u) const;

    /// Returns the displacements of the points, scene axes [length].
    std::vector<dealii::Tensor<1, 3>>
    displacements(const Vector &u) const;

    /// Adds the generalized forces of the point @p forces at @p u to f.
    void
    add_forces(const std::vector<dealii::Tensor<1, 3>> &forces,
               const Vector                            &u,
               Vector                                  &f) const;

    /// Returns the displacements of the points due to the DoF increment @p w.
    std::vector<dealii::Tensor<1, 3>>
    changes(const Vector &u, const Vector &w) const;

    /// Adds @p factor times the derivative of add_forces() at @p u in the
    /// direction @p w to f, for constant @p forces: this process's share.
    void
    add_rotated_forces(const std::vector<dealii::Tensor<1, 3>> &forces,
                       const double                             factor,
                       const Vector                            &u,
                       const Vector                            &w,
                       Vector                                  &f) const;

    /// Calls @p use with the blocks of the matrix of add_rotated_forces().
    void
    for_each_rotation_block(const std::vector<dealii::Tensor<1, 3>> &forces,
                            const double                             factor,
                            const Vector                            &u,
                            const BlockCallback                     &use) const;

  private:
    const Body           &body;
    std::vector<Location> locations;
    /// Rows of bodies whose rows do not depend on u, else empty.
    std::vector<std::vector<LinearFunctional>> fixed;
  };
} // namespace lamella

#endif
