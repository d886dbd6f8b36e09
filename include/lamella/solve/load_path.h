// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_load_path_h
#define lamella_solve_load_path_h

#include <lamella/contact/contact.h>
#include <lamella/contact/search_check.h>
#include <lamella/solve/checks.h>
#include <lamella/solve/nonlinear_solver.h>
#include <lamella/solve/parameters.h>

#include <deal.II/base/timer.h>

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace lamella
{
  /// Result of a load step: the state at its end, and checks of this state.
  struct SolvedStep
  {
    /// Load factor t, which multiplies loads and prescribed displacements.
    LoadFactor   load_factor;
    State        state;  ///< Equilibrium state at the end of the load step.
    Checks       checks; ///< Residuals, balances and resultants of `state`.
    unsigned int substeps = 1; ///< Number of equal substeps of the load step.
    /// Relative change from the solution with half as many substeps (see
    /// change_of()); empty if the number of substeps is fixed.
    std::optional<double> change = {};
    /// Number of bisections of substeps that did not converge.
    unsigned int cuts = 0;
  };

  /// Returns the relative difference of two solutions at the same load factor
  /// that start from the state @p before: the largest difference in
  /// - forces of supports and contacts, over the largest of these forces,
  /// - friction forces, over the largest, at least 1 % of the largest force,
  /// - displacements, over the largest displacement,
  /// - dissipated energy, over its value, at least 1 % of the strain energy.
  /// Divisors are at least @p before_force, or the displacement of @p before.
  double
  change_of(const SolvedStep &one,
            const SolvedStep &other,
            const State      &before,
            const double      before_force = 0.);

  /// Solution of one load step: from an equilibrium state to a checked
  /// equilibrium state at another load factor,
  ///   1. the solution by NonlinearSolver,
  ///   2. checks, which throw if the state is not reliable or, with constant
  ///      contact constraints, if the search distance of a contact was too
  ///      short.
  /// Without friction, the previous state affects the number of iterations
  /// only. Keeps references to all arguments but the solver; `timer` measures
  /// each Phase. Collective.
  class LoadStep
  {
  public:
    /// Creates the load step of a scene with @p n_supports supports. @p
    /// contacts are the initial constraints of its contacts @p contact_objects.
    LoadStep(std::unique_ptr<NonlinearSolver>     solver,
             const std::vector<ContactInterface> &contacts,
             const Contacts                      &contact_objects,
             const unsigned int                   n_supports,
             const SolveParameters               &parameters,
             dealii::TimerOutput                 &timer);

    /// Returns the solution at load factor @p to, starting from the state
    /// @p before at load factor @p from (empty if unloaded). Throws
    /// NumericsError if no reliable solution is found. The neglected
    /// effects of large deflections are estimated in the @p last substep only.
    SolvedStep
    operator()(const State      &before,
               const LoadFactor &from,
               const LoadFactor &to,
               const bool        last = true);

    /// Returns the checks of @p state at load factor @p factor. Throws
    /// NumericsError if the state is not reliable. Effects of large deflections
    /// are estimated if the structure is linear and @p last is true.
    Checks
    check(const State &state, const LoadFactor &factor, const bool last = true);

    /// Returns the constraints of the contacts; with finite rotations, those of
    /// the last solution.
    const std::vector<ContactInterface> &
    interfaces() const
    {
      return solver->linear_system() != nullptr ? contacts :
                                                  solver->moving().interfaces();
    }

    /// Continues an interrupted run from the state @p last at @p factor.
    void
    resume_from(const State &last, const LoadFactor &factor)
    {
      solver->restore(last, factor);
    }

  private:
    /// Throws if the constant constraints of the contacts are not valid for @p
    /// state at load factor @p factor.
    void
    check_pairs(const State &state, const LoadFactor &factor);

    const std::unique_ptr<NonlinearSolver> solver;
    const std::vector<ContactInterface>   &contacts;
    std::vector<SearchCheck>               searches;
    const unsigned int                     n_supports;
    const SolveParameters                 &parameters;
    dealii::TimerOutput                   &timer;
  };

  /// Sequence of the load steps of a scene. Each step starts from the state of
  /// the previous one. branch() returns additional solutions.
  class LoadPath
  {
  public:
    /// Relative difference of two solutions at one load factor that start from
    /// `before`; used in addition to change_of().
    using ChangeMeasure = std::function<double(const SolvedStep &one,
                                               const SolvedStep &other,
                                               const State      &before)>;

    /// Creates the path from the unloaded state through the load @p factors,
    /// each in @p substeps. If @p branches is true, branch() may be called.
    LoadPath(std::shared_ptr<LoadStep>      step,
             const std::vector<LoadFactor> &factors,
             const Substeps                &substeps = {},
             const bool                     branches = false);

    /// Sets @p more, an additional measure of the change between solutions,
    /// which automatic substeps reduce to their tolerance.
    void
    watch(ChangeMeasure more)
    {
      change_measure = std::move(more);
    }

    /// Continues an interrupted run after its first @p n_done >= 1 load steps,
    /// at whose end the state is @p state.
    void
    resume(const unsigned int n_done, State state);

    /// Returns the number of completed load steps.
    unsigned int
    n_done() const
    {
      return done;
    }
    /// Returns true if load steps remain.
    bool
    has_more() const
    {
      return done < factors.size();
    }
    /// Returns the load factor of the next load step.
    const LoadFactor &
    next_factor() const
    {
      return factors[done];
    }
    /// Returns the state after the last completed load step; initially empty.
    const State &
    state() const
    {
      return last;
    }

    /// Performs the next load step. If LoadStep throws, this object is
    /// unchanged.
    SolvedStep
    advance();

    /// Returns and stores the solution at load factor @p factor within load
    /// step @p load_step, or beyond the last step. Starts from the stored state
    /// with the nearest load factor; with friction, from the nearest one
    /// earlier on the path. Recomputes states that are missing after resume().
    SolvedStep
    branch(const double factor, const unsigned int load_step);

    /// Returns LoadStep::interfaces().
    const std::vector<ContactInterface> &
    interfaces() const
    {
      return step->interfaces();
    }

    /// Returns the checks of the last completed load step, evaluated again.
    Checks
    check_again() const
    {
      return step->check(last, factors[done - 1]);
    }

  private:
    /// Solves from the state @p before at load factor @p from to the load
    /// factor @p to in @p n equal substeps.
    SolvedStep
    solve_substeps(const State       &before,
                   const LoadFactor  &from,
                   const LoadFactor  &to,
                   const unsigned int n) const;
    /// Solves from the state @p before at load factor @p from to load factor @p
    /// to in the number of substeps of the scene, fixed or automatic.
    SolvedStep
    solve_requested_substeps(const State      &before,
                             const LoadFactor &from,
                             const LoadFactor &to) const;

    /// Start of a branch: state, load factor and index of the load step.
    struct StoredState
    {
      double       factor    = 0.;
      unsigned int load_step = 0;
      State        state;
    };

    /// Stores @p state for branch(), if branches are enabled and it is new.
    void
    store(const double       factor,
          const unsigned int load_step,
          const State       &state);
    /// Returns the stored state with the load factor nearest to @p factor.
    StoredState
    nearest(const double factor) const;
    /// Returns the nearest stored state before @p factor in step @p load_step.
    StoredState
    nearest_passed(const double factor, const unsigned int load_step);
    /// Returns the state at the end of load step @p load_step.
    StoredState
    end_of(const unsigned int load_step);

    const std::shared_ptr<LoadStep> step;
    const std::vector<LoadFactor>   factors;
    const Substeps                  substeps;
    const bool                      branches;
    ChangeMeasure                   change_measure;
    unsigned int                    done = 0;
    State                           last;
    /// Largest force of supports and contacts in the state `last`.
    double last_force = 0.;

    std::vector<StoredState> stored;
  };
} // namespace lamella

#endif
