// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_linear_trial_h
#define lamella_run_linear_trial_h

#include <lamella/run/run_scene.h>

#include <memory>
#include <string>

namespace lamella
{
  /**
   * `Rotations = auto`: the scene is solved with linear kinematics, whatever
   * comes of it, and what that leaves out is the largest of
   *   r        what stretching stiffens forces by (BeyondLinear::stiffening),
   *   theta^2  the square of the largest rotation [rad], which deflections are
   *            off by, to the order,
   *   a        by how much compression makes displacements grow
   *            (BeyondLinear::amplification),
   * over all load steps. Above `worth_turning` = 2e-3, where loads are above
   * those that buckle, or where there is no linear result, large rotations are
   * to be taken.
   */
  class LinearTrial
  {
  public:
    /// Solves @p scene, which is out of @p text and one that may turn. Throws
    /// InputError as the Simulation does.
    LinearTrial(const Scene &scene, const SceneText &text, std::ostream &out);

    bool
    suffices() const
    {
      return is_enough;
    }

    /// The linear run, if it suffices: else its memory is given back.
    Simulation &
    simulation() const
    {
      return *linear;
    }

    /// Calls @p bars and writes the linear run into @p directory, with why it
    /// is linear.
    void
    write(const std::string &directory, const Afterthought &bars) const;

    /// The scene of large rotations, with why.
    Scene
    large_scene() const;

  private:
    /// Looks at what the linear run came to.
    void
    judge();

    const Scene                &scene;
    std::unique_ptr<Simulation> linear;
    bool                        is_enough = false;
    std::string                 why;
  };
} // namespace lamella

#endif
