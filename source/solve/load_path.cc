// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/solve/checks.h>
#include <lamella/solve/load_path.h>
#include <lamella/solve/phase.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamella
{
  using dealii::TimerOutput;

  namespace
  {
    /// How far @p one and @p other are apart beside the larger of them.
    class RelativeChange
    {
    public:
      void
      add(const dealii::Tensor<1, 3> &one, const dealii::Tensor<1, 3> &other)
      {
        largest = std::max({largest, one.norm(), other.norm()});
        change  = std::max(change, (one - other).norm());
      }

      /// At least @p least is what it is beside.
      double
      value(const double least = 0.) const
      {
        const double size = std::max(largest, least);
        return size > 0. ? change / size : 0.;
      }

      double largest = 0.;

    private:
      double change = 0.;
    };



    /// Throws NumericsError if active points of @p contact slip by more than
    /// their spacing, where the initial pairs are not valid. @p forces and @p
    /// slips are those of its constraints.
    void
    check_small_slip(const ContactInterface                &contact,
                     const dealii::ArrayView<const double> &forces,
                     const dealii::ArrayView<const dealii::Tensor<1, 3>> &slips)
    {
      for (unsigned int k = 0; k < contact.rows.size(); ++k)
        {
          const ContactInterface::Point &point = contact.points[k];
          if (forces[k] > 0. && slips[k].norm() > point.spacing)
            throw NumericsError(
              "contact.large-sliding: Contact " + contact.name + ": slip at " +
              to_text(point.first) + " is " + to_text(slips[k].norm(), 3) +
              ", " + to_text(slips[k].norm() / point.spacing, 2) +
              " times the distance between neighboring contact points, so "
              "small-sliding contact is not valid. Use Rotations = large, "
              "longer elements or smaller loads.");
        }
    }



    /// The largest force of supports and contacts.
    double
    largest_force(const Checks &checks)
    {
      double largest = 0.;
      for (const Resultant &reaction : checks.reactions)
        largest = std::max(largest, reaction.force.norm());
      for (const KktResidual &contact : checks.contacts)
        largest = std::max(largest, contact.force.norm());
      return largest;
    }



    /// What displacements of @p state and of @p before are compared with.
    double
    displacements_of(const State &state, const State &before)
    {
      // Loads that cancel move nothing but the last digits.
      constexpr double digits = 1e3;
      return std::max({state.u.linfty_norm(),
                       before.u.n_blocks() > 0 ? before.u.linfty_norm() : 0.,
                       digits * state.rounding()});
    }
  } // namespace



  double
  change_of(const SolvedStep &one,
            const SolvedStep &other,
            const State      &before,
            const double      before_force)
  {
    // Friction that bears less of the largest force, or dissipates less of the
    // strain energy, matters less.
    constexpr double worth_having = 0.01;
    RelativeChange   forces, shears;
    for (unsigned int s = 0; s < one.checks.reactions.size(); ++s)
      forces.add(one.checks.reactions[s].force,
                 other.checks.reactions[s].force);
    for (unsigned int c = 0; c < one.checks.contacts.size(); ++c)
      {
        forces.add(one.checks.contacts[c].force,
                   other.checks.contacts[c].force);
        shears.add(one.checks.contacts[c].shear,
                   other.checks.contacts[c].shear);
      }
    BlockVector u = one.state.u;
    u -= other.state.u;
    const double size        = displacements_of(one.state, before);
    const double lost_before = before.friction.all_dissipated();
    const double lost     = one.state.friction.all_dissipated() - lost_before,
                 by_other = other.state.friction.all_dissipated() - lost_before,
                 energy =
                   std::max({lost,
                             by_other,
                             worth_having * std::abs(one.checks.energy)});
    const double largest = std::max(forces.largest, before_force);
    return std::max({forces.value(largest),
                     shears.value(worth_having * largest),
                     size > 0. ? u.linfty_norm() / size : 0.,
                     energy > 0. ? std::abs(lost - by_other) / energy : 0.});
  }



  LoadStep::LoadStep(std::unique_ptr<NonlinearSolver>     solver,
                     const std::vector<ContactInterface> &contacts,
                     const Contacts                      &contact_objects,
                     const unsigned int                   n_supports,
                     const SolveParameters               &parameters,
                     TimerOutput                         &timer)
    : solver(std::move(solver))
    , contacts(contacts)
    , n_supports(n_supports)
    , parameters(parameters)
    , timer(timer)
  {
    if (this->solver->linear_system() != nullptr)
      for (const auto &contact : contact_objects)
        searches.emplace_back(contact->parameters(),
                              this->solver->of().bodies());
  }



  SolvedStep
  LoadStep::operator()(const State      &before,
                       const LoadFactor &from,
                       const LoadFactor &to,
                       const bool        last)
  {
    SolvedStep solved;
    solved.load_factor = to;
    {
      const bool is_contact =
        solver->linear_system() != nullptr && !contacts.empty();
      TimerOutput::Scope scope(timer,
                               name_of(is_contact ? Phase::contact :
                                                    Phase::solve));
      Equilibrium        end = solver->solve(to, before, from);
      solved.state           = std::move(end.state);
      solved.cuts            = end.cuts;
    }
    solved.checks = check(solved.state, to, last);
    return solved;
  }



  void
  LoadStep::check_pairs(const State &state, const LoadFactor &factor)
  {
    const GapConstraints &rows = solver->moving().rows();
    for (unsigned int k = 0; k < contacts.size(); ++k)
      {
        // The nearest line is found at any distance from the roller.
        if (contacts[k].discretization != Discretization::line_to_roller)
          searches[k].check(contacts[k],
                            state.u,
                            factor,
                            rows.local_rows_of(k, state.active));
        if (!state.friction.empty())
          check_small_slip(contacts[k],
                           rows.of_contact(k, state.force),
                           rows.of_contact(k, state.friction.before));
      }
  }



  // Equilibrium, energy and contact law, then what the kinematics neglect.
  Checks
  LoadStep::check(const State &state, const LoadFactor &factor, const bool last)
  {
    Checks              checks;
    LinearSystem *const system = solver->linear_system();
    {
      TimerOutput::Scope scope(timer, name_of(Phase::solve));
      const auto         tangent = solver->tangent_at(state);
      checks = check_state(*tangent, interfaces(), n_supports, state, factor);
      check_solution(state, checks, parameters.rotation_limit);
      if (system == nullptr)
        check_followed(*tangent, factor);
      else
        check_pairs(state, factor);
    }
    if (system == nullptr || !parameters.computes_estimates || !last)
      return checks;
    const Structure &structure = system->tangent().of();
    {
      TimerOutput::Scope scope(timer, name_of(Phase::beyond));
      checks.beyond = beyond_linear(structure, *system, state, checks.energies);
    }
    if (parameters.beyond_linear == OutOfRange::refuse)
      check_linear_range(checks.beyond, structure);
    return checks;
  }



  LoadPath::LoadPath(std::shared_ptr<LoadStep>      step,
                     const std::vector<LoadFactor> &factors,
                     const Substeps                &substeps,
                     const bool                     branches)
    : step(std::move(step))
    , factors(factors)
    , substeps(substeps)
    , branches(branches)
  {}



  void
  LoadPath::resume(const unsigned int n_done, State state)
  {
    AssertIndexRange(n_done - 1, factors.size());
    done = n_done;
    last = std::move(state);
    step->resume_from(last, factors[done - 1]);
    last_force = largest_force(step->check(last, factors[done - 1], false));
    store(factors[done - 1].of_scene(), done - 1, last);
  }



  SolvedStep
  LoadPath::solve_substeps(const State       &before,
                           const LoadFactor  &from,
                           const LoadFactor  &to,
                           const unsigned int n) const
  {
    const auto part = [&](const unsigned int k) {
      return k == 0 ? from : k == n ? to : to.after(from, 1. * k / n);
    };
    SolvedStep   solved;
    unsigned int iterations = 0, cuts = 0;
    MethodCounts solved_by{};
    for (unsigned int k = 1; k <= n; ++k)
      {
        solved =
          (*step)(k == 1 ? before : solved.state, part(k - 1), part(k), k == n);
        iterations += solved.state.iterations;
        cuts += solved.cuts;
        for (unsigned int m = 0; m < solved_by.size(); ++m)
          solved_by[m] += solved.state.solved_by[m];
      }
    solved.state.iterations = iterations;
    solved.state.solved_by  = solved_by;
    solved.cuts             = cuts;
    solved.substeps         = n;
    return solved;
  }



  SolvedStep
  LoadPath::solve_requested_substeps(const State      &before,
                                     const LoadFactor &from,
                                     const LoadFactor &to) const
  {
    if (substeps.number > 0)
      return solve_substeps(before, from, to, substeps.number);
    SolvedStep coarser = solve_substeps(before, from, to, 1);
    for (unsigned int n = 2;; n *= 2)
      {
        SolvedStep solved = solve_substeps(before, from, to, n);
        solved.change     = change_of(solved, coarser, before, last_force);
        if (change_measure)
          solved.change =
            std::max(*solved.change, change_measure(solved, coarser, before));
        if (n == Substeps::most || *solved.change <= substeps.tolerance)
          return solved;
        coarser = std::move(solved);
      }
  }



  SolvedStep
  LoadPath::advance()
  {
    const LoadFactor &to  = factors[done],
                     from = done == 0 ? to.without_loads() : factors[done - 1];
    SolvedStep solved     = substeps.each.empty() ?
                              solve_requested_substeps(last, from, to) :
                              solve_substeps(last, from, to, substeps.each[done]);
    last_force            = largest_force(solved.checks);
    last                  = solved.state;
    store(to.of_scene(), done, last);
    ++done;
    return solved;
  }



  LoadPath::StoredState
  LoadPath::nearest(const double factor) const
  {
    StoredState found;
    double      distance = std::numeric_limits<double>::infinity();
    for (const StoredState &one : stored)
      if (std::abs(one.factor - factor) <= distance)
        {
          found    = one;
          distance = std::abs(one.factor - factor);
        }
    return found;
  }



  LoadPath::StoredState
  LoadPath::end_of(const unsigned int load_step)
  {
    const auto found =
      std::find_if(stored.begin(), stored.end(), [&](const StoredState &one) {
        return one.load_step == load_step &&
               one.factor == factors[load_step].of_scene();
      });
    if (found != stored.end())
      return *found;
    LoadPath again(step, factors, substeps);
    again.watch(change_measure);
    while (again.done <= load_step)
      again.advance();
    StoredState end{factors[load_step].of_scene(), load_step, again.last};
    store(end.factor, load_step, end.state);
    return end;
  }



  LoadPath::StoredState
  LoadPath::nearest_passed(const double factor, const unsigned int load_step)
  {
    StoredState  found = load_step == 0 ? StoredState() : end_of(load_step - 1);
    const double start = found.factor;
    for (const StoredState &one : stored)
      {
        // Of the way to here, where one and found are.
        const double share = (one.factor - start) / (factor - start);
        if (one.load_step == load_step && share > 0. && share < 1. &&
            share > (found.factor - start) / (factor - start))
          found = one;
      }
    return found;
  }



  SolvedStep
  LoadPath::branch(const double factor, const unsigned int load_step)
  {
    const StoredState from = last.friction.empty() ?
                               nearest(factor) :
                               nearest_passed(factor, load_step);
    SolvedStep        solved =
      solve_requested_substeps(from.state,
                               factors[0].of_scene_alone(from.factor),
                               factors[0].of_scene_alone(factor));
    store(factor, load_step, solved.state);
    return solved;
  }



  void
  LoadPath::store(const double       factor,
                  const unsigned int load_step,
                  const State       &state)
  {
    const auto is_here = [&](const StoredState &known) {
      return known.factor == factor && known.load_step == load_step;
    };
    if (branches && std::none_of(stored.begin(), stored.end(), is_here))
      stored.push_back({factor, load_step, state});
  }
} // namespace lamella
