// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_sparse_interface_system_h
#define lamella_solve_sparse_interface_system_h

#include <lamella/solve/interface_system.h>
#include <lamella/solve/penalty_matrix.h>

namespace lamella
{
  /// Adds the nodal forces B^T (@p force - those of the state of @p problem) of
  /// all constraints to @p f.
  void
  add_contact_forces(const GapConstraints &rows,
                     const ContactProblem &problem,
                     const PointVectors   &force,
                     BlockVector          &f);

  /// Equilibrium of the bodies by the sparse matrix K + K^p, K^p = B^T D B, of
  /// all DoFs, for many contact points. Keeps references to all arguments.
  /// Collective.
  class SparseInterfaceSystem : public InterfaceSystem
  {
  public:
    /// Creates the system for the increments of @p problem; @p matrix has the
    /// stiffness of @p tangent_operator.
    SparseInterfaceSystem(const TangentOperator     &tangent_operator,
                          const GapConstraints      &rows,
                          const NumericalCompliance &compliance,
                          const ContactProblem      &problem,
                          PenaltyMatrix             &matrix);

    /// Returns the contact points of the constraints.
    InterfacePoints
    points() const;

    void
    factorize(const PointStiffness &D) override;
    PointVectors
    solve(const PointVectors &force) override;
    InterfaceStep
    solve(const std::vector<LinearizedLaw> &laws,
          const PointVectors               &force) override;
    bool
    move_to(const PointVectors &force) override;
    void
    advance(const double t) override;
    PointVectors
    lengths() const override;

    /// Returns the displacement increment of the iterate.
    const BlockVector &
    displacement() const
    {
      return du;
    }

  private:
    const TangentOperator     &tangent_operator;
    const GapConstraints      &rows;
    const NumericalCompliance &compliance;
    const ContactProblem      &problem;
    PenaltyMatrix             &matrix;
    /// Symmetric matrix of factorize(); released by the next linearized laws.
    std::unique_ptr<PenaltyMatrix> symmetric;
    BlockVector                    du; ///< Displacement increment.
    BlockVector K_du;                  ///< Forces K du, computed from strains.
    BlockVector step;                  ///< Change of du by the last solution.
  };
} // namespace lamella

#endif
