// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/solve/checks.h>
#include <lamella/solve/friction_step.h>
#include <lamella/solve/nonlinear_solver.h>

#include <algorithm>
#include <cmath>

// Newton-Raphson iteration in load increments with bisection (Crisfield,
// Non-linear Finite Element Analysis of Solids and Structures 1, Wiley 1991,
// Ch. 9; Wriggers, Nonlinear Finite Element Methods, Springer 2008, Ch. 5).
//   advance()  divides the increment and bisects it after a failure,
//   attempt()  tries one part with predicted and with actual stresses,
//   step()     iterates until equilibrium, contact law and pairing hold,
//   correct()  solves one linearized contact problem (nonlinear_iteration.cc).
// Residuals are G^T (f + B^T lambda - f_int), from quadrature points. Linear
// structures keep tangent and rows, and have one part: step() with
// correct_linear().
namespace lamella
{
  namespace
  {
    std::string
    number_of_row(const unsigned int row)
    {
      return "row " + std::to_string(row);
    }



    /// Rounding error of the forces of the body @p b: its largest stiffness
    /// times the rounding error of the displacements @p u.
    double
    rounding_of_forces(const TangentOperator &here,
                       const BlockVector     &u,
                       const unsigned int     b)
    {
      return here.largest_stiffness(b) * displacement_rounding(u.block(b));
    }
  } // namespace



  NonlinearSolver::NonlinearSolver(const Structure           &structure,
                                   const SolverKind           requested,
                                   const NonlinearParameters &parameters)
    : NonlinearSolver(structure,
                      MovingContacts(GapConstraints()),
                      requested,
                      parameters)
  {}



  NonlinearSolver::NonlinearSolver(const Structure           &structure,
                                   MovingContacts             contacts,
                                   const SolverKind           requested,
                                   const NonlinearParameters &parameters,
                                   const Strategy             strategy)
    : progress([](const std::string &) {})
    , describe(number_of_row)
    , structure(structure)
    , contacts(std::move(contacts))
    , requested(requested)
    , parameters(parameters)
    , strategy(strategy)
  {
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      matrix_patterns.push_back(std::make_shared<MatrixPattern>());
  }



  NonlinearSolver::NonlinearSolver(LinearSystem              &linear,
                                   const NonlinearParameters &parameters)
    : progress([](const std::string &) {})
    , describe(number_of_row)
    , linear(&linear)
    , structure(linear.tangent().of())
    , contacts(linear.constraints())
    , requested(SolverKind::automatic)
    , parameters(parameters)
    , strategy(Strategy::undefined)
  {}



  Equilibrium
  NonlinearSolver::unloaded(const LoadFactor &factor) const
  {
    Equilibrium at;
    at.state.u = structure.zero();
    at.state.force.assign(contacts.rows().size(), 0.);
    if (contacts.rows().has_slips())
      at.state.friction = FrictionState::unloaded(contacts.rows());
    at.factor = factor.unloaded();
    return at;
  }



  BlockVector
  NonlinearSolver::unbalanced(const State      &state,
                              const LoadFactor &factor) const
  {
    BlockVector r = structure.residual(state.u, factor, state.rest);
    contacts.add_forces(state, r);
    return r;
  }



  // Relative residual |G^T r| / max(|f_int - B^T lambda|, |f|), Euclidean
  // norms, and the violation of the contact law. Residuals below the rounding
  // of the initial forces count as zero.
  bool
  NonlinearSolver::measure(const TangentOperator &here,
                           const BlockVector     &r,
                           const LoadFactor      &factor,
                           double                &began,
                           Equilibrium           &at) const
  {
    const BlockVector load     = structure.load(factor, at.state.u);
    BlockVector       internal = load;
    contacts.add_forces(at.state, internal);
    internal -= r;
    BlockVector left = r;
    here.condense(left);
    const double norm = left.l2_norm();
    // A step that begins without any force, with a moving obstacle only, takes
    // the first residual as reference.
    if (began == 0.)
      began = norm;
    // NaN if internal forces and loads vanish, which is above any tolerance.
    const double share = norm / std::max(internal.l2_norm(), load.l2_norm());
    at.residual =
      norm <= parameters.nothing * began &&
          !(share <= parameters.force_tolerance) &&
          // Small forces of stabilizing springs on one body may exceed the
          // rounding on another: each body is tested on its own.
          (!structure.has_springs() || is_rounding(here, left, at.state.u)) ?
        0. :
        share;
    at.law_error = contacts.law_error(at.state, factor);
    progress("iteration " + std::to_string(at.state.iterations) + ": " +
             to_text(at.residual, 2) + " of the forces unbalanced" +
             (contacts.none() ?
                "" :
                ", " + std::to_string(at.state.active.size()) +
                  " rows active, gaps off by " + to_text(at.law_error, 2)));
    // The comparison is false for NaN, which counts as divergence.
    return norm <= parameters.divergence_ratio * began;
  }



  void
  NonlinearSolver::ResidualHistory::add(const double left)
  {
    earlier = before;
    before  = now;
    now     = left;
  }



  bool
  NonlinearSolver::ResidualHistory::stagnates(const double share) const
  {
    return now > share * before && before > share * earlier;
  }



  // The last correction left the error r = dK du / 2 of the tangent change dK
  // along it. With the tangent before it, the next leaves dK K^-1 r, which is
  // 2 r^2 over the residual before.
  bool
  NonlinearSolver::is_accurate_enough(const RegularizedTangent &about,
                                      const ResidualHistory    &left) const
  {
    return about.K != nullptr && about.shift == nullptr &&
           about.regularization_factor == 1. &&
           left.before < std::numeric_limits<double>::max() &&
           2. * left.now * left.now <= parameters.force_tolerance * left.before;
  }



  double
  NonlinearSolver::reference_length(const State      &state,
                                    const LoadFactor &to) const
  {
    return linear != nullptr ? linear->displacement_scale(state, to) :
                               structure.size();
  }



  // Small displacements have their own rounding, positions that of the scene.
  double
  NonlinearSolver::rounding_of_gaps(const State      &state,
                                    const LoadFactor &to) const
  {
    return std::max(parameters.touching * reference_length(state, to),
                    state.rounding());
  }



  // Linear structures: refinement has reduced the residual to rounding.
  // Otherwise three criteria: the force tolerance; stagnation of the residual
  // below the rounding of slender bodies; a negligible correction near
  // equilibrium.
  bool
  NonlinearSolver::is_equilibrium(const ResidualHistory &unbalanced,
                                  const double           change) const
  {
    if (linear != nullptr)
      return true;
    // If all forces vanish, convergence is judged by the correction.
    if (unbalanced.now == 0.)
      return change <= parameters.negligible_correction * structure.size();
    return unbalanced.now <= parameters.force_tolerance ||
           (unbalanced.now < parameters.stagnation_level &&
            unbalanced.stagnates(parameters.stall_ratio) &&
            (!structure.has_springs() ||
             change < parameters.converged_change * structure.size())) ||
           (unbalanced.now < parameters.near_equilibrium &&
            change < parameters.negligible_correction * structure.size());
  }



  bool
  NonlinearSolver::is_rounding(const TangentOperator &here,
                               const BlockVector     &r,
                               const BlockVector     &u) const
  {
    for (unsigned int b = 0; b < u.n_blocks(); ++b)
      if (!(r.block(b).l2_norm() <= rounding_of_forces(here, u, b)))
        return false;
    return true;
  }



  // Tolerance by displacement and size of the scene, or stagnation.
  bool
  NonlinearSolver::satisfies_contact_law(const ResidualHistory &missed,
                                         const State           &state,
                                         const LoadFactor      &to) const
  {
    if (linear == nullptr)
      {
        const double size = length_of(state.u);
        return missed.now <= std::max(parameters.law * size,
                                      parameters.touching * structure.size()) ||
               (missed.now < parameters.stagnation_level * size &&
                missed.stagnates(parameters.stall_ratio));
      }
    const double size    = reference_length(state, to);
    const bool   is_slow = missed.now > parameters.slow * missed.before;
    if (missed.now <= std::max((is_slow ? parameters.weak_linear_law :
                                          parameters.linear_law) *
                                 size,
                               state.rounding()))
      return true;
    if (is_slow)
      linear->contact_strategy().increase_penalty();
    return false;
  }



  // Maximum norm in lengths: amplitudes of warping are scaled by their fields.
  double
  NonlinearSolver::length_of(const BlockVector &u) const
  {
    double largest = 0.;
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      largest =
        std::max(largest,
                 structure.bodies()[b]->magnitude(u.block(b)).displacement);
    return largest;
  }



  // Trust region of rotations: the correction of a body is scaled so that no
  // rotation increment exceeds the limit.
  void
  NonlinearSolver::shorten(BlockVector &change) const
  {
    for (unsigned int b = 0; b < structure.bodies().size(); ++b)
      if (const double spin =
            structure.bodies()[b]->magnitude(change.block(b)).rotation;
          spin > parameters.spin)
        change.block(b) *= parameters.spin / spin;
  }



  // Warm start from the forces of the previous step, whose slips stay.
  NonlinearSolver::StepStart
  NonlinearSolver::linear_start(const LoadFactor &to, Equilibrium &at) const
  {
    StepStart start;
    State    &state = at.state;
    start.estimate  = std::move(state);
    state           = linear->solve_free(to);
    if (contacts.rows().has_slips())
      {
        const FrictionState &previous = start.estimate.friction;
        state.friction          = FrictionState::unloaded(contacts.rows());
        state.friction.before   = previous.before;
        state.friction.history  = previous.history;
        state.friction.path_gap = previous.path_gap;
      }
    start.is_solution = is_open(state, start.estimate, to);
    return start;
  }



  // With friction, jammed bodies keep their forces in open gaps, too.
  bool
  NonlinearSolver::is_open(const State      &state,
                           const State      &previous,
                           const LoadFactor &to) const
  {
    const GapConstraints &rows = contacts.rows();
    if (rows.empty())
      return true;
    if (structure.has_springs() ||
        (rows.has_friction() && !previous.active.empty()) ||
        !rows.with_ties({}).empty())
      return false;
    const double closed = rounding_of_gaps(state, to);
    return std::none_of(rows.begin(), rows.end(), [&](const auto &row) {
      return row.gap(state.u, to) < -closed;
    });
  }



  // Linear predictor of the supports: the motion u_p of
  // the increment enters the first residual as the forces -K u_p.
  NonlinearSolver::StepStart
  NonlinearSolver::step_start(const LoadFactor &to, const Equilibrium &at) const
  {
    StepStart             result;
    const TangentOperator here(structure, at.state.u);
    result.moved = here.support_increment(at.factor, to);
    result.r     = unbalanced(at.state, to);
    if (result.moved.l2_norm() > 0.)
      result.r -= here.apply(result.moved);
    // With a moving obstacle only, r vanishes; loads and internal forces then
    // give the reference force.
    const BlockVector load = structure.load(to, at.state.u),
                      internal =
                        structure.internal_forces(at.state.u, at.state.rest);
    result.size =
      std::max({result.r.l2_norm(), load.l2_norm(), internal.l2_norm()});
    // Without active contact and loads, internal forces of moved bodies are
    // rounding: they give no reference force.
    double rounding = 0.;
    if (!contacts.none() && at.state.active.empty() && load.l2_norm() == 0.)
      for (unsigned int b = 0; b < internal.n_blocks(); ++b)
        rounding = std::max(rounding, rounding_of_forces(here, at.state.u, b));
    if (result.size <= rounding)
      result.size = 0.;
    return result;
  }



  std::shared_ptr<const TangentOperator>
  NonlinearSolver::tangent_at(const State &state) const
  {
    return linear != nullptr ?
             linear->shared_tangent() :
             std::make_shared<const TangentOperator>(structure, state.u);
  }



  // Rotations of supports are limited per step, as a position does not
  // determine the number of revolutions.
  double
  NonlinearSolver::largest_rotation(const LoadFactor &from,
                                    const LoadFactor &to) const
  {
    double largest = 0.;
    for (const PrescribedFunctional &row : structure.prescribed())
      if (row.rotation)
        largest = std::max(largest,
                           std::abs(to.of(row.history) - from.of(row.history)) *
                             row.rotation->rotation.norm());
    return largest;
  }



  // Forces, gaps and springs; the correction counts where all forces vanish.
  bool
  NonlinearSolver::is_converged(const Correction      &last,
                                const TangentOperator &here,
                                const BlockVector     &r,
                                const LoadFactor      &to,
                                Residuals             &residuals,
                                Equilibrium           &at) const
  {
    const State &state = at.state;
    residuals.forces.add(at.residual);
    residuals.gaps.add(at.law_error);
    residuals.springs.add(last.released.length);
    const double change = length_of(last.du),
                 negligible =
                   parameters.negligible_correction * structure.size();
    const bool balances = is_equilibrium(residuals.forces, change);
    at.rounding         = balances && at.residual > 0. ? 0. : change;
    BlockVector left    = r;
    here.condense(left);
    return satisfies_contact_law(residuals.gaps, state, to) &&
           last.released.is_done &&
           (balances ||
            (change <= negligible && is_rounding(here, left, state.u)));
  }



  bool
  NonlinearSolver::has_all_pairs(const BlockVector  &before,
                                 RegularizedTangent &about,
                                 const Correction   &last,
                                 const LoadFactor   &to,
                                 Equilibrium        &at)
  {
    if (contacts.find_loads(at.state, to))
      return false;
    contacts.check_kept(before, at.factor, at.state, to);
    check_stability(before, about, last, at.state, to);
    return true;
  }



  // One load increment. In each iteration k:
  // 1. correct() solves the linearized contact problem about u_k;
  // 2. contacts move to u_(k+1), and the residual is evaluated there;
  // 3. supports that rotate get the remaining first-order increment;
  // 4. after convergence, surfaces in contact without a row are paired anew,
  //    otherwise the tangent is checked for stability.
  bool
  NonlinearSolver::step(const LoadFactor &to,
                        const bool        predicted,
                        Equilibrium      &at)
  {
    State            &state  = at.state;
    const BlockVector before = state.u;
    contacts.begin_step(state, at.factor);
    StepStart start =
      linear != nullptr ? linear_start(to, at) : step_start(to, at);
    auto &[moved, r, began, estimate, is_solution] = start;
    RegularizedTangent about;
    Correction         last;
    Residuals          residuals;
    unsigned int       pairings = 0;
    for (unsigned int k = 0; k < parameters.max_iterations && !is_solution; ++k)
      {
        // Linear structures count the rounds of their contact problems.
        state.iterations += linear == nullptr ? 1 : 0;
        // Thermal strains of the increment are mostly free of stress, so the
        // first tangent uses the previous heat factor.
        if (linear == nullptr && !is_accurate_enough(about, residuals.forces))
          {
            // Frees the memory of the last factor.
            about = RegularizedTangent();
            about = tangent(state,
                            predicted ? last.du : BlockVector(),
                            k == 0 ? to.with_thermal_factor_of(at.factor) : to);
          }
        last     = linear != nullptr ? correct_linear(r, to, estimate, state) :
                                       correct(about, r, moved, to, state);
        estimate = State();

        structure.check_orientation(state.u);
        contacts.move(state, to);
        const auto tangent = tangent_at(state);
        r                  = unbalanced(state, to);
        if (!measure(*tangent, r, to, began, at))
          break;
        // Rotating rows are off their prescribed values by second-order terms.
        moved = tangent->support_increment(to, to);
        if (is_converged(last, *tangent, r, to, residuals, at) &&
            length_of(moved) <=
              parameters.negligible_correction * structure.size())
          {
            is_solution = has_all_pairs(before, about, last, to, at);
            if (is_solution)
              break;
            if (++pairings > parameters.max_pairings)
              break;
            r = unbalanced(state, to);
            // New pairs have their first forces: reset the reference residual.
            began     = 0.;
            residuals = Residuals();
          }
        if (moved.l2_norm() > 0.)
          r -= tangent->apply(moved);
      }
    if (is_solution)
      {
        end_step(contacts.rows(), to, linear == nullptr, state);
        at.factor = to;
      }
    else if (linear != nullptr)
      throw_not_settled(at,
                        last.released,
                        residuals.springs.now / residuals.springs.before);
    return is_solution;
  }



  // A failed attempt restores the state and the pairing of the start. Linear
  // structures have one attempt, as no smaller step does better.
  StepOutcome
  NonlinearSolver::attempt(const LoadFactor &to, Equilibrium &at)
  {
    if (linear != nullptr)
      return {step(to, false, at)};
    const Equilibrium                 before   = at;
    const std::vector<ContactHistory> pairings = contacts.memory();
    StepOutcome                       outcome;
    for (const bool predicted : {true, false})
      {
        try
          {
            if (step(to, predicted, at))
              return {true};
            outcome.reason = "The last iteration left " +
                             to_text(at.residual, 2) +
                             " of the forces unbalanced, and gaps off by " +
                             to_text(at.law_error, 2) + ".";
          }
        catch (const NumericsError &error)
          {
            outcome.reason = error.what();
            progress(outcome.reason);
          }
        // A lost contact is the cause of the failures that follow.
        if (!contacts.reason_of_loss().empty())
          outcome.lost_contact = contacts.reason_of_loss();
        const unsigned int iterations = at.state.iterations;
        const MethodCounts solved_by  = at.state.solved_by;
        at                            = before;
        at.state.iterations           = iterations;
        at.state.solved_by            = solved_by;
        contacts.restore(pairings, at.state.u, at.factor);
      }
    return outcome;
  }



  void
  NonlinearSolver::throw_not_converged(const StepOutcome &outcome,
                                       const LoadFactor  &from,
                                       const LoadFactor  &to) const
  {
    const std::string where = "beyond load factor " +
                              to_text(from.of_scene(), 6) + ", on the way to " +
                              to_text(to.of_scene(), 6);
    if (!outcome.lost_contact.empty())
      throw NumericsError("solve.contact-lost: No equilibrium was found " +
                          where + ". " + outcome.lost_contact);
    throw NumericsError(
      "solve.no-equilibrium: No stable equilibrium was found " + where +
      ": the loads may exceed a limit load, or a body may buckle. Prescribe a "
      "displacement instead of loads, or model a geometric imperfection." +
      (contacts.none() ?
         "" :
         " States after buckling are not found for a body that only another "
         "body restrains (an obstacle may restrain it).") +
      (structure.has_springs() ?
         " For a body with Stabilization, try other values from 1e-8 to 1e-5." :
         "") +
      (structure.bodies().back()->cells().n == 0 ?
         " The Force of an obstacle may exceed what its contacts balance, or "
         "point away from the bodies; then prescribe u." :
         "") +
      (outcome.reason.empty() ? "" : " (" + outcome.reason + ")"));
  }



  // A state from another path (a branch or a bisection) first restores the
  // contacts, whose constraints belong to the last solution.
  Equilibrium
  NonlinearSolver::solve(const LoadFactor &to,
                         const State      &before,
                         const LoadFactor &from)
  {
    Equilibrium start = unloaded(to);
    if (before.u.n_blocks() > 0)
      {
        if (reached.n_blocks() == 0 || !(before.u == reached))
          restore(before, from);
        start.state  = before;
        start.factor = from;
        // Iterations have the rounding of positions, and their own pairing.
        if (linear == nullptr)
          {
            start.state.free_sizes.clear();
            start.state.pairings.clear();
          }
      }
    else if (reached.n_blocks() > 0)
      contacts.restore(contacts.undeformed(), start.state.u, start.factor);
    // Constraints belong to no state during the iterations.
    reached         = BlockVector();
    Equilibrium end = advance(start, to);
    reached         = end.state.u;
    if (linear != nullptr)
      return end;
    end.state.pairings = contacts.memory();
    end.state.free_sizes.clear();
    // The iterations end at the rounding of the largest displacement; forces
    // between bodies have the rounding of their displacement.
    constexpr double digits = 100.;
    for (unsigned int b = 0; b < end.state.u.n_blocks(); ++b)
      end.state.free_sizes.push_back(
        std::max({digits * end.state.u.block(b).linfty_norm(),
                  end.rounding / arithmetic::rounding,
                  before.free_sizes.empty() ? 0. : before.free_sizes[b]}));
    return end;
  }



  // Automatic step division: halve after a failure, continue with the reduced
  // fraction after a success (Crisfield, Sec. 9.5).
  Equilibrium
  NonlinearSolver::advance(const Equilibrium &start, const LoadFactor &to)
  {
    Equilibrium at      = start;
    at.state.iterations = at.cuts = 0;
    at.state.solved_by            = {};
    // Completed fraction of the increment, and fraction of the next step.
    double done = 0., way = 1.;
    while (way * largest_rotation(start.factor, to) > parameters.rotation)
      way /= 2.;
    while (done < 1.)
      {
        const double     next   = std::min(1., done + way);
        const LoadFactor target = next < 1. ? to.after(start.factor, next) : to;
        const StepOutcome outcome = attempt(target, at);
        if (outcome.converged)
          {
            done = next;
            continue;
          }
        way /= 2.;
        if (++at.cuts > parameters.max_bisections)
          throw_not_converged(outcome, at.factor, to);
        progress("no convergence: a step of " + to_text(way, 4) +
                 " of the way is tried");
      }
    return at;
  }
} // namespace lamella
