// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_stacks_h
#define lamella_scene_stacks_h

#include <lamella/scene/scene_text.h>

namespace lamella
{
  /**
   * Writes out the stacks of @p text: bodies with `Copies = N`, N > 1. The body
   * `leaf` becomes leaf-1 to leaf-N, in its place in Bodies and with all
   * entries of its subsection, but
   *   Origin = Origin + (k - 1) Origin step,
   *   Length = Length + (k - 1) Length step.
   * Whatever names `leaf` stands for the copies:
   * - a region `leaf: top` of a support or a load is that of each copy;
   * - a contact with `leaf` on both sides, `leaf: bottom` and `leaf: top` say,
   *   becomes NAME-1 to NAME-(N-1), NAME-k between the copies k (the side that
   *   it has in the text) and k + 1;
   * - a contact with `leaf` on one side becomes NAME-1 to NAME-N.
   * Points (probes, lines, cuts) name a copy. What results is a scene like any
   * other, which is what a run leaves as scene.prm.
   *
   * Throws InputError for steps without copies, for a number of copies that is
   * none from 1 to 1000, for lengths that fall to zero, and where a generated
   * name is that of another body or contact.
   */
  void
  write_out_stacks(SceneText &text);
} // namespace lamella

#endif
