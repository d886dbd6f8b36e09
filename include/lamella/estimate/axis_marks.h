// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_axis_marks_h
#define lamella_estimate_axis_marks_h

#include <lamella/recover/results.h>
#include <lamella/scene/scene.h>

#include <optional>
#include <vector>

namespace lamella
{
  /// @p scene with the elements @p marked of its beams bisected. Their axes
  /// have to be made; bodies whose nodes a contact pairs (node to node) want
  /// all of their elements marked or none.
  Scene
  bisected(Scene scene, const std::vector<ElementError> &marked);

  /**
   * Which elements to bisect for @p goals: of each those with the largest
   * |error| per DoF until what all others do is below @p left of the tolerance,
   * and no less than @p share of the sum. None if a goal has no LocalErrors, or
   * a contact pairs nodes: then all elements are to be halved.
   */
  std::optional<std::vector<ElementError>>
  marked_elements(const Scene                   &scene,
                  const std::vector<GoalResult> &goals,
                  const double                   left,
                  const double                   share);

  /**
   * @p scene with elements of its beams merged that do nothing to any of
   * @p goals: of two neighbours with the lengths h_1, h_2 and the degree p
   * along the axis the error is expected to be
   *   (|e_1| + |e_2|) ((h_1 + h_2) / min(h_1, h_2))^(2 p),
   * what a smooth solution makes of it (e is 2^(-2 p) of what is known of
   * pairs), and pairs are merged, also ones that
   * are merged already, the least error first, while all of them together are
   * below @p left of each tolerance. Ends of elements at @p kept, of each body,
   * stay. Nothing is merged where a goal has no LocalErrors, where these are
   * not told element by element (contact, remainder) up to @p left of the
   * tolerance, or where a contact pairs nodes.
   */
  Scene
  merged(Scene                                   scene,
         const std::vector<std::vector<double>> &kept,
         const std::vector<GoalResult>          &goals,
         const double                            left);
} // namespace lamella

#endif
