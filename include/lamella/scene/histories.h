// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_histories_h
#define lamella_scene_histories_h

#include <lamella/scene/scene.h>

#include <string>

namespace lamella
{
  /// Returns the subsection (such as `Load push`) of the first support, load or
  /// obstacle of @p scene that has own load factors for the load steps (entry
  /// `Factors`) instead of the common ones; empty if there is none.
  std::string
  first_with_factors(const Scene &scene);

  /// Returns the first contact of @p scene with friction, or a null pointer.
  const ContactPair *
  first_with_friction(const Scene &scene);
} // namespace lamella

#endif
