// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_poorer_h
#define lamella_estimate_poorer_h

#include <lamella/axis/axis.h>
#include <lamella/body/beam_surplus.h>
#include <lamella/scene/scene.h>

#include <vector>

namespace lamella
{
  /**
   * @p axis with about half as many elements, whose lengths are known (no
   * fineness): neighbours become one, two by two from each end of a piece to
   * the next; of an odd number three become one, the longest among them. Only
   * an element alone between two such ends is kept.
   * Where all pieces are one element, as on graded axes, those places are taken
   * that elements get shorter to from both sides: what touches the axis is
   * there. All ends are ends of elements of @p axis.
   */
  AxisMesh
  halved(const AxisMesh &axis);

  /// The elements of @p axis after it was halved() @p times (at least once),
  /// with polynomials of its degree; of one less, but 1 at least, for each time
  /// that they found no partner.
  std::vector<AxisSpan>
  coarser_spans(AxisMesh axis, const unsigned int times);

  /// @p scene with the axes of its beams halved(). The axes have to be made
  /// (grade_axes()).
  Scene
  on_half_the_axis(Scene scene);

  /// @p scene with LE-(N-1) for LE-N in all bodies and pieces of them, N from 2
  /// on.
  Scene
  of_one_degree_less(Scene scene);
} // namespace lamella

#endif
