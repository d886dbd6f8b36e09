// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_axis_marks_h
#define lamella_estimate_axis_marks_h

#include <lamella/recover/results.h>
#include <lamella/scene/scene.h>

#include <optional>
#include <vector>

namespace lamella
{
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

  /// Returns @p scene with axis elements merged that contribute little to the
  /// errors of @p goals. A merged pair of neighbors with lengths h_1, h_2,
  /// errors e_1, e_2 and degree p along the axis is expected to have the error
  /// of a smooth solution,
  ///   (|e_1| + |e_2|) ((h_1 + h_2) / min(h_1, h_2))^(2 p),
  /// where e is multiplied by 2^(-2 p) if only errors of pairs are known
  /// (LocalErrors::of_pairs). Pairs, also of merged elements, are merged in
  /// ascending order of this error, until the sum of their errors reaches @p
  /// left times a tolerance. Element ends at the axial coordinates @p kept
  /// [length], one list per body, remain. Nothing is merged if a contact pairs
  /// nodes, if a goal has no element errors, or if its contact error exceeds @p
  /// left times its tolerance.
  Scene
  merged(Scene                                   scene,
         const std::vector<std::vector<double>> &kept,
         const std::vector<GoalResult>          &goals,
         const double                            left);
} // namespace lamella

#endif
