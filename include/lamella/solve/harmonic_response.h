// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_harmonic_response_h
#define lamella_solve_harmonic_response_h

#include <lamella/solve/modes.h>

#include <algorithm>
#include <complex>
#include <vector>

namespace lamella
{
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
