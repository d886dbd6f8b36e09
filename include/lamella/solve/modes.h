// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_modes_h
#define lamella_solve_modes_h

#include <lamella/body/fields.h>
#include <lamella/solve/linear_system.h>

#include <algorithm>
#include <array>
#include <complex>
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

  /// Request of a steady harmonic response.
  struct HarmonicRequest
  {
    std::vector<double> frequencies; ///< Frequencies [Hz], ascending.
    /// Damping ratio of each mode; the last one holds for all further modes.
    std::vector<double> damping;
    /// Amplitude of the acceleration of all supports, scene axes.
    dealii::Tensor<1, 3> base_acceleration;

    /// Returns the damping ratio of the mode with the index @p mode.
    double
    damping_of(const unsigned int mode) const
    {
      return damping[std::min<std::size_t>(mode, damping.size() - 1)];
    }
  };

  /// Steady harmonic response u(t) = Re (U exp(i omega t)) of small motions
  /// about an equilibrium state, by superposition of modes phi_k (phi . M phi =
  /// 1) with damping ratios zeta_k and with the static response of all other
  /// modes (mode acceleration method: Cornwell, Craig and Johnson, Earthquake
  /// Engng Struct. Dyn. 11 (1983) 679-688):
  ///   U = u_s + K^-1 F + sum_k phi_k (phi_k . F) (1 / D_k - 1 / omega_k^2)
  ///       - R R^T F / omega^2,
  ///   D_k = omega_k^2 - omega^2 + 2 i zeta_k omega_k omega,
  ///   F = f - M r a + omega^2 M u_s,
  /// with the amplitudes f of loads and u_s of the quasi-static motion due to
  /// prescribed displacements, the acceleration a of the base along the rigid
  /// translations r, relative to which U is then, and free rigid motions R.
  class HarmonicResponse
  {
  public:
    /// Computes the static responses by @p equations about the state at the
    /// load factors @p factor; amplitudes are those of
    /// LoadFactor::with_oscillation(). @p modes are those of the equations.
    /// Keeps a reference to @p request. Throws InputError if prescribed motions
    /// move a closed contact, for frequency 0 if the loads move free bodies,
    /// and where the response is unbounded without damping. Collective.
    HarmonicResponse(const VibrationEquations &equations,
                     const LoadFactor         &factor,
                     const NaturalModes       &modes,
                     const HarmonicRequest    &request);

    /// Returns the motions of which U is a linear combination.
    const std::vector<BlockVector> &
    motions() const
    {
      return basis;
    }

    /// Returns the coefficients of motions() at @p frequency [Hz].
    std::vector<std::complex<double>>
    coefficients(const double frequency) const;

    /// Returns the frequencies of the request and, for damped modes within
    /// their range, the natural frequencies f and half-power points (1 +- zeta)
    /// f, ascending.
    std::vector<double>
    frequencies() const;

  private:
    /// Sets the work of the forces @p f and M u_s, @p Mu, on rigid motions and
    /// modes.
    void
    add_work(const BlockVector &f, const BlockVector &Mu);
    /// Returns true if @p frequency is the natural frequency of an undamped
    /// mode, to the relative @p tolerance.
    bool
    is_undamped(const double frequency, const double tolerance) const;
    /// Throws InputError if the response at a requested frequency is unbounded.
    void
    check_frequencies() const;

    const HarmonicRequest &request;
    std::vector<double>    natural; ///< Natural frequencies [Hz].
    unsigned int           n_rigid;
    /// True if the loads f - M r a do work on free rigid motions.
    bool moves_rigidly = false;
    /// u_s + K^-1 (f - M r a), K^-1 M u_s, rigid motions, and modes.
    std::vector<BlockVector> basis;
    /// Products of rigid motions and modes with f - M r a, and with M u_s.
    std::vector<double> of_loads, of_motion;
  };
} // namespace lamella

#endif
