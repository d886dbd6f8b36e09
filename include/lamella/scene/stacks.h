// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_stacks_h
#define lamella_scene_stacks_h

#include <lamella/scene/scene_text.h>

namespace lamella
{
  /**
   * Expands the stacks of @p text: bodies with `Copies = N`, N > 1. The body
   * `leaf` becomes leaf-1 to leaf-N, with all entries of its subsection, except
   *   Origin = Origin + (k - 1) Origin step,
   *   Length = Length + (k - 1) Length step.
   * References to `leaf` are expanded; points (probes, lines, cuts) must name a
   * copy:
   * - a region `leaf: top` of a support or a load becomes that of each copy;
   * - a contact with `leaf` on both sides becomes NAME-1 to NAME-(N-1), NAME-k
   *   between the copies k (the side in the text) and k + 1;
   * - a contact with `leaf` on one side becomes NAME-1 to NAME-N.
   *
   * Throws InputError for steps without copies, a number of copies not in 1 to
   * 1000, lengths that are not positive, and generated names that exist.
   */
  void
  expand_stacks(SceneText &text);
} // namespace lamella

#endif
