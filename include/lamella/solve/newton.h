// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_newton_h
#define lamella_solve_newton_h

#include <lamella/base/arithmetic.h>
#include <lamella/solve/linearisation.h>

#include <optional>

namespace lamella
{
  /// When Newton's iterations end, and what is done where they do not.
  struct NewtonParameters
  {
    unsigned int max_iterations = 30;
    /// Unbalanced forces over the larger one of internal forces and loads, in
    /// the Euclidean norm, that are equilibrium.
    double balanced = arithmetic::negligible;
    /// Forces of slender bodies end at their rounding, some (L / h)^3 1e-16:
    /// below `floor` they do once an iteration leaves more than `stalls` of
    /// them; and below `near` where the correction is this share of the size
    /// of the scene.
    double floor = arithmetic::alike, stalls = 0.3, near = 1e-2,
           still = arithmetic::same_place;
    /// Forces that are left beyond this, over those that the step began with,
    /// are a failure; below `nothing` of these they are rounding.
    double diverged = 1e12, nothing = arithmetic::rounding_of_sums;
    /// How often a step is halved.
    unsigned int max_cuts = 6;
  };

  /// A state that bodies which turn are in equilibrium in, without contact.
  struct Equilibrium
  {
    BlockVector u;
    LoadFactor  factor;
    /// On the way to it, those of attempts that failed among them; and how
    /// often a step was halved.
    unsigned int iterations = 0, cuts = 0;
    /// Unbalanced forces over internal forces or loads.
    double residual = 0.;
  };

  /**
   * Newton's method for structures whose internal forces are not linear, cold
   * and without stabilising springs,
   *   f_int(u) = f(t),   u = G v + u_p(t),
   * from one load factor to the next: K du = f(t) - f_int(u) at each iterate,
   * where the first one takes up what supports move by, as forces K du_p: a
   * prescribed motion alone would tear the elements at the support.
   *
   * The stress of the geometric part of K is the one that the last correction
   * predicted (GreenAnswer): from 17 iterations down to 7 in a cantilever that
   * rolls up in one step. Where that fails the step is tried with the
   * stress as it is, and then in halves.
   *
   * Refers to the structure. Collective.
   */
  class Newton
  {
  public:
    /// Throws InputError if @p structure is heated or has springs.
    explicit Newton(const Structure        &structure,
                    const SolverKind        asked      = SolverKind::automatic,
                    const NewtonParameters &parameters = NewtonParameters());

    /// The state without loads, of a path to @p factor.
    Equilibrium
    at_rest(const LoadFactor &factor = 1.) const;

    /// That at load factor @p to, on from @p start. Throws NumericsError with
    /// the last factor that was reached if it cannot be had in
    /// 2^max_cuts parts of the way.
    Equilibrium
    advance(const Equilibrium &start, const LoadFactor &to) const;

  private:
    /// One step, with the stress that corrections predict or without; whether
    /// it ended. Counts its iterations in @p state.
    bool
    step(const LoadFactor &to, const bool predicted, Equilibrium &state) const;

    /// The same both ways; where it fails @p state stays but for the count.
    bool
    attempt(const LoadFactor &to, Equilibrium &state) const;

    /// The size of the unbalanced forces @p r at @p factor, condensed, over
    /// the loads or the internal forces; 0 where they are rounding of those
    /// that the step @p began with. Nothing where they grow beyond all bounds.
    std::optional<double>
    share_left(const BlockVector &r,
               const LoadFactor  &factor,
               const double       began) const;

    /// Whether iterations end where the share @p left is unbalanced, @p before
    /// by the iteration before, and the last correction is a @p change of that
    /// length.
    bool
    is_equilibrium(const double left,
                   const double before,
                   const double change) const;

    const Structure       &structure;
    const SolverKind       asked;
    const NewtonParameters parameters;
  };
} // namespace lamella

#endif
