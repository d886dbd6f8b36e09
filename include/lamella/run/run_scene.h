// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_run_run_scene_h
#define lamella_run_run_scene_h

#include <lamella/run/simulation.h>

#include <functional>
#include <iosfwd>
#include <memory>
#include <string>

namespace lamella
{
  /// Returns the unsolved simulation of @p scene, which was read from @p text.
  /// InputErrors contain the line of @p text. Prints progress to @p out.
  std::unique_ptr<Simulation>
  make_simulation(const Scene &scene, const SceneText &text, std::ostream &out);

  /// Callback after the last load step; may add results, such as error bars.
  using PostProcessing = std::function<void()>;

  /// Solves @p simulation, writes each completed load step into the folder
  /// @p directory (ResultsWriter) and prints the main results. With @p resume,
  /// continues the run in this folder. Throws what Simulation::solve() throws,
  /// after writing the completed steps, and InputError if the folder cannot be
  /// written, belongs to another run, or has no step to resume from.
  void
  run_scene(Simulation           &simulation,
            const std::string    &directory,
            const bool            resume          = false,
            const PostProcessing &post_processing = {});

  /// Writes the results of all load steps of @p simulation into the folder @p
  /// directory, with the same files as run_scene().
  void
  write_run(Simulation &simulation, const std::string &directory);

  /// Prints the main results of the last load step, and @p directory, to @p to.
  void
  print_results(const Simulation  &simulation,
                const std::string &directory,
                std::ostream      &to);

  /// Prints plies, laminate stiffnesses, beam properties of sections, bodies,
  /// contacts and notes of @p simulation, without solving (--validate). Unless
  /// @p directory is empty, writes section meshes to its subfolder `sections`.
  void
  print_validation(const Simulation &simulation, const std::string &directory);

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
