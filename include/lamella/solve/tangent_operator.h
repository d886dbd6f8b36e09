// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_tangent_operator_h
#define lamella_solve_tangent_operator_h

#include <lamella/solve/structure.h>

#include <functional>
#include <memory>
#include <vector>

namespace lamella
{
  /// The tangent stiffness of a structure at one state u,
  ///   K(u) = d f_int / du,
  /// with the internal forces f_int, springs included: as terms for assembly,
  /// as a product K w, and optionally with linear solvers for each body. For
  /// linear bodies, the tangent at u = 0 is valid at all u. Immutable. Keeps a
  /// reference to the structure. Collective.
  class TangentOperator
  {
  public:
    /// Optional callbacks for each body: `begins` before its stiffness is
    /// assembled, `assembled` after that, `factor_sized` with the size of the
    /// Cholesky factor before its memory is allocated, `ends` at the end. If
    /// `factor_sized` throws, nothing is allocated.
    struct BodyMonitor
    {
      std::function<void(const Body &)>                     begins, assembled;
      std::function<void(const Body &)>                     ends;
      std::function<void(const Body &, const FactorSize &)> factor_sized;
    };

    /// Creates the tangent at the displacements @p u and load factor @p factor
    /// without linear solvers, for FullStrategy.
    TangentOperator(const Structure   &structure,
                    const BlockVector &u,
                    const LoadFactor  &factor = LoadFactor());

    /// Creates the tangent at the displacements @p u with linear solvers of the
    /// kind @p requested for the stiffness of each body in its free DoFs. From
    /// the last Newton correction @p correction, if any, bodies with finite
    /// rotations predict the stress of their geometric stiffness. The solvers,
    /// not terms() and apply(), include follower loads at load factor @p factor
    /// and additional @p springs of each body. Throws IllConditioned if a
    /// stiffness is not positive definite, and InputError as
    /// Body::solver_kind() does.
    TangentOperator(const Structure   &structure,
                    const BlockVector &u,
                    const SolverKind   requested,
                    const BodyMonitor &monitor    = {},
                    const BlockVector &correction = BlockVector(),
                    const LoadFactor  &factor     = LoadFactor(),
                    const std::vector<std::vector<SpringTerm>> &springs = {});

    const Structure &
    of() const
    {
      return structure;
    }

    /// Returns the linear constraints that all supports impose on an increment
    /// of the displacements; at finite rotations they depend on the state.
    /// reduction() eliminates those of @p body.
    const std::vector<PrescribedFunctional> &
    prescribed() const
    {
      return moved_rows.empty() ? structure.prescribed() : moved_rows;
    }
    const RowReduction &
    reduction(const unsigned int body) const
    {
      return moved_reductions.empty() || moved_reductions[body] == nullptr ?
               structure.reduction(body) :
               *moved_reductions[body];
    }

    /// Condenses the forces @p r in place onto the free DoFs; entries of DoFs
    /// that supports eliminate become zero.
    void
    condense(BlockVector &r) const;

    /// Returns the increment of the prescribed displacements from load factor
    /// @p from of the state to @p to. Finite rotations are linearized:
    /// second-order terms would compress an unbent beam.
    BlockVector
    support_increment(const LoadFactor &from, const LoadFactor &to) const;

    /// Point of a support, and its distance from its prescribed position,
    /// divided by the tolerance.
    struct SupportError
    {
      dealii::Point<3> place;
      double           share = 0.;
    };
    /// Returns the largest support error of the state at load factor @p at.
    SupportError
    largest_support_error(const LoadFactor &at) const;

    /// Returns the terms of K(u) of @p body, springs included.
    StiffnessTerms
    terms(const unsigned int body) const;

    /// Returns K(u) @p w in all DoFs, springs included, computed from strains.
    BlockVector
    apply(const BlockVector &w) const;

    /// Returns the solver for the condensed stiffness of @p body.
    const LinearSolver &
    solver(const unsigned int body) const;

    /// Returns K(u)^-1 @p r, zero in prescribed DoFs; r need not be condensed.
    /// Requires solvers. If follower loads contribute an unsymmetric part A,
    /// solves
    ///   (1 + K^-1 A) x = K^-1 r
    /// by GMRES, or returns K^-1 r if GMRES does not converge.
    BlockVector
    solve(BlockVector r) const;

    /// Returns the largest diagonal entry of the condensed stiffness of
    /// @p body. If there are no solvers, the first call assembles its matrix.
    double
    largest_stiffness(const unsigned int body) const;

    /// Returns the largest condition number of the bodies' stiffnesses,
    /// estimated from below; 0 if unknown.
    double
    condition_estimate() const;

  private:
    /// Creates prescribed rows and reductions of bodies with finite rotations.
    void
    move_supports();

    /// Returns the solver for the stiffness of @p body with its @p springs.
    std::unique_ptr<LinearSolver>
    make_solver(const unsigned int             body,
                const SolverKind               requested,
                const Vector                  &correction,
                const std::vector<SpringTerm> &springs,
                const SolverMonitor           &monitor) const;

    /// Returns K^-1 @p r.
    BlockVector
    solve_symmetric(BlockVector r) const;
    /// Returns A @p w with the unsymmetric tangent A of follower loads.
    BlockVector
    unsymmetric_part(const BlockVector &w) const;

    const Structure                           &structure;
    const BlockVector                          state;
    const LoadFactor                           factor;
    std::vector<std::unique_ptr<LinearSolver>> solvers;
    /// Finite rotations: support constraints at the state, and their values.
    std::vector<PrescribedFunctional>          moved_rows;
    std::vector<double>                        measured;
    std::vector<std::unique_ptr<RowReduction>> moved_reductions;
    /// Cached largest_stiffness() if there are no solvers.
    mutable std::vector<double> stiffest;
  };

  /// Returns the tangent at u = 0 with solvers.
  std::shared_ptr<const TangentOperator>
  linearized(const Structure &structure,
             const SolverKind requested = SolverKind::automatic,
             const TangentOperator::BodyMonitor &monitor = {});

  /// Returns the tangent at u = 0 without solvers, for the `full` strategy.
  std::shared_ptr<const TangentOperator>
  linearized_without_solvers(const Structure &structure);
} // namespace lamella

#endif
