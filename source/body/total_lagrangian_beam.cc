// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/gauss_lobatto_basis.h>
#include <lamella/body/fields.h>
#include <lamella/body/total_lagrangian_beam.h>

#include <algorithm>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// @p section, if it is one whose strains are those of its displacements.
    std::shared_ptr<const Section>
    finite_strain_section(std::shared_ptr<const Section> section,
                          const Axis                    &axis)
    {
      if (section->completes_strains() || axis.degree() != 3)
        throw InputError(
          "body.theory-cannot-rotate: large rotations of a beam need Theory = "
          "LE-N or TE-N with N >= 2, whose sections can rotate, and Axis "
          "element = B4, since B2 and B3 have membrane locking.");
      return section;
    }
  } // namespace



  TotalLagrangianBeam::TotalLagrangianBeam(
    const std::string                    &name,
    const std::shared_ptr<const Section> &section,
    const std::shared_ptr<const Axis>    &axis,
    const Placement                      &placement)
    : FiniteRotationBeam(name,
                         finite_strain_section(section, *axis),
                         axis,
                         placement)
    , green(fields(), along_axis().n_stations())
  {}



  SectionForces
  TotalLagrangianBeam::section_forces(const SectionOperator &,
                                      const FieldParts &q) const
  {
    return green.forces(q);
  }



  // ---- where it is, and what it shows

  std::vector<Vector>
  TotalLagrangianBeam::rigid_motions(const Vector &u) const
  {
    std::vector<Vector> motions = Beam::rigid_motions(u);
    if (u.size() == 0)
      return motions;
    std::vector<double> moved(section().n_fields());
    for (unsigned int c = 0; c < 3; ++c)
      {
        Tensor<1, 3> axis;
        axis[c] = 1.;
        for (unsigned int node = 0; node < dofs().n_nodes(); ++node)
          {
            // All nodes carry all fields, in their order.
            const unsigned int first = dofs().first(node);
            std::copy_n(u.begin() + first, moved.size(), moved.begin());
            const std::vector<double> more =
              section().rotated(placement.vector_to_body(axis), moved);
            for (unsigned int alpha = 0; alpha < more.size(); ++alpha)
              motions[3 + c][first + alpha] += more[alpha];
          }
      }
    return motions;
  }



  FieldParts
  TotalLagrangianBeam::parts_at(const SectionPoint &point,
                                const AxisPoint    &on_axis,
                                const Vector       &u) const
  {
    return along_axis().at(ArrayView<const AxisPoint>(&on_axis, 1),
                           *point.fields,
                           u);
  }



  double
  TotalLagrangianBeam::rotation_along(const unsigned int cell,
                                      const Vector      &u) const
  {
    const SectionPoint middle   = section().evaluate(0, {0.5, 0.5});
    const auto         rotation = [&](const double eta) {
      return PolarDecomposition(
               gradient_at(middle,
                           parts_at(middle, axis().evaluate(cell, eta), u),
                           0))
        .rotation();
    };
    return angle_of(transpose(rotation(0.)) * rotation(1.));
  }



  Deformation
  TotalLagrangianBeam::deformation(const Vector &u) const
  {
    Deformation result;
    const auto [begin, end] = axis().own_cells();
    for (unsigned int cell = begin; cell < end; ++cell)
      {
        const FieldParts q = along_axis().on_element(cell, dofs().fields(0), u);
        const Stretch    stretch = green.largest(q);
        result.energy += along_axis().energy(cell, green.forces(q));
        result.max_rotation   = std::max(result.max_rotation, stretch.rotation);
        result.max_strain     = std::max(result.max_strain, stretch.strain);
        result.max_rms_strain = std::max(result.max_rms_strain, stretch.along);
        result.max_element_rotation =
          std::max(result.max_element_rotation, rotation_along(cell, u));
      }
    result = reduce_over_processes(result);
    // E . C epsilon_0 is quadratic in u, as the forces of heat are linear.
    if (is_heated())
      {
        Vector f(n_dofs());
        add_thermal_load(undisplaced, f);
        add_thermal_load(u, f);
        result.energy -= 0.5 * (f * u);
      }
    return result;
  }



  std::vector<Point<3>>
  TotalLagrangianBeam::inverted_points(const Vector &u) const
  {
    const auto [begin, end] = axis().own_cells();
    for (unsigned int cell = begin; cell < end; ++cell)
      if (const auto found = green.inverted_point(
            along_axis().on_element(cell, dofs().fields(0), u)))
        {
          const auto &[k, x]    = *found;
          const unsigned int of = cell * along_axis().n_stations() + k;
          return {placement.to_scene(
            {x[0], axis().integration_points()[of].y, x[1]})};
        }
    return {};
  }



  Voigt
  TotalLagrangianBeam::strain_at(const SectionPoint &point,
                                 const AxisPoint    &on_axis,
                                 const Gradient     &H,
                                 const Vector       &u) const
  {
    constexpr std::array<unsigned int, 3> lowered{{1, 3, 5}};
    const unsigned int cell = on_axis.cell, n = along_axis().n_stations();
    const double       begin = axis().cell_begin(cell);
    const FieldParts   q     = along_axis().at(
      ArrayView<const AxisPoint>(&axis().integration_points()[cell * n], n),
      *point.fields,
      u);
    const std::vector<double> weights =
      gauss_projection(n,
                       n - 2,
                       (on_axis.y - begin) / (axis().cell_end(cell) - begin));
    Voigt strain = green_strain(H);
    for (const unsigned int c : lowered)
      strain[c] = 0.;
    for (unsigned int k = 0; k < n; ++k)
      {
        const Voigt at_station = green_strain(gradient_at(point, q, k));
        for (const unsigned int c : lowered)
          strain[c] += weights[k] * at_station[c];
      }
    return strain;
  }



  FieldSample
  TotalLagrangianBeam::sample_at(const SectionPoint &point,
                                 const AxisPoint    &on_axis,
                                 const Vector       &u) const
  {
    const FieldParts q = parts_at(point, on_axis, u);
    const Gradient   H = gradient_at(point, q, 0);
    Tensor<1, 3>     displacement;
    for (unsigned int a = 0; a < point.fields->size(); ++a)
      displacement += q[FieldPart::value](a, 0) * point.value[a];
    return finite_strain_sample(
      displacement,
      H,
      strain_at(point, on_axis, H, u),
      placement,
      section().ply_axes(point.cell, point.position),
      law_at(point.cell,
             point.position,
             placement.to_scene(
               {point.position[0], on_axis.y, point.position[1]})));
  }



  // ---- the tangent

  std::vector<StiffnessBlock>
  TotalLagrangianBeam::make_blocks(const unsigned int cell,
                                   const bool         with_values) const
  {
    std::vector<StiffnessBlock> blocks;
    for (const auto *on_section : green.fields_of_cells())
      {
        StiffnessBlock &block = blocks.emplace_back();
        for (const unsigned int node : axis().nodes_of_cell(cell))
          for (const unsigned int alpha : *on_section)
            block.rows.push_back(dofs().first(node) +
                                 dofs().place(node, alpha));
        block.columns = block.rows;
        if (with_values)
          block.values.assign(block.rows.size() * block.columns.size(), 0.);
      }
    return blocks;
  }



  void
  TotalLagrangianBeam::for_each_thermal_block(const Vector &,
                                              const BlockCallback &use) const
  {
    const auto [begin, end] = axis().own_cells();
    for (unsigned int cell = begin; cell < end && is_heated(); ++cell)
      {
        std::vector<StiffnessBlock> blocks = make_blocks(cell, true);
        for (unsigned int k = 0; k < along_axis().n_stations(); ++k)
          {
            const double y =
              axis()
                .integration_points()[cell * along_axis().n_stations() + k]
                .y;
            auto block = blocks.begin();
            green.for_each_cell_of_stress(
              [&](const unsigned int on_section, const Point<2> &at) {
                return -1. * law_at(on_section,
                                    at,
                                    placement.to_scene({at[0], y, at[1]}))
                               .stress(Voigt());
              },
              [&](const FiniteStrainSectionOperator::CellTangent &tangent) {
                add_station(cell, k, tangent, *block++);
              });
          }
        for (const StiffnessBlock &block : blocks)
          use(block);
      }
  }



  void
  TotalLagrangianBeam::add_station(
    const unsigned int                              cell,
    const unsigned int                              k,
    const FiniteStrainSectionOperator::CellTangent &tangent,
    StiffnessBlock                                 &block) const
  {
    const unsigned int number = cell * along_axis().n_stations() + k;
    const AxisPoint   &point  = axis().integration_points()[number];
    const double       weight = axis().integration_weights()[number];
    const unsigned int n = tangent.fields->size(), n_nodes = point.N.size(),
                       columns = n * n_nodes;
    for (unsigned int i = 0; i < n_nodes; ++i)
      for (unsigned int j = 0; j < n_nodes; ++j)
        {
          const double NN  = weight * point.N[i] * point.N[j],
                       NdN = weight * point.N[i] * point.dN[j],
                       dNN = weight * point.dN[i] * point.N[j],
                       dd  = weight * point.dN[i] * point.dN[j];
          for (unsigned int a = 0; a < n; ++a)
            for (unsigned int b = 0; b < n; ++b)
              block.values[(i * n + a) * columns + j * n + b] +=
                NN * tangent.matrix(a, b) + NdN * tangent.matrix(a, n + b) +
                dNN * tangent.matrix(n + a, b) +
                dd * tangent.matrix(n + a, n + b);
        }
  }



  void
  TotalLagrangianBeam::subtract_assumed_strain(
    const unsigned int                                           cell,
    const std::vector<FiniteStrainSectionOperator::CellTangent> &tangents,
    StiffnessBlock                                              &block) const
  {
    const double       length = axis().cell_end(cell) - axis().cell_begin(cell);
    const unsigned int n      = tangents[0].fields->size(),
                       n_points = tangents[0].stretch.m(),
                       columns  = block.columns.size();
    LAPACKFullMatrix<double> X(n_points, columns), Y(n_points, columns),
      product(columns, columns);
    for (unsigned int k = 0; k < tangents.size(); ++k)
      {
        const AxisPoint &point =
          axis().integration_points()[cell * tangents.size() + k];
        const auto add = [&](const LAPACKFullMatrix<double> &rows,
                             const double                    factor,
                             LAPACKFullMatrix<double>       &sum) {
          for (unsigned int p = 0; p < n_points; ++p)
            for (unsigned int j = 0; j < columns; ++j)
              sum(p, j) += factor * (point.N[j / n] * rows(p, j % n) +
                                     point.dN[j / n] * rows(p, n + j % n));
        };
        add(tangents[k].stretch, green.share(k), X);
        add(tangents[k].on_stretch, length * green.share(k), Y);
      }
    Y.Tmmult(product, X);
    for (unsigned int i = 0; i < columns; ++i)
      for (unsigned int j = 0; j < columns; ++j)
        block.values[i * columns + j] -= product(i, j) + product(j, i);
  }



  void
  TotalLagrangianBeam::add_values(const unsigned int           cell,
                                  const Vector                &u,
                                  const Vector                &correction,
                                  std::vector<StiffnessBlock> &blocks) const
  {
    const AxisLoop loop = along_axis();
    // All nodes carry all fields.
    const std::vector<unsigned int> &all = dofs().fields(0);
    const FieldParts                 q   = loop.on_element(cell, all, u),
                     dq = loop.on_element(cell, all, correction);
    auto block          = blocks.begin();
    green.for_each_cell(
      q,
      dq,
      [&](
        const std::vector<FiniteStrainSectionOperator::CellTangent> &tangents) {
        for (unsigned int k = 0; k < tangents.size(); ++k)
          add_station(cell, k, tangents[k], *block);
        subtract_assumed_strain(cell, tangents, *block++);
      });
  }



  void
  TotalLagrangianBeam::for_each_stiffness_block(const Vector &u,
                                                const Vector &correction,
                                                const bool    with_values,
                                                const BlockCallback &use) const
  {
    if (u.size() == 0)
      return Beam::for_each_stiffness_block(u, correction, with_values, use);
    const auto [begin, end] = axis().own_cells();
    for (unsigned int cell = begin; cell < end; ++cell)
      {
        std::vector<StiffnessBlock> blocks = make_blocks(cell, with_values);
        if (with_values)
          add_values(cell, u, correction, blocks);
        for (const StiffnessBlock &block : blocks)
          use(block);
      }
  }
} // namespace lamella
