// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_tangent_operator_h
#define lamella_solve_tangent_operator_h

#include <lamella/base/exceptions.h>
#include <lamella/solve/structure.h>

#include <functional>
#include <memory>
#include <vector>

namespace lamella
{
  /// The tangent stiffness of a structure at one displacement state u,
  ///   K(u) = d f_int / du,
  /// with the internal forces f_int of bodies and springs. It provides terms
  /// for assembly, the product K w and, optionally, linear solvers for each
  /// body. For linear bodies, the tangent at u = 0 is valid at all u.
  /// Immutable. Keeps a reference to the structure. Collective.
  class TangentOperator
  {
  public:
    /// Optional callbacks during the setup of the solver of each body. If
    /// `factor_sized` throws, no factor is allocated.
    struct BodyMonitor
    {
      std::function<void(const Body &)> begins;    ///< Before assembly.
      std::function<void(const Body &)> assembled; ///< After assembly.
      std::function<void(const Body &)> ends;      ///< After factorization.
      /// Called with the size of the factor before its memory is allocated.
      std::function<void(const Body &, const FactorSize &)> factor_sized;
    };

    /// Pattern of the matrix of each body.
    using MatrixPatterns = std::vector<std::shared_ptr<MatrixPattern>>;

    /// Creates the tangent at the displacements @p u and load factor @p factor
    /// without linear solvers, for FullStrategy.
    TangentOperator(const Structure   &structure,
                    const BlockVector &u,
                    const LoadFactor  &factor     = LoadFactor(),
                    const BlockVector &correction = BlockVector(),
                    const std::vector<std::vector<SpringTerm>> &more = {});

    /// Creates the tangent at the displacements @p u, with linear solvers of
    /// the kind @p requested for the stiffness of each body in its free DoFs.
    /// Bodies with finite rotations use @p correction, the last one of Newton's
    /// method or empty, to predict the stress of their geometric stiffness. The
    /// solvers include follower loads at load factor @p factor and additional
    /// springs @p more of each body. Matrices with equal patterns have @p
    /// matrix_patterns, one per body or none, in common. Throws
    /// IllConditioned if a stiffness is not positive definite, and InputError
    /// if a solver is not available.
    TangentOperator(const Structure   &structure,
                    const BlockVector &u,
                    const SolverKind   requested,
                    const BodyMonitor &monitor    = {},
                    const BlockVector &correction = BlockVector(),
                    const LoadFactor  &factor     = LoadFactor(),
                    const std::vector<std::vector<SpringTerm>> &more = {},
                    const MatrixPatterns &matrix_patterns            = {});

    /// Returns the structure whose tangent stiffness this is.
    const Structure &
    of() const
    {
      return structure;
    }

    /// Returns the displacements u of this tangent.
    const BlockVector &
    displacements() const
    {
      return state;
    }

    /// Returns the linear equations by which supports constrain an increment of
    /// the displacements; for finite rotations they depend on the state.
    const std::vector<PrescribedFunctional> &
    prescribed() const
    {
      return moved_rows.empty() ? structure.prescribed() : moved_rows;
    }
    /// Returns the elimination of the DoFs of @p body that supports prescribe.
    const RowReduction &
    reduction(const unsigned int body) const
    {
      return moved_reductions[body] == nullptr ? structure.reduction(body) :
                                                 *moved_reductions[body];
    }

    /// Condenses the forces @p r in place onto the free DoFs.
    void
    condense(BlockVector &r) const;

    /// Returns the increment of the prescribed displacements from load factor
    /// @p from, that of the state, to @p to. Finite rotations are linearized.
    BlockVector
    support_increment(const LoadFactor &from, const LoadFactor &to) const;

    /// Distance of a support point from its prescribed position.
    struct SupportError
    {
      dealii::Point<3> place;      ///< Position of the point.
      double           share = 0.; ///< Distance over tolerance.
    };
    /// Returns the largest distance of a support point from its prescribed
    /// position at load factor @p at, relative to the tolerance.
    SupportError
    largest_support_error(const LoadFactor &at) const;

    /// Returns the terms of the stiffness of @p body: internal forces with
    /// predicted stresses, springs and follower loads, whose unsymmetric part
    /// does not belong to the stiffness.
    StiffnessTerms
    terms(const unsigned int body) const;
    /// Returns true if apply() is the product with the matrix of terms(): there
    /// are neither predicted stresses nor follower loads or additional springs.
    bool
    applies_terms() const
    {
      return correction.n_blocks() == 0 && more.empty() &&
             !structure.has_unsymmetric_loads();
    }

    /// Returns the product of tangent stiffness and @p w in all DoFs, computed
    /// from strains, springs included (applies_terms()).
    BlockVector
    apply(const BlockVector &w) const;

    /// Returns the linear solver for the stiffness of @p body in its free DoFs.
    const LinearSolver &
    solver(const unsigned int body) const;

    /// Returns the solution x of K x = r, zero in prescribed DoFs, for the
    /// forces @p r in all DoFs. Requires solvers. If follower loads add an
    /// unsymmetric matrix A to the symmetric tangent K, solves
    ///   (1 + K^-1 A) x = K^-1 r
    /// by GMRES; returns K^-1 r if GMRES does not converge.
    BlockVector
    solve(BlockVector r) const;

    /// Returns the largest diagonal entry of the stiffness of @p body in its
    /// free DoFs; without solvers, that at zero displacements.
    double
    largest_stiffness(const unsigned int body) const;

    /// Returns a lower bound of the largest condition number; 0 if unknown.
    double
    condition_estimate() const;

  private:
    /// Linearizes the support equations of bodies with finite rotations about
    /// the displacements of this tangent.
    void
    move_supports();

    /// Returns the solution for the forces @p r with the symmetric tangent.
    BlockVector
    solve_symmetric(BlockVector r) const;
    /// Returns the unsymmetric part of the follower-load tangent times @p w.
    BlockVector
    unsymmetric_part(const BlockVector &w) const;

    const Structure  &structure;
    const BlockVector state;
    const LoadFactor  factor;
    /// Last correction by Newton's method, for the prediction of stresses, and
    /// additional springs of each body; both may be empty.
    const BlockVector                          correction;
    const std::vector<std::vector<SpringTerm>> more;
    std::vector<std::unique_ptr<LinearSolver>> solvers;
    /// Support equations linearized about the displacements, their values, and
    /// the elimination of DoFs by them. Empty for small rotations.
    std::vector<PrescribedFunctional>          moved_rows;
    std::vector<double>                        measured;
    std::vector<std::unique_ptr<RowReduction>> moved_reductions;
  };

  /// Returns the tangent stiffness at zero displacements, with solvers.
  std::shared_ptr<const TangentOperator>
  linearized(const Structure &structure,
             const SolverKind requested = SolverKind::automatic,
             const TangentOperator::BodyMonitor &monitor = {});

  /// Returns the tangent stiffness at zero displacements, without solvers.
  std::shared_ptr<const TangentOperator>
  linearized_without_solvers(const Structure &structure);

  /// Exception: the problem cannot be solved in double precision, for example
  /// due to an indefinite stiffness or unbalanced forces. The solution is then
  /// repeated with additional section functions of the beams.
  class IllConditioned : public NumericsError
  {
  public:
    using NumericsError::NumericsError;
  };
} // namespace lamella

#endif
