// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_linear_trial_h
#define lamella_run_linear_trial_h

#include <lamella/run/run_scene.h>

#include <memory>
#include <string>

namespace lamella
{
  /// Choice of the kinematics for `Rotations = auto`. The scene is solved with
  /// linear kinematics. The effect of large deflections is estimated as the
  /// largest, over all load steps, of
  /// - r, stiffening by tension (NonlinearityEstimate::stiffening);
  /// - theta^2, with the largest rotation theta [rad], the order of the error
  ///   of deflections; theta with follower loads;
  /// - a, amplification by compression (NonlinearityEstimate::amplification).
  ///
  /// Finite rotations are chosen if this effect exceeds
  /// `needs_finite_rotations` = 2e-3, if loads exceed buckling loads, if
  /// rotations exceed their limit, or if the linear solution fails, unless
  /// finite rotations are impossible.
  class LinearTrial
  {
  public:
    /// Builds @p scene, read from @p text, with linear and with finite
    /// rotations, and solves the linear model. Throws as Simulation does.
    LinearTrial(const Scene &scene, const SceneText &text, std::ostream &out);

    /// Returns true if linear kinematics are sufficient.
    bool
    is_linear_sufficient() const
    {
      return linear_suffices;
    }

    /// Returns the solved linear run if sufficient, else an unsolved run with
    /// finite rotations.
    Simulation &
    chosen() const
    {
      return linear_suffices ? *linear : *large;
    }

    /// Calls @p bars and writes the (sufficient) linear run into @p directory.
    void
    write(const std::string &directory, const PostProcessing &bars) const;

  private:
    /// Builds the model with finite rotations, or stores why it cannot be.
    void
    build_large(const Scene &scene, const SceneText &text, std::ostream &out);
    /// Decides whether the linear run is sufficient.
    void
    judge(const Scene &scene);

    std::unique_ptr<Simulation> linear, large;
    bool                        linear_suffices = false;
    std::string                 why;
  };
} // namespace lamella

#endif
