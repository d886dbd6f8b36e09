// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/contact/constraint_geometry.h>

#include <algorithm>

namespace lamella
{
  namespace
  {
    /// Adds up rows of one body.
    class RowSum
    {
    public:
      explicit RowSum(const DofIndex n_dofs)
        : weights(n_dofs, 0.)
        , is_touched(n_dofs, false)
      {}

      void
      add(const LinearFunctional &row, const double factor)
      {
        for (const auto &[dof, weight] : row.entries())
          {
            if (!is_touched[dof])
              touched.push_back(dof);
            is_touched[dof] = true;
            weights[dof] += factor * weight;
          }
      }

      /// The sum; it begins anew.
      LinearFunctional
      take()
      {
        std::sort(touched.begin(), touched.end());
        LinearFunctional row;
        for (const DofIndex dof : touched)
          {
            row.add(dof, weights[dof]);
            weights[dof]    = 0.;
            is_touched[dof] = false;
          }
        touched.clear();
        return row;
      }

    private:
      std::vector<double>   weights;
      std::vector<bool>     is_touched;
      std::vector<DofIndex> touched;
    };
  } // namespace



  std::vector<BodyFunctional>
  body_rows(const unsigned int                                index,
            const DofIndex                                    n_dofs,
            const std::vector<std::vector<LinearFunctional>> &at,
            const ConstraintGeometry                         &side)
  {
    RowSum                      sum(n_dofs);
    std::vector<BodyFunctional> rows;
    for (const ConstraintGeometry::Weights &weights : side.weights)
      {
        for (const auto &[k, w] : weights)
          for (unsigned int c = 0; c < 3; ++c)
            sum.add(at[k][c], w[c]);
        rows.push_back({index, sum.take()});
      }
    return rows;
  }
} // namespace lamella
