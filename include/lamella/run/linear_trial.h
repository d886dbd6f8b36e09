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
   *            off by, to the order; theta itself where loads turn along,
   *   a        by how much compression makes displacements grow
   *            (BeyondLinear::amplification),
   * over all load steps. Above `worth_turning` = 2e-3, where loads are above
   * those that buckle, rotations are above their limit, or there is no linear
   * result, large rotations are taken; linear ones wherever large ones are
   * refused as the scene is built.
   */
  class LinearTrial
  {
  public:
    /// Builds @p scene, which is out of @p text, with large rotations, too, and
    /// solves it with linear ones. Throws InputError as the Simulation does.
    LinearTrial(const Scene &scene, const SceneText &text, std::ostream &out);

    /// Whether the linear run is the result.
    bool
    suffices() const
    {
      return is_enough;
    }

    /// The linear run, solved, if it suffices, else that of large rotations,
    /// not solved. The other one's memory is given back.
    Simulation &
    chosen() const
    {
      return is_enough ? *linear : *large;
    }

    /// Calls @p bars and writes the linear run, which suffices, into
    /// @p directory.
    void
    write(const std::string &directory, const Afterthought &bars) const;

  private:
    /// Makes the simulation of large rotations, or says why not.
    void
    build_large(const Scene &scene, const SceneText &text, std::ostream &out);
    /// Looks at what the linear run came to.
    void
    judge(const Scene &scene);

    std::unique_ptr<Simulation> linear, large;
    bool                        is_enough = false;
    std::string                 why;
  };
} // namespace lamella

#endif
