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
  /// What a load step came to: a state that may be trusted, and what was
  /// checked of it.
  struct SolvedStep
  {
    /// t: what multiplies loads and prescribed displacements.
    LoadFactor load_factor;
    State      state;
    Checks     checks;
    /// In how many parts it was done, and where these were sought by how much
    /// the last doubling changed it (change_of()).
    unsigned int          substeps = 1;
    std::optional<double> change   = {};
    /// How often it was halved on the way.
    unsigned int cuts = 0;
  };

  /**
   * How far @p one is from @p other, two ways from @p before to the same load
   * factor: the largest of what forces of supports and contacts, the forces
   * of friction among them alone, displacements, and the energy dissipated on
   * the way differ by, each over the largest of its kind; friction over a
   * hundredth of the largest force or the strain energy, if that is more.
   * Forces and displacements of @p before, whose largest are @p before_force
   * and its own, count among the largest: after unloading there is nothing.
   */
  double
  change_of(const SolvedStep &one,
            const SolvedStep &other,
            const State      &before,
            const double      before_force = 0.);

  /// A load step of a scene: from a state to the state at a load factor, and
  /// the checks of that. Which kinematics it has nobody need know. Collective.
  class Step
  {
  public:
    virtual ~Step() = default;

    /// From @p before, empty where there is none, which is that of the factors
    /// @p from, to @p to. Throws NumericsError for what cannot be solved or is
    /// not to be trusted. One that is not the @p last of its load step is not
    /// held against large deflections.
    virtual SolvedStep
    operator()(const State      &before,
               const LoadFactor &from,
               const LoadFactor &to,
               const bool        last = true) = 0;

    /// The checks of @p state, which is one at @p factor. Throws as above.
    virtual Checks
    check(const State      &state,
          const LoadFactor &factor,
          const bool        last = true) = 0;

    /// Goes on from @p last, a state at @p factor that another run has come
    /// to. Of linear kinematics there is nothing to do.
    virtual void
    go_on_from(const State &, const LoadFactor &)
    {}
  };

  /**
   * The step of linear kinematics:
   *   1. The linear solution without contact (ContactSolver::solve_free()),
   *   2. contact on top of it, from the active rows of the state before, and
   *      the release of stabilising springs,
   *   3. checks, which throw if the state is not to be trusted, or if a
   *      contact's search distance was too short.
   * Without friction the state before decides on rounds and not on the result.
   *
   * Refers to all that it is made of, `timer` too, which counts the seconds of
   * each Phase.
   */
  class LinearStep : public Step
  {
  public:
    /// With all @p contacts of the scene and the lives of each: paired once,
    /// since kinematics is linear, they tell whether the search distance was
    /// enough. @p n_supports are those of the scene.
    LinearStep(ContactSolver                       &solver,
               const std::vector<ContactInterface> &contacts,
               const Contacts                      &lives,
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
    const Contacts                      &lives;
    const GapRows                        rows;
    const unsigned int                   n_supports;
    const SolveParameters               &parameters;
    dealii::TimerOutput                 &timer;
  };

  /**
   * The load factors that a scene goes through, up and down, and how far it has
   * come: each step starts from the state of the one before. Beside the path
   * branches end at other factors, on the way of a step or beyond the last;
   * they start from a state that is stored and leave the path where it is.
   */
  class LoadPath
  {
  public:
    /// How far one end of a load step is from another, beside change_of(), with
    /// the state before it: what the user asks for, say.
    using Watch = std::function<double(const SolvedStep &one,
                                       const SolvedStep &other,
                                       const State      &before)>;

    /// From no state at all through @p factors, the way to each in
    /// @p substeps. @p branches says whether states are to be stored for some.
    LoadPath(std::shared_ptr<Step>          step,
             const std::vector<LoadFactor> &factors,
             const Substeps                &substeps = {},
             const bool                     branches = false);

    /// Substeps that are sought have to settle @p more, too.
    void
    watch(Watch more)
    {
      watches = std::move(more);
    }

    /// Goes on after the first @p n_done steps, of which the last, at least
    /// one, came to @p last. What another run checked is not kept with its
    /// state: checks are made again.
    void
    resume(const unsigned int n_done, State last);

    /// The steps that are done.
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
    /// That of the next step.
    const LoadFactor &
    next_factor() const
    {
      return factors[done];
    }
    /// That of the last step that is done; empty before the first.
    const State &
    state() const
    {
      return last;
    }

    /// Does the next step. Where it throws (Step) the path stays where it was.
    SolvedStep
    advance();

    /// The state at @p factor on the way of step @p leg, of that after the last
    /// one on the way on; is stored. It starts from the stored state nearest to
    /// it, and where bodies rub from the nearest one that the way has passed,
    /// in as many parts as a step. What of these is not stored, since the path
    /// has been resumed behind it, is solved for again.
    SolvedStep
    branch(const double factor, const unsigned int leg);

    /// The checks of the last step that is done, once more.
    Checks
    check_again() const
    {
      return step->check(last, factors[done - 1]);
    }

  private:
    /// From @p before, at @p from, to @p to in @p n parts.
    SolvedStep
    in_parts(const State       &before,
             const LoadFactor  &from,
             const LoadFactor  &to,
             const unsigned int n) const;
    /// The same in as many parts as the scene wants.
    SolvedStep
    as_wanted(const State      &before,
              const LoadFactor &from,
              const LoadFactor &to) const;

    /// A state that branches start from: at a factor, the first one on the way
    /// of a step.
    struct Stored
    {
      double       factor = 0.;
      unsigned int leg    = 0;
      State        state;
    };

    /// Where branches are, keeps @p state; of one factor on a way the first.
    void
    store(const double factor, const unsigned int leg, const State &state);
    /// The one nearest to @p factor; of two that are as near the newer one,
    /// whose rows are known.
    Stored
    nearest(const double factor) const;
    /// The one nearest to @p factor of those that the way of step @p leg has
    /// passed there.
    Stored
    passed(const double factor, const unsigned int leg);
    /// The end of step @p leg.
    Stored
    end_of(const unsigned int leg);

    const std::shared_ptr<Step>   step;
    const std::vector<LoadFactor> factors;
    const Substeps                substeps;
    const bool                    branches;
    Watch                         watches;
    unsigned int                  done = 0;
    State                         last;
    /// The largest of supports and contacts there.
    double last_force = 0.;

    std::vector<Stored> stored;
  };
} // namespace lamella

#endif
