// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_large_step_h
#define lamella_solve_large_step_h

#include <lamella/solve/load_path.h>
#include <lamella/solve/newton.h>

namespace lamella
{
  /**
   * A load step of bodies that turn by any angle: Newton's method from the
   * state before, with contacts that move along, and checks of what it came to
   * at the places where bodies are now. Where a whole step cannot be had it is
   * done in parts that nobody sees.
   */
  class LargeStep : public Step
  {
  public:
    /// Refers to all that it is made of. Iterations are told to @p progress,
    /// factorisations to @p monitor. @p n_supports are those of the scene.
    LargeStep(const Structure                  &structure,
              const MovingContacts             &contacts,
              const unsigned int                n_supports,
              const SolveParameters            &parameters,
              const Newton::Progress           &progress,
              const Linearisation::BodyMonitor &monitor,
              dealii::TimerOutput              &timer);

    SolvedStep
    operator()(const State      &before,
               const LoadFactor &from,
               const LoadFactor &to,
               const bool        last = true) override;

    Checks
    check(const State      &state,
          const LoadFactor &factor,
          const bool        last = true) override;

    void
    go_on_from(const State &last, const LoadFactor &factor) override;

  private:
    /// Where the path from @p before, at @p from, to @p to begins.
    Equilibrium
    start_at(const State &before, const LoadFactor &from, const LoadFactor &to);

    const Structure &structure;
    Newton           newton;
    /// The displacements of the last state, which the rows are of.
    BlockVector            reached;
    const unsigned int     n_supports;
    const SolveParameters &parameters;
    dealii::TimerOutput   &timer;
  };
} // namespace lamella

#endif
