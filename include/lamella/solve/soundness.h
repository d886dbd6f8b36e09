// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_soundness_h
#define lamella_solve_soundness_h

#include <lamella/solve/checks.h>
#include <lamella/solve/linearisation.h>

#include <string>
#include <vector>

namespace lamella
{
  /**
   * Throws NumericsError if the state is not to be trusted, looked at in this
   * order: stabilising springs that hold more than a tenth of the energy, last
   * corrections above 1e-6 of the displacements, balance of forces or moments,
   * residual or balance of energy above 1e-3, a contact force below zero or
   * gaps off the contact law by more than 1e-6 of the displacements, numbers
   * that are none, or a rotation above @p rotation_limit (rad). A check that is
   * not a number counts as failed.
   */
  void
  require_sound(const State  &state,
                const Checks &checks,
                const double  rotation_limit);

  /**
   * Throws NumericsError where a support of sections that turn, at load factor
   * @p at and the state of @p here, is off its place: others hold the same
   * places, and they agree with it to first order only. (Where sections warp,
   * rows that depend on others are off to second order: ten times what turning
   * the warpings does to their displacements is let pass.)
   */
  void
  require_followed(const Linearisation &here, const LoadFactor &at);

  /**
   * What the user should know of a state that is sound, a sentence each without
   * a full stop: penetrations above 1e-3 of the displacements, gaps whose
   * averages miss more than 1e-2 of them, bodies that overlap from the start;
   * rotations beyond 0.1 rad, stabilising springs with more than 1e-3 of the
   * energy, balances that hold to worse than 1e-7, and digits that the
   * assembled matrix lost (a first correction above 1e-7). @p contacts are
   * those of check_state().
   */
  std::vector<std::string>
  warnings_of(const State                         &state,
              const Checks                        &checks,
              const std::vector<ContactInterface> &contacts);
} // namespace lamella

#endif
