// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/body/beam_surplus.h>

#include <algorithm>
#include <cmath>

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
} // namespace lamella
