// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_follower_pressure_h
#define lamella_conditions_follower_pressure_h

#include <lamella/body/body.h>
#include <lamella/conditions/follower_load.h>
#include <lamella/conditions/load.h>

#include <deal.II/lac/full_matrix.h>

#include <map>
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

    /// Adds @p factor times the generalized forces of the point @p forces at @p
    /// u to f.
    void
    add_forces(const std::vector<dealii::Tensor<1, 3>> &forces,
               const double                             factor,
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

  /// Transforms linear and quadratic forms of the displacements u_k of points
  /// to forms of the DoFs of a body. Three functionals per point, one for each
  /// displacement component, express u_k by the DoFs.
  class RowTransformation
  {
  public:
    /// Constructs from the three functionals @p of_places[k] of each point k.
    explicit RowTransformation(
      std::vector<std::vector<LinearFunctional>> of_places)
      : rows(std::move(of_places))
    {
      for (const auto &of_place : rows)
        for (const LinearFunctional &row : of_place)
          for (const auto &[dof, weight] : row.entries())
            places.emplace(dof, 0);
      for (auto &[dof, place] : places)
        {
          place = block.rows.size();
          block.rows.push_back(dof);
        }
      block.columns        = block.rows;
      block.columns_ascend = true;
    }

    /// Returns the DoFs on which the points depend, without matrix values.
    const StiffnessBlock &
    pattern() const
    {
      return block;
    }

    /// Returns the matrix, in terms of DoFs, of a quadratic form of the u_k
    /// with matrix @p of_rows; its row 3 k + c belongs to component c of u_k.
    StiffnessBlock
    operator()(const dealii::FullMatrix<double> &of_rows) const
    {
      const unsigned int         n = block.rows.size(), m = of_rows.m();
      dealii::FullMatrix<double> to_rows(m, n), half(m, n), values(n, n);
      for (unsigned int i = 0; i < m; ++i)
        for (const auto &[dof, weight] : rows[i / 3][i % 3].entries())
          to_rows(i, places.at(dof)) += weight;
      of_rows.mmult(half, to_rows);
      to_rows.Tmmult(values, half);
      StiffnessBlock result = block;
      for (unsigned int i = 0; i < n; ++i)
        result.values.insert(result.values.end(),
                             values.begin(i),
                             values.end(i));
      return result;
    }

    /// Returns the coefficient of each DoF of pattern() in the linear form
    /// sum_k @p weights[k] . u_k of the point displacements u_k.
    std::vector<double>
    form(const std::vector<dealii::Tensor<1, 3>> &weights) const
    {
      std::vector<double> result(block.rows.size(), 0.);
      for (unsigned int p = 0; p < rows.size(); ++p)
        for (unsigned int c = 0; c < 3; ++c)
          for (const auto &[dof, weight] : rows[p][c].entries())
            result[places.at(dof)] += weights[p][c] * weight;
      return result;
    }

  private:
    const std::vector<std::vector<LinearFunctional>> rows;
    std::map<DofIndex, unsigned int>                 places;
    StiffnessBlock                                   block;
  };

  /// Returns a pressure that remains normal to the deformed surface, the one of
  /// @p load on @p region of @p body.
  std::unique_ptr<FollowerLoad>
  make_follower_pressure(const Load   &load,
                         const Region &region,
                         const Body   &body);
} // namespace lamella

#endif
