// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_tests_unit_solved_scene_h
#define lamella_tests_unit_solved_scene_h

#include <lamella/body/beam.h>
#include <lamella/recover/named_quantity.h>
#include <lamella/run/simulation.h>
#include <lamella/scene/scene_text.h>

#include <ostream>
#include <string>
#include <vector>

namespace lamella
{
  /// A scene of the repository that is solved, with overrides.
  struct SolvedScene
  {
    SolvedScene(const std::string              &file,
                const std::vector<std::string> &overrides)
      : nowhere(nullptr)
      , run(read_scene(SceneText::read(LAMELLA_SOURCE_DIR + file, overrides)),
            nowhere)
    {
      run.solve();
    }

    double
    value(const NamedQuantity &goal) const
    {
      return ResultNumbers(run.results()).value(goal);
    }

    /// Of the first body.
    const Beam &
    beam() const
    {
      return *beams_of(run.model().structure().bodies()).front();
    }

    const AxisMesh &
    axis() const
    {
      return run.model().scene().bodies.front().axis;
    }

    std::ostream nowhere;
    Simulation   run;
  };
} // namespace lamella

#endif
