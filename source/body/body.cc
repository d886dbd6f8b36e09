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
    linear_solver.reset();
    matrix.reset();
    const StiffnessTerms terms{n_dofs(),
                               owned_dofs(),
                               [this](const bool with_values, const auto &use) {
                                 for_each_stiffness_block(with_values, use);
                               },
                               springs};
    matrix = assemble_serial(terms, constraints);
  }



  void
  Body::factorise()
  {
    linear_solver = stiffness().factorise("body '" + name() + "'");
  }



  const StiffnessMatrix &
  Body::stiffness() const
  {
    Assert(matrix != nullptr, ExcMessage("Call assemble() first."));
    return *matrix;
  }



  const LinearSolver &
  Body::solver() const
  {
    Assert(linear_solver != nullptr, ExcMessage("Call factorise() first."));
    return *linear_solver;
  }
} // namespace lamella
