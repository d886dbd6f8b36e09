// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_coarser_scenes_h
#define lamella_estimate_coarser_scenes_h

#include <lamella/axis/axis.h>
#include <lamella/body/beam_surplus.h>
#include <lamella/scene/scene.h>

#include <vector>

namespace lamella
{
  /// Returns @p axis with about half as many elements. Neighbors are merged in
  /// pairs within each segment of the axis; of an odd number, three are merged
  /// at the longest element. On graded axes, where each segment is one element,
  /// segments end at the points toward which elements get shorter. All element
  /// ends are element ends of @p axis.
  AxisMesh
  halved(const AxisMesh &axis);

  /// Returns the elements of @p axis after halving it @p times. Its degree is
  /// reduced by one (not below 1) each time an element is not merged.
  std::vector<AxisSpan>
  coarser_spans(AxisMesh axis, const unsigned int times);

  /// Returns @p scene with the axes of its beams, which must exist, halved().
  Scene
  with_halved_axes(Scene scene);

  /// Returns @p scene with LE-(N-1) for LE-N, N >= 2, in all bodies.
  Scene
  with_lower_degree(Scene scene);
} // namespace lamella

#endif
