// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/processes.h>
#include <lamella/base/text.h>
#include <lamella/body/body_solver.h>
#include <lamella/linear/factorization.h>

namespace lamella
{
  using namespace dealii;

  SolverKind
  solver_kind(const Body &body, const SolverKind requested)
  {
    // From here on the factor of a solid takes tens of gigabytes and minutes.
    constexpr DofIndex large_for_a_factor = 300000;
    const bool         alone              = n_processes() == 1;
    if (requested == SolverKind::automatic)
      return body.is_nodal() && body.n_dofs() > large_for_a_factor ?
               SolverKind::cg :
             alone ? SolverKind::cholmod :
                     SolverKind::mumps;
    if (requested == SolverKind::cholmod && !alone)
      throw InputError(
        "Linear solver",
        name_of(requested),
        "body.solver-in-parallel: this solver works on one process only, "
        "but there are " +
          std::to_string(n_processes()) + " processes",
        "Choose auto or mumps, or start the program without mpirun.");
    if (requested == SolverKind::cg && !body.is_nodal())
      throw InputError(
        "Linear solver",
        name_of(requested),
        "body.multigrid-of-beam: this solver cannot be used for body '" +
          body.name() + "' (" + body.theory() +
          "): algebraic multigrid needs nodal displacements as DoFs, "
          "but the DoFs of a beam are amplitudes of section functions",
        "Choose auto or mumps.");
    return requested;
  }



  StiffnessTerms
  stiffness_terms(const Body                    &body,
                  const Vector                  &u,
                  const Vector                  &correction,
                  const std::vector<SpringTerm> &springs)
  {
    // Copies: whoever has the terms may outlive the state.
    return {body.n_dofs(),
            body.owned_dofs(),
            [&body,
             u,
             correction = correction.size() > 0 ?
                            correction :
                            Vector(u.size())](const bool  with_values,
                                              const auto &use) {
              body.for_each_stiffness_block(u, correction, with_values, use);
            },
            springs};
  }



  namespace
  {
    /// Returns the condensed matrix of @p terms for the solver @p requested.
    std::unique_ptr<StiffnessMatrix>
    assembled(const Body           &body,
              const StiffnessTerms &terms,
              const Constraints    &constraints,
              const SolverKind      requested)
    {
      const SolverKind kind = solver_kind(body, requested);
      if (kind == SolverKind::cholmod)
        return assemble_serial(terms, constraints);
      return assemble_distributed(terms,
                                  constraints,
                                  kind,
                                  kind == SolverKind::cg ?
                                    body.rigid_motions(undisplaced) :
                                    std::vector<Vector>());
    }
  } // namespace



  std::unique_ptr<StiffnessMatrix>
  assembled_stiffness(const Body                    &body,
                      const Constraints             &constraints,
                      const std::vector<SpringTerm> &springs)
  {
    return assembled(body,
                     stiffness_terms(body, undisplaced, undisplaced, springs),
                     constraints,
                     SolverKind::automatic);
  }



  std::unique_ptr<LinearSolver>
  Body::solver_of(const StiffnessTerms &terms,
                  const Constraints    &constraints,
                  const SolverKind      requested,
                  const SolverMonitor  &monitor) const
  {
    const auto matrix = assembled(*this, terms, constraints, requested);
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
        rethrow_with_position(*this, error);
      }
  }



  std::unique_ptr<LinearSolver>
  make_solver(const Body                    &body,
              const Constraints             &constraints,
              const std::vector<SpringTerm> &springs,
              const SolverKind               requested)
  {
    return body.solver_of(
      stiffness_terms(body, undisplaced, undisplaced, springs),
      constraints,
      requested,
      {});
  }



  void
  add_product_of_blocks(
    const std::function<void(const BlockCallback &)> &for_each_block,
    const Vector                                     &w,
    Vector                                           &f)
  {
    Vector share(f.size());
    for_each_block(
      [&](const StiffnessBlock &block) { block.add_product(w, share); });
    sum_over_processes(share);
    f += share;
  }



  void
  rethrow_with_position(const Body &body, const NotPositiveDefinite &error)
  {
    if (error.dof == numbers::invalid_dof_index)
      throw;
    throw NotPositiveDefinite(std::string(error.what()) +
                                " It occurs first near " +
                                to_text(body.dof(error.dof).position) +
                                ": look there for elements much shorter or "
                                "thinner than their neighbors.",
                              error.dof);
  }
} // namespace lamella
