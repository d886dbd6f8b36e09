// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_tests_unit_fixtures_h
#define lamella_tests_unit_fixtures_h

#include <lamella/body/beam.h>
#include <lamella/conditions/row_reduction.h>
#include <lamella/section/lagrange_element.h>
#include <lamella/section/laminate.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace lamella
{
  /// A rectangular section of plies of equal thickness and one material.
  inline Laminate
  rectangle(const double              width,
            const double              height,
            const std::vector<double> angles        = {0.},
            const unsigned int        cells_across  = 1,
            const unsigned int        cells_per_ply = 1)
  {
    const unsigned int n = angles.size();
    return {width,
            angles,
            std::vector<double>(n, height / n),
            std::vector<std::string>(n, "material"),
            cells_per_ply,
            cells_across};
  }

  /// LE-@p degree.
  inline Theory
  layer_wise(const unsigned int degree)
  {
    Theory theory;
    theory.kind  = Theory::Kind::LE;
    theory.order = degree;
    return theory;
  }

  inline std::shared_ptr<const Section>
  make_section(std::shared_ptr<const SectionMesh> mesh,
               const unsigned int                 degree)
  {
    return make_section(std::move(mesh), layer_wise(degree));
  }

  inline std::shared_ptr<const Section>
  make_section(const Laminate             &laminate,
               const EngineeringConstants &material,
               const unsigned int          degree)
  {
    return make_section(make_section_mesh(laminate, {{"material", material}}),
                        degree);
  }

  inline std::shared_ptr<const Axis>
  make_axis(const double       length,
            const unsigned int elements,
            const unsigned int degree = 3)
  {
    AxisMesh mesh;
    mesh.length   = length;
    mesh.degree   = degree;
    mesh.elements = {elements};
    return std::make_shared<Axis>(mesh);
  }

  /// A displacement field in scene coordinates.
  using Field = std::function<dealii::Tensor<1, 3>(const dealii::Point<3> &)>;

  /// Rows that prescribe @p field at all nodes of the surface of @p body.
  inline std::vector<PrescribedRow>
  prescribe_on_surface(const Body &body, const Field &field)
  {
    std::vector<PrescribedRow> rows;
    for (const std::string &surface : body.surfaces())
      if (surface != "ends")
        {
          std::vector<Location> locations;
          for (const SurfacePoint &p : body.surface_points(surface))
            locations.push_back(p.location);
          const auto all = body.rows(locations, Quantity::displacement);
          for (unsigned int i = 0; i < all.size(); ++i)
            for (unsigned int c = 0; c < 3; ++c)
              rows.push_back({{0, all[i][c]},
                              field(locations[i].position)[c],
                              0,
                              c,
                              locations[i].position});
        }
    return rows;
  }

  /// The displacements of @p body under @p rows alone, refined @p refinements
  /// times against the strain-first residual.
  inline Vector
  solve_prescribed(Body                             &body,
                   const std::vector<PrescribedRow> &rows,
                   const unsigned int                refinements = 2)
  {
    const RowReduction reduction(body, 0, rows, {"surface"});
    body.assemble(reduction.constraints());
    body.factorise();
    Vector u = reduction.particular();
    for (unsigned int k = 0; k <= refinements; ++k)
      {
        Vector r(body.n_dofs());
        body.add_internal_forces(u, r);
        r *= -1.;
        reduction.constraints().condense(r);
        reduction.constraints().set_zero(r);
        body.factorisation().solve(r);
        reduction.constraints().distribute(r);
        u += r;
      }
    return u;
  }
} // namespace lamella

#endif
