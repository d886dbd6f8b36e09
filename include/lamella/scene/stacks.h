// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_stacks_h
#define lamella_scene_stacks_h

#include <lamella/scene/scene_text.h>

namespace lamella
{
  /// Expands bodies of @p text that are repeated: bodies with `Copies = N`, N >
  /// 1. The body `leaf` becomes bodies leaf-1 to leaf-N with the entries of its
  /// subsection, except that body k has
  ///   Origin = Origin + (k - 1) Origin step,
  ///   Length = Length + (k - 1) Length step.
  /// References to `leaf` are expanded as follows; probes, lines and cuts must
  /// name one of the bodies leaf-k:
  /// - a region `leaf: top` of a support or a load becomes one region per body;
  /// - a contact NAME with `leaf` on both sides becomes the contacts NAME-1 to
  ///   NAME-(N-1), NAME-k between the bodies k and k + 1;
  /// - a contact NAME with `leaf` on one side becomes NAME-1 to NAME-N.
  ///
  /// Throws InputError for a step without `Copies`, N outside of 1 to 1000,
  /// lengths that are not positive, and generated names that exist already.
  void
  expand_stacks(SceneText &text);
} // namespace lamella

#endif
