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
  /// Result of a load step: the state at its end, and checks of this state.
  struct SolvedStep
  {
    /// Load factor t, which multiplies loads and prescribed displacements.
    LoadFactor load_factor;
    State      state;
    Checks     checks;
    /// Number of substeps; if automatic, `change` is the distance change_of()
    /// from the solution with half as many.
    unsigned int          substeps = 1;
    std::optional<double> change   = {};
    /// Number of bisections in this load step.
    unsigned int cuts = 0;
  };

  /// Returns the relative difference of @p one and @p other, two solutions at
  /// the same load factor that start from @p before: the largest difference in
  /// - forces of supports and contacts, over the largest of these forces,
  /// - friction forces, over their largest, at least 1 % of the largest force,
  /// - displacements, over the largest displacement,
  /// - dissipated energy, over its value, at least 1 % of the strain energy.
  /// The largest force @p before_force and displacement of @p before count as
  /// references, for steps that unload.
  double
  change_of(const SolvedStep &one,
            const SolvedStep &other,
            const State      &before,
            const double      before_force = 0.);

  /// Interface of the solution of one load step, from a state to a checked
  /// state at another load factor, independent of the kinematics. Collective.
  class Step
  {
  public:
    virtual ~Step() = default;

    /// Returns the solution at load factor @p to, starting from the state
    /// @p before at load factor @p from (empty if unloaded). Throws
    /// NumericsError if no reliable solution is found. Large deflections are
    /// checked only if this is the @p last substep.
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

    /// Continues from a state of an interrupted run at its load factor. This
    /// default implementation does nothing.
    virtual void
    resume_from(const State &, const LoadFactor &)
    {}
  };

  /// Load step of linear kinematics:
  ///   1. the linear solution without contact (ContactSolver::solve_free()),
  ///   2. the solution with contact, starting from the previous active set, and
  ///      the release of stabilizing springs,
  ///   3. checks, which throw if the state is not reliable, or if the search
  ///      distance of a contact was too short.
  /// Without friction, the previous state affects the number of rounds only.
  /// Keeps references to all arguments; `timer` measures each Phase.
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

  /// Sequence of the load steps of a scene, each of which starts from the state
  /// of the previous one. branch() returns additional solutions at other load
  /// factors, which do not affect the load steps.
  class LoadPath
  {
  public:
    /// Additional distance between two solutions, used with change_of().
    using ChangeMeasure = std::function<double(const SolvedStep &one,
                                               const SolvedStep &other,
                                               const State      &before)>;

    /// Creates the path from the unloaded state through the load @p factors,
    /// each in @p substeps. If @p branches, states are stored for branch().
    LoadPath(std::shared_ptr<Step>          step,
             const std::vector<LoadFactor> &factors,
             const Substeps                &substeps = {},
             const bool                     branches = false);

    /// Sets an additional distance @p more that automatic substeps reduce.
    void
    watch(ChangeMeasure more)
    {
      change_measure = std::move(more);
    }

    /// Resumes after the first @p n_done >= 1 steps with @p last, the state at
    /// the end of the last of these steps.
    void
    resume(const unsigned int n_done, State last);

    /// Returns the number of completed load steps.
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
    /// Returns the load factor of the next load step.
    const LoadFactor &
    next_factor() const
    {
      return factors[done];
    }
    /// Returns the state of the last completed step; initially empty.
    const State &
    state() const
    {
      return last;
    }

    /// Performs the next load step. If Step throws, this object is unchanged.
    SolvedStep
    advance();

    /// Returns and stores the solution at load factor @p factor within load
    /// step @p load_step, or beyond the last step. Starts from the stored state
    /// with the nearest load factor; with friction, from the nearest one
    /// earlier on the load path. States missing after resume() are recomputed.
    SolvedStep
    branch(const double factor, const unsigned int load_step);

    /// Returns the checks of the last completed load step, evaluated again.
    Checks
    check_again() const
    {
      return step->check(last, factors[done - 1]);
    }

  private:
    /// Solves from @p before, at load @p from, to @p to in @p n substeps.
    SolvedStep
    solve_substeps(const State       &before,
                   const LoadFactor  &from,
                   const LoadFactor  &to,
                   const unsigned int n) const;
    /// Solves from @p before, at load factor @p from, to @p to in the number of
    /// substeps of the scene, fixed or automatic.
    SolvedStep
    solve_requested_substeps(const State      &before,
                             const LoadFactor &from,
                             const LoadFactor &to) const;

    /// Stored state from which branches start, with its factor and load step.
    struct StoredState
    {
      double       factor    = 0.;
      unsigned int load_step = 0;
      State        state;
    };

    /// Stores @p state for branch(), if enabled and new at its load factor.
    void
    store(const double       factor,
          const unsigned int load_step,
          const State       &state);
    /// Returns the stored state whose load factor is nearest to @p factor; of
    /// two equally near, the later one.
    StoredState
    nearest(const double factor) const;
    /// Returns the nearest stored state before @p factor in step @p load_step.
    StoredState
    nearest_passed(const double factor, const unsigned int load_step);
    /// Returns the state at the end of load step @p load_step.
    StoredState
    end_of(const unsigned int load_step);

    const std::shared_ptr<Step>   step;
    const std::vector<LoadFactor> factors;
    const Substeps                substeps;
    const bool                    branches;
    ChangeMeasure                 change_measure;
    unsigned int                  done = 0;
    State                         last;
    /// Largest force of supports and contacts in the state `last`.
    double last_force = 0.;

    std::vector<StoredState> stored;
  };
} // namespace lamella

#endif
