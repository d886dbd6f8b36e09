// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/section/section.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <numeric>

namespace lamella
{
  using namespace dealii;

  Voigt
  axial_strain(const Tensor<1, 3> &v)
  {
    Voigt strain;
    strain[1] = v[1];
    strain[3] = v[0];
    strain[5] = v[2];
    return strain;
  }



  Section::Section(std::unique_ptr<const CrossSectionElement> element)
    : expansion(std::move(element))
  {
    for (const Ply &ply : plies())
      elasticities.push_back(ply.stiffness());
    for (const auto &cell :
         expansion->section_mesh().mesh.active_cell_iterators())
      ply_of_cell.push_back(cell->material_id());

    make_fields();
    make_points();
    make_matrices();

    std::vector<std::pair<BoundingBox<2>, unsigned int>> cell_boxes;
    for (const auto &cell :
         expansion->section_mesh().mesh.active_cell_iterators())
      {
        // A curved side may bulge out of the box of its vertices.
        BoundingBox<2> box = cell->bounding_box();
        box.extend(0.2 * cell->diameter());
        cell_boxes.emplace_back(box, cell->active_cell_index());
      }
    boxes = pack_rtree(cell_boxes);
  }



  void
  Section::make_fields()
  {
    // Functions 0, 1, 2 are 1, (x - x_c)/h, (z - z_c)/h; components x, y, z.
    const auto linear = [](std::vector<SectionField::Term> terms) {
      return SectionField{std::move(terms), 0};
    };
    fields                      = {linear({{0, 0, 1.}}),
                                   linear({{0, 1, 1.}}),
                                   linear({{0, 2, 1.}}),
                                   linear({{1, 1, 1.}}),
                                   linear({{2, 1, 1.}}),
                                   linear({{2, 0, 1.}, {1, 2, -1.}}),
                                   linear({{1, 0, 1.}}),
                                   linear({{2, 2, 1.}}),
                                   linear({{2, 0, 1.}, {1, 2, 1.}})};
    const unsigned int n_linear = fields.size();
    for (unsigned int tau = 3; tau < expansion->n_functions(); ++tau)
      for (unsigned int c = 0; c < 3; ++c)
        fields.push_back({{{tau, c, 1.}}, 1});

    cell_fields.resize(ply_of_cell.size());
    for (unsigned int cell = 0; cell < cell_fields.size(); ++cell)
      {
        cell_fields[cell].resize(n_linear);
        std::iota(cell_fields[cell].begin(), cell_fields[cell].end(), 0);
        for (const unsigned int tau : expansion->cell_functions(cell))
          if (tau >= 3)
            for (unsigned int c = 0; c < 3; ++c)
              cell_fields[cell].push_back(n_linear + 3 * (tau - 3) + c);
      }
  }



  SectionPoint
  Section::evaluate(const unsigned int cell, const Point<2> &unit) const
  {
    const FunctionValues             f = expansion->evaluate(cell, unit);
    const std::vector<unsigned int> &functions =
      expansion->cell_functions(cell);

    SectionPoint point;
    point.cell     = cell;
    point.unit     = unit;
    point.position = f.position;
    point.jacobian = determinant(f.jacobian);
    point.fields   = &cell_fields[cell];
    for (const unsigned int alpha : cell_fields[cell])
      {
        Tensor<1, 3> value, d_dx, d_dz;
        for (const SectionField::Term &term : fields[alpha].terms)
          {
            const unsigned int k = std::lower_bound(functions.begin(),
                                                    functions.end(),
                                                    term.function) -
                                   functions.begin();
            value[term.component] += term.factor * f.values[k];
            d_dx[term.component] += term.factor * f.gradients[k][0];
            d_dz[term.component] += term.factor * f.gradients[k][1];
          }
        Voigt strain;
        strain[0] = d_dx[0];
        strain[2] = d_dz[2];
        strain[3] = d_dx[1];
        strain[4] = d_dz[0] + d_dx[2];
        strain[5] = d_dz[1];
        point.value.push_back(value);
        point.in_plane.push_back(strain);
        point.twist.push_back(0.5 * (d_dz[0] - d_dx[2]));
      }
    return point;
  }



  void
  Section::make_points()
  {
    const QGauss<2> quadrature(expansion->degree() + 1);
    for (unsigned int cell = 0; cell < n_cells(); ++cell)
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          points.push_back(evaluate(cell, quadrature.point(q)));
          weights.push_back(quadrature.weight(q) * points.back().jacobian);
        }
  }



  void
  Section::make_matrices()
  {
    DynamicSparsityPattern pattern(n_fields());
    for (const std::vector<unsigned int> &coupled : cell_fields)
      for (const unsigned int alpha : coupled)
        pattern.add_entries(alpha, coupled.begin(), coupled.end(), true);
    sparsity.copy_from(pattern);
    for (Matrix &matrix : matrices)
      matrix.reinit(sparsity);

    std::vector<std::array<Voigt, 2>> strain, stress;
    for (unsigned int k = 0; k < points.size(); ++k)
      {
        const SectionPoint  &point = points[k];
        const ElasticTensor &C     = elasticity(point.cell);
        const unsigned int   n     = point.fields->size();
        strain.resize(n);
        stress.resize(n);
        for (unsigned int a = 0; a < n; ++a)
          {
            strain[a] = {{point.in_plane[a], axial_strain(point.value[a])}};
            for (unsigned int p = 0; p < 2; ++p)
              stress[a][p] = weights[k] * (C * strain[a][p]);
          }
        std::vector<double> entries(n);
        for (unsigned int p = 0; p < 2; ++p)
          for (unsigned int q = 0; q < 2; ++q)
            for (unsigned int a = 0; a < n; ++a)
              {
                for (unsigned int b = 0; b < n; ++b)
                  entries[b] = strain[a][p] * stress[b][q];
                matrices[2 * p + q].add((*point.fields)[a],
                                        n,
                                        point.fields->data(),
                                        entries.data(),
                                        false,
                                        true);
              }
      }
  }



  std::vector<std::pair<unsigned int, Point<2>>>
  Section::locate(const Point<2> &x, const double tolerance) const
  {
    std::vector<std::pair<BoundingBox<2>, unsigned int>> candidates;
    BoundingBox<2> around(std::make_pair(x, x));
    around.extend(tolerance);
    boxes.query(boost::geometry::index::intersects(around),
                std::back_inserter(candidates));

    // Newton's method on the element's own map, from the middle of the cell.
    std::vector<std::pair<unsigned int, Point<2>>> found;
    for (const auto &[box, cell] : candidates)
      {
        Point<2> unit(0.5, 0.5);
        double   distance = 0.;
        double   size     = 0.;
        for (unsigned int iteration = 0; iteration < 20; ++iteration)
          {
            const FunctionValues at = expansion->evaluate(cell, unit);
            size     = std::sqrt(std::abs(determinant(at.jacobian)));
            distance = x.distance(at.position);
            if (distance < 1e-14 * size)
              break;
            unit += invert(at.jacobian) * (x - at.position);
            // Beyond its cell a curved map may fold; stay near.
            for (unsigned int d = 0; d < 2; ++d)
              unit[d] = std::min(1.5, std::max(-0.5, unit[d]));
          }
        const Point<2> inside = GeometryInfo<2>::project_to_unit_cell(unit);
        const double   off =
          x.distance(expansion->evaluate(cell, inside).position);
        if (off <= tolerance)
          found.emplace_back(cell, inside);
      }
    std::sort(found.begin(), found.end(), [](const auto &a, const auto &b) {
      return a.first < b.first;
    });
    return found;
  }



  double
  Section::area() const
  {
    return std::accumulate(weights.begin(), weights.end(), 0.);
  }
} // namespace lamella
