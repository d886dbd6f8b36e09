// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_estimate_model_key_h
#define lamella_estimate_model_key_h

#include <lamella/scene/scene.h>

#include <string>

namespace lamella
{
  /// Returns a string that identifies the model of @p scene: the text of all
  /// entries as read (Scene::resolved), and with all digits the members that
  /// may have changed since: theory, axis segments, axis, refinement and
  /// stabilization of bodies, divisions of sections, and contact laws. Models
  /// with equal strings have equal results at the last load factor. Without a
  /// member of these structures, this function does not compile.
  std::string
  key_of(const Scene &scene);
} // namespace lamella

#endif
