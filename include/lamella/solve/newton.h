// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_newton_h
#define lamella_solve_newton_h

#include <lamella/base/arithmetic.h>
#include <lamella/solve/active_constraint_shift.h>
#include <lamella/solve/contact_solver.h>
#include <lamella/solve/moving_contacts.h>
#include <lamella/solve/tangent_operator.h>

#include <functional>
#include <limits>
#include <memory>
#include <string>

namespace lamella
{
  /// Tolerances, limits and fallback options of Newton's method.
  struct NewtonParameters
  {
    unsigned int max_iterations = 30;
    /// Tolerance of equilibrium: unbalanced over internal forces or loads.
    double force_tolerance = arithmetic::rounding_of_solutions;
    /// Criteria for slender bodies, whose forces have a rounding error of about
    /// (L / h)^3 1e-16 (length L, thickness h). Below the relative residual
    /// `stagnation_level`, iterations end if two of them leave more than
    /// `stall_ratio` of the residual; below `near_equilibrium`, if a correction
    /// is at most `negligible_correction` times the scene size.
    double stagnation_level = arithmetic::same_value, stall_ratio = 0.5,
           near_equilibrium      = 1e-3,
           negligible_correction = arithmetic::same_position;
    /// Growth of the residual over that at the beginning of the step that
    /// counts as divergence. Forces below `nothing` times it are rounding.
    double divergence_ratio = 1e12, nothing = arithmetic::rounding_of_sums;
    /// Tolerance of the contact law: the larger of `law` times the largest
    /// displacement and `touching` times the size of the scene. If forces are
    /// inaccurate, `stagnation_level` times the displacement.
    double law = arithmetic::negligible, touching = arithmetic::rounding;
    /// Relative step of differences in Newton::rotation_of_constraints();
    /// relative tolerance and limit of its iterations.
    double       difference = arithmetic::same_value, rotation_tolerance = 1e-3;
    unsigned int max_rotation_corrections = 20;
    /// Largest ratio of corrections without and with stabilizing springs.
    double max_spring_influence = 10.;
    /// Converged correction over the scene size if springs determine it.
    double converged_change = 1e-7;
    /// A motion against springs is unstable if its stiffness is below minus
    /// this factor times the contact force over the size of the scene.
    double instability_share = 0.2;
    /// Maximum number of new pairings in a load step.
    unsigned int max_pairings = 3;
    /// If the last correction is below this fraction of the step's increment,
    /// the tangent at the solution is not checked again.
    double converged_step = 0.01;
    /// Largest rotation in an iteration [rad]; larger ones are shortened.
    double spin = 1.;
    /// Maximum number of bisections of a load step.
    unsigned int max_bisections = 6;
    /// Largest rotation of a support in one step [rad], below a revolution.
    double rotation = 2.;
  };

  /// Equilibrium state at finite rotations, with its contact forces and errors.
  struct Equilibrium
  {
    /// State; its iterations include those of failed attempts.
    State      state;
    LoadFactor factor;
    /// Number of bisections of the load step.
    unsigned int cuts = 0;
    /// Unbalanced over internal forces or loads; law error [length].
    double residual = 0., law_error = 0.;
    /// Last correction if all forces are rounding (support motion), else 0.
    double rounding = 0.;
  };

  /// Newton's method for structures with nonlinear internal forces and contact,
  ///   f_int(u) = f(t) + B(u)^T lambda,   u = G v + u_p(t),
  /// from one load factor t to the next, with the contact law of the current
  /// gaps g(u, t) >= 0, their gradient B, the free DoFs v and prescribed
  /// displacements u_p.
  ///
  /// Each iteration linearizes forces (tangent K) and gaps (B), and solves the
  /// resulting contact problem for the total contact forces as for linear
  /// bodies (ContactStrategy::solve()). K omits the derivative of B. The first
  /// iteration applies support motion as forces K du_p, since otherwise only
  /// elements at supports would deform. Obstacles move along initial normals.
  ///
  /// The geometric part of K uses the stress predicted by the last correction
  /// (FiniteStrainSectionOperator): a cantilever that rolls up in one step
  /// takes 7 instead of 17 iterations. If a step fails, it is repeated with the
  /// actual stress, then bisected. Stabilizing springs contribute to K only:
  /// they have no force at the iterate, and limit corrections of motions that
  /// only contact restrains.
  ///
  /// Iterations end if forces balance, gaps satisfy the law, and no unpaired
  /// surfaces are in contact; unpaired surfaces in contact are paired anew. The
  /// Cholesky factor of K then proves a minimum of the energy. (Couples have an
  /// energy in plane motion only; a positive definite symmetric part of K is
  /// sufficient for stability.) For bodies supported by an obstacle only, K is
  /// regularized by ActiveConstraintShift. Keeps references to structure and
  /// contacts. Collective.
  class Newton
  {
  public:
    /// Callback for a line of text.
    using Progress = std::function<void(const std::string &)>;

    /// Creates a solver without contact.
    explicit Newton(const Structure        &structure,
                    const SolverKind        requested  = SolverKind::automatic,
                    const NewtonParameters &parameters = NewtonParameters());

    /// Creates a solver with @p contacts, which are left at the last state.
    Newton(const Structure        &structure,
           const MovingContacts   &contacts,
           const SolverKind        requested,
           const NewtonParameters &parameters);

    /// Callback for a line of text per iteration; no output by default.
    Progress progress;
    /// Callbacks of each factorization.
    TangentOperator::BodyMonitor monitor;

    /// Returns the unloaded state that begins a path to @p factor.
    Equilibrium
    unloaded(const LoadFactor &factor = 1.) const;

    /// Restores the contacts of @p state at load factor @p factor.
    void
    restore(const State &state, const LoadFactor &factor)
    {
      contacts.restore(state.pairings, state.u, factor);
    }

    /// Returns the equilibrium at load factor @p to, starting from @p start,
    /// the state at which the contact constraints are. If it fails with
    /// 2^max_bisections substeps, throws NumericsError with the factor reached.
    Equilibrium
    advance(const Equilibrium &start, const LoadFactor &to);

    /// Returns the contacts in their current state.
    const MovingContacts &
    moving() const
    {
      return contacts;
    }

  private:
    /// Start of a step: support motion, unbalanced and reference forces.
    struct StepStart
    {
      BlockVector moved, r;
      double      size = 0.;
    };
    StepStart
    step_start(const LoadFactor &to, const Equilibrium &at) const;

    /// Returns the largest rotation angle of a support between the factors.
    double
    largest_rotation(const LoadFactor &from, const LoadFactor &to) const;

    /// Updates the friction history at the end of a step to @p state at load
    /// factor @p to; @p began are the forces at its beginning.
    void
    update_friction(const MultiplierTransfer &began,
                    const LoadFactor         &to,
                    State                    &state) const;

    /// Performs one step from @p at to load factor @p to, with the contact
    /// forces @p transfer at its beginning and, if @p predicted, with predicted
    /// stresses. Returns true on convergence; counts iterations in @p at.
    bool
    step(const LoadFactor         &to,
         const MultiplierTransfer &transfer,
         const bool                predicted,
         Equilibrium              &at);

    /// Calls step() with, then without prediction; counts iterations in @p at.
    bool
    attempt(const LoadFactor &to, Equilibrium &at);

    /// Result of an iteration: displacement increment, whether
    /// ActiveConstraintShift was used, and whether friction is unstable.
    struct Correction
    {
      BlockVector du;
      bool        uses_constraint_shift = false, is_unstable = false;
    };

    /// Performs one iteration: adds to @p state the correction due to the
    /// unbalanced forces @p r, with the support motion @p moved and the contact
    /// constraints, and returns it. Predicts stresses with the last
    /// @p correction.
    Correction
    correct(const BlockVector &r,
            const BlockVector &moved,
            const BlockVector &correction,
            const LoadFactor  &to,
            State             &state) const;

    /// Regularization of an indefinite tangent: by active constraints, or by
    /// springs with stiffnesses multiplied by `regularization_factor`.
    struct Regularization
    {
      std::unique_ptr<const ActiveConstraintShift> shift;
      double                                       regularization_factor = 1.;
    };

    /// Returns the tangent of @p state at load factor @p to, after the last
    /// @p correction, regularized if needed. Throws IllConditioned if
    /// indefinite.
    TangentOperator
    tangent(const State       &state,
            const BlockVector &correction,
            const LoadFactor  &to,
            Regularization    &regularization) const;

    /// Throws IllConditioned if the tangent of @p state at load factor @p to,
    /// with the active constraints, is not definite. The tangent of the last
    /// correction was definite; it suffices if that correction is small
    /// relative to the increment from @p before and no regularization was used.
    /// Throws NumericsError if friction is unstable.
    void
    check_stability(const BlockVector &before,
                    const Correction  &last,
                    const State       &state,
                    const LoadFactor  &to) const;

    /// Throws NumericsError if @p state at load factor @p to is stable only due
    /// to its stabilizing springs, and IllConditioned if it is unstable even
    /// with springs. Returns false if it was not checked: without contact
    /// force, and with friction, which has its own stability criterion.
    ///
    /// With the spring rows R, scaled such that R^T R is their contribution to
    /// K, and the compliance C of K with the active constraints fixed, the
    /// motions that only springs restrain are V = C R^T. With the derivative H
    /// of the contact forces (rotation_of_constraints()), their energy
    ///   V^T (K - R^T R - H) V = G - G G - V^T H V,   G = R C R^T,
    /// must not be negative compared with the work of the contact forces over
    /// such a motion. Neutral motions (a sliding block) are accepted.
    bool
    check_supports(const State &state, const LoadFactor &to) const;

    /// Solves the contact problem of @p rows in @p state at load factor @p to
    /// by @p strategy, and returns its solution.
    ContactSolution
    solve_contact(ContactStrategy      &strategy,
                  const GapConstraints &rows,
                  const LoadFactor     &to,
                  State                &state) const;

    /// Returns the correction @p du of the displacements @p u, improved by the
    /// rotation of the constraints and without spring forces. With H = sum
    /// lambda Hess g for the forces of @p state, which are updated, and the
    /// spring stiffness S in K, multiplied by @p regularization_factor, solves
    ///   K du - B^T dlambda = r + (H + S) du
    /// for active constraints by GMRES; returns @p du if it does not converge.
    BlockVector
    correct_row_rotation(ContactStrategy   &strategy,
                         const BlockVector &u,
                         const BlockVector &du,
                         const double       regularization_factor,
                         const LoadFactor  &to,
                         State             &state) const;

    /// Adds the spring forces @p regularization_factor S w to @p f.
    void
    add_spring_forces(const double       regularization_factor,
                      const BlockVector &w,
                      BlockVector       &f) const;

    /// Returns H @p w at @p u, the change of the contact forces with the
    /// rotation of the constraints, by central differences; zero if any has no
    /// projection.
    BlockVector
    rotation_of_constraints(const State       &state,
                            const BlockVector &u,
                            const BlockVector &w,
                            const LoadFactor  &to) const;

    /// Returns the largest displacement due to @p u; for bodies with rotation
    /// DoFs by Body::dof_scales(), since warping amplitudes are not lengths.
    double
    length_of(const BlockVector &u) const;
    /// Scales down the increment @p change of bodies that would rotate too far.
    void
    shorten(BlockVector &change) const;

    /// Returns f(t) + B^T lambda - f_int of @p state, not condensed.
    BlockVector
    unbalanced(const State &state, const LoadFactor &factor) const;

    /// Returns the unbalanced forces @p r, condensed by @p here.
    static BlockVector
    condensed(const TangentOperator &here, BlockVector r);

    /// Computes, stores in @p at and reports the residuals of forces and gaps.
    /// The condensed forces @p r at load factor @p factor are divided by loads
    /// or internal forces; 0 if they are rounding. @p began is the residual at
    /// the start of the step. Returns false if they diverge.
    bool
    measure(const TangentOperator &here,
            const BlockVector     &r,
            const LoadFactor      &factor,
            double                &began,
            Equilibrium           &at) const;

    /// Residuals of the last three iterations.
    struct ResidualHistory
    {
      double now     = std::numeric_limits<double>::max(),
             before  = std::numeric_limits<double>::max(),
             earlier = std::numeric_limits<double>::max();
      void
      add(const double left);
      /// Returns true if two iterations left over @p share of the residual.
      bool
      stagnates(const double share) const;
    };

    /// Returns true if the residuals @p unbalanced and the last correction
    /// @p change satisfy the convergence criteria.
    bool
    is_equilibrium(const ResidualHistory &unbalanced,
                   const double           change) const;

    /// Returns true if the forces @p r are within the rounding of @p u.
    bool
    is_rounding(const TangentOperator &here,
                const BlockVector     &r,
                const BlockVector     &u) const;

    /// Throws NumericsError with the factor reached and the cause of failure.
    [[noreturn]] void
    throw_not_converged(const LoadFactor &reached, const LoadFactor &to) const;

    /// Returns true if the displacement @p way is negligible.
    bool
    is_negligible(const BlockVector &way) const;

    /// Returns true if the law errors @p missed are small for this @p size.
    bool
    satisfies_contact_law(const ResidualHistory &missed,
                          const double           size) const;

    const Structure &structure;
    /// Body::dof_scales() of bodies with rotation DoFs, empty for all others.
    std::vector<std::vector<double>> sizes;
    MovingContacts                   contacts;
    /// Message of the last failed attempt, and why a contact was lost in it.
    std::string            last_failure, lost_contact;
    const SolverKind       requested;
    const NewtonParameters parameters;
  };
} // namespace lamella

#endif
