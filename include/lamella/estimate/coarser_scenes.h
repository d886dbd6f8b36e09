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
  /// where they are longest. On graded axes, where each segment is one element,
  /// pairs are formed between the points toward which elements get shorter; a
  /// single one between segments of several elements remains. All element ends
  /// of the result are element ends of @p axis.
  AxisMesh
  halved(const AxisMesh &axis);

  /// Applies halved() to @p axis @p times times and returns the elements. Each
  /// time, elements that were not merged get one degree less (at least 1).
  std::vector<AxisSpan>
  coarser_spans(AxisMesh axis, const unsigned int times);

  /// Returns @p scene with about half as many elements on the axis of each beam
  /// (halved()). The axes must already be divided into elements.
  Scene
  with_halved_axes(Scene scene);

  /// Returns @p scene with LE-N replaced by LE-(N-1) in all bodies, N >= 2.
  Scene
  with_lower_degree(Scene scene);

  /// Returns @p scene with @p fewer wave numbers less in SV-N, at least one.
  Scene
  with_fewer_waves(Scene scene, const unsigned int fewer);

  /// Returns @p scene with one section order less in bodies of SV, at least
  /// one, and with_lower_degree().
  Scene
  with_lower_section_order(Scene scene);
} // namespace lamella

#endif
