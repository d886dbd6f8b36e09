// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_find_modes_h
#define lamella_run_find_modes_h

#include <lamella/recover/results.h>
#include <lamella/run/built_scene.h>
#include <lamella/solve/linear_system.h>

namespace lamella
{
  /// Computes the natural and buckling modes and the harmonic response that the
  /// scene of @p built requests about @p state, the last load step of @p
  /// results, and sets them there. @p system has solved it, and is null for
  /// finite rotations. With linear kinematics, natural modes include the
  /// stresses of the state unless it is beyond the linear range (a note).
  /// Throws InputError for buckling modes without stresses or with finite
  /// rotations, and as natural_modes(), buckling_modes() and HarmonicResponse.
  /// Collective.
  void
  find_modes(const BuiltScene &built,
             LinearSystem     *system,
             const State      &state,
             Results          &results);
} // namespace lamella

#endif
