// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/conditions/follower_load.h>
#include <lamella/run/linear_trial.h>
#include <lamella/scene/rotation_rules.h>

#include <algorithm>
#include <limits>
#include <ostream>

namespace lamella
{
  namespace
  {
    // Of forces or displacements.
    constexpr double needs_finite_rotations = 2e-3;



    /// @p scene with linear kinematics; nothing keeps these within their range
    /// if there @p are_others to take then.
    Scene
    with_linear_rotations(Scene scene, const bool are_others)
    {
      scene.solve.rotations = Rotations::linear;
      if (are_others)
        {
          scene.solve.rotation_limit = std::numeric_limits<double>::max();
          scene.solve.beyond_linear  = OutOfRange::accept;
        }
      return scene;
    }
  } // namespace



  LinearTrial::LinearTrial(const Scene     &scene,
                           const SceneText &text,
                           std::ostream    &out)
  {
    build_large(scene, text, out);
    linear = make_simulation(with_linear_rotations(scene, large != nullptr),
                             text,
                             out);
    out << "Rotations = auto: the linear model first" << std::endl;
    try
      {
        linear->solve();
        judge(scene);
      }
    catch (const NumericsError &error)
      {
        if (large == nullptr)
          throw;
        why = "the linear model has no result: " + strip_period(error.what());
      }
    why = std::string("rotations: ") + (linear_suffices ? "linear" : "large") +
          ", taken by Rotations = auto: " + why;
    out << why << std::endl;
    (linear_suffices ? large : linear).reset();
    chosen().add_endnote("run.rotations-chosen: the kinematics, linear or with "
                         "large rotations, were chosen automatically; " +
                         why);
  }



  void
  LinearTrial::build_large(const Scene     &scene,
                           const SceneText &text,
                           std::ostream    &out)
  {
    try
      {
        large = make_simulation(with_finite_rotations(scene), text, out);
      }
    catch (const InputError &error)
      {
        if (requests_finite_rotations(scene))
          throw;
        why = "large is refused: " + strip_period(error.what()) + "; ";
      }
  }



  void
  LinearTrial::judge(const Scene &scene)
  {
    double rotation = 0., stiffening = 0., amplification = 0.;
    bool   is_buckled = false;
    for (const StepResults &step : linear->results().steps)
      {
        const NonlinearityEstimate &beyond = step.checks.beyond;
        rotation      = std::max(rotation, step.checks.max_rotation);
        stiffening    = std::max(stiffening, beyond.stiffening);
        amplification = std::max(amplification, beyond.amplification);
        is_buckled |= beyond.buckling_factor && *beyond.buckling_factor < 1.;
      }
    const bool along =
      std::any_of(scene.loads.begin(), scene.loads.end(), is_follower_load);
    const double turned   = along ? rotation : rotation * rotation,
                 left_out = std::max({stiffening, turned, amplification});
    linear_suffices =
      large == nullptr || (!is_buckled && left_out <= needs_finite_rotations &&
                           rotation <= scene.solve.rotation_limit);
    const auto per_cent = [](const double share) {
      return to_text(100. * share, 2) + " %";
    };
    why += "what the linear model leaves out is " + per_cent(stiffening) +
           " by stretching, " + per_cent(turned) + " by turning (" +
           (along ? "loads turn by " : "the square of ") +
           to_text(rotation, 2) + " rad), " +
           (is_buckled ? "and it buckles below these loads" :
                         per_cent(amplification) + " by compression") +
           "; from " + per_cent(needs_finite_rotations) + " on bodies turn";
  }



  void
  LinearTrial::write(const std::string    &directory,
                     const PostProcessing &bars) const
  {
    bars();
    write_run(*linear, directory);
    print_results(*linear, directory, linear->output());
  }
} // namespace lamella
