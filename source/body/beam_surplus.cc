// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/body/beam_surplus.h>

namespace lamella
{
  bool
  BeamSurplus::is_possible(const Beam &beam)
  {
    if (!HierarchicalSurplus::is_possible(beam.section()) ||
        beam.fields().n_modes() > 0 || beam.axis().degree() < 2)
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
        of_section.keep_beyond(q, c);
        for (unsigned int k = 0; k < n; ++k)
          result[first + k] = c[k];
      }
    return result;
  }



  Vector
  BeamSurplus::along_axis(const Vector &u, const unsigned int q) const
  {
    const GaussLobattoBasis &basis = GaussLobattoBasis::of_degree(q);
    const Axis              &axis  = beam.axis();
    const unsigned int       n     = beam.section().n_fields();
    Vector                   result(u.size());
    std::vector<double>      weights(basis.size());
    for (unsigned int cell = 0; cell < axis.n_cells(); ++cell)
      {
        std::vector<AxisPoint> coarse;
        for (unsigned int m = 0; m < basis.size(); ++m)
          coarse.push_back(axis.evaluate(cell, basis.point(m)));
        const auto  &nodes = axis.nodes_of_cell(cell);
        const double begin = axis.cell_begin(cell),
                     size  = axis.cell_end(cell) - begin;
        // The first two are the ends, where nothing is left.
        for (unsigned int i = 2; i < nodes.size(); ++i)
          {
            basis.evaluate((axis.nodes()[nodes[i]] - begin) / size,
                           weights.data(),
                           nullptr);
            const DofIndex to = beam.dofs().first(nodes[i]);
            for (unsigned int k = 0; k < n; ++k)
              result[to + k] = u[to + k];
            for (unsigned int m = 0; m < basis.size(); ++m)
              for (unsigned int j = 0; j < nodes.size(); ++j)
                {
                  const double   weight = weights[m] * coarse[m].N[j];
                  const DofIndex from   = beam.dofs().first(nodes[j]);
                  for (unsigned int k = 0; k < n; ++k)
                    result[to + k] -= weight * u[from + k];
                }
          }
      }
    return result;
  }
} // namespace lamella
