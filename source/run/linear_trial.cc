// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/sentence.h>
#include <lamella/base/text.h>
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
    constexpr double worth_turning = 2e-3;



    /// @p scene with linear kinematics that nothing keeps within their range.
    Scene
    linear_one(Scene scene)
    {
      scene.solve.rotations      = Rotations::linear;
      scene.solve.rotation_limit = std::numeric_limits<double>::max();
      scene.solve.beyond_linear  = OutOfRange::accept;
      return scene;
    }
  } // namespace



  LinearTrial::LinearTrial(const Scene     &scene,
                           const SceneText &text,
                           std::ostream    &out)
    : scene(scene)
    , linear(make_simulation(linear_one(scene), text, out))
  {
    out << "Rotations = auto: the linear model first" << std::endl;
    try
      {
        linear->solve();
        judge();
      }
    catch (const NumericsError &error)
      {
        why =
          "the linear model has no result: " + without_full_stop(error.what());
      }
    why = std::string("rotations: ") + (is_enough ? "linear" : "large") +
          ", taken by Rotations = auto: " + why;
    out << why << std::endl;
    if (!is_enough)
      linear.reset();
  }



  void
  LinearTrial::judge()
  {
    double rotation = 0., stiffening = 0., amplification = 0.;
    bool   is_buckled = false;
    for (const StepResults &step : linear->results().steps)
      {
        const BeyondLinear &beyond = step.checks.beyond;
        rotation      = std::max(rotation, step.checks.max_rotation);
        stiffening    = std::max(stiffening, beyond.stiffening);
        amplification = std::max(amplification, beyond.amplification);
        is_buckled |= beyond.buckling_factor && *beyond.buckling_factor < 1.;
      }
    const double turned   = rotation * rotation,
                 left_out = std::max({stiffening, turned, amplification});
    is_enough             = !is_buckled && left_out <= worth_turning;
    const auto per_cent   = [](const double share) {
      return to_text(100. * share, 2) + " %";
    };
    why = "what the linear model leaves out is " + per_cent(stiffening) +
          " by stretching, " + per_cent(turned) +
          " by turning (the square of " + to_text(rotation, 2) + " rad), " +
          (is_buckled ? "and it buckles below these loads" :
                        per_cent(amplification) + " by compression") +
          "; from " + per_cent(worth_turning) + " on bodies turn";
  }



  void
  LinearTrial::write(const std::string  &directory,
                     const Afterthought &bars) const
  {
    linear->add_endnote(why);
    bars();
    write_run(*linear, directory);
    print_results(*linear, directory, linear->output());
  }



  Scene
  LinearTrial::large_scene() const
  {
    Scene large = turning(scene);
    large.warnings.push_back(why);
    return large;
  }
} // namespace lamella
