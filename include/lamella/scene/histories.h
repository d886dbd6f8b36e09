// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_histories_h
#define lamella_scene_histories_h

#include <lamella/scene/scene.h>

#include <string>

namespace lamella
{
  /// The subsection of the first support, load or obstacle of @p scene, in this
  /// order, that has `Factors` of its own, as in `Load push`; empty if all go
  /// with the load factor of the scene.
  std::string
  first_with_factors(const Scene &scene);

  /// The first contact of @p scene with friction, which makes a state depend on
  /// those before it; null if there is none.
  const ContactPair *
  first_with_friction(const Scene &scene);
} // namespace lamella

#endif
