// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/body/beam_surplus.h>
#include <lamella/linear/dense_factors.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace lamella
{
  bool
  BeamSurplus::is_possible(const Beam &beam)
  {
    if (!HierarchicalSurplus::is_possible(beam.section()) ||
        beam.fields().n_modes() > 0)
      return false;
    for (unsigned int node = 0; node < beam.axis().n_nodes(); ++node)
      if (beam.dofs().fields(node).size() != beam.section().n_fields())
        return false;
    return true;
  }



  BeamSurplus::BeamSurplus(const Beam &beam)
    : beam(beam)
    , of_section(beam.section())
  {}



  Vector
  BeamSurplus::in_section(const Vector &u, const unsigned int q) const
  {
    const unsigned int n = beam.section().n_fields();
    Vector             result(u.size()), c(n);
    for (unsigned int node = 0; node < beam.axis().n_nodes(); ++node)
      {
        const DofIndex first = beam.dofs().first(node);
        for (unsigned int k = 0; k < n; ++k)
          c[k] = u[first + k];
        of_section.remove_lower_degree(q, c);
        for (unsigned int k = 0; k < n; ++k)
          result[first + k] = c[k];
      }
    return result;
  }



  void
  BeamSurplus::subtract_interpolation(const AxisSpan &span,
                                      const Vector   &u,
                                      Vector         &result) const
  {
    const GaussLobattoBasis &basis = GaussLobattoBasis::of_degree(span.degree);
    const Axis              &axis  = beam.axis();
    const unsigned int       n     = beam.section().n_fields();
    const double             size  = span.end - span.begin,
                 near              = arithmetic::same_in_element * size;
    // The fields of u at the points of the span.
    std::vector<Vector> at_points(basis.size(), Vector(n));
    for (unsigned int m = 0; m < basis.size(); ++m)
      {
        const auto [cell, place] =
          axis.locate(span.begin + basis.point(m) * size, near).front();
        const AxisPoint point = axis.evaluate(cell, place);
        for (unsigned int j = 0; j < point.N.size(); ++j)
          for (unsigned int k = 0; k < n; ++k)
            at_points[m][k] +=
              point.N[j] *
              u[beam.dofs().first(axis.nodes_of_cell(cell)[j]) + k];
      }
    std::vector<double> weights(basis.size());
    for (unsigned int node = 0; node < axis.n_nodes(); ++node)
      {
        const double y = axis.nodes()[node];
        // At its ends nothing is left.
        if (y > span.begin + near && y < span.end - near)
          {
            basis.evaluate((y - span.begin) / size, weights.data(), nullptr);
            for (unsigned int m = 0; m < basis.size(); ++m)
              for (unsigned int k = 0; k < n; ++k)
                result[beam.dofs().first(node) + k] -=
                  weights[m] * at_points[m][k];
          }
      }
  }



  Vector
  BeamSurplus::along_axis(const Vector                &u,
                          const std::vector<AxisSpan> &spans) const
  {
    const Axis        &axis = beam.axis();
    const unsigned int n    = beam.section().n_fields();
    Vector             result(u);
    for (const AxisSpan &span : spans)
      subtract_interpolation(span, u, result);
    // Ends of spans are nodes of both axes: what is there is kept whole.
    const double near = arithmetic::same_position * axis.length();
    const auto   ends = [&](const double y) {
      return std::any_of(spans.begin(), spans.end(), [&](const auto &span) {
        return std::abs(y - span.begin) < near || std::abs(y - span.end) < near;
      });
    };
    for (unsigned int node = 0; node < axis.n_nodes(); ++node)
      if (ends(axis.nodes()[node]))
        for (unsigned int k = 0; k < n; ++k)
          result[beam.dofs().first(node) + k] = 0.;
    return result;
  }



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
