// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_moved_points_h
#define lamella_conditions_moved_points_h

#include <lamella/body/body.h>

#include <vector>

namespace lamella
{
  /**
   * Points of a body in any state u of it: where they are, and what forces
   * there do,
   *   f(u) = sum over k of R_k(u)^T F_k,   R_k the rows of point k at u
   * (Body::rows_at()). Rows that no state changes are made once. Refers to the
   * body.
   */
  class MovedPoints
  {
  public:
    MovedPoints(const Body &body, std::vector<Location> locations);

    /// R_k(u), three rows a point.
    std::vector<std::vector<Row>>
    rows(const Vector &u) const;

    /// By how much they have moved, scene axes [length].
    std::vector<dealii::Tensor<1, 3>>
    displacements(const Vector &u) const;

    /// f += what @p forces do at @p u.
    void
    add_forces(const std::vector<dealii::Tensor<1, 3>> &forces,
               const Vector                            &u,
               Vector                                  &f) const;

    /// Of each point the displacement that the change @p w of @p u makes.
    std::vector<dealii::Tensor<1, 3>>
    changes(const Vector &u, const Vector &w) const;

    /// f += @p factor times what @p forces, that stay as they are, do more
    /// where @p u changes by @p w: sum over k of dR_k^T F_k.
    void
    add_turned(const std::vector<dealii::Tensor<1, 3>> &forces,
               const double                             factor,
               const Vector                            &u,
               const Vector                            &w,
               Vector                                  &f) const;

    /// The same as blocks of a matrix.
    void
    for_each_turned_block(
      const std::vector<dealii::Tensor<1, 3>>           &forces,
      const double                                       factor,
      const Vector                                      &u,
      const std::function<void(const StiffnessBlock &)> &use) const;

  private:
    const Body                   &body;
    std::vector<Location>         locations;
    std::vector<std::vector<Row>> fixed;
  };
} // namespace lamella

#endif
