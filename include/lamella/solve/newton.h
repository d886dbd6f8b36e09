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
  /// Tolerances, limits and remedies of Newton's method.
  struct NewtonParameters
  {
    unsigned int max_iterations = 30;
    /// Tolerance of equilibrium: unbalanced forces over internal or loads.
    double force_tolerance = arithmetic::rounding_of_solutions;
    /// Limits for slender bodies, whose forces have a rounding of about (L /
    /// h)^3 1e-16. Below `stagnation_level`, two iterations that leave more
    /// than `stall_ratio` of the residual end it; below `near_equilibrium`, a
    /// correction of at most `negligible_correction` of the scene's size.
    double stagnation_level = arithmetic::same_value, stall_ratio = 0.5,
           near_equilibrium      = 1e-3,
           negligible_correction = arithmetic::same_position;
    /// Residual growth over the step's start that is a failure; below `nothing`
    /// of that start, forces are rounding.
    double divergence_ratio = 1e12, nothing = arithmetic::rounding_of_sums;
    /// Tolerance of the contact law: the larger of `law` times the largest
    /// displacement and `touching` times the scene's size; forces of lower
    /// accuracy end it below `stagnation_level` of the displacement.
    double law = arithmetic::negligible, touching = arithmetic::rounding;
    /// Relative step of differences in Newton::rotation_of_constraints(), and
    /// share of a correction that ends its iteration, within a limit.
    double       difference = arithmetic::same_value, rotation_tolerance = 1e-3;
    unsigned int max_rotation_corrections = 20;
    /// Largest factor between corrections without and with stabilizing springs.
    double max_spring_influence = 10.;
    /// Correction over the scene's size that is small if springs determine it.
    double converged_change = 1e-7;
    /// A motion against springs is unstable if its stiffness is below minus
    /// this share of the contact force over the size of the scene.
    double instability_share = 0.2;
    /// Limit of the new pairings in a step.
    unsigned int max_pairings = 3;
    /// Last correction over the step's increment that needs no check of K.
    double converged_step = 0.01;
    /// Largest rotation of an iteration [rad]; longer ones are shortened.
    double spin = 1.;
    /// Limit of the bisections of a step.
    unsigned int max_bisections = 6;
    /// Largest rotation of a support in a step [rad], below a revolution.
    double rotation = 2.;
  };

  /// Equilibrium state with finite rotations and its contact forces.
  struct Equilibrium
  {
    /// State; its iterations include those of failed attempts on the way.
    State      state;
    LoadFactor factor;
    /// Number of bisections on the way.
    unsigned int cuts = 0;
    /// Unbalanced forces over internal ones or loads, violation of the law.
    double residual = 0., law_error = 0.;
    /// Last correction if all forces are rounding (moved by supports), else 0.
    double rounding = 0.;
  };

  /**
   * Newton's method for structures with nonlinear internal forces,
   *   f_int(u) = f(t) + B(u)^T lambda,   u = G v + u_p(t),
   * with the contact law of the current gaps g(u, t) >= 0 and their gradient B,
   * from one load factor to the next.
   *
   * Each iteration linearizes the forces with the tangent K and the gaps with
   * B, and solves the resulting contact problem by the strategy of linear
   * bodies (ContactStrategy::solve()), with total contact forces. K omits the
   * rotation of B under contact forces. The first iteration applies support
   * motion as forces K du_p, since a prescribed motion alone would tear the
   * elements at the support. Obstacles move along the initial normals.
   *
   * The geometric part of K uses the stress predicted by the last correction
   * (FiniteStrainSectionOperator): 7 instead of 17 iterations in a cantilever
   * that rolls up in one step. If a step fails, it is repeated with the actual
   * stress, then in halves. Stabilizing springs contribute to K only: they have
   * no force at the iterate, and limit corrections of motions that only contact
   * restrains.
   *
   * Iterations end if forces balance, gaps satisfy the law, and no unpaired
   * surfaces are in contact; otherwise these are paired anew. The Cholesky
   * factor of K then proves a minimum of the energy. (Couples have no energy
   * except in their plane; a positive definite symmetric part of K is
   * sufficient for stability.) For bodies supported by an obstacle only, K with
   * ActiveConstraintShift takes its place. Refers to structure and contacts.
   * Collective.
   */
  class Newton
  {
  public:
    /// Callback for a line of text.
    using Progress = std::function<void(const std::string &)>;

    /// Creates a solver without contact.
    explicit Newton(const Structure        &structure,
                    const SolverKind        requested  = SolverKind::automatic,
                    const NewtonParameters &parameters = NewtonParameters());

    /// Creates a solver with @p contacts, whose rows stay at the last state.
    Newton(const Structure        &structure,
           const MovingContacts   &contacts,
           const SolverKind        requested,
           const NewtonParameters &parameters);

    /// Callback for a line of text per iteration; no output by default.
    Progress progress;
    /// Callbacks of each factorization.
    TangentOperator::BodyMonitor monitor;

    /// Returns the unloaded state of a path to @p factor.
    Equilibrium
    unloaded(const LoadFactor &factor = 1.) const;

    /// Restores the contacts of @p state at @p factor.
    void
    restore(const State &state, const LoadFactor &factor)
    {
      contacts.restore(state.pairings, state.u, factor);
    }

    /// Returns the equilibrium at load factor @p to, from @p start, the state
    /// of the current rows. Throws NumericsError with the last factor reached
    /// if it fails in 2^max_bisections parts.
    Equilibrium
    advance(const Equilibrium &start, const LoadFactor &to);

    /// Returns the contacts in their current state.
    const MovingContacts &
    moving() const
    {
      return contacts;
    }

  private:
    /// Start of a step: support motion, unbalanced forces, reference force.
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

    /// Updates the friction history at the end of a step, which @p began with
    /// these forces, to @p state at @p to.
    void
    update_friction(const MultiplierTransfer &began,
                    const LoadFactor         &to,
                    State                    &state) const;

    /// Performs one step with the forces @p transfer, with predicted stresses
    /// if @p predicted. Returns true on convergence; @p at counts iterations.
    bool
    step(const LoadFactor         &to,
         const MultiplierTransfer &transfer,
         const bool                predicted,
         Equilibrium              &at);

    /// Tries step() with and without prediction; counts iterations in @p at.
    bool
    attempt(const LoadFactor &to, Equilibrium &at);

    /// Result of an iteration: increment, regularization, unstable friction.
    struct Correction
    {
      BlockVector du;
      bool        uses_constraint_shift = false, is_unstable = false;
    };

    /// Performs one iteration: adds to @p state the correction due to the
    /// unbalanced forces @p r, with the support motion @p moved and the contact
    /// constraints, and returns it. The last @p correction predicts stresses.
    Correction
    correct(const BlockVector &r,
            const BlockVector &moved,
            const BlockVector &correction,
            const LoadFactor  &to,
            State             &state) const;

    /// Regularization of an indefinite tangent: active constraints, or springs
    /// scaled by `regularization_factor`.
    struct Regularization
    {
      std::unique_ptr<const ActiveConstraintShift> shift;
      double                                       regularization_factor = 1.;
    };

    /// Returns the tangent of @p state at @p to, after the last @p correction,
    /// regularized if needed. Throws IllConditioned if that does not suffice.
    TangentOperator
    tangent(const State       &state,
            const BlockVector &correction,
            const LoadFactor  &to,
            Regularization    &regularization) const;

    /// Throws IllConditioned if the tangent of @p state at @p to, with the
    /// active constraints, is not definite. That of the last correction was,
    /// and suffices if this correction was small beside the increment from @p
    /// before and without regularization. Throws NumericsError if friction is
    /// unstable.
    void
    check_stability(const BlockVector &before,
                    const Correction  &last,
                    const State       &state,
                    const LoadFactor  &to) const;

    /**
     * Throws NumericsError if @p state at @p to is stable by its springs only,
     * IllConditioned if not even then. Returns false if not checked: without
     * contact force, and with friction, which has its own criterion.
     *
     * With the spring rows R, scaled such that R^T R is their part of K, and
     * the compliance C of K with the active constraints fixed, springs alone
     * restrain the motions V = C R^T. Their energy
     *   V^T (K - R^T R - H) V = G - G G - V^T H V,   G = R C R^T,
     * must not be negative beside the work of the contact forces over such a
     * motion. Neutral motions, such as those of a sliding block, are accepted.
     */
    bool
    check_supports(const State &state, const LoadFactor &to) const;

    /// Solves the contact problem of @p rows in @p state at @p to by @p
    /// strategy, and returns forces, active set and displacement increment.
    ContactSolution
    solve_contact(ContactStrategy      &strategy,
                  const GapConstraints &rows,
                  const LoadFactor     &to,
                  State                &state) const;

    /// Returns the correction @p du of the state @p u with the rotation of rows
    /// included and no spring force. With H = sum lambda Hess g of the forces
    /// of @p state, which are updated, and the springs S in K, scaled by @p
    /// regularization_factor, solves
    ///   K du - B^T dlambda = r + (H + S) du
    /// for the active rows by GMRES; returns @p du without convergence.
    BlockVector
    correct_row_rotation(ContactStrategy   &strategy,
                         const BlockVector &u,
                         const BlockVector &du,
                         const double       regularization_factor,
                         const LoadFactor  &to,
                         State             &state) const;

    /// Adds the forces @p regularization_factor S w of springs to @p f.
    void
    add_spring_forces(const double       regularization_factor,
                      const BlockVector &w,
                      BlockVector       &f) const;

    /// Returns H @p w about @p u by central differences of B^T lambda; zero if
    /// a row loses its projection.
    BlockVector
    rotation_of_constraints(const State       &state,
                            const BlockVector &u,
                            const BlockVector &w,
                            const LoadFactor  &to) const;

    /// Returns the largest displacement due to @p u, for rotating rows by sizes
    /// of DoFs, as warping amplitudes are no lengths.
    double
    length_of(const BlockVector &u) const;
    /// Scales down the @p change of bodies that would rotate too far.
    void
    shorten(BlockVector &change) const;

    /// Returns f(t) + B^T lambda - f_int of @p state, not condensed.
    BlockVector
    unbalanced(const State &state, const LoadFactor &factor) const;

    /// Returns the unbalanced forces @p r, condensed by @p here.
    static BlockVector
    condensed(const TangentOperator &here, BlockVector r);

    /// Stores in @p at, and reports, the residuals of forces and gaps:
    /// condensed forces @p r at @p factor over loads or internal forces, or 0
    /// if they are rounding. Returns true if they are within bounds.
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
      /// Returns true if two successive iterations left more than @p share.
      bool
      stagnates(const double share) const;
    };

    /// Returns true if @p unbalanced and the last @p change end iterations.
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

    /// Returns true if violations @p missed satisfy the law at that @p size.
    bool
    satisfies_contact_law(const ResidualHistory &missed,
                          const double           size) const;

    const Structure &structure;
    /// Body::dof_scales() of bodies with rotating rows, empty for all others.
    std::vector<std::vector<double>> sizes;
    MovingContacts                   contacts;
    /// Message of the last failed attempt, and why a contact was lost in it.
    std::string            last_failure, lost_contact;
    const SolverKind       requested;
    const NewtonParameters parameters;
  };
} // namespace lamella

#endif
