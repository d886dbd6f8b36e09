// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/body/body.h>

#include <deal.II/base/quadrature_lib.h>

namespace lamella
{
  using namespace dealii;

  Body::Body(std::string name)
    : body_name(std::move(name))
  {}



  Body::~Body() = default;



  std::vector<Point<3>>
  Body::line_points(const Point<3> &a, const Point<3> &b) const
  {
    const QGaussLobatto<1>    nodes(line_degree(a, b) + 1);
    const std::vector<double> breaks = line_breaks(a, b);
    std::vector<Point<3>>     points;
    for (unsigned int k = 0; k + 1 < breaks.size(); ++k)
      for (unsigned int q = k == 0 ? 0 : 1; q < nodes.size(); ++q)
        points.push_back(
          a + (breaks[k] + nodes.point(q)[0] * (breaks[k + 1] - breaks[k])) *
                (b - a));
    return points;
  }



  std::vector<std::pair<Point<3>, double>>
  Body::line_quadrature(const Point<3> &a, const Point<3> &b) const
  {
    // Two points more than the trace needs, for loads that vary.
    const QGauss<1>                          quadrature(line_degree(a, b) + 3);
    const std::vector<double>                breaks = line_breaks(a, b);
    std::vector<std::pair<Point<3>, double>> points;
    for (unsigned int k = 0; k + 1 < breaks.size(); ++k)
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        points.emplace_back(a + (breaks[k] + quadrature.point(q)[0] *
                                               (breaks[k + 1] - breaks[k])) *
                                  (b - a),
                            quadrature.weight(q) * (breaks[k + 1] - breaks[k]) *
                              a.distance(b));
    return points;
  }



  void
  Body::assemble(const Constraints             &constraints,
                 const std::vector<SpringTerm> &springs)
  {
    factor.reset();
    matrix.clear();
    std::vector<std::vector<DofIndex>> coupled;
    for (const auto &[row, stiffness] : springs)
      {
        coupled.emplace_back();
        for (const auto &[dof, weight] : row.entries())
          coupled.back().push_back(dof);
      }
    assemble_stiffness(constraints, coupled, sparsity, matrix);
    constraints.condense(matrix);

    for (unsigned int s = 0; s < springs.size(); ++s)
      {
        const auto        &r = springs[s].first.entries();
        FullMatrix<double> term(r.size());
        for (unsigned int i = 0; i < r.size(); ++i)
          for (unsigned int j = 0; j < r.size(); ++j)
            term(i, j) = springs[s].second * r[i].second * r[j].second;
        constraints.distribute_local_to_global(term, coupled[s], matrix);
      }
  }



  void
  Body::factorise()
  {
    Assert(matrix.m() > 0, ExcMessage("Call assemble() first."));
    factor = lamella::factorise(matrix, "body '" + name() + "'");
  }



  const Matrix &
  Body::stiffness() const
  {
    Assert(matrix.m() > 0, ExcMessage("Call assemble() first."));
    return matrix;
  }



  const Factorisation &
  Body::factorisation() const
  {
    Assert(factor != nullptr, ExcMessage("Call factorise() first."));
    return *factor;
  }
} // namespace lamella
