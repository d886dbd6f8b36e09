// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_nonlinear_solver_h
#define lamella_solve_nonlinear_solver_h

#include <lamella/solve/linear_system.h>
#include <lamella/solve/moving_contacts.h>
#include <lamella/solve/nonlinear_parameters.h>
#include <lamella/solve/tangent_operator.h>

#include <functional>
#include <limits>
#include <memory>
#include <string>

namespace lamella
{
  /// Equilibrium state of a load step, with its remaining errors.
  struct Equilibrium
  {
    /// State; its number of iterations includes failed attempts.
    State        state;
    LoadFactor   factor;   ///< Load factor of `state`.
    unsigned int cuts = 0; ///< Number of bisections of the load step.
    /// Unbalanced forces over internal forces or loads (norms).
    double residual  = 0.;
    double law_error = 0.; ///< Largest error of the contact law [length].
    /// Largest displacement of the last correction [length] if all forces are
    /// rounding errors, as in a rigid support motion; otherwise 0.
    double rounding = 0.;
  };

  /// Outcome of an attempt to find the equilibrium at a load factor.
  struct StepOutcome
  {
    bool        converged = false; ///< True if it was found.
    std::string reason    = {};    ///< Cause of a failure, one sentence.
    /// Why a contact was lost in the attempt; empty if none was lost.
    std::string lost_contact = {};
  };

  /// Newton's method for structures with contact, linear or with finite
  /// rotations,
  ///   f_int(u) = f(t) + B(u)^T lambda,   u = G v + u_p(t),
  /// from one load factor t to the next, with internal forces f_int, loads f,
  /// contact forces lambda, gaps g(u, t) >= 0 and their gradient B, free DoFs v
  /// with their expansion G, and prescribed displacements u_p.
  ///
  /// Each iteration linearizes forces (tangent K, without the derivative of B)
  /// and gaps, and solves the resulting contact problem for the total contact
  /// forces (ContactStrategy::solve()). These are the estimates of the next
  /// iteration (method of multipliers). The support motion du_p enters the
  /// residual as the forces -K du_p.
  ///
  /// With finite rotations, the geometric part of K uses the stress before the
  /// last correction plus its linearized change. If a step fails, it is
  /// repeated with the stress of the present displacements, then bisected.
  /// Stabilizing springs contribute to K only; they have no force at the
  /// iterate. An indefinite K is regularized by ActiveConstraintShift or by
  /// stiffer springs.
  ///
  /// With a LinearSystem, K and B are constant, and a step starts from the
  /// solution without contact. Each iteration finds the active set, then
  /// refines displacements and forces (LinearSystem::refine_contact()). A step
  /// that does not converge is not repeated.
  ///
  /// Iterations end if forces balance, gaps satisfy the law, and no unpaired
  /// surfaces are in contact; unpaired surfaces in contact are paired anew. The
  /// state is stable if K is then positive definite. The last tangent is
  /// kept if is_accurate_enough(). Keeps a reference to the structure.
  /// Collective.
  class NonlinearSolver
  {
  public:
    /// Callback that receives a line of text.
    using Progress = std::function<void(const std::string &)>;
    /// Function that returns a description of the gap constraint with an index.
    using Describe = std::function<std::string(const unsigned int)>;

    /// Creates a solver without contact; @p requested is the linear solver.
    explicit NonlinearSolver(
      const Structure           &structure,
      const SolverKind           requested  = SolverKind::automatic,
      const NonlinearParameters &parameters = NonlinearParameters());

    /// Creates a solver with @p contacts, which are left at the last state.
    /// Their linearized problems are solved by @p strategy.
    NonlinearSolver(const Structure           &structure,
                    MovingContacts             contacts,
                    const SolverKind           requested,
                    const NonlinearParameters &parameters,
                    const Strategy             strategy = Strategy::condensed);

    /// Creates a solver for the constant stiffness and the constraints of @p
    /// linear, which must outlive this object.
    explicit NonlinearSolver(
      LinearSystem              &linear,
      const NonlinearParameters &parameters = NonlinearParameters());

    /// Callback with a line of text per iteration; empty by default.
    Progress progress;
    /// Description of a gap constraint in messages; its index by default.
    Describe describe;
    /// Callbacks during the factorization of each body.
    TangentOperator::BodyMonitor monitor;

    /// Returns the unloaded state, from which a load path to @p factor starts.
    Equilibrium
    unloaded(const LoadFactor &factor = 1.) const;

    /// Restores the contact constraints of @p state at load factor @p factor.
    void
    restore(const State &state, const LoadFactor &factor)
    {
      contacts.restore(state.pairings, state.u, factor);
      reached = state.u;
    }

    /// Returns the equilibrium at load factor @p to, starting from the
    /// equilibrium @p start, to which the contact constraints must belong.
    /// Throws NumericsError if none is found after max_bisections bisections,
    /// for linear structures at once.
    Equilibrium
    advance(const Equilibrium &start, const LoadFactor &to);

    /// Returns the equilibrium at load factor @p to, starting from the state
    /// @p before at load factor @p from; empty: the unloaded state. Restores
    /// the contacts of @p before if needed, then calls advance().
    Equilibrium
    solve(const LoadFactor &to, const State &before, const LoadFactor &from);
    /// Returns the equilibrium at @p to of a linear structure, or from the
    /// unloaded state.
    Equilibrium
    solve(const LoadFactor &to, const State &before = State())
    {
      return solve(to, before, to.unloaded());
    }

    /// Returns the tangent at the displacements of @p state without solvers;
    /// of linear structures, the constant one.
    std::shared_ptr<const TangentOperator>
    tangent_at(const State &state) const;

    /// Returns the structure whose equilibrium is solved for.
    const Structure &
    of() const
    {
      return structure;
    }

    /// Returns the constant equations of a linear structure, or null.
    LinearSystem *
    linear_system() const
    {
      return linear;
    }

    /// Returns the contacts, whose constraints are those of the last state.
    const MovingContacts &
    moving() const
    {
      return contacts;
    }

  private:
    /// Start of a step: support motion `moved`, unbalanced forces `r`, and the
    /// reference `size` of forces.
    struct StepStart
    {
      BlockVector moved, r;
      double      size = 0.;
      /// State whose contact forces are the first estimates, if not empty.
      State estimate = State();
      /// True if the state without contact is the solution.
      bool is_solution = false;
    };
    /// Returns the data for a load step from @p at to load factor @p to.
    StepStart
    step_start(const LoadFactor &to, const Equilibrium &at) const;
    /// Replaces the state of @p at by the linear solution without contact at
    /// load factor @p to, and returns the data for a load step from there.
    StepStart
    linear_start(const LoadFactor &to, Equilibrium &at) const;
    /// Returns true if @p state, without contact forces, is the solution at
    /// load factor @p to, after the state @p previous.
    bool
    is_open(const State      &state,
            const State      &previous,
            const LoadFactor &to) const;

    /// Returns the largest support rotation between two load factors [rad].
    double
    largest_rotation(const LoadFactor &from, const LoadFactor &to) const;

    /// Performs one step from @p at to load factor @p to, with predicted
    /// stresses if @p predicted. Returns true on convergence; counts iterations
    /// in @p at. For linear structures, throws NumericsError instead of
    /// returning false.
    bool
    step(const LoadFactor &to, const bool predicted, Equilibrium &at);

    /// Performs step() with stress prediction and, if that fails, without.
    StepOutcome
    attempt(const LoadFactor &to, Equilibrium &at);

    /// Changes of spring offsets in an iteration of a linear structure: the
    /// spring with the largest change of force, that force, and the largest
    /// change of length. `is_done`: one of them is a rounding error.
    struct SpringRelease
    {
      unsigned int body = 0, spring = 0;
      double       length = 0., force = 0.;
      bool         is_done = true;
    };
    /// Returns the largest differences between lengths and offsets of the
    /// springs of @p state at load factor @p to.
    SpringRelease
    spring_motion(const State &state, const LoadFactor &to) const;

    /// Tangent K of an iteration. If it is indefinite, it is regularized by
    /// active constraints, or by springs with stiffnesses multiplied by
    /// `regularization_factor`.
    struct RegularizedTangent
    {
      std::unique_ptr<const TangentOperator>       K;
      std::unique_ptr<const ActiveConstraintShift> shift;
      double                                       regularization_factor = 1.;
    };

    /// Returns the tangent of @p state at load factor @p to, after the last
    /// @p correction, regularized. Throws IllConditioned if indefinite.
    RegularizedTangent
    tangent(const State       &state,
            const BlockVector &correction,
            const LoadFactor  &to) const;

    /// Result of an iteration: displacement increment, whether friction is
    /// unstable, and the spring with the largest force.
    struct Correction
    {
      BlockVector   du;
      bool          is_unstable = false;
      SpringRelease released    = {};
    };

    /// Performs one iteration with the tangent @p about: adds to @p state, and
    /// returns, the correction due to the unbalanced forces @p r, support
    /// motion @p moved and contact.
    Correction
    correct(const RegularizedTangent &about,
            const BlockVector        &r,
            const BlockVector        &moved,
            const LoadFactor         &to,
            State                    &state) const;
    /// Performs one iteration of a linear structure. The first estimates are
    /// the contact forces of @p estimate, if not empty, in its active
    /// constraints that penetrate without contact.
    Correction
    correct_linear(const BlockVector &r,
                   const LoadFactor  &to,
                   const State       &estimate,
                   State             &state) const;

    /// Throws IllConditioned if the regularized tangent of @p state at load
    /// factor @p to is not definite, unless the structure is linear. The
    /// tangent @p about of the last iteration was definite; it suffices if it
    /// is near, relative to the increment from @p before, and not shifted,
    /// otherwise it is freed. Throws NumericsError if friction is unstable
    /// after the @p last correction.
    void
    check_stability(const BlockVector  &before,
                    RegularizedTangent &about,
                    const Correction   &last,
                    const State        &state,
                    const LoadFactor   &to) const;

    /// Checks whether @p state at load factor @p to is stable without its
    /// springs. Throws NumericsError if it is not, and IllConditioned if it is
    /// unstable even with springs. Returns false if the check does not apply:
    /// if there is no contact force, or with friction
    /// (InterfaceSolution::stability).
    ///
    /// R are the spring rows, scaled such that the tangent K contains R^T R. C
    /// is the inverse of K with all active gaps kept closed. The motions that
    /// only springs restrain are V = C R^T. Their energy without springs, with
    /// the derivative H of the contact forces (rotation_of_constraints()),
    ///   V^T (K - R^T R - H) V = G - G G - V^T H V,   G = R C R^T,
    /// must not be negative compared with the work of the contact forces over
    /// such a motion. Neutral motions (a sliding block) are accepted.
    bool
    check_supports(const State &state, const LoadFactor &to) const;

    /// Returns the contact problem of @p rows in @p state with the unbalanced
    /// forces @p r at load factor @p to.
    ContactProblem
    problem_at(const GapConstraints &rows,
               const BlockVector    &r,
               const LoadFactor     &to,
               const State          &state) const;
    /// Solves @p problem of @p rows by @p strategy; returns its solution, and
    /// stores its forces in @p state.
    ContactSolution
    solve_contact(ContactStrategy      &strategy,
                  const GapConstraints &rows,
                  const ContactProblem &problem,
                  State                &state) const;
    /// Throws NumericsError if @p rounds of the @p strategy reach
    /// max_iterations. The message names three of the constraints @p changing.
    void
    check_rounds(const ContactStrategy           &strategy,
                 const unsigned int               rounds,
                 const std::vector<unsigned int> &changing) const;
    /// Returns a sentence on the initial overlap of bodies, if any.
    std::string
    describe_overlap() const;

    /// Returns the correction @p du of the displacements @p u, improved by the
    /// rotation of contact normals and without forces of stabilizing springs.
    /// Updates the contact forces lambda of @p state. With the derivative H =
    /// sum lambda d2g/du2 of the contact forces, unbalanced forces r, and the
    /// spring stiffness S times @p regularization_factor contained in K, solves
    ///   K du - B^T dlambda = r + (H + S) du
    /// for active constraints by GMRES; returns @p du if it does not converge.
    BlockVector
    correct_row_rotation(ContactStrategy   &strategy,
                         const BlockVector &u,
                         const BlockVector &du,
                         const double       regularization_factor,
                         const LoadFactor  &to,
                         State             &state) const;

    /// Returns the change of B(u)^T lambda, with constant contact forces lambda
    /// of @p state, due to the increment @p w of the displacements @p u. Uses
    /// central differences of B; zero if a contact point has no projection.
    BlockVector
    rotation_of_constraints(const State       &state,
                            const BlockVector &u,
                            const BlockVector &w,
                            const LoadFactor  &to) const;

    /// Returns the length to which tolerances refer: the scene diagonal, for
    /// linear structures LinearSystem::displacement_scale().
    double
    reference_length(const State &state, const LoadFactor &to) const;
    /// Returns the rounding error of gaps of @p state at load factor @p to.
    double
    rounding_of_gaps(const State &state, const LoadFactor &to) const;
    /// Returns the largest displacement component of @p u [length]. DoFs that
    /// are no lengths (rotations, warping) are scaled by DofInfo::scale.
    double
    length_of(const BlockVector &u) const;
    /// Scales @p change in each body to rotations up to `spin`.
    void
    shorten(BlockVector &change) const;

    /// Returns loads plus contact forces minus internal forces in all DoFs.
    BlockVector
    unbalanced(const State &state, const LoadFactor &factor) const;

    /// Stores in @p at, and reports, the relative norm of the unbalanced forces
    /// @p r and the error of the contact law at load factor @p factor. @p began
    /// is the norm at the start of the step. Returns false on divergence.
    bool
    measure(const TangentOperator &here,
            const BlockVector     &r,
            const LoadFactor      &factor,
            double                &began,
            Equilibrium           &at) const;

    /// Residuals (forces, or errors of gaps) of the last three iterations.
    struct ResidualHistory
    {
      double now     = std::numeric_limits<double>::max(),
             before  = std::numeric_limits<double>::max(),
             earlier = std::numeric_limits<double>::max();
      /// Appends the residual @p left of an iteration and drops the oldest one.
      void
      add(const double left);
      /// Returns true if each of the last two iterations left more than the
      /// fraction @p share of the residual.
      bool
      stagnates(const double share) const;
    };

    /// Returns true if residuals and the last correction have converged.
    bool
    is_equilibrium(const ResidualHistory &unbalanced,
                   const double           change) const;
    /// Errors in the iterations of a step: unbalanced forces, contact law, and
    /// motions of springs that are released.
    struct Residuals
    {
      ResidualHistory forces, gaps, springs;
    };
    /// Adds the errors of @p at to @p residuals, and returns true if it is an
    /// equilibrium at load factor @p to after the correction @p last. The
    /// tangent is @p here, and the unbalanced forces are @p r.
    bool
    is_converged(const Correction      &last,
                 const TangentOperator &here,
                 const BlockVector     &r,
                 const LoadFactor      &to,
                 Residuals             &residuals,
                 Equilibrium           &at) const;
    /// Returns true if a correction with the tangent @p about of the iteration
    /// before is expected to reach the force tolerance, from the residuals
    /// @p left by the iterations.
    bool
    is_accurate_enough(const RegularizedTangent &about,
                       const ResidualHistory    &left) const;
    /// Pairs surfaces anew that are in contact without a constraint, and
    /// returns false if there are any. Otherwise checks the equilibrium @p at
    /// at load factor @p to, after the displacements @p before and the
    /// correction @p last (MovingContacts::check_kept(), check_stability()).
    bool
    has_all_pairs(const BlockVector  &before,
                  RegularizedTangent &about,
                  const Correction   &last,
                  const LoadFactor   &to,
                  Equilibrium        &at);

    /// Returns true if the forces @p r at displacements @p u are rounding.
    bool
    is_rounding(const TangentOperator &here,
                const BlockVector     &r,
                const BlockVector     &u) const;

    /// Throws NumericsError: the iterations of a linear structure did not
    /// converge. The spring with the largest force is @p released, and @p rate
    /// is the ratio of the largest changes of length in the last two
    /// iterations.
    [[noreturn]] void
    throw_not_settled(const Equilibrium   &at,
                      const SpringRelease &released,
                      const double         rate) const;
    /// Throws NumericsError for the rigid motion @p motion of @p body, if no
    /// contact balances its loads.
    [[noreturn]] void
    throw_unconstrained_motion(const std::string &body,
                               const std::string &motion,
                               const double       rate) const;

    /// Throws NumericsError: the last attempt from load factor @p from on the
    /// way to @p to ended with @p outcome.
    [[noreturn]] void
    throw_not_converged(const StepOutcome &outcome,
                        const LoadFactor  &from,
                        const LoadFactor  &to) const;

    /// Returns true if the last errors @p missed of the contact law are within
    /// tolerance for @p state at load factor @p to. Increases the penalty of a
    /// linear structure if the error decreases slowly.
    bool
    satisfies_contact_law(const ResidualHistory &missed,
                          const State           &state,
                          const LoadFactor      &to) const;

    /// Constant equations of a linear structure; null for finite rotations.
    LinearSystem *const linear = nullptr;
    const Structure    &structure;
    MovingContacts      contacts;
    /// Patterns and symbolic factors that the tangents have in common.
    TangentOperator::MatrixPatterns matrix_patterns;
    /// Displacements at which solve() or restore() left the contacts.
    BlockVector               reached;
    const SolverKind          requested;
    const NonlinearParameters parameters;
    const Strategy            strategy; ///< Of the linearized contact problems.
  };
} // namespace lamella

#endif
