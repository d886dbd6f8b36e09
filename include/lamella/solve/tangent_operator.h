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
  /// including springs: as terms for assembly, as a product, and optionally
  /// with linear solvers for each body. It is immutable. For linear bodies,
  /// that at u = 0 is always valid. Keeps a reference to the structure.
  /// Collective.
  class TangentOperator
  {
  public:
    /// Optional callbacks for each body: at the beginning and end of its
    /// factorization, after assembly, and with the size of its factor before
    /// memory is allocated. Exceptions of `factor_sized` prevent this.
    struct BodyMonitor
    {
      std::function<void(const Body &)>                     begins, assembled;
      std::function<void(const Body &)>                     ends;
      std::function<void(const Body &, const FactorSize &)> factor_sized;
    };

    /// Creates the tangent at @p u without solvers, for the `full` strategy.
    TangentOperator(const Structure   &structure,
                    const BlockVector &u,
                    const LoadFactor  &factor = LoadFactor());

    /// Creates the tangent at @p u with solvers of the kind @p requested for
    /// the condensed stiffness of each body. @p correction is the last
    /// correction of u, if any, for predicted stresses. Follower loads at load
    /// factor @p factor and additional @p springs of each body contribute to
    /// the solvers only. Throws IllConditioned if a stiffness is not positive
    /// definite, InputError as Body::solver_kind() does, and what @p monitor
    /// throws.
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

    /// Returns the prescribed rows of all supports for increments of the state:
    /// those of the structure, except for bodies with finite rotations.
    /// reduction() returns the expansion G of @p body in the same way.
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

    /// Computes G^T r in place, zero in the eliminated DoFs.
    void
    condense(BlockVector &r) const;

    /// Returns the increment of the prescribed displacements from load factor
    /// @p from, that of the state, to @p to. With finite rotations this is the
    /// first-order increment: second-order terms would compress an unbent beam.
    BlockVector
    support_increment(const LoadFactor &from, const LoadFactor &to) const;

    /// Point of a support off its prescribed position; error over tolerance.
    struct SupportError
    {
      dealii::Point<3> place;
      double           share = 0.;
    };
    /// Returns the largest support error at @p at that corrections leave.
    SupportError
    largest_support_error(const LoadFactor &at) const;

    /// Returns the terms of K(u) of @p body, springs included.
    StiffnessTerms
    terms(const unsigned int body) const;

    /// Returns K(u) @p w of bodies and springs, not condensed, from strains.
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

    /// Returns the largest estimate (lower bound) of condition numbers, or 0.
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
    /// Returns A @p w with the unsymmetric part A of follower loads.
    BlockVector
    unsymmetric_part(const BlockVector &w) const;

    const Structure                           &structure;
    const BlockVector                          state;
    const LoadFactor                           factor;
    std::vector<std::unique_ptr<LinearSolver>> solvers;
    /// Prescribed rows at the state, and the value of each, if rows rotate.
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
