// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/body/beam_transfer.h>
#include <lamella/linear/dense_cholesky.h>

#include <algorithm>
#include <map>
#include <memory>

namespace lamella
{
  namespace
  {
    /// The amplitudes of the section's fields at a point of the axis.
    std::vector<double>
    amplitudes(const Beam &beam, const AxisPoint &point, const Vector &u)
    {
      std::vector<double> sum(beam.fields().n_fields(), 0.);
      const auto         &nodes = beam.axis().nodes_of_cell(point.cell);
      for (unsigned int i = 0; i < nodes.size(); ++i)
        {
          const auto    &list  = beam.dofs().fields(nodes[i]);
          const DofIndex first = beam.dofs().first(nodes[i]);
          for (unsigned int k = 0; k < list.size(); ++k)
            sum[list[k]] += point.N[i] * u[first + k];
        }
      beam.fields().expand(sum);
      return sum;
    }



    /// What turns amplitudes of the section's fields into those of a list.
    class ListProjection
    {
    public:
      ListProjection(const SectionSpace              &space,
                     const std::vector<unsigned int> &list)
        : list(list)
      {
        if (list.back() < space.first_mode())
          return;
        for (const unsigned int field : list)
          {
            columns.push_back(space.in_section_functions(field));
            sizes.push_back(columns.back().l2_norm());
            columns.back() /= sizes.back();
          }
        const unsigned int  n = columns.size();
        std::vector<double> products(n * n);
        for (unsigned int j = 0; j < n; ++j)
          for (unsigned int i = j; i < n; ++i)
            products[j * n + i] = columns[i] * columns[j];
        factor = std::make_unique<DenseCholesky>(std::move(products),
                                                 n,
                                                 "the fields of a node");
      }

      std::vector<double>
      operator()(const std::vector<double> &amplitudes) const
      {
        std::vector<double> result;
        if (columns.empty())
          for (const unsigned int field : list)
            result.push_back(amplitudes[field]);
        else
          {
            const Vector all(amplitudes.begin(), amplitudes.end());
            for (const Vector &column : columns)
              result.push_back(column * all);
            factor->solve(result);
            for (unsigned int k = 0; k < result.size(); ++k)
              result[k] /= sizes[k];
          }
        return result;
      }

    private:
      std::vector<unsigned int> list;
      /// Of unit norm, and the norms they had.
      std::vector<Vector>            columns;
      std::vector<double>            sizes;
      std::unique_ptr<DenseCholesky> factor;
    };
  } // namespace



  Vector
  transferred(const Beam &from, const Vector &u, const Beam &to)
  {
    Vector                                              result(to.n_dofs());
    std::map<std::vector<unsigned int>, ListProjection> projections;
    const double                                        tolerance =
      arithmetic::same_position_along * from.axis().length();
    for (unsigned int node = 0; node < to.axis().n_nodes(); ++node)
      {
        const auto &list = to.dofs().fields(node);
        const auto  projection =
          projections.try_emplace(list, to.fields(), list).first;
        const auto [cell, eta] =
          from.axis().locate(to.axis().nodes()[node], tolerance).front();
        const std::vector<double> values = projection->second(
          amplitudes(from, from.axis().evaluate(cell, eta), u));
        std::copy(values.begin(),
                  values.end(),
                  result.begin() + to.dofs().first(node));
      }
    return result;
  }
} // namespace lamella
