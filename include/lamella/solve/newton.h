// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_newton_h
#define lamella_solve_newton_h

#include <lamella/base/arithmetic.h>
#include <lamella/solve/contact_solver.h>
#include <lamella/solve/leaning_rows.h>
#include <lamella/solve/linearisation.h>
#include <lamella/solve/moving_contacts.h>

#include <functional>
#include <limits>
#include <memory>
#include <string>

namespace lamella
{
  /// When Newton's iterations end, and what is done where they do not.
  struct NewtonParameters
  {
    unsigned int max_iterations = 30;
    /// Unbalanced forces over the larger one of internal forces and loads, in
    /// the Euclidean norm, that are equilibrium.
    double balanced = arithmetic::rounding_of_solutions;
    /// Forces of slender bodies end at their rounding, some (L / h)^3 1e-16:
    /// below `floor` they do once two iterations on end leave more than
    /// `stalls` of them; and below `near` where the correction is this share of
    /// the size of the scene.
    double floor = arithmetic::alike, stalls = 0.5, near = 1e-3,
           still = arithmetic::same_place;
    /// Forces that are left beyond this, over those that the step began with,
    /// are a failure; below `nothing` of these they are rounding.
    double diverged = 1e12, nothing = arithmetic::rounding_of_sums;
    /// What gaps may miss the law by, of the largest displacement, or of the
    /// size of the scene if that is more. Where there are more rows than the
    /// surfaces can follow it is less than their forces are known to: below
    /// `floor` of the displacement they end as forces do.
    double law = arithmetic::negligible, touching = arithmetic::rounding;
    /// How rows turn (Newton::turn_of_rows()) is found from a way of
    /// `difference` of the size of the scene. It is followed until this share
    /// of a correction is left, in at most so many back substitutions.
    double       difference = arithmetic::alike, follows = 1e-3;
    unsigned int max_follows = 20;
    /// By how much further than with stabilising springs an iteration goes
    /// without them, at most.
    double released = 10.;
    /// Corrections of this share of the size of the scene are small where
    /// springs make them so.
    double settles = 1e-7;
    /// A motion that springs hold is unstable where its stiffness is below
    /// minus that share of what presses over the size of the scene, and else
    /// neutral.
    double falls = 0.2;
    /// How often contacts pair anew in a step.
    unsigned int max_pairings = 3;
    /// A last correction of this share of the way of a step ends it without a
    /// look at the tangent where it led.
    double settled = 0.01;
    /// The largest spin of an iteration [rad]: a longer change is shortened.
    double spin = 1.;
    /// How often a step is halved.
    unsigned int max_cuts = 6;
    /// How far supports turn at most in a step [rad]: a place knows nothing of
    /// how often it has been round.
    double turn = 2.;
  };

  /// A state that bodies which turn are in equilibrium in, with what presses
  /// them.
  struct Equilibrium
  {
    /// Its iterations are those on the way to it, those of attempts that failed
    /// among them.
    State      state;
    LoadFactor factor;
    /// How often a step was halved on the way.
    unsigned int cuts = 0;
    /// Unbalanced forces over internal forces or loads; the length by which
    /// gaps miss the contact law.
    double residual = 0., law_error = 0.;
    /// The length of the last correction where all forces are rounding, of
    /// bodies that supports carry away; else 0.
    double rounding = 0.;
  };

  /**
   * Newton's method for structures whose internal forces are not linear,
   *   f_int(u) = f(t) + B(u)^T lambda,   u = G v + u_p(t),
   * with the contact law of the gaps g(u, t) >= 0 of surfaces that have moved,
   * B their gradient, from one load factor to the next.
   *
   * At each iterate the forces are linear with the tangent K, and gaps with B:
   * the contact problem of that is solved whole, by the strategy of linear
   * bodies on the compliance of K (ContactStrategy::settle()), and its rows'
   * forces are totals. What B turns by as it is pressed is left out of K. The
   * first iteration takes up what supports move by, as forces K du_p: a
   * prescribed motion alone would tear the elements at the support; obstacles
   * move along the normals that they have at the start.
   *
   * The stress of the geometric part of K is the one that the last correction
   * predicted (GreenAnswer): from 17 iterations down to 7 in a cantilever that
   * rolls up in one step. Where that fails the step is tried with the
   * stress as it is, and then in halves.
   *
   * Stabilising springs are in K alone: they are without force where each
   * iterate is, and hold back corrections of what nothing but contact holds.
   *
   * It ends where forces balance, gaps keep the law, and no surfaces touch that
   * are not paired; else these are paired anew and it goes on. (Which of rows
   * that depend on each other are active is not asked: it may be others in each
   * iteration.) K is positive definite there, as its
   * Cholesky factor exists: the equilibrium is a minimum of the energy. (With
   * couples there is none, but in their plane; that the symmetric part of K is
   * positive definite is enough for stability, and more than it takes.) Where
   * nothing but an obstacle holds a body, K with LeaningRows is.
   *
   * Refers to the structure and the contacts. Collective.
   */
  class Newton
  {
  public:
    /// Takes a line of text.
    using Progress = std::function<void(const std::string &)>;

    /// Without contact.
    explicit Newton(const Structure        &structure,
                    const SolverKind        asked      = SolverKind::automatic,
                    const NewtonParameters &parameters = NewtonParameters());

    /// With @p contacts, whose rows are left as the last state has them.
    Newton(const Structure        &structure,
           const MovingContacts   &contacts,
           const SolverKind        asked,
           const NewtonParameters &parameters);

    /// Called with a line of text per iteration; does nothing by default.
    Progress progress;
    /// Told of each factorisation.
    Linearisation::BodyMonitor monitor;

    /// The state without loads, of a path to @p factor.
    Equilibrium
    at_rest(const LoadFactor &factor = 1.) const;

    /// Has contacts as they were in @p state at @p factor
    /// (MovingContacts::recall()).
    void
    recall(const State &state, const LoadFactor &factor)
    {
      contacts.recall(state.pairings, state.u, factor);
    }

    /// That at load factor @p to, on from @p start, whose rows are those that
    /// the contacts have now. Throws NumericsError with the last factor that
    /// was reached if it cannot be had in 2^max_cuts parts of the way.
    Equilibrium
    advance(const Equilibrium &start, const LoadFactor &to);

    /// The contacts as they are.
    const MovingContacts &
    moving() const
    {
      return contacts;
    }

  private:
    /// What a step begins with: by what supports move on the way, the
    /// unbalanced forces with what that does to the body, and the size of
    /// forces.
    struct Beginning
    {
      BlockVector moved, r;
      double      size = 0.;
    };
    Beginning
    beginning(const LoadFactor &to, const Equilibrium &at) const;

    /// The largest angle by which a support turns what it holds on the way.
    double
    largest_turn(const LoadFactor &from, const LoadFactor &to) const;

    /// Ends a step that has come to @p state at @p to from forces that
    /// @p began it: what friction remembers.
    void
    end_friction(const PressedPlaces &began,
                 const LoadFactor    &to,
                 State               &state) const;

    /// One step from what is @p pressed, with the stress that corrections
    /// predict or without; whether it ended. Counts its iterations in @p at.
    bool
    step(const LoadFactor    &to,
         const PressedPlaces &pressed,
         const bool           predicted,
         Equilibrium         &at);

    /// The same both ways; where it fails @p at stays but for the count.
    bool
    attempt(const LoadFactor &to, Equilibrium &at);

    /// What an iteration has changed, whether rows had to lean for it, and
    /// whether what they rub with is stable.
    struct Correction
    {
      BlockVector du;
      bool        leans = false, is_unstable = false;
    };

    /// One iteration: adds to @p state the correction that @p r, the unbalanced
    /// forces, makes about it, and what supports have @p moved by with it, with
    /// the rows that this closes; returns it. The last @p correction predicts
    /// stresses, unless it is empty.
    Correction
    correct(const BlockVector &r,
            const BlockVector &moved,
            const BlockVector &correction,
            const LoadFactor  &to,
            State             &state) const;

    /// What makes a tangent definite that has no other hold: rows that lean, or
    /// stabilising springs that are as many times firmer.
    struct Aid
    {
      std::unique_ptr<const LeaningRows> leaning;
      double                             firmer = 1.;
    };

    /// The tangent of @p state, after the @p correction that led there, at @p
    /// to; with an @p aid where it needs one. Throws LostDigits where none is
    /// enough.
    Linearisation
    tangent(const State       &state,
            const BlockVector &correction,
            const LoadFactor  &to,
            Aid               &aid) const;

    /// Throws LostDigits where the tangent of @p state at @p to is not definite
    /// with the rows that bear a force there. That of the last correction was,
    /// and is not looked at again if this was small beside the way from
    /// @p before and leant on nothing: rows may have opened. Throws
    /// NumericsError where what rubs is unstable.
    void
    require_minimum(const BlockVector &before,
                    const Correction  &last,
                    const State       &state,
                    const LoadFactor  &to) const;

    /**
     * Throws NumericsError where @p state at @p to is stable by its springs
     * alone, LostDigits where it is not even by them. Whether it was looked at:
     * not where nothing presses, and what rubs is judged by its own law.
     *
     * With R their rows, so that R^T R is what they have in K, and C the
     * compliance of K with the rows that bear a force held, the motions
     * V = C R^T are all that they hold, of the energy
     *   V^T (K - R^T R - H) V = G - G G - V^T H V,   G = R C R^T,
     * which must not be negative beside the work of what presses on the way of
     * such a motion over the size of the scene. Neutral ones are let pass, as
     * of a block that may slide.
     */
    bool
    require_held(const State &state, const LoadFactor &to) const;

    /// Presses the gaps of @p rows in @p state at @p to by the @p strategy: its
    /// forces and active rows, and what that moves bodies by, which is in what
    /// is returned.
    ContactSolution
    press(ContactStrategy  &strategy,
          const GapRows    &rows,
          const LoadFactor &to,
          State            &state) const;

    /// What the correction @p du of the state @p u becomes where rows turn as
    /// bodies move, and no spring is to hold them: with H = sum lambda Hess g
    /// of the forces of @p state, which come along, and S the springs in K, so
    /// many times @p firmer,
    ///   K du - B^T dlambda = r + (H + S) du,
    /// for the rows that are active, by GMRES; @p du itself where that does not
    /// end.
    BlockVector
    follow_rows(ContactStrategy   &strategy,
                const BlockVector &u,
                const BlockVector &du,
                const double       firmer,
                const LoadFactor  &to,
                State             &state) const;

    /// f += S w of the stabilising springs, so many times @p firmer.
    void
    add_spring_forces(const double       firmer,
                      const BlockVector &w,
                      BlockVector       &f) const;

    /// H @p w about the state @p u, by central differences of B^T lambda; zero
    /// where a row is lost on the way.
    BlockVector
    turn_of_rows(const State       &state,
                 const BlockVector &u,
                 const BlockVector &w,
                 const LoadFactor  &to) const;

    /// The largest displacement that the numbers of @p u make, of bodies whose
    /// rows turn by the sizes of their DoFs: warpings are no lengths.
    double
    length_of(const BlockVector &u) const;
    /// Shortens the @p change of bodies that would turn too far in it.
    void
    shorten(BlockVector &change) const;

    /// f(t) + B^T lambda - f_int of @p state, not condensed; contacts are where
    /// it is.
    BlockVector
    unbalanced(const State &state, const LoadFactor &factor) const;

    /// The unbalanced forces @p r, condensed @p here.
    static BlockVector
    condensed(const Linearisation &here, BlockVector r);

    /// Says in @p at, and to who listens, what is left of forces and gaps: the
    /// unbalanced forces @p r @p here at @p factor, condensed, over the loads
    /// or the internal forces, and 0 where they are rounding of those that the
    /// step
    /// @p began with. Whether that is within bounds.
    bool
    measure(const Linearisation &here,
            const BlockVector   &r,
            const LoadFactor    &factor,
            double              &began,
            Equilibrium         &at) const;

    /// What the last three iterations left.
    struct Decay
    {
      double now     = std::numeric_limits<double>::max(),
             before  = std::numeric_limits<double>::max(),
             earlier = std::numeric_limits<double>::max();
      void
      add(const double left);
      /// Whether two of them on end left more than @p share.
      bool
      stands(const double share) const;
    };

    /// Whether iterations end where this share is @p unbalanced, and the last
    /// correction is a @p change of that length.
    bool
    is_equilibrium(const Decay &unbalanced, const double change) const;

    /// Whether the forces @p r @p here are, on each body, no more than the last
    /// digits of the displacements @p u make.
    bool
    is_rounding(const Linearisation &here,
                const BlockVector   &r,
                const BlockVector   &u) const;

    /// Throws NumericsError: how far it came, and what became of the rest.
    [[noreturn]] void
    fail_beyond(const LoadFactor &reached, const LoadFactor &to) const;

    /// Whether to move bodies by @p way leaves them where they are: what
    /// supports are still to do, or a correction.
    bool
    is_still(const BlockVector &way) const;

    /// Whether gaps that miss the contact law by these lengths, at
    /// displacements of that @p size, are those of the law.
    bool
    keeps_law(const Decay &missed, const double size) const;

    const Structure &structure;
    /// Of bodies whose rows turn Body::dof_sizes(), empty for all others.
    std::vector<std::vector<double>> sizes;
    MovingContacts                   contacts;
    /// What the last attempt that threw said, and of the last one why a contact
    /// is lost; empty if none is.
    std::string            last_failure, lost_contact;
    const SolverKind       asked;
    const NewtonParameters parameters;
  };
} // namespace lamella

#endif
