// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_stacks_h
#define lamella_scene_stacks_h

#include <lamella/scene/scene_text.h>

namespace lamella
{
  /// Replaces each body of @p text with the entry `Copies = N`, N > 1, by N
  /// bodies. For example, `leaf` becomes leaf-1 to leaf-N. They have the
  /// entries of `leaf`, except that body number k has
  ///   Origin = Origin + (k - 1) Origin step,
  ///   Length = Length + (k - 1) Length step.
  /// References to `leaf` are replaced as well:
  /// - a region `leaf: top` of a support or a load becomes one region per body;
  /// - a contact NAME between `leaf` and itself becomes the contacts NAME-1 to
  ///   NAME-(N-1), where NAME-k is between the bodies k and k + 1;
  /// - a contact NAME between `leaf` and another body becomes NAME-1 to NAME-N.
  ///
  /// Probes, lines and cuts must refer to one of the bodies, such as leaf-2.
  /// Throws InputError for a step without `Copies`, N outside of 1 to 1000,
  /// lengths that are not positive, and generated names that exist already.
  void
  expand_stacks(SceneText &text);
} // namespace lamella

#endif
