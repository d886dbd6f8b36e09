// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_linear_trial_h
#define lamella_run_linear_trial_h

#include <lamella/run/run_scene.h>

#include <memory>
#include <string>

namespace lamella
{
  /// Chooses linear kinematics or finite rotations for `Rotations = auto`. The
  /// scene is solved with linear kinematics first. The relative error due to
  /// neglected rotations is estimated as the largest, over all load steps, of
  /// - the stiffening by tension (NonlinearityEstimate::stiffening);
  /// - theta^2, where theta is the largest rotation [rad], or theta with
  ///   follower loads, whose directions rotate by this angle;
  /// - the amplification by compression (NonlinearityEstimate::amplification).
  ///
  /// Finite rotations are chosen if this estimate exceeds 2e-3, if loads exceed
  /// the buckling load, if rotations exceed the limit of the scene, or if the
  /// linear solution fails. Linear kinematics are kept if the scene has entries
  /// that finite rotations do not support (see with_finite_rotations()).
  class LinearTrial
  {
  public:
    /// Builds models of @p scene, read from @p text, with linear kinematics
    /// and, if possible, finite rotations. Solves the first. Throws like
    /// Simulation.
    LinearTrial(const Scene &scene, const SceneText &text, std::ostream &out);

    /// Returns true if linear results are kept, false for finite rotations.
    bool
    is_linear_sufficient() const
    {
      return linear_suffices;
    }

    /// Returns the solved linear simulation if linear kinematics are
    /// sufficient, otherwise an unsolved simulation with finite rotations.
    Simulation &
    chosen() const
    {
      return linear_suffices ? *linear : *large;
    }

    /// Calls @p bars, which may compute error bars, then writes the results of
    /// the linear simulation into the folder @p directory and prints them.
    /// Requires is_linear_sufficient().
    void
    write(const std::string &directory, const PostProcessing &bars) const;

  private:
    /// Builds the model with finite rotations, or stores why it is impossible.
    void
    build_large(const Scene &scene, const SceneText &text, std::ostream &out);
    /// Decides whether the linear solution is accurate enough.
    void
    judge(const Scene &scene);

    std::unique_ptr<Simulation> linear, large;
    bool                        linear_suffices = false;
    std::string                 why;
  };
} // namespace lamella

#endif
