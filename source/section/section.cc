// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/inverse_map.h>
#include <lamella/section/lagrange_element.h>
#include <lamella/section/section.h>
#include <lamella/section/taylor_element.h>
#include <lamella/shape/section_mesh.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>

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



  Section::Section(std::unique_ptr<const CrossSectionElement> element,
                   const Theory                              &theory)
    : expansion(std::move(element))
    , section_theory(theory)
    , laws(expansion->section_mesh().plies,
           theory.kind == Theory::Kind::TBT ? theory.shear_factor : 1.)
  {
    for (const auto &cell :
         expansion->section_mesh().mesh.active_cell_iterators())
      ply_of_cell.push_back(cell->material_id());

    is_curved = has_curved_edges(expansion->section_mesh());
    make_fields();
    make_points();
    if (spans_the_section())
      make_moments();
    else
      make_matrices();
    make_boxes();
  }



  void
  Section::make_boxes()
  {
    std::vector<std::pair<BoundingBox<2>, unsigned int>> cell_boxes;
    for (const auto &cell :
         expansion->section_mesh().mesh.active_cell_iterators())
      {
        // A curved side may bulge out of the box of its vertices. (Boxes of
        // thin straight cells that grew alike would hold each other.)
        BoundingBox<2> box = cell->bounding_box();
        if (is_curved)
          box.extend(0.2 * cell->diameter());
        cell_boxes.emplace_back(box, cell->active_cell_index());
      }
    boxes = pack_rtree(cell_boxes);
  }



  void
  Section::make_fields()
  {
    // Functions 0, 1, 2 are 1, (x - x_c)/h, (z - z_c)/h; components x, y, z.
    const auto linear = [](std::vector<SectionFunction::Term> terms) {
      return SectionFunction{std::move(terms), 0};
    };
    fields = {linear({{0, 0, 1.}}),
              linear({{0, 1, 1.}}),
              linear({{0, 2, 1.}}),
              linear({{1, 1, 1.}}),
              linear({{2, 1, 1.}})};
    if (section_theory.can_twist())
      fields.push_back(linear({{2, 0, 1.}, {1, 2, -1.}}));
    if (!section_theory.is_classical())
      {
        fields.push_back(linear({{1, 0, 1.}}));
        fields.push_back(linear({{2, 2, 1.}}));
        fields.push_back(linear({{2, 0, 1.}, {1, 2, 1.}}));
      }
    const unsigned int n_linear = fields.size();
    for (unsigned int tau = 3; tau < expansion->n_functions(); ++tau)
      for (unsigned int c = 0; c < 3; ++c)
        fields.push_back({{{tau, c, 1.}}, expansion->level(tau)});

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



  std::vector<double>
  Section::rotated(const Tensor<1, 3> &v, const std::vector<double> &q) const
  {
    // Fields are orthogonal in functions times components.
    std::vector<Tensor<1, 3>> of_function(expansion->n_functions());
    for (unsigned int alpha = 0; alpha < n_fields(); ++alpha)
      for (const SectionFunction::Term &term : fields[alpha].terms)
        of_function[term.function][term.component] += term.factor * q[alpha];
    for (Tensor<1, 3> &u : of_function)
      u = cross_product_3d(v, u);
    std::vector<double> result;
    for (const SectionFunction &field : fields)
      {
        double along = 0., norm = 0.;
        for (const SectionFunction::Term &term : field.terms)
          {
            along += term.factor * of_function[term.function][term.component];
            norm += term.factor * term.factor;
          }
        result.push_back(along / norm);
      }
    return result;
  }



  namespace
  {
    /// D_s u of Eq. 5 for the derivatives of u.
    Voigt
    section_strain(const Tensor<1, 3> &d_dx, const Tensor<1, 3> &d_dz)
    {
      Voigt strain;
      strain[0] = d_dx[0];
      strain[2] = d_dz[2];
      strain[3] = d_dx[1];
      strain[4] = d_dz[0] + d_dx[2];
      strain[5] = d_dz[1];
      return strain;
    }



    /// Drops the transverse shear strains of a value and of its derivative:
    /// their sum vanishes by Kirchhoff's constraint, with loss of digits.
    void
    drop_transverse_shear(SectionPoint &point)
    {
      for (unsigned int a = 0; a < point.fields->size(); ++a)
        for (const unsigned int shear : {3, 5})
          {
            point.in_plane[a][shear] = 0.;
            point.along[a][shear]    = 0.;
          }
    }



    /// @p unit on those sides of the unit square that it is within @p tolerance
    /// of, where @p jacobian is d(x, z) / d(xi, eta).
    Point<2>
    on_near_sides(Point<2>            unit,
                  const Tensor<2, 2> &jacobian,
                  const double        tolerance)
    {
      for (unsigned int d = 0; d < 2; ++d)
        {
          const double size = std::hypot(jacobian[0][d], jacobian[1][d]);
          for (const double side : {0., 1.})
            if (std::abs(unit[d] - side) * size <= tolerance)
              unit[d] = side;
        }
      return unit;
    }
  } // namespace



  SectionPoint
  Section::evaluate_fields(const unsigned int cell, const Point<2> &unit) const
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
        for (const SectionFunction::Term &term : fields[alpha].terms)
          {
            const unsigned int k = std::lower_bound(functions.begin(),
                                                    functions.end(),
                                                    term.function) -
                                   functions.begin();
            value[term.component] += term.factor * f.values[k];
            d_dx[term.component] += term.factor * f.gradients[k][0];
            d_dz[term.component] += term.factor * f.gradients[k][1];
          }
        point.value.push_back(value);
        point.in_plane.push_back(section_strain(d_dx, d_dz));
        point.along.push_back(axial_strain(value));
        point.twist.push_back(0.5 * (d_dz[0] - d_dx[2]));
      }
    if (section_theory.kind == Theory::Kind::EBBT)
      drop_transverse_shear(point);
    return point;
  }



  SectionPoint
  Section::evaluate(const unsigned int cell, const Point<2> &unit) const
  {
    SectionPoint point = evaluate_fields(cell, unit);
    if (completion != nullptr)
      completion->complete(point);
    return point;
  }



  Voigt
  Section::completion_of_initial(const unsigned int cell,
                                 const Point<2>    &x,
                                 const Voigt       &initial) const
  {
    return completion == nullptr ? Voigt() :
                                   completion->of_initial(cell, x, initial);
  }



  bool
  Section::completes_by_modes() const
  {
    return completion != nullptr && !section_theory.is_classical();
  }



  void
  Section::for_each_point(const PointCallback &use) const
  {
    if (!spans_the_section())
      {
        for (unsigned int k = 0; k < points.size(); ++k)
          use(points[k], weights[k]);
        return;
      }
    const QGauss<2> quadrature(expansion->n_gauss_points());
    for (unsigned int cell = 0; cell < n_cells(); ++cell)
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          const SectionPoint point = evaluate(cell, quadrature.point(q));
          use(point, quadrature.weight(q) * point.jacobian);
        }
  }



  bool
  Section::spans_the_section() const
  {
    return section_theory.kind == Theory::Kind::TE && section_theory.order > 1;
  }



  void
  Section::make_sample_points()
  {
    constexpr double   enough = 500.;
    const unsigned int n =
      std::min<double>(expansion->n_gauss_points(),
                       std::max(1., std::round(std::sqrt(enough / n_cells()))));
    const QGauss<2> quadrature(n);
    for (unsigned int cell = 0; cell < n_cells(); ++cell)
      for (const Point<2> &unit : quadrature.get_points())
        {
          points.push_back(evaluate_fields(cell, unit));
          if (laws.has_varying_laws())
            point_laws.push_back(law(cell, points.back().position));
        }
  }



  void
  Section::make_points()
  {
    if (spans_the_section())
      {
        make_sample_points();
        return;
      }
    const QGauss<2> quadrature(expansion->n_gauss_points());
    for (unsigned int cell = 0; cell < n_cells(); ++cell)
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          points.push_back(evaluate_fields(cell, quadrature.point(q)));
          weights.push_back(quadrature.weight(q) * points.back().jacobian);
          if (laws.has_varying_laws())
            point_laws.push_back(law(cell, points.back().position));
        }

    if (!section_theory.poisson_correction)
      return;
    if (section_theory.is_classical())
      completion = std::make_unique<FreeContraction>(laws, ply_of_cell);
    else if (section_theory.kind == Theory::Kind::TE &&
             section_theory.order == 1)
      completion = std::make_unique<ContractionModes>(expansion->shared_mesh(),
                                                      points,
                                                      weights,
                                                      laws,
                                                      ply_of_cell,
                                                      n_fields());
    if (completion != nullptr)
      for (SectionPoint &point : points)
        completion->complete(point);
  }



  std::pair<Point<2>, double>
  Section::nearest_in_cell(const unsigned int cell, const Point<2> &x) const
  {
    const auto missing = [&](const Point<2> &unit) {
      const auto [position, jacobian] = expansion->map(cell, unit);
      return std::make_pair(x - position, Tensor<2, 2>(jacobian));
    };
    const Point<2> unit =
      inverse_image(Point<2>(0.5, 0.5), false, missing, clip_to_neighborhood<2>)
        .unit;
    const Point<2> inside = GeometryInfo<2>::project_to_unit_cell(unit);
    return {inside, x.distance(expansion->map(cell, inside).position)};
  }



  std::vector<std::pair<unsigned int, Point<2>>>
  Section::locate(const Point<2> &x, const double tolerance) const
  {
    std::vector<std::pair<BoundingBox<2>, unsigned int>> candidates;
    BoundingBox<2> around(std::make_pair(x, x));
    around.extend(tolerance);
    boxes.query(boost::geometry::index::intersects(around),
                std::back_inserter(candidates));

    std::vector<std::pair<unsigned int, Point<2>>> found, nearest;
    double smallest = std::numeric_limits<double>::max();
    for (const auto &[box, cell] : candidates)
      {
        const auto [place, distance] = nearest_in_cell(cell, x);
        if (distance <= tolerance)
          found.emplace_back(
            cell,
            on_near_sides(place,
                          Tensor<2, 2>(expansion->map(cell, place).jacobian),
                          tolerance));
        // Fraction of the cell's extension, which the box exceeds by a fifth.
        const auto   corners = box.get_boundary_points();
        const double size    = corners.first.distance(corners.second) / 1.4;
        if (is_curved && distance < std::min(smallest, 0.02 * size))
          {
            smallest = distance;
            nearest  = {{cell, place}};
          }
      }
    if (found.empty())
      return nearest;
    std::sort(found.begin(), found.end(), [](const auto &a, const auto &b) {
      return a.first < b.first;
    });
    return found;
  }



  double
  Section::area() const
  {
    const QGauss<2> quadrature(expansion->n_gauss_points());
    double          sum = 0.;
    for (unsigned int cell = 0; cell < n_cells(); ++cell)
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        sum +=
          quadrature.weight(q) *
          determinant(expansion->evaluate(cell, quadrature.point(q)).jacobian);
    return sum;
  }



  std::shared_ptr<const Section>
  make_section(const std::shared_ptr<const SectionMesh> &mesh,
               const Theory                             &theory)
  {
    const Theory                               of_section = theory.of_section();
    std::unique_ptr<const CrossSectionElement> element;
    if (of_section.kind == Theory::Kind::LE)
      element = std::make_unique<LagrangeElement>(
        mesh,
        of_section.order,
        LagrangeElement::default_column_aspect,
        of_section.hierarchical ? LagrangeElement::Basis::hierarchical :
                                  LagrangeElement::Basis::nodal);
    else
      element = std::make_unique<TaylorElement>(mesh, of_section.order);
    return std::make_shared<Section>(std::move(element), of_section);
  }



  std::vector<dealii::Point<2>>
  corners_of(const Section &section)
  {
    const SectionMesh            &mesh = section.element().section_mesh();
    std::vector<dealii::Point<2>> corners;
    for (const unsigned int vertex : singular_corners(mesh))
      corners.push_back(mesh.mesh.get_vertices()[vertex]);
    return corners;
  }
} // namespace lamella
