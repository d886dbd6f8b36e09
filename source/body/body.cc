// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>
#include <lamella/base/text.h>
#include <lamella/body/body.h>
#include <lamella/linear/factorization.h>
#include <lamella/shape/section_mesh.h>

#include <deal.II/base/quadrature_lib.h>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // From here on the factor of a solid takes tens of gigabytes and minutes.
    constexpr DofIndex large_for_a_factor = 300000;
  } // namespace



  Body::Body(std::string name, const Placement &placement)
    : placement(placement)
    , body_name(std::move(name))
  {}



  Body::~Body() = default;



  const Constraints &
  Body::kinematic_constraints() const
  {
    static const Constraints none = [] {
      Constraints empty;
      empty.close();
      return empty;
    }();
    return none;
  }



  Point<3>
  Body::center() const
  {
    return bounding_box().center();
  }



  double
  Body::size() const
  {
    const BoundingBox<3> box = bounding_box();
    return 0.5 *
           std::max(
             {box.side_length(0), box.side_length(1), box.side_length(2)});
  }



  namespace
  {
    [[noreturn]] void
    refuse_material(const Ply         &ply,
                    const std::string &property,
                    const Body        &body,
                    const std::string &what_asks_for_it,
                    const std::string &remedy)
    {
      throw InputError("Material " + ply.material,
                       "",
                       "body.material-property-missing: the material has no " +
                         property + ", and body '" + body.name() +
                         "', which consists of this material, " +
                         what_asks_for_it,
                       remedy);
    }
  } // namespace



  void
  Body::heat(const ScalarField &change)
  {
    for (const Ply &ply : plies())
      if (!ply.properties.expansion)
        refuse_material(ply,
                        "Thermal expansion",
                        *this,
                        "has a Temperature",
                        "Write it, or remove the body from the load.");
    temperature_change = change;
  }



  std::vector<double>
  Body::densities() const
  {
    std::vector<double> rho;
    for (const Ply &ply : plies())
      {
        if (!ply.properties.density)
          refuse_material(
            ply,
            "Density",
            *this,
            "is under Gravity",
            "Give it (0 if its weight does not count), or leave out Gravity.");
        rho.push_back(*ply.properties.density);
      }
    return rho;
  }



  std::vector<Point<3>>
  Body::line_points(const Point<3> &from, const Point<3> &to) const
  {
    const QGaussLobatto<1>    nodes(line_degree(from, to) + 1);
    const std::vector<double> breaks = line_breaks(from, to);
    std::vector<Point<3>>     points;
    for (unsigned int k = 0; k + 1 < breaks.size(); ++k)
      for (unsigned int q = k == 0 ? 0 : 1; q < nodes.size(); ++q)
        points.push_back(
          from + (breaks[k] + nodes.point(q)[0] * (breaks[k + 1] - breaks[k])) *
                   (to - from));
    return points;
  }



  double
  Body::stiffness_entries() const
  {
    double n = 0.;
    for_each_stiffness_block(false, [&n](const StiffnessBlock &block) {
      n += double(block.rows.size()) * block.columns.size();
    });
    return dealii::Utilities::MPI::sum(n, communicator());
  }



  SolverKind
  Body::solver_kind(const SolverKind requested) const
  {
    const bool alone = n_processes() == 1;
    if (requested == SolverKind::automatic)
      return is_nodal() && n_dofs() > large_for_a_factor ? SolverKind::cg :
             alone                                       ? SolverKind::cholmod :
                                                           SolverKind::mumps;
    if (requested == SolverKind::cholmod && !alone)
      throw InputError(
        "Linear solver",
        name_of(requested),
        "body.solver-in-parallel: this solver works on one process only, "
        "but there are " +
          std::to_string(n_processes()) + " processes",
        "Choose auto or mumps, or start the program without mpirun.");
    if (requested == SolverKind::cg && !is_nodal())
      throw InputError(
        "Linear solver",
        name_of(requested),
        "body.multigrid-of-beam: this solver cannot be used for body '" +
          name() + "' (" + theory() +
          "): algebraic multigrid needs nodal displacements as DoFs, "
          "but the DoFs of a beam are amplitudes of section functions",
        "Choose auto or mumps.");
    return requested;
  }



  StiffnessTerms
  Body::stiffness_terms(const std::vector<SpringTerm> &springs) const
  {
    return {n_dofs(),
            owned_dofs(),
            [this](const bool with_values, const auto &use) {
              for_each_stiffness_block(with_values, use);
            },
            springs};
  }



  std::unique_ptr<StiffnessMatrix>
  Body::assembled(const StiffnessTerms &terms,
                  const Constraints    &constraints,
                  const SolverKind      requested) const
  {
    const SolverKind kind = solver_kind(requested);
    if (kind == SolverKind::cholmod)
      return assemble_serial(terms, constraints);
    return assemble_distributed(terms,
                                constraints,
                                kind,
                                kind == SolverKind::cg ? rigid_motions() :
                                                         std::vector<Vector>());
  }



  std::unique_ptr<StiffnessMatrix>
  Body::assembled_stiffness(const Constraints             &constraints,
                            const std::vector<SpringTerm> &springs,
                            const SolverKind               requested) const
  {
    return assembled(stiffness_terms(springs), constraints, requested);
  }



  std::unique_ptr<LinearSolver>
  Body::solver_of(const StiffnessTerms &terms,
                  const Constraints    &constraints,
                  const SolverKind      requested,
                  const SolverMonitor  &monitor) const
  {
    const auto matrix = assembled(terms, constraints, requested);
    if (monitor.assembled)
      monitor.assembled();
    try
      {
        return matrix->factorize("body '" + name() + "'",
                                 [&](const FactorSize &size) {
                                   matrix->release();
                                   if (monitor.factor_sized)
                                     monitor.factor_sized(size);
                                 });
      }
    catch (const NotPositiveDefinite &error)
      {
        rethrow_with_position(error);
      }
  }



  std::unique_ptr<LinearSolver>
  Body::make_solver(const Constraints             &constraints,
                    const std::vector<SpringTerm> &springs,
                    const SolverKind               requested,
                    const SolverMonitor           &monitor) const
  {
    return solver_of(stiffness_terms(springs), constraints, requested, monitor);
  }



  void
  Body::for_each_tangent_block(
    const Vector &,
    const Vector &,
    const bool,
    const std::function<void(const StiffnessBlock &)> &) const
  {
    Assert(false, dealii::ExcNotImplemented());
  }



  StiffnessTerms
  Body::tangent_terms(const Vector                  &u,
                      const Vector                  &correction,
                      const std::vector<SpringTerm> &springs) const
  {
    StiffnessTerms terms = stiffness_terms(springs);
    if (has_finite_rotations())
      // Copies: whoever has the terms may outlive the state.
      terms.for_each_block =
        [this,
         u,
         correction = correction.size() > 0 ? correction : Vector(u.size())](
          const bool                                         with_values,
          const std::function<void(const StiffnessBlock &)> &use) {
          for_each_tangent_block(u, correction, with_values, use);
        };
    return terms;
  }



  void
  Body::add_tangent_forces(const Vector &u, const Vector &w, Vector &f) const
  {
    if (!has_finite_rotations())
      return add_internal_forces(w, f);
    Vector share(f.size());
    for_each_tangent_block(u,
                           Vector(u.size()),
                           true,
                           [&](const StiffnessBlock &block) {
                             block.add_product(w, share);
                           });
    sum_over_processes(share);
    f += share;
  }



  std::unique_ptr<LinearSolver>
  Body::make_tangent_solver(const Vector                  &u,
                            const Vector                  &correction,
                            const Constraints             &constraints,
                            const std::vector<SpringTerm> &springs,
                            const SolverKind               requested,
                            const SolverMonitor           &monitor) const
  {
    return has_finite_rotations() ?
             solver_of(tangent_terms(u, correction, springs),
                       constraints,
                       requested,
                       monitor) :
             make_solver(constraints, springs, requested, monitor);
  }



  std::vector<OutputCell>
  Body::output_cells(const unsigned int n, const Vector &u) const
  {
    std::vector<OutputCell> cells;
    for_each_output_cell({{n, n, n}},
                         u,
                         [&cells](const unsigned int number,
                                  const OutputCell  &cell) {
                           if (number >= cells.size())
                             cells.resize(number + 1);
                           cells[number] = cell;
                         });
    return cells;
  }



  void
  Body::rethrow_with_position(const NotPositiveDefinite &error) const
  {
    if (error.dof == numbers::invalid_dof_index)
      throw;
    throw NotPositiveDefinite(std::string(error.what()) +
                                " It occurs first near " +
                                to_text(dof_position(error.dof)) +
                                ": look there for elements much shorter or "
                                "thinner than their neighbors.",
                              error.dof);
  }
} // namespace lamella
