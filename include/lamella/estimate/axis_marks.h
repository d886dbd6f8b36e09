// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_axis_marks_h
#define lamella_estimate_axis_marks_h

#include <lamella/recover/results.h>
#include <lamella/scene/scene.h>

#include <optional>
#include <vector>

namespace lamella
{
  /// Returns @p scene with the elements @p marked of its beams bisected. Axes
  /// have to be made. Bodies with paired nodes need all or none marked.
  Scene
  bisected(Scene scene, const std::vector<ElementError> &marked);

  /// Returns the elements to bisect for @p goals: for each goal those with the
  /// largest |error| per DoF, at least @p share of the sum of |error|, and as
  /// many as leave at most @p left of the tolerance to all others. Nothing if a
  /// goal has no LocalErrors or a contact pairs nodes.
  std::optional<std::vector<ElementError>>
  marked_elements(const Scene                   &scene,
                  const std::vector<GoalResult> &goals,
                  const double                   left,
                  const double                   share);

  /**
   * Returns @p scene with elements merged that contribute little to the error
   * of any of @p goals. A merged pair of neighbors with lengths h_1, h_2 and
   * degree p along the axis is expected to have the error of a smooth solution,
   *   (|e_1| + |e_2|) ((h_1 + h_2) / min(h_1, h_2))^(2 p),
   * where e is multiplied by 2^(-2 p) if only errors of pairs are known
   * (LocalErrors::of_pairs). Pairs, also of merged elements, are merged in
   * order of increasing error while the sum is below @p left of each tolerance.
   * Element ends at @p kept (one list per body) stay. Nothing is merged if a
   * contact pairs nodes, or if a goal has no LocalErrors or too large parts
   * without an element (contact, remainder).
   */
  Scene
  merged(Scene                                   scene,
         const std::vector<std::vector<double>> &kept,
         const std::vector<GoalResult>          &goals,
         const double                            left);
} // namespace lamella

#endif
