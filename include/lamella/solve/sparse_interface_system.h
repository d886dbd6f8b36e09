// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_sparse_interface_system_h
#define lamella_solve_sparse_interface_system_h

#include <lamella/solve/interface_system.h>
#include <lamella/solve/penalty_matrix.h>

namespace lamella
{
  /// Returns the gap and slips of each constraint in the proximal problem about
  /// the force estimates lambda_bar of @p problem, without the term d lambda:
  ///   (g, s - s_0) - (d - a) lambda_bar
  /// at the displacement increment @p du, with the compliance a of the law and
  /// the numerical compliance d.
  PointVectors
  proximal_lengths(const GapConstraints      &rows,
                   const NumericalCompliance &compliance,
                   const ContactProblem      &problem,
                   const BlockVector         &du);

  /// Adds the nodal forces B^T (@p force - those of the state of @p problem) of
  /// all constraints to @p f.
  void
  add_contact_forces(const GapConstraints &rows,
                     const ContactProblem &problem,
                     const PointVectors   &force,
                     BlockVector          &f);

  /// Equilibrium of the bodies by the sparse matrix K + B^T D B of all DoFs,
  /// for many contact points. Keeps references to all arguments. Collective.
  class SparseInterfaceSystem : public InterfaceSystem
  {
  public:
    /// Assembles the stiffness of @p tangent_operator for the increments of
    /// @p problem.
    SparseInterfaceSystem(const TangentOperator     &tangent_operator,
                          const GapConstraints      &rows,
                          const NumericalCompliance &compliance,
                          const ContactProblem      &problem);

    /// Returns the contact points of the constraints.
    InterfacePoints
    points() const;

    void
    factorize(const PointStiffness &D) override;
    PointVectors
    solve(const PointVectors &force) override;
    void
    advance(const double t) override;
    PointVectors
    lengths() const override;

    BlockVector du;   ///< Displacement increment of the iterate.
    BlockVector K_du; ///< Forces K du, computed from strains.

  private:
    const TangentOperator     &tangent_operator;
    const GapConstraints      &rows;
    const NumericalCompliance &compliance;
    const ContactProblem      &problem;
    PenaltyMatrix              matrix;
    BlockVector                step;
  };
} // namespace lamella

#endif
