// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_coarser_scenes_h
#define lamella_estimate_coarser_scenes_h

#include <lamella/axis/axis.h>
#include <lamella/body/beam_surplus.h>
#include <lamella/scene/scene.h>

#include <vector>

namespace lamella
{
  /// Returns @p axis with about half as many elements, of given lengths.
  /// Neighbors are merged two by two within each piece; of an odd number, three
  /// at the longest element are merged. If all pieces are single elements, as
  /// on graded axes, pieces end at the places toward which elements get shorter
  /// from both sides. All element ends are element ends of @p axis.
  AxisMesh
  halved(const AxisMesh &axis);

  /// Returns the elements of @p axis after halving it @p times, with its degree
  /// reduced by one (1 at least) for each time an element was not merged.
  std::vector<AxisSpan>
  coarser_spans(AxisMesh axis, const unsigned int times);

  /// Returns @p scene with the (made) axes of its beams halved().
  Scene
  with_halved_axes(Scene scene);

  /// Returns @p scene with LE-(N-1) for LE-N in all bodies and pieces, N >= 2.
  Scene
  with_lower_degree(Scene scene);
} // namespace lamella

#endif
