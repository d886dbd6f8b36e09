// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_model_key_h
#define lamella_estimate_model_key_h

#include <lamella/scene/scene.h>

#include <string>

namespace lamella
{
  /// Returns a string that identifies the model of @p scene: the text of all
  /// entries as read (Scene::resolved), and each member that may have changed
  /// later: theory, pieces, axis, refinement and stabilization of the bodies,
  /// divisions of sections, and the law of each contact, with all digits.
  /// Models with equal keys have equal results at the last load factor. A new
  /// member of these structures does not compile until it is included.
  std::string
  key_of(const Scene &scene);
} // namespace lamella

#endif
