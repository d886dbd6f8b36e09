// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_theory_notes_h
#define lamella_scene_theory_notes_h

#include <lamella/scene/scene.h>

#include <string>
#include <vector>

namespace lamella
{
  /**
   * Sentences on bodies of @p scene whose theory or axis does not suit them,
   * from constants of their sections (section/theory_limits.h): EBBT, TBT and
   * TE-N in the shear of laminates and sandwiches at the length that they have,
   * TE-N in the torsion of other sections; long elements at ends that supports
   * hold as a whole. @p meshes are those of the scene's sections.
   */
  std::vector<std::string>
  notes_on_theories(const Scene &scene, const SectionMeshes &meshes);
} // namespace lamella

#endif
