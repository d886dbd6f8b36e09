// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_tests_unit_fixtures_h
#define lamella_tests_unit_fixtures_h

#include <lamella/body/beam.h>
#include <lamella/body/body_solver.h>
#include <lamella/conditions/row_reduction.h>
#include <lamella/section/lagrange_element.h>
#include <lamella/shape/shapes.h>
#include <lamella/solve/linear_system.h>

#include <deal.II/base/quadrature_lib.h>

#include <functional>
#include <iomanip>
#include <memory>
#include <sstream>
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
            {cells_per_ply},
            {cells_across}};
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
  make_section(const Laminate    &laminate,
               const Material    &material,
               const unsigned int degree)
  {
    return make_section(make_section_mesh(laminate, {{"material", material}}),
                        degree);
  }

  /// Gauss points of the boundary named @p boundary, @p n on each side of a
  /// cell, with weights of the integral over its length.
  inline std::vector<EdgePoint>
  edge_quadrature(const CrossSectionElement &element,
                  const std::string         &boundary,
                  const unsigned int         n)
  {
    const dealii::QGauss<1> rule(n);
    std::vector<EdgePoint>  points;
    for (const auto &[cell, face] : element.boundary_faces(boundary))
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          points.push_back(element.edge_point(cell, face, rule.point(q)[0]));
          points.back().weight *= rule.weight(q);
        }
    return points;
  }

  inline std::shared_ptr<const Axis>
  make_axis(const double       length,
            const unsigned int elements,
            const unsigned int degree        = 3,
            const bool         assumed_shear = false)
  {
    AxisMesh mesh;
    mesh.length        = length;
    mesh.degree        = degree;
    mesh.elements      = {elements};
    mesh.assumed_shear = assumed_shear;
    return std::make_shared<Axis>(mesh);
  }

  /// A displacement field in scene coordinates.
  using Field = std::function<dealii::Tensor<1, 3>(const dealii::Point<3> &)>;

  /// Rows that prescribe @p field at all nodes of the surface of @p body.
  inline std::vector<PrescribedFunctional>
  prescribe_on_surface(const Body &body, const Field &field)
  {
    std::vector<PrescribedFunctional> rows;
    for (const std::string &surface : body.surfaces())
      if (surface != "ends" && surface != "all")
        {
          std::vector<Location> locations;
          for (const SurfacePoint &p : body.surface_points(surface))
            locations.push_back(p.location);
          const auto all = body.rows(locations, undisplaced);
          for (unsigned int i = 0; i < all.size(); ++i)
            for (unsigned int c = 0; c < 3; ++c)
              rows.push_back({{0, all[i][c]},
                              field(locations[i].position)[c],
                              0,
                              scene_axis(c),
                              locations[i].position});
        }
    return rows;
  }

  /// The displacements of @p body, factorized, under @p reduction alone,
  /// refined
  /// @p refinements times against the strain-first residual.
  inline Vector
  solve_factorized(const Body         &body,
                   const LinearSolver &solver,
                   const RowReduction &reduction,
                   const unsigned int  refinements = 2)
  {
    Vector u = reduction.particular();
    for (unsigned int k = 0; k <= refinements; ++k)
      {
        Vector r(body.n_dofs());
        body.add_internal_forces(u, r);
        r *= -1.;
        reduction.constraints().condense(r);
        reduction.constraints().set_zero(r);
        solver.solve(r);
        reduction.constraints().distribute(r);
        u += r;
      }
    return u;
  }

  /// The displacements of @p body under @p rows alone.
  inline Vector
  solve_prescribed(Body                                    &body,
                   const std::vector<PrescribedFunctional> &rows,
                   const unsigned int                       refinements = 2)
  {
    const RowReduction reduction(body, 0, rows, {"surface"});
    return solve_factorized(body,
                            *make_solver(body, reduction.constraints()),
                            reduction,
                            refinements);
  }

  /// A body held and loaded, and its displacements at load factor 1.
  struct Solved
  {
    std::unique_ptr<Structure> structure;
    State                      state;
    double                     condition = 0.;

    FieldSample
    at(const dealii::Point<3> &point) const
    {
      const Body &body = *structure->bodies()[0];
      return body.sample(body.locate({point}).at(0).at(0), state.u.block(0));
    }

    /// Half the work of the loads.
    double
    strain_energy() const
    {
      return structure->bodies()[0]->deformation(state.u.block(0)).energy;
    }
  };

  /// Solves for @p body alone, as a run does, with @p refinements at most.
  inline Solved
  solve_linear(std::unique_ptr<Body>       body,
               const std::vector<Support> &supports,
               const std::vector<Load>    &loads,
               const unsigned int          refinements = 6)
  {
    Bodies bodies;
    bodies.push_back(std::move(body));
    Solved solved;
    solved.structure =
      std::make_unique<Structure>(std::move(bodies), supports, loads);
    const std::vector<GapConstraint> none;
    NonlinearParameters              parameters;
    parameters.max_refinements = refinements;
    LinearSystem solver(linearized(*solved.structure), none, parameters);
    solved.state     = solver.solve_free(1.);
    solved.condition = solver.tangent().condition_estimate();
    return solved;
  }

  /// @p value for an expression, to the last digit.
  inline std::string
  digits(const double value)
  {
    std::ostringstream text;
    text << std::setprecision(17) << value;
    return text.str();
  }

  /// u = 0 on @p surface of the one body.
  inline Support
  clamp(const std::string &surface)
  {
    return {surface, {{0, Region::Kind::surface, surface, {}}}, {{0., 0., 0.}}};
  }

  /// Tractions on @p surface of the one body, as expressions.
  inline Load
  traction(const std::string &surface,
           const std::string &x,
           const std::string &y,
           const std::string &z)
  {
    return {"traction",
            {{0, Region::Kind::surface, surface, {}}},
            {{x, y, z}},
            ""};
  }
} // namespace lamella

#endif
