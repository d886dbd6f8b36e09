// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>
#include <lamella/body/fields.h>
#include <lamella/body/total_lagrangian_solid.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  TotalLagrangianSolid::TotalLagrangianSolid(
    const std::string                        &name,
    const std::shared_ptr<const SectionMesh> &section,
    const AxisMesh                           &axis,
    const Placement                          &placement,
    const unsigned int                        degree,
    const SolidRefinement                    &refinement)
    : Solid(name, section, axis, placement, degree, refinement)
  {
    if (degree < 2)
      throw InputError(
        "body.solid-1-cannot-rotate: large rotations of a solid need Theory = "
        "solid-2, since solid-1 has modes for infinitesimal strains.");
  }



  // ---- where it is, and what it shows

  std::vector<Vector>
  TotalLagrangianSolid::rigid_motions(const Vector &u) const
  {
    std::vector<Vector> motions = Solid::rigid_motions(u);
    if (u.size() == 0)
      return motions;
    for (unsigned int m = 3; m < 6; ++m)
      {
        Tensor<1, 3> axis;
        axis[m - 3]           = 1.;
        const Tensor<1, 3> in = placement.vector_to_body(axis);
        for (DofIndex first = 0; first < n_dofs(); first += 3)
          {
            const Tensor<1, 3> more =
              cross_product_3d(in,
                               Point<3>(u[first], u[first + 1], u[first + 2]));
            for (unsigned int c = 0; c < 3; ++c)
              motions[m][first + c] += more[c];
          }
      }
    return motions;
  }



  double
  TotalLagrangianSolid::rotation_along(const unsigned int cell,
                                       const Vector      &u) const
  {
    const auto rotation = [&](const double along) {
      const HexahedronPoint point =
        hexahedron().evaluate(nodes_of(cell), {0.5, along, 0.5});
      return PolarDecomposition(gradient_at(cell, point, u)).rotation();
    };
    return angle_of(transpose(rotation(0.)) * rotation(1.));
  }



  Deformation
  TotalLagrangianSolid::deformation(const Vector &u) const
  {
    Deformation result;
    const auto [begin, end] = hexahedra().owned_cells();
    for (unsigned int cell = begin; cell < end; ++cell)
      {
        double volume = 0., squares = 0.;
        for (const HexahedronPoint &point :
             hexahedron().quadrature_points(nodes_of(cell)))
          {
            const Gradient H    = gradient_at(cell, point, u);
            const Stretch  here = stretch_of(H);
            result.energy +=
              point.JxW *
              law(cell, point.position).energy_density(green_strain(H));
            result.max_rotation = std::max(result.max_rotation, here.rotation);
            result.max_strain   = std::max(result.max_strain, here.strain);
            volume += point.JxW;
            squares += point.JxW * here.along * here.along;
          }
        result.max_rms_strain =
          std::max(result.max_rms_strain, std::sqrt(squares / volume));
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
  TotalLagrangianSolid::inverted_points(const Vector &u) const
  {
    const auto [begin, end] = hexahedra().owned_cells();
    for (unsigned int cell = begin; cell < end; ++cell)
      for (const HexahedronPoint &point :
           hexahedron().quadrature_points(nodes_of(cell)))
        if (is_inverted(gradient_at(cell, point, u)))
          return {placement.to_scene(point.position)};
    return {};
  }



  FieldSample
  TotalLagrangianSolid::sample_at_element_point(const Location::Place &place,
                                                const Vector          &u) const
  {
    const HexahedronPoint point =
      hexahedron().evaluate(nodes_of(place.cell), place.unit);
    const auto  &nodes = hexahedra().cells()[place.cell].nodes;
    Tensor<1, 3> displacement;
    for (unsigned int i = 0; i < nodes.size(); ++i)
      for (unsigned int c = 0; c < 3; ++c)
        displacement[c] += point.N[i] * u[3 * DofIndex(nodes[i]) + c];
    const Gradient H = gradient_at(place.cell, point, u);
    return finite_strain_sample(displacement,
                                H,
                                green_strain(H),
                                placement,
                                ply_axes(place.cell, point.position),
                                law_at(place.cell, place.unit, point.position));
  }



  // ---- forces and the tangent

  void
  TotalLagrangianSolid::add_internal_forces(const Vector &u, Vector &f) const
  {
    Vector share(n_dofs());
    const auto [begin, end] = hexahedra().owned_cells();
    for (unsigned int cell = begin; cell < end; ++cell)
      {
        const std::vector<DofIndex> dofs = dofs_of(cell);
        for (const HexahedronPoint &point :
             hexahedron().quadrature_points(nodes_of(cell)))
          {
            const Gradient     H = gradient_at(cell, point, u);
            const Tensor<2, 3> P =
              point.JxW *
              first_stress(H,
                           law(cell, point.position).stress(green_strain(H)));
            for (unsigned int d = 0; d < dofs.size(); ++d)
              for (unsigned int i = 0; i < 3; ++i)
                share[dofs[d]] += point.gradients[d / 3][i] * P[i][d % 3];
          }
      }
    sum_over_processes(share);
    f += share;
  }



  std::vector<double>
  TotalLagrangianSolid::tangent_of(
    const unsigned int                                          cell,
    const std::function<Tensor<2, 9>(const HexahedronPoint &)> &D) const
  {
    const unsigned int  n = hexahedra().cells()[cell].nodes.size();
    std::vector<double> values(9 * n * n, 0.);
    for (const HexahedronPoint &point :
         hexahedron().quadrature_points(nodes_of(cell)))
      {
        const Tensor<2, 9> at_point = D(point);
        for (unsigned int i = 0; i < n; ++i)
          {
            // grad N_i . D: a row a component, a column for each entry of H.
            std::array<std::array<double, 9>, 3> left{};
            for (unsigned int a = 0; a < 3; ++a)
              for (unsigned int c = 0; c < 3; ++c)
                for (unsigned int m = 0; m < 9; ++m)
                  left[c][m] +=
                    point.JxW * point.gradients[i][a] * at_point[3 * a + c][m];
            for (unsigned int k = 0; k < n; ++k)
              for (unsigned int c = 0; c < 3; ++c)
                for (unsigned int d = 0; d < 3; ++d)
                  for (unsigned int b = 0; b < 3; ++b)
                    values[(3 * i + c) * 3 * n + 3 * k + d] +=
                      left[c][3 * b + d] * point.gradients[k][b];
          }
      }
    return values;
  }



  void
  TotalLagrangianSolid::for_each_stiffness_block(const Vector &u,
                                                 const Vector &correction,
                                                 const bool    with_values,
                                                 const BlockCallback &use) const
  {
    if (u.size() == 0)
      return Solid::for_each_stiffness_block(u, correction, with_values, use);
    const auto [begin, end] = hexahedra().owned_cells();
    for (unsigned int cell = begin; cell < end; ++cell)
      {
        StiffnessBlock block;
        block.rows = block.columns = dofs_of(cell);
        if (with_values)
          block.values = tangent_of(cell, [&](const HexahedronPoint &point) {
            const Gradient   H = gradient_at(cell, point, u);
            const ElasticLaw C = law(cell, point.position);
            return green_tangent(H,
                                 C.stress(predicted_strain(
                                   H, gradient_at(cell, point, correction))),
                                 C);
          });
        use(block);
      }
  }



  void
  TotalLagrangianSolid::for_each_thermal_block(const Vector &,
                                               const BlockCallback &use) const
  {
    const auto [begin, end] = hexahedra().owned_cells();
    for (unsigned int cell = begin; cell < end && is_heated(); ++cell)
      {
        StiffnessBlock block;
        block.rows = block.columns = dofs_of(cell);
        block.values = tangent_of(cell, [&](const HexahedronPoint &point) {
          return stress_tangent(
            -1. * law_at(cell, point.unit, point.position).stress(Voigt()));
        });
        use(block);
      }
  }
} // namespace lamella
