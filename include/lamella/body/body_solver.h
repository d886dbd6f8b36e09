// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_body_body_solver_h
#define lamella_body_body_solver_h

#include <lamella/body/body.h>

namespace lamella
{
  class NotPositiveDefinite;

  /// Returns the solver @p requested or, if it is `automatic`, `cg` for nodal
  /// bodies of more than 300000 DoFs, otherwise CHOLMOD on one process and
  /// MUMPS on several. Throws InputError for `cholmod` on several processes and
  /// for `cg` if Body::is_nodal() is false.
  SolverKind
  solver_kind(const Body &body, const SolverKind requested);

  /// Returns the terms of the unconstrained tangent stiffness K(u) + sum k r^T
  /// r of @p body, where each of @p springs has a stiffness k and an elongation
  /// r, a functional of the DoFs. For the Newton @p correction see
  /// Body::for_each_stiffness_block(). The body must outlive the result.
  StiffnessTerms
  stiffness_terms(const Body                    &body,
                  const Vector                  &u          = undisplaced,
                  const Vector                  &correction = undisplaced,
                  const std::vector<SpringTerm> &springs    = {});

  /// Returns the stiffness T^T (K + sum k r^T r) T of the undeformed @p body,
  /// assembled for the automatic solver; see stiffness_terms(). The homogeneous
  /// @p constraints u = T v must include Body::kinematic_constraints(). Throws
  /// as solver_kind() does. Collective.
  std::unique_ptr<StiffnessMatrix>
  assembled_stiffness(const Body                    &body,
                      const Constraints             &constraints,
                      const std::vector<SpringTerm> &springs = {});

  /// Returns a solver for the matrix of assembled_stiffness(); see
  /// Body::solver_of() for exceptions. Collective.
  std::unique_ptr<LinearSolver>
  make_solver(const Body                    &body,
              const Constraints             &constraints,
              const std::vector<SpringTerm> &springs   = {},
              const SolverKind               requested = SolverKind::automatic);

  /// Adds the product of @p w and the sum over all processes of the blocks for
  /// which @p for_each_block calls its argument to @p f. Collective.
  void
  add_product_of_blocks(
    const std::function<void(const BlockCallback &)> &for_each_block,
    const Vector                                     &w,
    Vector                                           &f);

  /// Rethrows @p error as a NumericsError with the position of its DoF.
  [[noreturn]] void
  rethrow_with_position(const Body &body, const NotPositiveDefinite &error);
} // namespace lamella

#endif
