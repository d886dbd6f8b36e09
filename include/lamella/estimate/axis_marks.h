// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_axis_marks_h
#define lamella_estimate_axis_marks_h

#include <lamella/recover/results.h>
#include <lamella/run/simulation.h>
#include <lamella/scene/scene.h>

#include <optional>
#include <vector>

namespace lamella
{
  /// Returns true if a contact of @p scene pairs nodes of two bodies, whose
  /// axes can only be refined alike.
  bool
  pairs_nodes(const Scene &scene);

  /// Returns @p scene with the axis elements @p marked of its beams bisected.
  /// The axes must already be divided into elements. If a contact pairs the
  /// nodes of two bodies, all or none of their elements must be marked.
  Scene
  bisected(Scene scene, const std::vector<ElementError> &marked);

  /// Returns the axis elements to be bisected to reduce the errors of @p goals.
  /// For each goal, elements are selected in descending order of |error| per
  /// DoF. The sum of |error| of the selected elements is at least @p share
  /// times that of all, and that of the others at most @p left times the
  /// tolerance. Returns an empty optional without element errors or if a
  /// contact pairs nodes.
  std::optional<std::vector<ElementError>>
  marked_elements(const Scene                   &scene,
                  const std::vector<GoalResult> &goals,
                  const double                   left,
                  const double                   share);

  /// Returns @p scene, a scene of the bodies of @p run, with axis elements at
  /// supports bisected if they are longer than @p longest times the larger
  /// section side: at points, lines and ends that supports constrain. Empty if
  /// there are none.
  std::optional<Scene>
  with_short_elements_at_supports(Scene             scene,
                                  const Simulation &run,
                                  const double      longest);
} // namespace lamella

#endif
