// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/arithmetic.h>
#include <lamella/base/entry.h>
#include <lamella/base/text.h>
#include <lamella/solve/modes.h>
#include <lamella/solve/small_motions.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// Returns the acceleration @p a of all bodies.
    BlockVector
    translation(const Structure    &structure,
                const BlockVector  &u,
                const Tensor<1, 3> &a)
    {
      const auto  rigid = rigid_motions_about(structure, u, Point<3>());
      BlockVector all   = structure.zero();
      for (unsigned int d = 0; d < 3; ++d)
        all.add(a[d], rigid[d]);
      return all;
    }



    /// Returns the quasi-static displacements due to the prescribed ones @p
    /// u_p.
    BlockVector
    quasi_static(const SmallMotions &motions, BlockVector u_p)
    {
      if (motions.largest_jump(u_p) >
          arithmetic::rounding_of_results * u_p.linfty_norm())
        Entry("Find", "response")
          .refuse("solve.support-moves-contact: a prescribed motion of a "
                  "support moves a closed contact directly",
                  "Move the support away from the contact.");
      BlockVector f = motions.times_stiffness(u_p);
      f *= -1.;
      u_p += motions.solve(f);
      return u_p;
    }
  } // namespace



  HarmonicResponse::HarmonicResponse(const VibrationEquations &equations,
                                     const LoadFactor         &factor,
                                     const NaturalModes       &modes,
                                     const HarmonicRequest    &request)
    : request(request)
    , n_rigid(modes.n_rigid)
  {
    for (const Mode &mode : modes.modes)
      natural.push_back(mode.value);
    const TangentOperator &tangent   = equations.system.tangent();
    const Structure       &structure = tangent.of();
    const MassMatrix      &mass      = equations.mass;
    const SmallMotions    &small     = equations.motions;
    const BlockVector     &u         = equations.state.u;
    const LoadFactor       raised    = factor.with_oscillation();
    const BlockVector      u_s =
      quasi_static(small, tangent.support_increment(factor, raised));
    BlockVector f = structure.load(raised, u);
    f -= structure.load(factor, u);
    f -= mass(translation(structure, u, request.base_acceleration));
    const BlockVector Mu = mass(u_s);
    basis                = {u_s, small.solve(Mu)};
    basis[0] += small.solve(f);
    for (const BlockVector &motion : small.rigid_motions())
      basis.push_back(motion);
    for (const Mode &mode : modes.modes)
      basis.push_back(mode.shape);
    add_work(f, Mu);
    check_frequencies();
  }



  void
  HarmonicResponse::add_work(const BlockVector &f, const BlockVector &Mu)
  {
    for (unsigned int k = 2; k < basis.size(); ++k)
      {
        of_loads.push_back(basis[k] * f);
        of_motion.push_back(basis[k] * Mu);
        const double scale = basis[k].l2_norm() * f.l2_norm();
        if (k < n_rigid + 2 &&
            std::abs(of_loads.back()) > arithmetic::rounding_of_results * scale)
          moves_rigidly = true;
      }
  }



  bool
  HarmonicResponse::is_undamped(const double frequency,
                                const double tolerance) const
  {
    for (unsigned int k = 0; k < natural.size(); ++k)
      if (request.damping_of(k) == 0. &&
          std::abs(frequency - natural[k]) <= tolerance * natural[k])
        return true;
    return false;
  }



  void
  HarmonicResponse::check_frequencies() const
  {
    for (const double f : request.frequencies)
      {
        const Entry entry("Harmonic response/Frequencies", to_text(f, 9));
        if (f == 0. && moves_rigidly)
          entry.refuse(
            "solve.static-response-of-free-bodies: the response at 0 "
            "Hz is unbounded, since the loads move free bodies",
            "Begin at a higher frequency, or hold the bodies.");
        if (is_undamped(f, arithmetic::rounding_of_results))
          entry.refuse(
            "solve.undamped-resonance: the response is unbounded, "
            "since this is the natural frequency of an undamped mode",
            "Write another frequency, or Damping.");
      }
  }



  std::vector<std::complex<double>>
  HarmonicResponse::coefficients(const double frequency) const
  {
    const double omega = 2. * numbers::PI * frequency, square = omega * omega;
    std::vector<std::complex<double>> c{1., square};
    for (unsigned int k = 0; k < of_loads.size(); ++k)
      {
        if (k < n_rigid)
          {
            c.push_back(-of_motion[k] -
                        (moves_rigidly ? of_loads[k] / square : 0.));
            continue;
          }
        const double               force = of_loads[k] + square * of_motion[k];
        const unsigned int         mode  = k - n_rigid;
        const double               own   = 2. * numbers::PI * natural[mode];
        const std::complex<double> D(own * own - square,
                                     2. * request.damping_of(mode) * own *
                                       omega);
        c.push_back(force * (1. / D - 1. / (own * own)));
      }
    return c;
  }



  std::vector<double>
  HarmonicResponse::frequencies() const
  {
    std::vector<double> all   = request.frequencies;
    const double        first = all.front(), last = all.back();
    for (unsigned int k = 0; k < natural.size(); ++k)
      if (const double zeta = request.damping_of(k); zeta > 0.)
        for (const double factor : {1. - zeta, 1., 1. + zeta})
          if (const double f = factor * natural[k];
              f > first && f < last && !is_undamped(f, arithmetic::same_value))
            all.push_back(f);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(),
                          all.end(),
                          [](const double one, const double other) {
                            return other - one <=
                                   arithmetic::negligible * other;
                          }),
              all.end());
    return all;
  }
} // namespace lamella
