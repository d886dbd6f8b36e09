// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_modes_h
#define lamella_solve_modes_h

#include <lamella/body/fields.h>
#include <lamella/solve/linear_system.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lamella
{
  class GeometricStiffness;
  struct VibrationEquations;

  /// A mode of vibration or buckling.
  struct Mode
  {
    /// Number from 1, by ascending value, without rigid motions.
    unsigned int number = 0;
    /// Natural frequency [Hz], or buckling factor of the loads.
    double value = 0.;
    /// Mode shape, all DoFs. The modal mass v . M v of a mode of vibration is
    /// 1; of a buckling mode, the largest DoF is 1.
    BlockVector  shape;
    unsigned int body = 0; ///< Body with the largest part of the energy.
    BodyMotion   motion;   ///< Motion of this body.
    /// Participation factors v . M r of rigid motions r of all bodies along
    /// the scene axes and about axes through the center of mass; their squares
    /// are effective masses and moments of inertia.
    std::array<double, 6> participation{};

    /// Returns the modal assurance criterion (a . b)^2 / (a . a) (b . b) of the
    /// momenta a, b of two modes, perhaps of different meshes and theories; 0
    /// if different bodies move most. (Allemang and Brown, IMAC 1982.)
    double
    similarity(const Mode &other) const;

    /// Returns the name of the motion with the largest share.
    std::string
    kind() const;
  };

  /// Natural modes of a structure about an equilibrium state.
  struct NaturalModes
  {
    unsigned int      n_rigid = 0; ///< Number of rigid motions, of 0 Hz.
    std::vector<Mode> modes;       ///< Elastic modes, frequencies ascending.
  };

  /// Request of natural modes: the lowest ones, or all in a range.
  struct ModeRequest
  {
    unsigned int number = 10; ///< Number of elastic modes.
    /// Range of frequencies [Hz] in place of a number.
    std::optional<std::pair<double, double>> range = {};
    /// True if modes include the stresses of the state, in its linear range.
    bool has_stresses = true;
    /// True if a model with too few DoFs returns fewer modes.
    bool is_limit = false;
  };

  /// Returns the modes v with (K + K_G) v = (2 pi f)^2 M v of @p equations,
  /// with closed contacts as equations (SmallMotions). Participation factors
  /// refer to rotations about @p center, the center of mass. K_G is that of
  /// linear kinematics; tangents of finite rotations contain it. Throws
  /// InputError, which names the entry Modes, if the model has too few DoFs or
  /// no mode is in the range, and NumericsError if the state is not stable.
  /// Collective.
  NaturalModes
  natural_modes(const VibrationEquations &equations,
                const dealii::Point<3>   &center,
                const ModeRequest        &request);

  /// Returns at most @p number buckling modes (K + lambda K_G) v = 0 with the
  /// smallest positive factors lambda of the loads, for closed contacts that
  /// stay closed. Short-wave modes, of factors above the inverse of
  /// GeometricStiffness::largest_short_wave_ratio(), depend on the mesh.
  /// Throws InputError as natural_modes(). Collective.
  std::vector<Mode>
  buckling_modes(LinearSystem             &system,
                 const State              &state,
                 const GeometricStiffness &geometric,
                 const unsigned int        number);
} // namespace lamella

#endif
