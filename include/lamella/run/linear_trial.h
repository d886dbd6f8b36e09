// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_linear_trial_h
#define lamella_run_linear_trial_h

#include <lamella/run/run_scene.h>

#include <memory>
#include <string>

namespace lamella
{
  /**
   * Choice for `Rotations = auto`. The scene is solved with linear kinematics,
   * and the effect of large deflections is estimated as the largest of
   *   r        stiffening by tension (NonlinearityEstimate::stiffening),
   *   theta^2  square of the largest rotation [rad], the order of the error of
   *            deflections; theta with follower loads,
   *   a        amplification by compression
   *            (NonlinearityEstimate::amplification)
   * over all load steps. Large rotations are chosen if it exceeds
   * `needs_finite_rotations` = 2e-3, if loads exceed buckling loads, if
   * rotations exceed their limit, or if the linear solution fails, unless the
   * scene cannot be built with large rotations.
   */
  class LinearTrial
  {
  public:
    /// Builds @p scene, read from @p text, with linear and large rotations, and
    /// solves the linear one. Throws InputError as Simulation does.
    LinearTrial(const Scene &scene, const SceneText &text, std::ostream &out);

    /// Returns whether the linear run is the result.
    bool
    is_linear_sufficient() const
    {
      return linear_suffices;
    }

    /// Returns the linear run if it suffices, else the unsolved large one.
    Simulation &
    chosen() const
    {
      return linear_suffices ? *linear : *large;
    }

    /// Calls @p bars and writes the sufficient linear run into @p directory.
    void
    write(const std::string &directory, const PostProcessing &bars) const;

  private:
    /// Makes the simulation with large rotations, or stores why it is refused.
    void
    build_large(const Scene &scene, const SceneText &text, std::ostream &out);
    /// Evaluates the results of the linear run.
    void
    judge(const Scene &scene);

    std::unique_ptr<Simulation> linear, large;
    bool                        linear_suffices = false;
    std::string                 why;
  };
} // namespace lamella

#endif
