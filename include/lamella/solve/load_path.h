// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_load_path_h
#define lamella_solve_load_path_h

#include <lamella/contact/contact.h>
#include <lamella/solve/checks.h>
#include <lamella/solve/contact_solver.h>
#include <lamella/solve/parameters.h>

#include <deal.II/base/timer.h>

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace lamella
{
  /// Result of a load step: a checked state.
  struct SolvedStep
  {
    /// Load factor t, which multiplies loads and prescribed displacements.
    LoadFactor load_factor;
    State      state;
    Checks     checks;
    /// Number of substeps; automatic ones with the last change (change_of()).
    unsigned int          substeps = 1;
    std::optional<double> change   = {};
    /// Number of bisections on the way.
    unsigned int cuts = 0;
  };

  /**
   * Returns the distance of @p one from @p other, two solutions from @p before
   * to the same load factor: the largest relative difference of the forces of
   * supports and contacts, the friction forces alone, the displacements, and
   * the dissipated energy. Each is relative to the largest of its kind,
   * friction to at least a hundredth of the largest force or of the strain
   * energy. The largest force @p before_force and displacement of @p before
   * count too, as after unloading little is left.
   */
  double
  change_of(const SolvedStep &one,
            const SolvedStep &other,
            const State      &before,
            const double      before_force = 0.);

  /// Interface of a load step, from a state to the checked state at a load
  /// factor, independent of the kinematics. Collective.
  class Step
  {
  public:
    virtual ~Step() = default;

    /// Solves from @p before (empty if none), at the factors @p from, to @p to.
    /// Throws NumericsError without a reliable solution. Only the @p last
    /// substep of a load step is checked for large deflections.
    virtual SolvedStep
    operator()(const State      &before,
               const LoadFactor &from,
               const LoadFactor &to,
               const bool        last = true) = 0;

    /// Returns the checks of @p state at @p factor. Throws as operator() does.
    virtual Checks
    check(const State      &state,
          const LoadFactor &factor,
          const bool        last = true) = 0;

    /// Continues from @p last, a state at @p factor from another run.
    virtual void
    resume_from(const State &, const LoadFactor &)
    {}
  };

  /**
   * Load step of linear kinematics:
   *   1. the linear solution without contact (ContactSolver::solve_free()),
   *   2. the solution with contact, starting from the previous active set, and
   *      the release of stabilizing springs,
   *   3. checks, which throw if the state is not reliable, or if the search
   *      distance of a contact was too short.
   * Without friction the previous state affects the number of rounds only.
   * Refers to all constructor arguments; `timer` counts seconds by Phase.
   */
  class LinearStep : public Step
  {
  public:
    /// Creates a step with all @p contacts and @p n_supports supports of the
    /// scene. @p contact_objects, paired once, check the search distances.
    LinearStep(ContactSolver                       &solver,
               const std::vector<ContactInterface> &contacts,
               const Contacts                      &contact_objects,
               const unsigned int                   n_supports,
               const SolveParameters               &parameters,
               dealii::TimerOutput                 &timer);

    SolvedStep
    operator()(const State      &before,
               const LoadFactor &from,
               const LoadFactor &to,
               const bool        last = true) override;

    Checks
    check(const State      &state,
          const LoadFactor &factor,
          const bool        last = true) override;

  private:
    ContactSolver                       &solver;
    const Structure                     &structure;
    const std::vector<ContactInterface> &contacts;
    const Contacts                      &contact_objects;
    const GapConstraints                 rows;
    const unsigned int                   n_supports;
    const SolveParameters               &parameters;
    dealii::TimerOutput                 &timer;
  };

  /// Sequence of the load factors of a scene, and the progress along it. Each
  /// step starts from the previous state. Branches end at other factors, within
  /// a step or beyond the last one; they do not affect the path.
  class LoadPath
  {
  public:
    /// Additional distance between two results, beside change_of().
    using ChangeMeasure = std::function<double(const SolvedStep &one,
                                               const SolvedStep &other,
                                               const State      &before)>;

    /// Starts unloaded with the load @p factors, each reached in @p substeps.
    /// @p branches enables the storage of states for branches.
    LoadPath(std::shared_ptr<Step>          step,
             const std::vector<LoadFactor> &factors,
             const Substeps                &substeps = {},
             const bool                     branches = false);

    /// Adds @p more as a criterion for automatic substeps.
    void
    watch(ChangeMeasure more)
    {
      change_measure = std::move(more);
    }

    /// Resumes after the first @p n_done >= 1 steps, the last of which gave @p
    /// last.
    void
    resume(const unsigned int n_done, State last);

    /// Returns the number of completed steps.
    unsigned int
    n_done() const
    {
      return done;
    }
    bool
    has_more() const
    {
      return done < factors.size();
    }
    /// Returns the load factor of the next step.
    const LoadFactor &
    next_factor() const
    {
      return factors[done];
    }
    /// Returns the state of the last completed step; empty before the first.
    const State &
    state() const
    {
      return last;
    }

    /// Performs the next step. If it throws (Step), the path is unchanged.
    SolvedStep
    advance();

    /// Returns and stores the state at @p factor on the way of step @p
    /// load_step, or beyond the last step. Starts from the nearest stored
    /// state, or with friction from the nearest one already passed, with as
    /// many substeps as a step. States missing after a resume are solved for
    /// again.
    SolvedStep
    branch(const double factor, const unsigned int load_step);

    /// Returns the checks of the last completed step, evaluated again.
    Checks
    check_again() const
    {
      return step->check(last, factors[done - 1]);
    }

  private:
    /// Solves from @p before, at @p from, to @p to in @p n substeps.
    SolvedStep
    solve_substeps(const State       &before,
                   const LoadFactor  &from,
                   const LoadFactor  &to,
                   const unsigned int n) const;
    /// Solves from @p before, at @p from, to @p to in the requested substeps.
    SolvedStep
    solve_requested_substeps(const State      &before,
                             const LoadFactor &from,
                             const LoadFactor &to) const;

    /// Stored state from which branches start: its factor and first step.
    struct StoredState
    {
      double       factor    = 0.;
      unsigned int load_step = 0;
      State        state;
    };

    /// Stores @p state if branches are enabled and it is the first.
    void
    store(const double       factor,
          const unsigned int load_step,
          const State       &state);
    /// Returns the stored state nearest to @p factor, the newer of two.
    StoredState
    nearest(const double factor) const;
    /// Returns the nearest stored state that step @p load_step has passed.
    StoredState
    nearest_passed(const double factor, const unsigned int load_step);
    /// Returns the state at the end of step @p load_step.
    StoredState
    end_of(const unsigned int load_step);

    const std::shared_ptr<Step>   step;
    const std::vector<LoadFactor> factors;
    const Substeps                substeps;
    const bool                    branches;
    ChangeMeasure                 change_measure;
    unsigned int                  done = 0;
    State                         last;
    /// Largest force of supports and contacts in the last state.
    double last_force = 0.;

    std::vector<StoredState> stored;
  };
} // namespace lamella

#endif
