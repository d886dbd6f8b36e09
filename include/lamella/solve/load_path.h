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
  /// Result of a load step: the state at its end, with its checks.
  struct SolvedStep
  {
    /// Load factor t, which multiplies loads and prescribed displacements.
    LoadFactor load_factor;
    State      state;
    Checks     checks;
    /// Number of substeps; if automatic, with the last change_of() results.
    unsigned int          substeps = 1;
    std::optional<double> change   = {};
    /// Number of bisections in this load step.
    unsigned int cuts = 0;
  };

  /// Returns the distance between @p one and @p other, two solutions at the
  /// same load factor that start from @p before: the largest relative
  /// difference of support and contact forces, friction forces alone,
  /// displacements, and dissipated energy. Each is relative to the largest
  /// value of its kind, friction to at least a hundredth of the largest force
  /// or of the strain energy. Reference values include the largest force
  /// @p before_force and displacement of @p before, for steps that unload.
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

    /// Solves from the state @p before (empty if none), at the load factor
    /// @p from, to the load factor @p to. Throws NumericsError if no reliable
    /// solution is found. Only the @p last substep is checked for large
    /// deflections.
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

    /// Continues from the given state at a load factor of another run. This
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
  /// of the previous one. Branches are additional solutions at other load
  /// factors, within a step or beyond the last; the sequence ignores them.
  class LoadPath
  {
  public:
    /// Additional distance between two solutions, used with change_of().
    using ChangeMeasure = std::function<double(const SolvedStep &one,
                                               const SolvedStep &other,
                                               const State      &before)>;

    /// Starts unloaded. Each of the load @p factors is reached in @p substeps.
    /// If @p branches, states are stored, from which branches start.
    LoadPath(std::shared_ptr<Step>          step,
             const std::vector<LoadFactor> &factors,
             const Substeps                &substeps = {},
             const bool                     branches = false);

    /// Adds @p more as a criterion for the number of automatic substeps.
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

    /// Returns and stores the state at the load factor @p factor within load
    /// step @p load_step, or beyond the last step. Starts from the nearest
    /// stored state, or with friction from the nearest one that precedes it on
    /// the load path, with as many substeps as a load step. States missing
    /// after a resume are solved for again.
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

    /// Stores @p state for branches, if enabled and the first at its factor.
    void
    store(const double       factor,
          const unsigned int load_step,
          const State       &state);
    /// Returns the stored state nearest to @p factor; of two, the later stored.
    StoredState
    nearest(const double factor) const;
    /// Returns the nearest stored state that step @p load_step has passed.
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
