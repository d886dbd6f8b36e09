// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/solve/contact_solver.h>
#include <lamella/solve/friction_step.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

// Solution of a load step with contact. The outer loop of solve_contact() is
// the method of multipliers (Hestenes, Powell; Simo and Laursen, Comput.
// Struct. 42 (1992) 97-116), a proximal point iteration on the forces
// (Rockafellar, SIAM J. Control Optim. 14 (1976) 877-898):
// 1. the strategy finds active set and forces for the estimates;
// 2. refine(): iterative refinement of displacements and forces against the
//    residual from strains (Higham, Accuracy and Stability of Numerical
//    Algorithms, SIAM 2002, Ch. 12);
// 3. find_violations(): Kuhn-Tucker conditions and Coulomb's law;
// 4. the refined forces are the next estimates, with a tenfold penalty if the
//    violation falls slowly;
// 5. release_springs() repeats all with shifted springs until these are free of
//    force, if only contact constrains a body.
//
// The start of the first load step has zero estimates; later ones take the
// forces of the previous step. Tolerances are relative to the displacements
// (displacement_scale()), as gaps are differences of displacements.
namespace lamella
{
  using namespace dealii;

  namespace
  {
    std::vector<unsigned int>
    sorted_union(std::vector<unsigned int>        a,
                 const std::vector<unsigned int> &b)
    {
      a.insert(a.end(), b.begin(), b.end());
      return a;
    }
  } // namespace



  // The strategy refers to the tangent operator, which this object shares.
  ContactSolver::ContactSolver(std::shared_ptr<const TangentOperator> tangent,
                               const GapConstraints                  &rows,
                               const SolverParameters &parameters,
                               const Strategy          which)
    : progress([](const std::string &) {})
    , describe(
        [](const unsigned int row) { return "row " + std::to_string(row); })
    , tangent_operator(std::move(tangent))
    , structure(tangent_operator->of())
    , rows(rows)
    , parameters(parameters)
    , strategy(make_strategy(which, *tangent_operator, rows))
  {}



  // g = B u + g_init + t g_rate (Eq. 16).
  std::vector<double>
  ContactSolver::gaps(const BlockVector &u, const LoadFactor &factor) const
  {
    std::vector<double> g;
    for (const GapConstraint &row : rows)
      g.push_back(row.gap(u, factor));
    return g;
  }



  // ---- contact on top of a free state

  // With a correct active set, the loop ends by the error of the law. If a set
  // returns, correct_active_set() decides close gaps on refined states, and
  // multipliers_are_reliable() accepts forces of dependent rows.
  State
  ContactSolver::solve_contact(const State      &free,
                               const LoadFactor &factor,
                               const State      &previous)
  {
    State state = free;
    if (rows.has_friction())
      {
        state.friction = FrictionState::unloaded(rows);
        if (!previous.friction.empty())
          {
            state.friction.before   = previous.friction.before;
            state.friction.history  = previous.friction.history;
            state.friction.path_gap = previous.friction.path_gap;
          }
      }
    ContactProblem            problem = first_problem(state, factor, previous);
    double                    before  = std::numeric_limits<double>::max();
    std::vector<unsigned int> last;
    unsigned int              not_counted = 0;
    while (true)
      {
        const ContactSolution found =
          strategy->solve(problem, [&](const Round &round) {
            not_counted += !round.counts;
            watch(round, not_counted, state.iterations);
          });
        if (state.iterations == 0)
          return state;
        if (found.is_unstable)
          throw_unstable();
        state.u += found.du;
        store_forces(rows, found, state);
        const State settled       = state;
        state.contact_corrections = refine(state, factor, 1);

        const ContactViolations missed = find_violations(state, factor);
        const bool              slow   = missed.gap > parameters.slow * before;
        if (missed.is_active_set_correct() ?
              satisfies_contact_law(state, factor, missed.gap, slow) :
              ((found.active == last || !state.friction.empty()) &&
               correct_active_set(state, factor)) ||
                multipliers_are_reliable(state, settled, factor))
          return state;
        check_iterations(state.iterations - not_counted,
                         sorted_union(sorted_union(missed.tensile,
                                                   missed.penetrating),
                                      missed.friction_violations));
        if (slow)
          strategy->increase_penalty();
        before  = missed.gap;
        last    = found.active;
        problem = problem_at(state, factor);
      }
  }



  // Warm start from the last step, for rows that penetrate without contact.
  ContactProblem
  ContactSolver::first_problem(const State      &free,
                               const LoadFactor &factor,
                               const State      &previous) const
  {
    // Other rows start open, as in unloading they become tensile and activate
    // others. With friction they may be jammed, and keep their forces.
    ContactProblem problem = problem_at(free, factor);
    problem.start.clear();
    for (const unsigned int r : previous.active)
      if (problem.gap[r] < 0.)
        {
          problem.start.push_back(r);
          problem.estimate[r] = previous.force[r];
        }
    if (!previous.friction.empty())
      problem.first_forces = forces_by_rows(rows, previous);
    return problem;
  }



  // The increment problem about the state, its forces as estimates lambda_bar.
  ContactProblem
  ContactSolver::problem_at(const State &state, const LoadFactor &factor) const
  {
    ContactProblem problem;
    problem.gap      = gaps(state.u, factor);
    problem.force    = state.force;
    problem.estimate = state.force;
    problem.start    = state.active;
    problem.closed   = length_of(parameters.rounding, state, factor);
    if (!state.friction.empty())
      add_friction(rows, state, factor, problem);
    return problem;
  }



  // Stick: |lambda_t| <= mu lambda_n. Slip: v + |v| e = 0, so that the slip is
  // opposite to the shear force.
  void
  ContactSolver::add_friction_violations(const State       &state,
                                         const LoadFactor  &factor,
                                         const unsigned int r,
                                         const double       closed,
                                         const double       small,
                                         ContactViolations &found) const
  {
    const Tensor<1, 2> v     = slip_in_step(rows[r], r, state, factor),
                       shear = along_tangents(rows[r], state.friction.shear[r]),
                       e = along_tangents(rows[r], state.friction.direction[r]);
    const bool sticks    = e.norm() == 0.;
    if (sticks)
      found.gap = std::max(found.gap, v.norm());
    const bool is_wrong =
      sticks ? shear.norm() > rows[r].friction * state.force[r] + small :
               (v + v.norm() * e).norm() > closed;
    if (is_wrong)
      found.friction_violations.push_back(r);
  }



  // Kuhn-Tucker conditions by rows: active rows have lambda >= 0 and g + a
  // lambda = 0, others g >= -closed.
  ContactSolver::ContactViolations
  ContactSolver::violations(const State      &state,
                            const LoadFactor &factor,
                            const double      closed) const
  {
    const std::vector<double> g       = gaps(state.u, factor);
    double                    largest = 0.;
    for (const double lambda : state.force)
      largest = std::max(largest, std::abs(lambda));
    // A slip is known to a few corrections, once refinement gains no digits.
    constexpr double few = 4.;
    const double     slid =
      std::max(few * closed,
               length_of(parameters.weak_law_tolerance, state, factor));
    ContactViolations found;
    for (const unsigned int r : state.active)
      {
        if (state.force[r] < 0.)
          found.tensile.push_back(r);
        else
          found.gap =
            std::max(found.gap,
                     std::abs(g[r] + law_compliance(rows[r]) * state.force[r]));
        if (!rows[r].slips.empty())
          add_friction_violations(state,
                                  factor,
                                  r,
                                  slid,
                                  parameters.weak_law_tolerance * largest,
                                  found);
      }
    for (unsigned int r = 0; r < rows.size(); ++r)
      if (g[r] < -closed &&
          !std::binary_search(state.active.begin(), state.active.end(), r))
        found.penetrating.push_back(r);
    return found;
  }



  // Penetrations up to the last correction are rounding.
  ContactSolver::ContactViolations
  ContactSolver::find_violations(const State      &state,
                                 const LoadFactor &factor) const
  {
    return violations(state,
                      factor,
                      length_of(std::max(parameters.rounding,
                                         state.contact_corrections.back()),
                                state,
                                factor));
  }



  // The weak tolerance applies if a further round hardly improves the law.
  bool
  ContactSolver::satisfies_contact_law(const State      &state,
                                       const LoadFactor &factor,
                                       const double      error,
                                       const bool        was_slow) const
  {
    return error <= length_of(parameters.law_tolerance, state, factor) ||
           (was_slow &&
            error <= length_of(parameters.weak_law_tolerance, state, factor));
  }



  // Forces of dependent rows are not unique: displacements are refined for
  // fixed forces, without equations for the rows.
  bool
  ContactSolver::multipliers_are_reliable(State            &state,
                                          const State      &settled,
                                          const LoadFactor &factor)
  {
    if (!strategy->forces_are_accurate() || !state.friction.empty())
      return false;
    const double weak_law_tolerance =
      length_of(parameters.weak_law_tolerance, state, factor);
    state = settled;
    state.active.clear();
    state.contact_corrections = refine(state, factor, 1);
    state.active              = settled.active;
    const ContactViolations left =
      violations(state, factor, weak_law_tolerance);
    return left.penetrating.empty() && left.gap <= weak_law_tolerance;
  }



  // Primal-dual exchange on refined states: tensile rows leave, penetrating
  // rows join, all at once. With friction only directions of slip are
  // corrected.
  bool
  ContactSolver::correct_active_set(State &state, const LoadFactor &factor)
  {
    State at = state;
    for (unsigned int round = 0; round < parameters.max_set_corrections;
         ++round)
      {
        const ContactViolations found = find_violations(at, factor);
        if (found.is_active_set_correct())
          {
            if (found.gap >
                length_of(parameters.weak_law_tolerance, at, factor))
              return false;
            state = std::move(at);
            return true;
          }
        for (const unsigned int r : found.tensile)
          at.force[r] = 0.;
        if (!at.friction.empty() &&
            (!found.tensile.empty() || !found.penetrating.empty()))
          return false;
        turn_shear_forces(rows, factor, at);
        // Exchange: without the tensile rows, with the penetrating ones.
        std::vector<unsigned int> active_goals;
        std::set_difference(at.active.begin(),
                            at.active.end(),
                            found.tensile.begin(),
                            found.tensile.end(),
                            std::back_inserter(active_goals));
        at.active = sorted_union(std::move(active_goals), found.penetrating);
        std::sort(at.active.begin(), at.active.end());
        ++at.iterations;
        at.contact_corrections = refine(at, factor, 1);
      }
    return false;
  }



  // ---- without the forces of stabilizing springs

  // Proximal point iteration on the rigid-body motions: spring offsets r_0 =
  // r(u_k) of the last round make the springs free of force at convergence. The
  // rate is s / (s + k), s and k the stiffness of springs and contact.
  State
  ContactSolver::release_springs(State state, const LoadFactor &factor)
  {
    if (!structure.has_springs())
      return state;
    double before = std::numeric_limits<double>::max();
    for (unsigned int round = 1;; ++round)
      {
        // Proximal step: the springs become free of force at the last state.
        // The offset change times the stiffness is the remaining force.
        const SpringOffsets rest   = structure.spring_lengths(state.u);
        double              change = 0., force = 0.;
        for (unsigned int b = 0; b < rest.size(); ++b)
          for (unsigned int k = 0; k < rest[b].size(); ++k)
            {
              const double moved = std::abs(
                rest[b][k] - (state.rest.empty() ? 0. : state.rest[b][k]));
              change = std::max(change, moved);
              force =
                std::max(force, structure.springs(b)[k].stiffness * moved);
            }
        double forces = std::max(structure.load(factor).linfty_norm(),
                                 structure.thermal_load().linfty_norm());
        for (const double lambda : state.force)
          forces = std::max(forces, std::abs(lambda));
        if (change <= parameters.spring_offset_tolerance *
                        displacement_scale(state, factor) ||
            force <= parameters.spring_force_tolerance * forces)
          return state;
        if (round > parameters.max_releases)
          throw_spring_failure(state, change / before);
        before = change;
        progress("round " + std::to_string(round) +
                 " of releasing the stabilizing springs:");
        state = with_springs_at(rest, std::move(state), factor);
      }
  }



  // With the same active set, the offsets only change a right-hand side.
  State
  ContactSolver::with_springs_at(const SpringOffsets &rest,
                                 State                state,
                                 const LoadFactor    &factor)
  {
    State next = state;
    next.rest  = rest;
    ++next.iterations;
    next.contact_corrections     = refine(next, factor, 1);
    const ContactViolations left = find_violations(next, factor);
    if (left.is_active_set_correct() ?
          satisfies_contact_law(next, factor, left.gap, false) :
          !next.friction.empty() && correct_active_set(next, factor))
      return next;
    next = solve_contact(solve_free(factor, rest), factor, state);
    next.iterations += state.iterations;
    return next;
  }



  // A rate of about 1: loads on the motion are balanced by the springs only.
  void
  ContactSolver::throw_unconstrained_motion(const std::string &body,
                                            const std::string &motion,
                                            const double       rate) const
  {
    const bool has_friction = rows.has_friction();
    if (motion == motion_along_force)
      throw NumericsError("solve.force-not-balanced: Obstacle '" + body +
                          "': no contact balances its Force (in each iteration "
                          "it moves " +
                          to_text(rate, 4) +
                          " times as far as in the iteration before). Point "
                          "Force towards the bodies, check the positions of "
                          "obstacle and bodies, or prescribe u.");
    throw NumericsError(
      "solve.unconstrained-motion: Body '" + body +
      "' has a rigid-body motion that no support or contact prevents (" +
      motion + ", in each iteration " + to_text(rate, 4) +
      " times as far as in the iteration before): its contacts" +
      (has_friction ? " and their friction" : "") +
      " do not balance its loads. Add a support, " +
      (has_friction ? "increase Friction, " : "") +
      (has_friction && !strategy->forces_are_accurate() ?
         "write Contact strategy = condensed (full may not converge where "
         "friction alone constrains a body), " :
         "") +
      "close its gaps by a prescribed displacement, or load it towards the "
      "other body.");
  }



  // With the rate q = s / (s + k) of the offsets, a share with the rate 0.1 is
  // recommended; a rate of 1 means k = 0, an unconstrained motion.
  void
  ContactSolver::throw_spring_failure(const State &state,
                                      const double rate) const
  {
    constexpr double wanted_rate = 0.1;

    // Spring with the largest remaining force.
    const SpringOffsets lengths = structure.spring_lengths(state.u);
    unsigned int        body = 0, spring = 0;
    double              largest = -1.;
    for (unsigned int b = 0; b < lengths.size(); ++b)
      for (unsigned int k = 0; k < lengths[b].size(); ++k)
        {
          const double force = structure.springs(b)[k].stiffness *
                               std::abs(lengths[b][k] - state.rest[b][k]);
          if (force > largest)
            {
              largest = force;
              body    = b;
              spring  = k;
            }
        }
    const Spring     &worst = structure.springs(body)[spring];
    const std::string name  = structure.bodies()[body]->name();
    if (!(rate < 0.999) || worst.motion == motion_along_force)
      throw_unconstrained_motion(name, worst.motion, rate);
    throw NumericsError(
      "solve.springs-too-stiff: The stabilizing springs of body '" + name +
      "' are too stiff compared with its contacts (" + worst.motion +
      "): the force in these springs decreases only by the factor " +
      to_text(rate, 3) + " in each iteration. Write a smaller value, Body " +
      name + "/Stabilization = " +
      to_text(worst.share * wanted_rate / (1. - wanted_rate) * (1. - rate) /
                rate,
              1) +
      ".");
  }



  // Reference length of all tolerances: the maximum norm of displacements,
  // obstacle motions and accumulated slips.
  double
  ContactSolver::displacement_scale(const State      &state,
                                    const LoadFactor &factor) const
  {
    // Gaps are differences of displacements and motions of obstacles.
    double size = state.u.linfty_norm();
    for (const GapConstraint &row : rows)
      size = std::max(size, std::abs(factor.of(row.history) * row.gap_rate));
    // Slips since the start count, as a body may return to its initial place.
    for (const Tensor<1, 3> &slip : state.friction.before)
      size = std::max(size, slip.norm());
    return size;
  }



  // Absolute tolerances are at least the rounding of nearly rigid motions.
  double
  ContactSolver::length_of(const double      share,
                           const State      &state,
                           const LoadFactor &factor) const
  {
    return std::max(share * displacement_scale(state, factor),
                    state.rounding());
  }



  // Linear solution without contact by iterative refinement from u = u_p(t).
  State
  ContactSolver::solve_free(const LoadFactor &factor, const SpringOffsets &rest)
  {
    State state;
    state.rest = rest;
    state.u    = structure.particular(factor);
    state.force.assign(rows.size(), 0.);
    // u = u_p(t) satisfies the supports; corrections are zero in prescribed
    // DoFs.
    // The first correction is the solution itself, the second a refinement.
    state.free_corrections = refine(state, factor, 2);
    state.free_corrections.erase(state.free_corrections.begin());
    for (unsigned int b = 0; b < state.u.n_blocks() && !structure.has_springs();
         ++b)
      state.free_sizes.push_back(state.u.block(b).linfty_norm());
    return state;
  }



  // All closed rows as sticking: the symmetric tangent for small disturbances.
  ActiveConstraints
  ContactSolver::sticking_equations(const State &state) const
  {
    ActiveConstraints held(state.active);
    for (const unsigned int r : state.active)
      for (unsigned int a = 0; a < rows[r].slips.size(); ++a)
        held.numbers.push_back(rows.slip(r, a));
    return held;
  }



  // r_lambda = -(g + a lambda) for gaps, -v for the slips of sticking rows.
  Vector
  ContactSolver::law_residual(const State             &state,
                              const LoadFactor        &factor,
                              const ActiveConstraints &closed) const
  {
    Vector residual(closed.numbers.size());
    for (unsigned int i = 0; i < residual.size(); ++i)
      {
        const unsigned int number = closed.numbers[i], r = rows.row_of(number);
        residual[i] =
          number == r ?
            -(rows[r].gap(state.u, factor) +
              law_compliance(rows[r]) * state.force[r]) :
            -slip_in_step(rows[r], r, state, factor)[number - rows.slip(r, 0)];
      }
    return residual;
  }



  // One correction of iterative refinement: residuals at the state, a linear
  // solution with the active set fixed, and the update of u and lambda.
  double
  ContactSolver::correct(State &state, const LoadFactor &factor)
  {
    BlockVector r_u = structure.residual(state.u, factor, state.rest);
    // All forces, also those of rows without an equation
    // (multipliers_are_reliable()).
    for (unsigned int r = 0; r < rows.size() && !state.force.empty(); ++r)
      if (state.force[r] != 0.)
        add_force(rows[r],
                  state.force[r],
                  state.friction.empty() ? Tensor<1, 3>() :
                                           state.friction.shear[r],
                  r_u);
    const ActiveConstraints closed = active_equations(rows, state);
    BlockVector             du;
    Vector                  dlambda;
    strategy->solve(
      closed, r_u, law_residual(state, factor, closed), du, dlambda);
    state.u += du;
    add_forces(rows, closed, dlambda, state);

    // The test catches NaN, too.
    const double size = state.u.linfty_norm(), change = du.l2_norm();
    if (!std::isfinite(change))
      throw NumericsError(
        "solve.not-finite: The solution is not finite. Check the loads.");
    return change <= state.rounding() ? 0. : du.linfty_norm() / size;
  }



  // Stopping criteria of iterative refinement (Higham, Ch. 12): a tolerance,
  // a ratio above 1/2 of successive corrections, a limit.
  bool
  ContactSolver::is_refined(const std::vector<double> &corrections,
                            const unsigned int         at_least) const
  {
    // Tolerance, rounding of the residual, or limit reached.
    const unsigned int n = corrections.size();
    return n >= at_least &&
           (corrections.back() < parameters.refinement_tolerance ||
            (n > at_least && corrections[n - 1] > 0.5 * corrections[n - 2]) ||
            n >= parameters.max_refinements + at_least);
  }



  // Iterative refinement in fixed precision: the residual from strains is more
  // accurate than the matrix, so each correction gains digits.
  std::vector<double>
  ContactSolver::refine(State             &state,
                        const LoadFactor  &factor,
                        const unsigned int at_least)
  {
    std::vector<double> corrections;
    do
      corrections.push_back(correct(state, factor));
    while (!is_refined(corrections, at_least));
    return corrections;
  }



  // Counts rounds of the strategy and reports them.
  void
  ContactSolver::watch(const Round       &round,
                       const unsigned int not_counted,
                       unsigned int      &iterations) const
  {
    ++iterations;
    progress("iteration " + std::to_string(iterations) + ": " +
             std::to_string(round.active) + " active rows, " +
             std::to_string(round.changed.size()) + " to change" +
             (round.changed.empty() ?
                "" :
                ", gaps off by up to " + to_text(round.violation, 3)));
    if (!round.changed.empty())
      check_iterations(iterations - not_counted, round.changed);
  }



  std::string
  ContactSolver::describe_overlap() const
  {
    unsigned int deepest = 0;
    for (unsigned int r = 0; r < rows.size(); ++r)
      if (rows[r].initial_gap < rows[deepest].initial_gap)
        deepest = r;
    if (rows.empty() || rows[deepest].initial_gap >= 0.)
      return "";
    return " Bodies overlap at the start by up to " +
           to_text(-rows[deepest].initial_gap, 4) + " (" + describe(deepest) +
           "): use Overclosure = adjust, which subtracts the overlap from the "
           "gaps, or move them apart.";
  }



  // Lists the first constraints that still change, and the initial overlap.
  void
  ContactSolver::check_iterations(
    const unsigned int               iterations,
    const std::vector<unsigned int> &changing) const
  {
    if (iterations < parameters.max_iterations)
      return;
    std::string names;
    for (unsigned int k = 0; k < changing.size() && k < 3; ++k)
      names += (k > 0 ? "; " : "") + describe(changing[k]);
    throw NumericsError(
      "solve.not-converged: The contact did not converge in " +
      std::to_string(parameters.max_iterations) + " iterations; " +
      std::to_string(changing.size()) + " of " + std::to_string(rows.size()) +
      " contact constraints still change between active and inactive" +
      (names.empty() ? "" :
                       " (" + names + (changing.size() > 3 ? "; ...)" : ")")) +
      "." + describe_overlap() + " Try " + strategy->remedy() +
      ", a finer mesh at the contact edge, or larger Maximum iterations.");
  }
} // namespace lamella
